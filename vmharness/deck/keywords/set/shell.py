"""*SET_SHELL: shell elements by list or by range."""

from vmharness.deck.card import Card, Rows
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

HEAD = Card(sid=integer(above=0), da1=real(0.0), da2=real(0.0), da3=real(0.0), da4=real(0.0))

SET_SHELL_LIST = Keyword(
    "SET_SHELL_LIST",
    HEAD,
    Rows(per_line=8, shells=integer(0)),
    aliases=("SET_SHELL",),
    options=("TITLE",),
    unique="sid",
    kind="shell set",
)

SET_SHELL_LIST_GENERATE = Keyword(
    "SET_SHELL_LIST_GENERATE",
    HEAD,
    Rows(per_line=8, together=2, ranges=integer(0)),  # first, last, first, last, ...
    options=("TITLE",),
    unique="sid",
    kind="shell set",
)
