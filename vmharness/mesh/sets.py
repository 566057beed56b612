"""Sets of the deck: nodes as rows, parts as numbers."""

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Entry, Keyword
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.set.node import (
    SET_NODE_ADD,
    SET_NODE_COLUMN,
    SET_NODE_GENERAL,
    SET_NODE_LIST,
    SET_NODE_LIST_GENERATE,
)
from vmharness.deck.keywords.set.part import SET_PART_ADD, SET_PART_LIST, SET_PART_LIST_GENERATE
from vmharness.mesh.nodes import Index, Nodes

NODE_SETS = (SET_NODE_LIST, SET_NODE_LIST_GENERATE, SET_NODE_GENERAL, SET_NODE_COLUMN, SET_NODE_ADD)
PART_SETS = (SET_PART_LIST, SET_PART_LIST_GENERATE, SET_PART_ADD)


def node_set(deck: Deck, nodes: Nodes, entry: Entry, field: str, row: int | None = None) -> Index:
    """Rows (m,) of the node set that `field` of `entry` names (in row `row` of a list), each once, increasing.

    Raises DeckError where the set is not defined, is ill-formed, or has no node.
    """
    number = getattr(entry, field) if row is None else int(getattr(entry, field)[row])
    place = (entry, field) if row is None else (entry, field, row)
    found = deck.find(*NODE_SETS, sid=number, referred_by=place)
    rows = _members(deck, nodes, found)
    if not rows.size:
        what = f"node set {found.sid} has no node of the deck; see {found.file}:{found.line}"
        raise entry.error(field, what, row)
    return rows


def part_set(deck: Deck, entry: Entry, field: str) -> set[int]:
    """Numbers of the parts in the part set that `field` of `entry` names; raises DeckError where it has none."""
    found = deck.find(*PART_SETS, sid=getattr(entry, field), referred_by=(entry, field))
    parts = parts_of_set(deck, found)
    if not parts:
        raise entry.error(
            field, f"part set {found.sid} has no part of the deck; see {found.file}:{found.line}"
        )
    return parts


def parts_of_set(deck: Deck, found: Entry) -> set[int]:
    """Numbers of the parts of a part set."""
    if found.keyword is SET_PART_LIST:
        return set(found.parts.tolist())
    if found.keyword is SET_PART_LIST_GENERATE:
        pids = np.array([part.pid for part in deck.all(PART)], np.int64)
        return set(pids[in_ranges(found, pids)].tolist())
    return {pid for one in _added(deck, found, PART_SETS) for pid in parts_of_set(deck, one)}


def _members(deck: Deck, nodes: Nodes, found: Entry) -> Index:
    """Rows (m,) of the nodes of a node set."""
    if found.keyword in (SET_NODE_LIST, SET_NODE_COLUMN):
        return np.unique(nodes.find(found, "nodes", found.nodes))
    if found.keyword is SET_NODE_LIST_GENERATE:  # numbers that no node has are passed over, as LS-DYNA does
        return np.flatnonzero(in_ranges(found, nodes.ids))
    if found.keyword is SET_NODE_ADD:
        added = [_members(deck, nodes, one) for one in _added(deck, found, NODE_SETS)]
        return np.unique(np.concatenate(added))
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


def _added(deck: Deck, found: Entry, keywords: tuple[Keyword, ...]) -> list[Entry]:
    """The sets that a set adds up, none of which adds others."""
    sets = [
        deck.find(*keywords, sid=number, referred_by=(found, "sets", row))
        for row, number in enumerate(found.sets.tolist())
    ]
    for row, one in enumerate(sets):
        if "sets" in one.values:
            raise found.error("sets", "adds up other sets itself, which is not supported here", row)
    return sets


def in_ranges(found: Entry, numbers: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Which `numbers` (n,) are in any of the ranges of a set; raises DeckError for what is no range."""
    chosen = np.zeros(numbers.size, bool)
    for pair, (first, last) in enumerate(found.ranges.reshape(-1, 2).tolist()):
        if not 0 < first <= last:
            what = f"a range {first} to {last}: give the first number, then the last; both are positive"
            raise found.error("ranges", what, 2 * pair)
        chosen |= (numbers >= first) & (numbers <= last)
    return chosen


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
