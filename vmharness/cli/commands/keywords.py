"""`vm keywords`: the keywords of the deck reader, and their support by a solver."""

from typing import TYPE_CHECKING

import click

from vmharness.cli.options import solver_option
from vmharness.cli.say import complain, say
from vmharness.suite.outcome import NOTHING_SELECTED

if TYPE_CHECKING:
    from vmharness.deck import Keyword
    from vmharness.deck.support import Supported


@click.command("keywords")
@click.argument("words", nargs=-1, metavar="[WORD]...")
@solver_option()
def command(words: tuple[str, ...], solver: str) -> int:
    """List the known keywords, or show the cards of some.

    With WORDs, the command lists only keywords whose names contain one of them, with their cards. A card shows each
    field in capitals with its default. If the solver supports only some values of a field, the card shows them.
    """
    from vmharness.backends import calls
    from vmharness.deck import vocabulary
    from vmharness.deck.misspelling import misspelling_of

    known = {keyword.name: keyword for keyword in vocabulary().values()}
    wanted = [word.upper().lstrip("*") for word in words]
    found = [known[name] for name in sorted(known) if not words or any(word in name for word in wanted)]
    if not found:
        meant = misspelling_of(wanted[0], known)
        complain(f"no keyword like {words[0]}" + (f"; did you mean *{meant}?" if meant else ""))
        return NOTHING_SELECTED
    supported = calls.supported(solver) if words else None
    for keyword in found:
        if words:
            _say_cards(keyword, supported)
        else:
            say(_name(keyword))
    return 0


def _name(keyword: "Keyword") -> str:
    return f"*{keyword.name}" + "".join(f" [_{option}]" for option in keyword.options)


def _say_cards(keyword: "Keyword", supported: "Supported | None") -> None:
    """Print the cards, with their support by the solver; it may not declare what it supports."""
    support = supported.get(keyword.name) if supported is not None else None
    remark = support.effect if support else "not supported" if supported is not None else ""
    say(_name(keyword) + (f"   ({remark})" if remark else ""))
    limits = {name: rule.brief for name, rule in support.rules.items()} if support else {}
    for card in keyword.summary(limits):
        say(f"    {card}")
