"""What is wrong in a deck, and where."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any, TypeVar

Item = TypeVar("Item")


class DeckError(Exception):
    """A deck cannot be read or used; `str` is "file:line: *KEYWORD: FIELD = value: what is wrong".

    Parts that are not known are left out.

    >>> str(DeckError("only 2 is supported", "deck.k", 21, "SECTION_SHELL", "elform", 16))
    'deck.k:21: *SECTION_SHELL: ELFORM = 16: only 2 is supported'
    >>> str(DeckError("no such file", "deck.k"))
    'deck.k: no such file'
    """

    sought: frozenset[str] = (
        frozenset()
    )  # families of keywords (MAT, SET) that should have had what is missing

    def __init__(
        self,
        what: str,
        file: str = "",
        line: int = 0,
        keyword: str = "",
        field: str = "",
        value: object = None,
    ) -> None:
        super().__init__(what, file, line, keyword, field, value)  # args: so that it survives a pickle
        self.what = what
        self.file = file
        self.line = line
        self.keyword = keyword
        self.field = field
        self.value = value

    def __str__(self) -> str:
        place = f"{self.file}:{self.line}" if self.line else self.file
        keyword = f"*{self.keyword}" if self.keyword else ""
        field = f"{self.field.upper()} = {show(self.value)}" if self.field else ""
        return ": ".join(part for part in (place, keyword, field, self.what) if part)

    @property
    def errors(self) -> "Sequence[DeckError]":
        """The single errors: this one."""
        return (self,)


class DeckErrors(DeckError):  # noqa: N818 - several errors
    """Several things are wrong; `str` has a line for each. Its own place is that of the first."""

    def __init__(self, errors: Sequence[DeckError]) -> None:
        first = errors[0]
        super().__init__(first.what, first.file, first.line, first.keyword, first.field, first.value)
        self.args = (errors,)

    def __str__(self) -> str:
        return "\n".join(map(str, self.errors))

    @property
    def errors(self) -> Sequence[DeckError]:
        """The single errors, in the order in which they were found."""
        found: Sequence[DeckError] = self.args[0]
        return found


def refuse(errors: Sequence[DeckError]) -> None:
    """Raise what is wrong, if anything: a single error as itself, several as DeckErrors."""
    if errors:
        raise errors[0] if len(errors) == 1 else DeckErrors(errors)


def each(items: Iterable[Item], act: Callable[[Item], Any]) -> None:
    """Call `act` with every item, whatever is wrong with others; then raise all that was wrong together."""
    wrong: list[DeckError] = []
    try:
        for item in items:
            try:
                act(item)
            except DeckError as error:
                wrong += error.errors
    except DeckError as error:  # of the items themselves
        wrong += error.errors
    refuse(wrong)


def show(value: object) -> str:
    """A value as a deck would write it.

    >>> show(0.5), show(""), show("A")
    ('0.5', '(blank)', 'A')
    """
    return "(blank)" if value is None or value == "" else str(value)
