"""`vm new`: a new case folder to fill in."""

import re
from pathlib import Path

import click

from vmharness.cli.say import complain, say
from vmharness.suite.outcome import EXIT_CODES, Status


@click.command("new")
@click.argument("id", metavar="ID")
@click.option(
    "--cases",
    type=click.Path(path_type=Path),
    default=Path("cases"),
    metavar="DIR",
    help="Folder that contains the case folders.  [default: ./cases]",
)
def command(id: str, cases: Path) -> int:
    """Make a new case folder to fill in.

    The folder contains a mass in free fall as an example; replace it by your problem. The case runs when its title,
    reference and reasons are filled in.

    ID is its name: letters, digits, dots and hyphens.
    """
    from vmharness.case import CaseError
    from vmharness.case.new import new

    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9.-]*", id):
        raise click.BadParameter(f"{id!r} is not an id: use letters, digits, dots and hyphens")
    try:
        written = new(cases / id)
    except (CaseError, OSError) as error:
        complain(str(error))
        return EXIT_CODES[Status.BROKEN]
    for path in written:
        say(str(path))
    say(
        f"Fill in the empty texts of case.toml; `vm check {id}` shows what is missing, `vm run {id}` runs the case."
    )
    return 0
