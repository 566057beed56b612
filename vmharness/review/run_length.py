"""Events and states of a case beside the length of its run."""

from vmharness.case import Case
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.round_off import ROUND_OFF

MOST_STATES = 1e6  # of a published column: no code writes more


def beyond_the_end(case: Case, deck: Deck) -> list[str]:
    """Sentences on events that by theory are not before the end of the deck's run."""
    end = deck.one(CONTROL_TERMINATION).endtim
    wrong = []
    for name, event in case.file.events.items():
        if event.at is not None and (t := case.evaluate(f"at {name}")) > end * (1.0 + ROUND_OFF):
            wrong.append(
                f"[events] {name}: at = {event.at} is {t:.7g}, but the run of the deck ends at {end:.7g}"
            )
    for number, result in enumerate(case.file.results, 1):
        if result.channel == "time" and (t := case.target(result.key)) > end * (1.0 + ROUND_OFF):
            wrong.append(
                f"[results] {number}: {result.key}: by theory the time is {t:.7g}, "
                f"but the run of the deck ends at {end:.7g}"
            )
    return wrong


def intervals(case: Case, deck: Deck) -> list[str]:
    """Sentences on published columns with an interval of states that the run does not have."""
    end, unit = deck.one(CONTROL_TERMINATION).endtim, case.file.units.time
    wrong = []
    for number, column in enumerate(case.published, 1):
        interval = column.interval
        if interval is not None and not end / MOST_STATES <= interval <= end:
            wrong.append(
                f"[published] {number}: interval = {interval:g}: the run of {end:g} {unit} has 1 to "
                f"{MOST_STATES:g} states, so the interval is between {end / MOST_STATES:g} and {end:g} {unit}"
            )
    return wrong
