"""The one case that a study is of."""

from pathlib import Path
from typing import TYPE_CHECKING

import click

from vmharness.suite.select import SelectError, cases_folder, select

if TYPE_CHECKING:
    from vmharness.case import Case


def one(selector: str, cases: Path | None) -> "Case":
    """The case that `selector` names, read; raises CaseError, or UsageError where it means none or several."""
    from vmharness.case import read

    try:
        found, unknown = select(cases_folder(cases), (selector,))
    except SelectError as error:
        raise click.UsageError(str(error)) from None
    for problem in unknown.values():
        raise click.UsageError(problem)
    if len(found) > 1:
        raise click.UsageError(f"{selector} means {len(found)} cases; name one")
    return read(found[0].folder)
