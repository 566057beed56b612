"""Sets of the deck: nodes as rows, parts as numbers."""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.set.node import SET_NODE_GENERAL, SET_NODE_LIST, SET_NODE_LIST_GENERATE
from vmharness.deck.keywords.set.part import SET_PART_LIST
from vmharness.mesh.nodes import Index, Nodes


def node_set(deck: Deck, nodes: Nodes, entry: Entry, field: str, row: int | None = None) -> Index:
    """Rows (m,) of the node set that `field` of `entry` names (in row `row` of a list), each once, increasing.

    Raises DeckError where the set is not defined, is ill-formed, or has no node.
    """
    keywords = (SET_NODE_LIST, SET_NODE_LIST_GENERATE, SET_NODE_GENERAL)
    number = getattr(entry, field) if row is None else int(getattr(entry, field)[row])
    place = (entry, field) if row is None else (entry, field, row)
    found = deck.find(*keywords, sid=number, referred_by=place)
    rows = _members(deck, nodes, found)
    if not rows.size:
        what = f"node set {found.sid} has no node of the deck; see {found.file}:{found.line}"
        raise entry.error(field, what, row)
    return rows


def part_set(deck: Deck, entry: Entry, field: str) -> set[int]:
    """Numbers of the parts in the part set that `field` of `entry` names."""
    return set(deck.find(SET_PART_LIST, sid=getattr(entry, field), referred_by=(entry, field)).parts.tolist())


def _members(deck: Deck, nodes: Nodes, found: Entry) -> Index:
    """Rows (m,) of the nodes of a node set."""
    if found.keyword is SET_NODE_LIST:
        return np.unique(nodes.find(found, "nodes", found.nodes))
    if found.keyword is SET_NODE_LIST_GENERATE:
        return _ranges(nodes, found)
    return np.unique(np.concatenate([_general(deck, nodes, found, row) for row in range(found.option.size)]))


def nodes_of_parts(deck: Deck, nodes: Nodes, pids: set[int]) -> Index:
    """Rows (m,) of all nodes that elements of these parts join, each once, in increasing order."""
    rows = [
        nodes.find(table, name, getattr(table, name)[np.isin(table.pid, list(pids))], True)
        for table in deck.entries
        for name in table.keyword.corners
    ]
    found = np.unique(np.concatenate(rows)) if rows else np.zeros(0, np.intp)
    return found[found >= 0]  # without the ground


def _ranges(nodes: Nodes, found: Entry) -> Index:
    """Nodes with a number in any of the ranges; numbers that no node has are passed over, as LS-DYNA does."""
    chosen = np.zeros(nodes.ids.size, bool)
    for pair, (first, last) in enumerate(found.ranges.reshape(-1, 2).tolist()):
        if not 0 < first <= last:
            what = f"a range {first} to {last}: give the first number, then the last; both are positive"
            raise found.error("ranges", what, 2 * pair)
        chosen |= (nodes.ids >= first) & (nodes.ids <= last)
    return np.flatnonzero(chosen)


def _general(deck: Deck, nodes: Nodes, found: Entry, row: int) -> Index:
    """Nodes of one line of *SET_NODE_GENERAL; raises DeckError where one of its members has none."""
    if found.option[row] == "ALL":
        return np.arange(nodes.node_count)
    members = [(f"e{k}", int(getattr(found, f"e{k}")[row])) for k in range(1, 8)]
    members = [(name, number) for name, number in members if number]
    if not members:
        raise found.error("option", "the numbers that belong to it are missing", row)
    if found.option[row] == "NODE":
        return np.array([nodes.row(found, name, number, row) for name, number in members], np.intp)
    rows = [nodes_of_parts(deck, nodes, {number}) for _, number in members]
    for (name, _), own in zip(members, rows, strict=True):
        if not own.size:
            raise found.error(name, "no element of the deck belongs to this part", row)
    return np.concatenate(rows)
