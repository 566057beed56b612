"""Published values beside theory: what differs by more than the printed digits needs a remark."""

from decimal import Decimal

from vmharness.case import Case
from vmharness.case.format import Published
from vmharness.formula import Unit


def unexplained(case: Case) -> list[str]:
    """Sentences on published targets that theory does not give, and on printed errors that do not fit their values.

    A remark explains a value if it quotes its digits.
    """
    found = []
    for number, column in enumerate(case.published, 1):
        for key, text in column.values.items():
            what = _target(case, column, key) or _error(case, column, key)
            if what and text not in _numbers(column.remark):
                place = f"[published] {number} ({column.name}): {key} = {text}"
                found.append(f"{place}: {what}; a remark must quote {text} and say why")
    return found


def _target(case: Case, column: Published, key: str) -> str:
    """How theory differs from a published target by more than its digits, or nothing."""
    target = in_unit(case, key)
    if column.kind != "target" or fits(target, column.values[key]):
        return ""
    return f"theory gives {target:.7g}"


def _error(case: Case, column: Published, key: str) -> str:
    """How a printed error in percent differs from that of its value by more than the digits of both, or nothing."""
    if key not in column.errors_percent:
        return ""
    printed, target = column.errors_percent[key], in_unit(case, key)
    if not target:
        return "its error in percent has no meaning: the target is 0"
    error = 100.0 * (float(column.values[key]) / target - 1.0)
    allowed = 100.0 * half_digit(column.values[key]) / abs(target) + half_digit(repr(printed))
    return (
        ""
        if abs(error - printed) <= allowed
        else f"it differs from theory by {error:.3g} %, not {printed:g} %"
    )


def in_unit(case: Case, key: str) -> float:
    """The target of a result in its unit."""
    return case.target(key) / case.units.factor(Unit(case.result(key).unit))


def fits(value: float, text: str) -> bool:
    """Whether `value` agrees with printed digits: it differs by half of the last one at most.

    >>> fits(0.0719816, "0.07198"), fits(0.1004449, "0.10037"), fits(-100.0000001, "-100")
    (True, False, True)
    """
    return abs(Decimal(value) - Decimal(text)) <= Decimal(half_digit(text)) * Decimal("1.000001")


def half_digit(text: str) -> float:
    """Half of the last digit of a printed number.

    >>> half_digit("-1.23"), half_digit("0.494e-4")
    (0.005, 5e-08)
    """
    return 0.5 * 10.0 ** int(Decimal(text).as_tuple().exponent)


def _numbers(remark: str) -> set[str]:
    """The words of a remark without the punctuation around them."""
    return {word.strip(".,;:()") for word in remark.replace("−", "-").split()}
