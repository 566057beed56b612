"""`vm check`: are the cases sound, as far as can be said without running them."""

from pathlib import Path

import click

from vmharness.cli.say import complain, say
from vmharness.cli.selection import selected, selecting
from vmharness.suite import last_run
from vmharness.suite.check import check
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status

REPORTS = Path("reports")


@click.command("check")
@selecting
def command(selectors: tuple[str, ...], cases: Path | None, words: str, tags: tuple[str, ...]) -> int:
    """Check case files, decks and tolerances; run nothing.

    The schema, units, formulas, channels and faults are checked, too. Tolerances are held against the errors of the
    last run of which reports/ has a record.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder.
    """
    found, unknown = selected(selectors, cases, words, tags)
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    sound, errors = not unknown, last_run.errors(REPORTS)
    for case in found:
        review = check(case.folder, errors.get(case.id))
        say(f"{case.id}: {'wrong' if review.wrong else 'ok'}")
        for sentence in review.wrong:
            say(f"  {sentence}")
        for sentence in review.doubtful:
            say(f"  doubtful: {sentence}")
        sound = sound and not review.wrong
    return 0 if sound else EXIT_CODES[Status.BROKEN]
