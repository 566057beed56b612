"""A deck: typed entries in file order, with lookups whose errors name the card that asks."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from os.path import commonprefix
from pathlib import Path

from vmharness.deck.entry import Entry
from vmharness.deck.error import DeckError
from vmharness.deck.field import Value
from vmharness.deck.keyword import Keyword


@dataclass(frozen=True, slots=True, eq=False)
class Deck:
    """What `read` found. A keyword may be asked for as `Keyword` or by any of its names."""

    path: Path
    entries: Sequence[Entry]  # in file order, includes in their place
    parameters: Mapping[str, Value]  # by name in lower case
    notes: Sequence[str]  # of options of *KEYWORD that cannot change results, one sentence each
    files: Mapping[str, str]  # name relative to the deck's folder -> SHA-256
    sound: bool = True  # whether nothing was ill-formed; what was has stand-ins
    _by_name: dict[str, list[Entry]] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        for entry in self.entries:
            for name in (entry.keyword.name, *entry.keyword.aliases):
                self._by_name.setdefault(name, []).append(entry)

    @property
    def title(self) -> str:
        """The text of *TITLE, or nothing."""
        entry = self.first("TITLE")
        return entry.title if entry else ""

    def all(self, *keywords: Keyword | str) -> list[Entry]:
        """All entries of the keywords: keyword by keyword, each in file order."""
        return [entry for keyword in keywords for entry in self._by_name.get(_name(keyword), ())]

    def first(self, keyword: Keyword | str) -> Entry | None:
        """The entry of a keyword that may be missing, such as a control card; two are a DeckError."""
        found = self.all(keyword)
        if len(found) > 1:
            other = f"{found[0].file}:{found[0].line}"
            raise found[1].error(None, f"may stand only once; there is one already at {other}")
        return found[0] if found else None

    def one(self, keyword: Keyword | str) -> Entry:
        """The only entry of a keyword; none or more than one is a DeckError."""
        found = self.first(keyword)
        if found is None:
            raise DeckError(f"*{_name(keyword)} is required", self.path.name)
        return found

    def find(
        self,
        *keywords: Keyword | str,
        referred_by: tuple[Entry, str] | tuple[Entry, str, int] | None = None,
        **id: int,
    ) -> Entry:
        """The entry of any of `keywords` whose field has the value of `id`, as in find(MAT_ELASTIC, mid=3).

        `referred_by` = (entry, field[, row]) is the card that asks: a DeckError for a missing id is placed
        there and says which ids there are.
        """
        ((name, wanted),) = id.items()
        candidates = self.all(*keywords)
        for entry in candidates:
            if entry.values.get(name) == wanted:
                return entry
        defined = ", ".join(str(entry.values[name]) for entry in candidates if name in entry.values) or "none"
        what = f"no {_describe(keywords)} with {name.upper()} = {wanted}; defined: {defined}"
        if referred_by is None:
            error = DeckError(what, self.path.name)
        else:
            entry, field, *row = referred_by
            error = entry.error(field, what, *row)
        error.sought = frozenset(_name(keyword).partition("_")[0] for keyword in keywords)
        raise error


def _name(keyword: Keyword | str) -> str:
    return keyword.name if isinstance(keyword, Keyword) else keyword.upper().lstrip("*")


def _describe(keywords: Sequence[Keyword | str]) -> str:
    """ "*SET_SEGMENT", or "*MAT_..." for several.

    >>> _describe(["MAT_ELASTIC", "MAT_RIGID"]), _describe(["DEFINE_CURVE"])
    ('*MAT_...', '*DEFINE_CURVE')
    """
    names = [_name(keyword) for keyword in keywords]
    if len(names) == 1:
        return f"*{names[0]}"
    prefix = commonprefix(names).rpartition("_")[0]  # noqa: RUF071 - by characters is meant
    return f"*{prefix}_..." if prefix else " or ".join(f"*{name}" for name in names)
