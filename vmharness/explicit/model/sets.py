"""Sets of the deck: nodes as rows of the state's arrays, parts as numbers."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.set.node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.set.part import SET_PART_LIST
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.state import Index
from vmharness.explicit.rigid.definitions import body_numbers


def node_set(deck: Deck, model: Model, entry: Entry, field: str) -> Index:
    """Rows (m,) of the node set that `field` of `entry` names, each once, in increasing order."""
    keywords = (SET_NODE_LIST, SET_NODE_LIST_GENERATE, SET_NODE_GENERAL)
    found = deck.find(*keywords, sid=getattr(entry, field), referred_by=(entry, field))
    if found.keyword is SET_NODE_LIST:
        return np.unique(model.find(found, "nodes", found.nodes))
    if found.keyword is SET_NODE_LIST_GENERATE:
        return _ranges(model, found)
    return np.unique(np.concatenate([_general(deck, model, found, row) for row in range(found.option.size)]))


def part_set(deck: Deck, entry: Entry, field: str) -> set[int]:
    """Numbers of the parts in the part set that `field` of `entry` names."""
    return set(deck.find(SET_PART_LIST, sid=getattr(entry, field), referred_by=(entry, field)).parts.tolist())


def nodes_of_parts(deck: Deck, model: Model, pids: set[int]) -> Index:
    """Rows (m,) of all nodes that elements of these parts join, each once, in increasing order."""
    rows = [
        model.find(table, name, getattr(table, name)[np.isin(table.pid, list(pids))], True)
        for table in deck.entries
        for name in table.keyword.corners
    ]
    found = np.unique(np.concatenate(rows)) if rows else np.zeros(0, np.intp)
    return found[found >= 0]  # without the ground


def masses_of_parts(deck: Deck, model: Model, pids: set[int]) -> Index:
    """Rows (m,) of all nodes of these parts, and of the centres of the rigid bodies among them."""
    centres = [model.centre(number) for number in body_numbers(deck) if number in pids]
    return np.concatenate([nodes_of_parts(deck, model, pids), np.array(centres, np.intp)])


def _ranges(model: Model, found: Entry) -> Index:
    """Nodes with a number in any of the ranges; numbers without a node are ignored, as LS-DYNA does."""
    if found.ranges.size % 2:
        raise found.error("ranges", "ranges come in pairs, first and last", found.ranges.size - 1)
    chosen = np.zeros(model.ids.size, bool)
    for first, last in found.ranges.reshape(-1, 2):
        chosen |= (model.ids >= first) & (model.ids <= last)
    return np.flatnonzero(chosen)


def _general(deck: Deck, model: Model, found: Entry, row: int) -> Index:
    """Nodes of one line of *SET_NODE_GENERAL."""
    members = [int(getattr(found, f"e{k}")[row]) for k in range(1, 8)]
    members = [member for member in members if member]
    if found.option[row] == "ALL":
        return np.arange(model.node_count)
    if found.option[row] == "NODE":
        return np.array([model.row(found, "e1", nid, row) for nid in members], np.intp)
    return nodes_of_parts(deck, model, set(members))
