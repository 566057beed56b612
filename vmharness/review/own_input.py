"""Results that read only what the deck prescribes: motions of supports, of prescribed motions and of fixed walls."""

from vmharness.case import Case
from vmharness.case.format import Channel
from vmharness.case.tautology import DERIVATIVES
from vmharness.deck import Deck
from vmharness.mesh.driven import driven, driven_bodies
from vmharness.mesh.nodes import nodes_of
from vmharness.mesh.sets import nodes_of_parts

AXES = ("x", "y", "z")
OFFSETS = {"position": 0, "angle": 3}  # of the degrees of freedom of translation and rotation
WALL = "RIGIDWALL_PLANAR"


def own_input(case: Case, deck: Deck) -> list[str]:
    """Sentences on results whose value, or whose time, the deck gives and no solver computes.

    Raises DeckError where the deck refers to what it does not define.
    """
    given = {name for name, channel in case.file.channels.items() if is_given(deck, channel)}
    wrong = []
    for number, result in enumerate(case.file.results, 1):
        read = case.file.events[result.event].of if result.channel == "time" else result.channel
        if read in given:
            wrong.append(
                f"[results] {number}: {result.key}: {read} is held or prescribed by the deck, so that the "
                "result reads only the deck's own input and cannot disagree: read a force, or another place"
            )
    return wrong


def is_given(deck: Deck, channel: Channel) -> bool:
    """Whether the deck gives the whole history of a channel."""
    axis, _, quantity = (channel.component or "").partition("-")
    base, _ = DERIVATIVES.get(quantity, ("", 0))
    if channel.wall is not None:
        return base == "position" and _is_fixed_wall(deck, channel.wall)
    if base not in OFFSETS or axis not in AXES:
        return False
    place = OFFSETS[base] + AXES.index(axis)
    if channel.rigid is not None:
        flags = driven_bodies(deck).get(channel.rigid)
        return flags is not None and bool(flags[place])
    nodes = nodes_of(deck)
    if channel.node is not None and channel.contact is None:
        return bool(driven(deck, nodes)[nodes.ids == channel.node, place].any())
    if isinstance(channel.centre, int):
        rows = nodes_of_parts(deck, nodes, {channel.centre})
        return bool(rows.size) and bool(driven(deck, nodes)[rows, place].all())
    return False


def _is_fixed_wall(deck: Deck, number: int) -> bool:
    """Whether a wall, by its ID or its place among the walls, does not move."""
    walls = [entry for entry in deck.entries if entry.keyword.name.startswith(WALL)]
    found = [wall for wall in walls if wall.values.get("id") == number] or walls[number - 1 : number]
    return bool(found) and "MOVING" not in found[0].keyword.name
