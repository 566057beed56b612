"""What a solver says of a deck before it runs: what it cannot do, and what has no effect."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from vmharness.deck.deck import Deck
from vmharness.deck.error import DeckError, refuse


@dataclass(frozen=True, slots=True)
class Finding:
    """One line of a review: a place of the deck, and what there is to say; `str` reads as a DeckError does."""

    error: DeckError
    idle: bool = False  # has no effect in this deck; otherwise it is not supported

    def __str__(self) -> str:
        return str(self.error)


def in_order(deck: Deck, findings: Iterable[Finding]) -> list[Finding]:
    """The findings in the order of the deck's files and lines."""
    files = {name: number for number, name in enumerate(deck.files)}
    return sorted(findings, key=lambda finding: (files.get(finding.error.file, -1), finding.error.line))


def unsupported(findings: Iterable[Finding]) -> list[DeckError]:
    """The findings that keep a solver from running the deck, as errors."""
    return [finding.error for finding in findings if not finding.idle]


def refuse_unsupported(findings: Sequence[Finding]) -> None:
    """Raise DeckError, or DeckErrors with a line for each, if anything is not supported."""
    refuse(unsupported(findings))
