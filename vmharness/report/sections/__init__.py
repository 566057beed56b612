"""Sections of the page for the studies: one module for each study, in the order of the page.

The study `converge` writes the record studies/converge.json beside the page. The module `converge` has

    section(content, case) -> Section

which makes the section of the page from the bytes of the record; the index shows its `summary`. A study with drawings
also has

    figures(content) -> list[Figure]

which the index does not need. A study with findings on published columns also has

    columns(content, case) -> dict[str, Section]

by name of the column; the page adds them to the section on that column.
"""
