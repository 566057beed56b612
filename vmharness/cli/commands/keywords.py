"""`vm keywords`: the keywords of the deck reader, and their support by the built-in solver."""

import difflib
from typing import TYPE_CHECKING

import click

from vmharness.cli.say import complain, say
from vmharness.suite.outcome import NOTHING_SELECTED

if TYPE_CHECKING:
    from vmharness.deck import Keyword


@click.command("keywords")
@click.argument("words", nargs=-1, metavar="[WORD]...")
def command(words: tuple[str, ...]) -> int:
    """List the known keywords, or the cards of some.

    With WORDs, only keywords whose names contain one of them are listed, with their cards. A card shows each field
    in capitals, with its default and, where the built-in solver does not support all values, those that it does.
    """
    from vmharness.deck import vocabulary

    known = {keyword.name: keyword for keyword in vocabulary().values()}
    wanted = [word.upper().lstrip("*") for word in words]
    found = [known[name] for name in sorted(known) if not words or any(word in name for word in wanted)]
    if not found:
        near = difflib.get_close_matches(wanted[0], known, n=3, cutoff=0.4)
        complain(f"no keyword like {words[0]}" + (f"; there is *{', *'.join(near)}" if near else ""))
        return NOTHING_SELECTED
    for keyword in found:
        if words:
            _say_cards(keyword)
        else:
            say(_name(keyword))
    return 0


def _name(keyword: "Keyword") -> str:
    return f"*{keyword.name}" + "".join(f" [_{option}]" for option in keyword.options)


def _say_cards(keyword: "Keyword") -> None:
    """Print the cards, with their support by the built-in solver."""
    from vmharness.backends import supported
    from vmharness.cli.options import SOLVER

    support = supported(SOLVER).get(keyword.name)
    remark = support.effect if support else "not supported"
    say(_name(keyword) + (f"   ({remark})" if remark else ""))
    limits = {name: rule.brief for name, rule in support.rules.items()} if support else {}
    for card in keyword.summary(limits):
        say(f"    {card}")
