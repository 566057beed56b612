"""Parts of the deck: elements with their section, material and hourglass control."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from vmharness import dropins
from vmharness.deck import Deck, Entry, Keyword
from vmharness.deck.keywords.element_shell import ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section_shell import SECTION_SHELL
from vmharness.explicit.model import Model
from vmharness.explicit.state import Array

Index = NDArray[np.intp]


@dataclass(frozen=True)
class ShellPart:
    """The shells of one part."""

    part: Entry
    section: Entry
    material: Entry
    eid: NDArray[np.int64]  # (ne,)
    nodes: Index  # (ne, 4) rows of the state's arrays
    thickness: Array  # (ne,) mean of the nodal thicknesses


def material_keywords() -> list[Keyword]:
    """The *MAT_... that the folder of materials defines."""
    return [module.KEYWORD for module in dropins.modules("vmharness.explicit.materials")]


def shell_parts(deck: Deck, model: Model) -> Iterator[ShellPart]:
    """Every part that has shells, in the order of their first element."""
    tables = deck.all(ELEMENT_SHELL, ELEMENT_SHELL_THICKNESS)
    if not tables:
        return
    pids = np.concatenate([table.pid for table in tables])
    for pid in dict.fromkeys(pids.tolist()):
        owner = next(table for table in tables if pid in table.pid)
        part = deck.find(PART, pid=pid, referred_by=(owner, "pid"))
        section = deck.find(SECTION_SHELL, secid=part.secid, referred_by=(part, "secid"))
        material = deck.find(*material_keywords(), mid=part.mid, referred_by=(part, "mid"))
        blocks = [_shells(table, pid, section, model) for table in tables if pid in table.pid]
        eid, nodes, thickness = (np.concatenate(column) for column in zip(*blocks, strict=True))
        yield ShellPart(part, section, material, eid, nodes, thickness)


def _shells(table: Entry, pid: int, section: Entry, model: Model) -> tuple[NDArray[np.int64], Index, Array]:
    """Number, nodes and thickness of the shells of part `pid` in one table of elements."""
    chosen = np.flatnonzero(table.pid == pid)
    nodes = np.empty((chosen.size, 4), np.intp)
    for corner, name in enumerate(("n1", "n2", "n3", "n4")):
        ids = getattr(table, name)[chosen]
        nodes[:, corner] = [
            model.row(table, name, nid, int(row)) for nid, row in zip(ids, chosen, strict=True)
        ]
    for row, corners in zip(chosen, nodes, strict=True):
        if len(set(corners.tolist())) < 4:
            raise table.error(
                "n4", "a triangle; only quadrilaterals with four different nodes are supported", int(row)
            )
    if table.keyword is ELEMENT_SHELL_THICKNESS:
        own = np.column_stack([getattr(table, f"thic{i}")[chosen] for i in range(1, 5)])
    else:
        own = np.zeros((chosen.size, 4))
    t1 = section.t1
    usual = [t1, *(value if value > 0.0 else t1 for value in (section.t2, section.t3, section.t4))]
    thickness = np.where(own > 0.0, own, usual).mean(axis=1)
    if not np.all(thickness > 0.0):
        raise section.error("t1", "a shell needs a thickness greater than 0")
    return table.eid[chosen], nodes, thickness
