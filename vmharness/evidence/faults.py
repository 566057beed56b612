"""Planted faults: changes of the deck alone that a case must notice."""

from vmharness.case import Case
from vmharness.case.change import changed_value
from vmharness.case.format import Fault


def planted(case: Case, fault: Fault) -> Case:
    """The case with `fault` in its deck: the theory, and so the targets, stay as they are."""
    return case.with_deck_of(
        {name: changed_value(case.given[name], change) for name, change in fault.change.items()}
    )
