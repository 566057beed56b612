"""`vm check`: are the cases sound, as far as can be said without running them."""

from pathlib import Path

import click

from vmharness.cli.options import FILE, solver_option
from vmharness.cli.say import complain, say
from vmharness.cli.selection import selected, selecting
from vmharness.suite import last_run
from vmharness.suite.check import Review, check
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status
from vmharness.suite.select import Entry

REPORTS = Path("reports")


@click.command("check")
@selecting
@solver_option()
@click.option("--json", type=FILE, metavar="FILE", help="Write what is found as JSON, too.")
def command(
    selectors: tuple[str, ...],
    cases: Path | None,
    words: str,
    tags: tuple[str, ...],
    solver: str,
    json: Path | None,
) -> int:
    """Check case files, decks and tolerances; run nothing.

    The schema, units, formulas, channels and faults are checked, too. Tolerances are held against the errors of the
    last run of which reports/ has a record; studies there that other sources made, or another state of the case, are
    named.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder.
    """
    found, unknown = selected(selectors, cases, words, tags)
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    errors, reviews = last_run.errors(REPORTS), {}
    for case in found:
        review = reviews[case.id] = check(case.folder, errors.get(case.id), solver)
        review.doubtful += _stale(case)
        say(f"{case.id}: {'wrong' if review.wrong else 'ok'}")
        for sentence in review.wrong:
            say(f"  {sentence}")
        for sentence in review.doubtful:
            say(f"  doubtful: {sentence}")
    if json is not None:
        _write(json, reviews)
    sound = not unknown and not any(review.wrong for review in reviews.values())
    return 0 if sound else EXIT_CODES[Status.BROKEN]


def _stale(case: Entry) -> list[str]:
    """Studies in reports/ that would have to be made anew."""
    from vmharness.case.digest import inputs
    from vmharness.report.records import FOLDER, stale
    from vmharness.studies.sources import sources

    return stale(REPORTS / case.id / FOLDER, inputs(case.folder), sources())


def _write(path: Path, reviews: dict[str, Review]) -> None:
    import msgspec

    from vmharness.execution import atomic

    found = [
        {"case": id, "wrong": review.wrong, "doubtful": review.doubtful} for id, review in reviews.items()
    ]
    atomic.write(path, msgspec.json.format(msgspec.json.encode(found), indent=1).decode() + "\n")
