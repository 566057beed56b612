"""*SET_NODE: nodes by list, by range, by other sets, or by what they belong to."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import Field, integer, real, text
from vmharness.deck.keyword import Keyword

HEAD = Card(
    sid=integer(above=0),
    da1=real(0.0),
    da2=real(0.0),
    da3=real(0.0),
    da4=real(0.0),
    solver=text("MECH", capitals=True),
    its=integer(1),
)

SET_NODE_LIST = Keyword(
    "SET_NODE_LIST",
    HEAD,
    Rows(per_line=8, nodes=integer(0)),
    aliases=("SET_NODE",),
    options=("TITLE",),
    unique="sid",
    kind="node set",
)

SET_NODE_LIST_GENERATE = Keyword(
    "SET_NODE_LIST_GENERATE",
    HEAD,
    Rows(per_line=8, together=2, ranges=integer(0)),  # first, last, first, last, ...
    options=("TITLE",),
    unique="sid",
    kind="node set",
)

SET_NODE_COLUMN = Keyword(
    "SET_NODE_COLUMN",
    HEAD,
    Rows(nodes=integer(above=0), a1=real(0.0), a2=real(0.0), a3=real(0.0), a4=real(0.0)),
    options=("TITLE",),
    unique="sid",
    kind="node set",
)

SET_NODE_ADD = Keyword(
    "SET_NODE_ADD",
    HEAD,
    Rows(per_line=8, sets=integer(0)),
    options=("TITLE",),
    unique="sid",
    kind="node set",
)

MEMBERS: dict[str, Field] = {f"e{i}": integer(0) for i in range(1, 8)}

SET_NODE_GENERAL = Keyword(
    "SET_NODE_GENERAL",
    HEAD,
    Rows({"option": text(capitals=True), **MEMBERS}),
    options=("TITLE",),
    unique="sid",
    kind="node set",
)
