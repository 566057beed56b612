"""`vm list`: the cases of a folder."""

from pathlib import Path

import click

from vmharness.cli.say import complain, plain_table, say_table
from vmharness.cli.selection import selected, selecting
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status


@click.command("list")
@selecting
def command(selectors: tuple[str, ...], cases: Path | None, words: str, tags: tuple[str, ...]) -> int:
    """List cases with their titles and tags.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder.
    """
    found, unknown = selected(selectors, cases, words, tags)
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    table = plain_table("Case", "Title", "Covers")
    for case in found:
        table.add_row(case.id, case.title or "(cannot be read: see `vm check`)", ", ".join(case.tags))
    say_table(table)
    return EXIT_CODES[Status.BROKEN] if unknown else 0
