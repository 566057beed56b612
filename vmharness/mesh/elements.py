"""Corners of the elements of a deck, as rows of its nodes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, Keyword
from vmharness.deck.keywords.element.shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.mesh.nodes import Index, Nodes


@dataclass(frozen=True)
class Elements:
    """Columns over elements (ne,) of one kind."""

    eid: NDArray[np.int64]
    pid: NDArray[np.int64]  # of the part
    nodes: Index  # (ne, corners); -1 is the ground

    def only(self, chosen: NDArray[np.bool_] | Index) -> "Elements":
        """The chosen ones."""
        return Elements(self.eid[chosen], self.pid[chosen], self.nodes[chosen])


def elements(deck: Deck, nodes: Nodes, corners: int, *keywords: Keyword) -> Elements:
    """All elements of these keywords, in the order of the deck."""
    tables = deck.all(*keywords)
    none = np.zeros(0, np.int64)
    return Elements(
        np.concatenate([none, *(table.eid for table in tables)]),
        np.concatenate([none, *(table.pid for table in tables)]),
        np.concatenate([
            np.zeros((0, corners), np.intp),
            *(nodes.corners(table, table.keyword.corners, ground=True) for table in tables),
        ]),
    )  # fmt: skip


def by_part(found: Elements) -> Elements:
    """The elements part by part, in the order of the parts' first elements."""
    _, first, part = np.unique(found.pid, return_index=True, return_inverse=True)
    return found.only(np.argsort(first[part], kind="stable"))


def shells(deck: Deck, nodes: Nodes) -> Elements:
    """All shells: those of four corners part by part, then the triangles, whose third corner comes twice."""
    found = by_part(elements(deck, nodes, 4, ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS))
    third, fourth = found.nodes[:, 2:].T
    triangle = (fourth == third) | (fourth < 0)
    found.nodes[triangle, 3] = third[triangle]
    return found.only(np.argsort(triangle, kind="stable"))
