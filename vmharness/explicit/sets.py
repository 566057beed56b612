"""Sets of the deck: nodes as rows of the state's arrays, parts as numbers."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.element_shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.set_node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.set_part import SET_PART_LIST
from vmharness.explicit.model import Model

Index = NDArray[np.intp]


def node_set(deck: Deck, model: Model, entry: Entry, field: str) -> Index:
    """Rows (m,) of the node set that `field` of `entry` names, each once, in increasing order."""
    keywords = (SET_NODE_LIST, SET_NODE_LIST_GENERATE, SET_NODE_GENERAL)
    found = deck.find(*keywords, sid=getattr(entry, field), referred_by=(entry, field))
    if found.keyword is SET_NODE_LIST:
        rows = [model.row(found, "nodes", nid, i) for i, nid in enumerate(found.nodes)]
    elif found.keyword is SET_NODE_LIST_GENERATE:
        rows = _ranges(model, found)
    else:
        rows = _general(deck, model, found)
    return np.unique(np.array(rows, np.intp))


def part_set(deck: Deck, entry: Entry, field: str) -> set[int]:
    """Numbers of the parts in the part set that `field` of `entry` names."""
    return set(deck.find(SET_PART_LIST, sid=getattr(entry, field), referred_by=(entry, field)).parts.tolist())


def _ranges(model: Model, found: Entry) -> list[int]:
    """Nodes with a number in any of the ranges; numbers that no node has are passed over, as LS-DYNA does."""
    if found.ranges.size % 2:
        raise found.error("ranges", "ranges come in pairs, first and last", found.ranges.size - 1)
    chosen = np.zeros(model.ids.size, bool)
    for first, last in found.ranges.reshape(-1, 2):
        chosen |= (model.ids >= first) & (model.ids <= last)
    return np.flatnonzero(chosen).tolist()


def _general(deck: Deck, model: Model, found: Entry) -> list[int]:
    rows: list[int] = []
    for i, option in enumerate(found.option):
        members = [int(getattr(found, f"e{k}")[i]) for k in range(1, 8)]
        members = [member for member in members if member]
        if option == "ALL":
            rows += range(model.ids.size)
        elif option == "NODE":
            rows += [model.row(found, "e1", nid, i) for nid in members]
        else:
            rows += _nodes_of_parts(deck, model, set(members))
    return rows


def _nodes_of_parts(deck: Deck, model: Model, pids: set[int]) -> list[int]:
    rows: list[int] = []
    for table in deck.all(ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS):
        for row in np.flatnonzero(np.isin(table.pid, list(pids))):
            rows += [
                model.row(table, name, getattr(table, name)[row], int(row))
                for name in ("n1", "n2", "n3", "n4")
            ]
    return rows
