"""*SET_PART: parts by list, by range, or by other sets."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real, text
from vmharness.deck.keyword import Keyword

HEAD = Card(
    sid=integer(above=0),
    da1=real(0.0),
    da2=real(0.0),
    da3=real(0.0),
    da4=real(0.0),
    solver=text("MECH", capitals=True),
)


def _keyword(name: str, rows: Rows, *aliases: str) -> Keyword:
    return Keyword(name, HEAD, rows, aliases=aliases, options=("TITLE",), unique="sid", kind="part set")


SET_PART_LIST = _keyword("SET_PART_LIST", Rows(per_line=8, parts=integer(0)), "SET_PART")
SET_PART_LIST_GENERATE = _keyword(
    "SET_PART_LIST_GENERATE", Rows(per_line=8, together=2, ranges=integer(0))
)  # first, last, first, last, ...
SET_PART_ADD = _keyword("SET_PART_ADD", Rows(per_line=8, sets=integer(0)))
