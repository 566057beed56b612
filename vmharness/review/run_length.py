"""Events and states of a case beside the length of its run."""

from vmharness.case import Case
from vmharness.deck import Deck
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.round_off import ROUND_OFF

START = 1e-6  # of the run: no solver has computed anything before
MOST_STATES = 1e6  # of a published column: no code writes more


def outside_run(case: Case, deck: Deck) -> list[str]:
    """Sentences on events that by theory are after the end of the deck's run, or at its very start."""
    end = deck.one(CONTROL_TERMINATION).endtim
    places = {
        f"[events] {name}: at = {event.at}": case.evaluate(f"at {name}")
        for name, event in case.file.events.items()
        if event.at is not None
    }
    places |= {
        f"[results] {number}: {result.key}: target = {result.target}": case.target(result.key)
        for number, result in enumerate(case.file.results, 1)
        if result.channel == "time"
    }
    wrong = []
    for place, t in places.items():
        if t > end * (1.0 + ROUND_OFF):
            wrong.append(f"{place} is {t:.7g}, but the run of the deck ends at {end:.7g}")
        elif t < START * end:
            wrong.append(f"{place} is {t:.7g}: at the start of the run all values are those of the deck")
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
