"""Planar rigid walls of a deck, as figures show them."""

from dataclasses import dataclass

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.rigidwall import KEYWORDS
from vmharness.mesh.nodes import Array, Index, Nodes
from vmharness.mesh.sets import node_set


@dataclass(frozen=True)
class Wall:
    """A planar rigid wall; it is infinite where it has no edges."""

    number: int  # its ID, or its place among the walls
    name: str
    at: Array  # (3,) tail of the normal, a corner of a finite wall
    normal: Array  # (3,) of length 1, toward the nodes
    edges: Array | None  # (2, 3) from the corner
    nodes: Index  # rows of the nodes that it acts on
    velocity: float | None  # along the normal at t = 0; None for a wall that stands


def walls(deck: Deck, nodes: Nodes) -> list[Wall]:
    """The walls in the order of the deck; raises DeckError for a normal or an edge without a direction."""
    entries = [entry for entry in deck.entries if entry.keyword in KEYWORDS]
    return [_wall(deck, nodes, entry, place) for place, entry in enumerate(entries, 1)]


def _wall(deck: Deck, nodes: Nodes, entry: Entry, place: int) -> Wall:
    tail = np.array([entry.xt, entry.yt, entry.zt])
    normal = _unit(entry, "xh", np.array([entry.xh, entry.yh, entry.zh]) - tail)
    return Wall(
        entry.id or place,
        entry.heading,
        tail,
        normal,
        _edges(entry, tail, normal) if "lenl" in entry.values else None,
        node_set(deck, nodes, entry, "nsid") if entry.nsid else np.arange(nodes.ids.size),
        entry.v0 if "v0" in entry.values else None,
    )


def _edges(entry: Entry, tail: Array, normal: Array) -> Array:
    """Edge l across the normal, toward HEV, and edge m = n x l."""
    toward = np.array([entry.xhev, entry.yhev, entry.zhev]) - tail
    first = _unit(entry, "xhev", toward - (toward @ normal) * normal)
    return np.array([entry.lenl * first, entry.lenm * np.cross(normal, first)])


def _unit(entry: Entry, field: str, vector: Array) -> Array:
    length = float(np.linalg.norm(vector))
    if length == 0.0:
        raise entry.error(field, "the direction from the tail (XT, YT, ZT) has no length")
    return vector / length
