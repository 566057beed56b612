"""The layout of a keyword, as data."""

from collections.abc import Mapping

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import Value, integer, text

OPTIONS = {
    "TITLE": Card(title=text("", width=80)),
    "ID": Card(id=integer(0), heading=text("", width=70)),
}
RESERVED = {
    "keyword",
    "spelled",
    "suffix",
    "file",
    "line",
    "values",
    "lines",
    "raw",
    "references",
    "line_of",
    "error",
    "of_defaults",
}


class Keyword:
    """What may stand in the block of a keyword.

    - `cards`: the cards of one group, in order; a last `Rows` takes all remaining lines.
    - `repeat`: groups follow each other until the block ends, one entry each.
    - `table`: the cards are one row of a table, one entry for the block, its fields are arrays.
    - `one_line`: a card that may stand for all cards of a row, known by a first line too long for the first card.
    - `options`: suffixes that put a card before each group: "TITLE" and "ID", or a mapping of suffix to card. One of
      a card without fields puts none: it serves those `when` the suffix is there.
    - `aliases`: other names of the same keyword.
    - `unique`: the field that names what the entry defines; `kind` is what must not have two of the same name
      (several keywords may define one kind: all materials share "mid").
    - `single`: the keyword may stand once in a deck.
    - `corners`: of an element keyword, the fields that name the nodes it joins.

    The block of a keyword without cards is kept as it stands in the deck, unread.
    """

    def __init__(
        self,
        name: str,
        *cards: Card,
        repeat: bool = False,
        table: bool = False,
        one_line: Card | None = None,
        options: tuple[str, ...] | Mapping[str, Card] = (),
        aliases: tuple[str, ...] = (),
        unique: str = "",
        kind: str = "",
        single: bool = False,
        corners: tuple[str, ...] = (),
    ) -> None:
        self.name = name
        self.rows: tuple[Card, ...] = (
            cards if table else tuple(card for card in cards if isinstance(card, Rows))
        )
        self.cards = tuple(card for card in cards if card not in self.rows)
        self.one_line = one_line
        self.repeat = repeat
        self.options = dict(options) if isinstance(options, Mapping) else {o: OPTIONS[o] for o in options}
        self.aliases = aliases
        self.unique = unique
        self.kind = kind or unique
        self.single = single
        self.corners = corners
        fields = [name for card in (*self.cards, *self.rows) for name in card.defaults()]
        if hidden := RESERVED.intersection(fields):
            raise ValueError(f"*{name}: an entry cannot have a field {', '.join(sorted(hidden))}")
        if repeat and self.rows:
            raise ValueError(f"*{name}: rows take all lines, so that groups cannot repeat")
        one_of = {
            name for card in self.cards if card.when for name in card.defaults()
        }  # cards of which one is there
        always = [name for card in (*self.cards, *self.rows) if not card.when for name in card.defaults()]
        names = [*one_of, *always]
        if again := {name for name in names if names.count(name) > 1}:
            raise ValueError(f"*{name}: two fields have the name {', '.join(sorted(again))}")

    def __repr__(self) -> str:
        return f"*{self.name}"

    def group(self, option: str) -> tuple[Card, ...]:
        """The cards of one group, the option's card first."""
        return (self.options[option], *self.cards) if option and self.options[option].fields else self.cards

    def all_cards(self) -> tuple[Card, ...]:
        """Every card that may stand in the block."""
        return (*self.options.values(), *self.cards, *self.rows)

    def default(self, field: str) -> Value | None:
        """The value of a field that is blank."""
        return next(card.defaults()[field] for card in self.all_cards() if field in card.defaults())

    def names(self) -> list[str]:
        """Every name under which the keyword may stand in a deck."""
        plain = [self.name, *self.aliases]
        return plain + [f"{name}_{option}" for name in plain for option in self.options]

    def summary(self, limits: Mapping[str, str] | None = None) -> list[str]:
        """Each card in one line: fields in capitals, with defaults, and what of them is supported by `limits`.

        >>> Keyword("SET_X", Card(sid=integer(), its=integer(1), n=integer(0))).summary({"n": "only 0, 1"})
        ['SID ITS=1 N=0(only 0, 1)']
        """
        limits = limits or {}
        return [
            " ".join(
                name.upper()
                + ("" if field.default is None else f"={field.default}")
                + (f"({limits[name]})" if limits.get(name) else "")
                for name, field in card.fields.items()
                if not name.startswith("_")
            )
            for card in self.all_cards()
            if card.fields
        ]
