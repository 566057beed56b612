"""A deck file reviewed for `vm check`: everything that keeps a solver from running it, at once."""

import textwrap
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from vmharness.cli.say import say

if TYPE_CHECKING:
    from vmharness.deck import DeckError

WIDTH = 80

ILL_FORMED, UNSUPPORTED, IDLE = "ill-formed", "not supported", "has no effect here"

Found = dict[str, "list[DeckError]"]  # by group, in the order of the deck


def is_deck(selector: str) -> bool:
    """Whether an argument is a file, and so a deck: cases are folders."""
    return Path(selector).is_file()


def check_deck(path: Path, solver: str) -> Found:
    """What there is to say of a deck, by group; a field is named once."""
    from vmharness.backends import calls
    from vmharness.deck import read_all, vocabulary
    from vmharness.deck.finding import Finding, in_order

    deck, errors = read_all(path, vocabulary())
    wrong = [finding.error for finding in in_order(deck, map(Finding, _one_a_field(errors)))]
    follows = _following(wrong)
    findings = [finding for finding in calls.solver(solver).review(deck, {}) if not follows(finding.error)]
    return {
        ILL_FORMED: wrong,
        UNSUPPORTED: [finding.error for finding in findings if not finding.idle],
        IDLE: [finding.error for finding in findings if finding.idle],
    }


def _place(error: "DeckError") -> tuple[str, int, str]:
    return error.file, error.line, error.field


def _one_a_field(errors: "Sequence[DeckError]") -> "Iterator[DeckError]":
    """The errors without those that follow from another of the same field."""
    fields = set()
    for error in errors:
        if not (error.field and _place(error) in fields):
            yield error
        fields.add(_place(error))


def _following(wrong: "Sequence[DeckError]") -> "Callable[[DeckError], bool]":
    """Whether a finding is of a stand-in for what is ill-formed, or of a definition that could not be read."""
    places, unread = {_place(error) for error in wrong}, _unread(wrong)
    parameters = any(error.keyword.startswith("PARAMETER") for error in wrong)
    return lambda error: bool(
        _place(error) in places
        or error.sought & unread
        or (parameters and str(error.value).removeprefix("-").startswith("&"))
    )


def _unread(wrong: "Sequence[DeckError]") -> frozenset[str]:
    """Families of keywords (MAT, SET) that may define what seems to be missing: some of them could not be read."""
    from vmharness.deck import vocabulary

    keywords = vocabulary().values()
    families = [(keyword.name.partition("_")[0], keyword.unique) for keyword in keywords]
    if any(error.keyword in ("", "INCLUDE") for error in wrong):  # a file of the deck is missing
        return frozenset(family for family, _ in families)
    own = {(error.keyword.partition("_")[0], error.field) for error in wrong}
    return frozenset(family for family, unique in families if own & {(family, ""), (family, unique)})


def is_good(found: Found) -> bool:
    """Whether the solver can run the deck."""
    return not (found[ILL_FORMED] or found[UNSUPPORTED])


def say_deck(path: Path, found: Found) -> None:
    """Print what was found, in 80 columns."""
    say(f"{path}: {'ok' if is_good(found) else 'wrong'}")
    for group, errors in found.items():
        if errors:
            say(f"  {group}:")
        for line in _of_keywords(errors) if group == IDLE else map(str, errors):
            say(
                textwrap.fill(
                    line, WIDTH, initial_indent="    ", subsequent_indent="      ", break_on_hyphens=False
                )
            )


def as_objects(found: Found) -> dict[str, list[dict[str, Any]]]:
    """The findings by group, each as an object, for JSON."""
    names = ("file", "line", "keyword", "field", "value", "what")
    return {
        group: [{name: _plain(getattr(error, name)) for name in names} | {"group": group} for error in errors]
        for group, errors in found.items()
    }


def _plain(value: Any) -> Any:
    """A value without the types of numpy."""
    return value.tolist() if hasattr(value, "tolist") else value


def _of_keywords(errors: "Sequence[DeckError]") -> Iterator[str]:
    """A line, at the place of the first, for all errors that say the same of a field, or of whole keywords."""
    alike: dict[tuple[str, ...], list[DeckError]] = {}
    for error in errors:
        field = (error.keyword, error.field, str(error.value)) if error.field else ()
        alike.setdefault((*field, error.what), []).append(error)
    for first, *others in alike.values():
        if first.field:
            yield str(first) + (f" ({len(others) + 1} such cards)" if others else "")
        else:
            keywords = dict.fromkeys(f"*{error.keyword}" for error in (first, *others))
            yield f"{first.file}:{first.line}: {', '.join(keywords)}: {first.what}"
