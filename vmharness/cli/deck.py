"""A deck file reviewed for `vm check`: everything that keeps a solver from running it, at once."""

import textwrap
from pathlib import Path

from vmharness.cli.say import say

WIDTH = 80

ILL_FORMED, UNSUPPORTED, IDLE = "ill-formed", "not supported", "has no effect here"

Found = dict[str, list[str]]  # group -> lines "file:line: *KEYWORD: FIELD = value: what"


def is_deck(selector: str) -> bool:
    """Whether an argument is a file, and so a deck: cases are folders."""
    return Path(selector).is_file()


def check_deck(path: Path, solver: str) -> Found:
    """What there is to say of a deck, by group."""
    from vmharness.backends import calls
    from vmharness.deck import read_all, vocabulary

    deck, wrong = read_all(path, vocabulary())
    places = {(error.file, error.line, error.field) for error in wrong}
    findings = [
        finding
        for finding in calls.solver(solver).review(deck, {})
        if (finding.error.file, finding.error.line, finding.error.field) not in places
    ]
    return {
        ILL_FORMED: [str(error) for error in wrong],
        UNSUPPORTED: [str(finding) for finding in findings if not finding.idle],
        IDLE: [str(finding) for finding in findings if finding.idle],
    }


def is_good(found: Found) -> bool:
    """Whether the solver can run the deck."""
    return not (found[ILL_FORMED] or found[UNSUPPORTED])


def say_deck(path: Path, found: Found) -> None:
    """Print what was found, in 80 columns."""
    say(f"{path}: {'ok' if is_good(found) else 'wrong'}")
    for group, lines in found.items():
        if lines:
            say(f"  {group}:")
        for line in lines:
            say(
                textwrap.fill(
                    line, WIDTH, initial_indent="    ", subsequent_indent="      ", break_on_hyphens=False
                )
            )
