"""Results that read only the deck's input: motions that it prescribes, and other names of the motion of their event."""

import numpy as np
from msgspec import structs

from vmharness.case import Case
from vmharness.case.format import Channel, Result
from vmharness.case.tautology import DERIVATIVES, tautology
from vmharness.deck import Deck
from vmharness.deck.keywords.part import PART, PART_CONTACT
from vmharness.mesh.driven import driven, driven_bodies
from vmharness.mesh.nodes import nodes_of
from vmharness.mesh.sets import nodes_of_parts
from vmharness.mesh.supports import supported

AXES = ("x", "y", "z")
OFFSETS = {"position": 0, "angle": 3}  # of the degrees of freedom of translation and rotation
WALL = "RIGIDWALL_PLANAR"


def own_input(case: Case, deck: Deck) -> list[str]:
    """Sentences on results whose value, or whose time, the deck gives and no solver computes.

    Raises DeckError where the deck refers to what it does not define.
    """
    given = {name for name, channel in case.file.channels.items() if is_given(deck, channel)}
    known = {result.key: _known(case, deck, result, given) for result in case.file.results}
    return [
        f"[results] {number}: {key}: {why}; this result cannot disagree with its target"
        for number, (key, why) in enumerate(known.items(), 1)
        if why
    ]


def _known(case: Case, deck: Deck, result: Result, given: set[str]) -> str:
    """Why a result is known before a run, or nothing; the deck gives the channels `given`."""
    event = case.file.events[result.event]
    read = event.of if result.channel == "time" else result.channel
    if read in given:
        return f"{read} is held or prescribed by the deck: read a force, or another place"
    if not event.of or result.channel == "time":
        return ""
    seen, other = (by_one_name(deck, case.file.channels[name]) for name in (event.of, read))
    why = tautology(event, seen, other)
    return f"{read} and {event.of} are the same quantity: {why}" if why else ""


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


def by_one_name(deck: Deck, channel: Channel) -> Channel:
    """The channel as that of a node or of the whole model, where the deck makes these the same.

    So are the centre of mass of a single node that moves and that node, all supports and a single one, the energy of a
    single part and that of the model.
    """
    if channel.energy is not None:
        return structs.replace(channel, part=None) if len(deck.all(PART, PART_CONTACT)) == 1 else channel
    nodes = nodes_of(deck)
    if channel.support == "all":
        held = nodes.ids[supported(deck, nodes).any(axis=1)]
        return structs.replace(channel, support=int(held[0])) if held.size == 1 else channel
    axis, _, quantity = (channel.component or "").partition("-")
    if channel.centre is None or axis not in AXES or quantity not in DERIVATIVES:
        return channel
    rows = np.arange(nodes.ids.size)
    if isinstance(channel.centre, int):
        rows = nodes_of_parts(deck, nodes, {channel.centre})
    moving = nodes.ids[rows[~driven(deck, nodes)[rows, AXES.index(axis)]]]
    return structs.replace(channel, centre=None, node=int(moving[0])) if moving.size == 1 else channel


def _is_fixed_wall(deck: Deck, number: int) -> bool:
    """Whether a wall, by its ID or its place among the walls, does not move."""
    walls = [entry for entry in deck.entries if entry.keyword.name.startswith(WALL)]
    found = [wall for wall in walls if wall.values.get("id") == number] or walls[number - 1 : number]
    return bool(found) and "MOVING" not in found[0].keyword.name
