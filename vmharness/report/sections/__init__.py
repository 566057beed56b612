"""Studies on the page of a case, one a file; the folder is the list, and the order on the page.

The study `converge` leaves studies/converge.json beside the page. The module of that name has

    section(content, case) -> Section

which makes of the file's bytes what the page shows, and its `summary` what the index shows; a study with drawings has

    figures(content) -> list[Figure]

too, which the index does without; one that has something to say of published columns has

    columns(content, case) -> dict[str, Section]

by name of the column, which stands where the page tells of that.
"""
