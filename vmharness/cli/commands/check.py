"""`vm check`: checks of cases and decks that need no run."""

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click

from vmharness.cli.deck import Found, as_objects, check_deck, is_deck, is_good, say_deck
from vmharness.cli.options import FILE, READING, solver_option, timeout_option
from vmharness.cli.say import complain, say, write_file
from vmharness.cli.selection import selected, selecting
from vmharness.execution.call import called, calling
from vmharness.execution.message import Done, Lost, Raised
from vmharness.execution.pool import Pool
from vmharness.suite import last_run
from vmharness.suite.check import Review, check
from vmharness.suite.outcome import EXIT_CODES, NOTHING_SELECTED, Status
from vmharness.suite.select import Entry

REPORTS = Path("reports")


@click.command("check")
@selecting
@solver_option()
@timeout_option(READING)
@click.option("--json", type=FILE, metavar="FILE", help="Also write the findings as JSON.")
def command(
    selectors: tuple[str, ...],
    cases: Path | None,
    words: str,
    tags: tuple[str, ...],
    solver: str,
    timeout: float,
    json: Path | None,
) -> int:
    """Check cases, or deck files; run nothing.

    For a deck file, the command lists all format errors, all keywords and fields that the solver does not support, and
    all that have no effect.

    For a case, it checks schema, units, formulas, deck, channels and faults. It compares the tolerances with the
    errors of the last run in reports/, and names the studies there that are out of date.

    SELECT is an id, a pattern such as 'VM-0*', or the path of a case folder or of a deck file.
    """
    decks = {name: check_deck(Path(name), solver) for name in selectors if is_deck(name)}
    for name, of_deck in decks.items():
        say_deck(Path(name), of_deck)
    good = all(map(is_good, decks.values()))
    others = tuple(name for name in selectors if name not in decks)
    if decks and not others:
        _write(json, {}, decks)
        return 0 if good else EXIT_CODES[Status.BROKEN]
    found, unknown = selected(others, cases, words, tags)
    if not found:
        complain("nothing selected")
        return NOTHING_SELECTED
    reviews = {}
    for case, review in _reviews(found, solver, timeout):
        reviews[case.id] = review
        say(f"{case.id}: {'wrong' if review.wrong else 'ok'}")
        for sentence in review.wrong:
            say(f"  {sentence}")
        for sentence in review.doubtful:
            say(f"  doubtful: {sentence}")
    _write(json, reviews, decks)
    sound = good and not unknown and not any(review.wrong for review in reviews.values())
    return 0 if sound else EXIT_CODES[Status.BROKEN]


def _reviews(found: Sequence[Entry], solver: str, timeout: float) -> Iterator[tuple[Entry, Review]]:
    """The review of each case, made in another process."""
    from vmharness.studies.sources import sources

    errors = last_run.errors(REPORTS)
    with Pool(1, calling, "vmharness.suite.check") as pool:
        calls = [partial(_review, case, errors.get(case.id), solver, sources()) for case in found]
        for number, end in called(pool, calls, timeout):
            case = found[number]
            match end:
                case Done(review):
                    yield case, review
                case Lost(reason):
                    yield case, Review([f"{case.id}: cannot be checked: {reason}"])
                case Raised(error):
                    yield case, Review([f"{case.id}: cannot be checked: {error}"])


def _review(case: Entry, errors: Mapping[str, float] | None, solver: str, sources: str) -> Review:
    """In a worker: the review of a case, and sentences on its studies in reports/ that are out of date."""
    from vmharness.case.digest import inputs
    from vmharness.report.records import FOLDER, stale

    review = check(case.folder, errors, solver)
    studies = REPORTS / case.id / FOLDER
    if studies.is_dir():
        review.doubtful += stale(studies, inputs(case.folder), sources)
    return review


def _write(path: Path | None, reviews: dict[str, Review], decks: dict[str, Found]) -> None:
    """Write the findings as JSON, if --json is given."""
    if path is None:
        return
    import msgspec

    found: list[dict[str, Any]] = [
        {"case": id, "wrong": review.wrong, "doubtful": review.doubtful} for id, review in reviews.items()
    ]
    found += [{"deck": name, **as_objects(of_deck)} for name, of_deck in decks.items()]
    write_file(path, msgspec.json.format(msgspec.json.encode(found), indent=1).decode() + "\n")
