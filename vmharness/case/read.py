"""Reading of a case folder, with all checks that need no run."""

from pathlib import Path

from msgspec.structs import asdict

from vmharness.case.bounds import check_bounds
from vmharness.case.case import Case, evaluate_theory
from vmharness.case.check import Checks
from vmharness.case.check_numbers import check_numbers
from vmharness.case.check_studies import check_converge, check_sweep, planned
from vmharness.case.decode import FILE, decode
from vmharness.case.error import CaseError
from vmharness.case.files import check_files
from vmharness.case.prose import check_prose
from vmharness.case.tautology import check_times
from vmharness.formula import UnitError, UnitSystem


def read(folder: Path) -> Case:
    """The case in `folder`; raises CaseError with the file, the table and the wrong entry."""
    file = decode(folder / FILE)
    check_files(folder, file)
    try:
        units = UnitSystem(**{name: value for name, value in asdict(file.units).items() if value})
    except (UnitError, TypeError, ValueError) as error:
        raise CaseError(f"{folder.name}/{FILE}: [units]: {error}") from None
    checked = Checks(folder, file, units)
    check_numbers(checked)
    checked.all()
    check_converge(checked)
    check_sweep(checked)
    check_prose(folder)
    theory = evaluate_theory(folder.name, file, checked.values, checked.formulas)
    case = Case(
        id=folder.name,
        folder=folder,
        file=file,
        units=units,
        given=checked.values,
        formulas=checked.formulas,
        dimensions=checked.dimensions,
        theory=theory,
    )
    for place, name in planned(file):
        if not case.moves_deck(name):
            raise CaseError(
                f"{folder.name}/{FILE}: {place}: {name} cannot be set: nothing in the deck depends on it"
            )
    check_bounds(case)
    check_times(case)
    case.deck_source()  # raises CaseError if its template makes no deck
    return case
