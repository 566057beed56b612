"""The deck's own parameters compared with the data of the case.

A parameter of the deck is the value of its formula, rounded to the digits that it is written with. A given datum has
all its digits in the deck. Six digits fit a field of ten columns in any format; a parameter with fewer must be named in
[deck.rounded], with the reason why they are enough.
"""

from decimal import Decimal

from vmharness.case import Case
from vmharness.case.format import RUN_LENGTH
from vmharness.deck import Deck
from vmharness.round_off import ROUND_OFF

SIX_DIGITS = 5e-6  # largest relative error of a number that is rounded to six digits
LEAST_DIGITS = 5e-3  # of one that is rounded to three, the fewest that a reason can allow


def disagreements(case: Case, deck: Deck) -> list[str]:
    """Sentences on parameters of the deck that are not those of the case.

    The end of the run may be any time after the last event (`run_length`).
    """
    wrong = []
    for name, formula in case.file.deck.parameters.items():
        written = deck.parameters.get(name.lower())
        if formula == RUN_LENGTH or not isinstance(written, int | float):
            continue
        value = case.evaluate(f"parameter {name}")
        if why := _disagreement(case, name, float(written), value):
            wrong.append(
                f"{case.deck_name}: parameter {name} = {written:.15g}, but {formula} = {value:.10g}: {why}"
            )
    return wrong


def _disagreement(case: Case, name: str, written: float, value: float) -> str:
    """Why a number of the deck is not the value of its formula, or nothing."""
    error = abs(written - value)
    if error <= ROUND_OFF * abs(value):
        return ""
    formula = case.file.deck.parameters[name]
    if formula in case.given:
        return "the deck must have the datum of case.toml"
    if written != float(f"{value:.{_digits(written) - 1}e}"):
        return "it is not this value, rounded to the digits of the deck"
    if name in case.file.deck.rounded:
        return "" if error <= LEAST_DIGITS * abs(value) else "three digits are the fewest that may be kept"
    if error > SIX_DIGITS * abs(value):
        return "write six digits or more, or say in [deck.rounded] why fewer are enough"
    return ""


def _digits(value: float) -> int:
    """How many significant digits a number has, without zeros at its end.

    >>> _digits(39.3022555), _digits(1e4)
    (9, 1)
    """
    return len(Decimal(repr(value)).normalize().as_tuple().digits)
