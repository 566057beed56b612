"""`vm keywords`: what the deck reader and the built-in solver support."""

import difflib

import click

from vmharness.cli.say import complain, say
from vmharness.suite.outcome import NOTHING_SELECTED


@click.command("keywords")
@click.argument("words", nargs=-1, metavar="[WORD]...")
def command(words: tuple[str, ...]) -> int:
    """List the supported keywords, or the cards of some.

    With WORDs, only keywords whose names contain one of them are listed, with their cards. A card shows each field
    in capitals, with its default and, where not all values are supported, those that are.
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
        options = "".join(f" [_{option}]" for option in keyword.options)
        say(f"*{keyword.name}{options}" + (f"   ({keyword.effect})" if words and keyword.effect else ""))
        for card in keyword.summary() if words else ():
            say(f"    {card}")
    return 0
