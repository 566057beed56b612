"""Trusses of ELFORM 3, in one of two forms.

Where both nodes are held across the truss, a brick C3D8 of square section: the node is a corner, the others follow it
along the truss, and the section stays a rectangle that is free to contract. A thick brick would have lateral inertia,
which a truss has not: its side is at most a tenth of its length, and its material so much stiffer, denser and stronger
that stiffness, mass and yield force are those of the truss. Elsewhere T3D2, if it is elastic: CalculiX
2.20 diverges where a T3D2 is plastic. Initial velocities do not reach a T3D2.

Poisson's ratio of an elastic truss is zero: its force does not depend on it, and without lateral motion there is no
lateral inertia.
"""

import numpy as np

from vmharness.backends.calculix.materials import of
from vmharness.backends.calculix.model import Lines, Model, real
from vmharness.deck import Entry
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC

SLENDER = 0.1  # side of a brick over its length
STRAIGHT = 1e-9  # of its length, by which a truss may deviate from an axis


def add(
    model: Model, entry: Entry, row: int, ends: np.ndarray, section: Entry, material: Entry
) -> tuple[str, Lines]:
    """Add the truss in a row of *ELEMENT_BEAM; return the name of its element set, and the section of that."""
    axis, pid, eid = _axis(model, ends), int(entry.pid[row]), int(entry.eid[row])
    if axis is not None:
        first, second = sorted(ends.tolist(), key=lambda end: float(model.nodes.x0[end, axis]))
        side = _side(model.length(first, second), section.a)
        law = of(model, material, "BAR", section.a / side**2)
        numbers = [*_section(model, first, axis, side), *_section(model, second, axis, side)]
        name = f"BAR{pid}{law}"
        model.add(entry.keyword, eid, "C3D8", name, ends.tolist(), numbers, side**2 / section.a)
        model.work += 0.25  # most of its degrees of freedom are tied
        return name, [f"*SOLID SECTION,ELSET={name},MATERIAL={law}"]
    if material.keyword is not MAT_ELASTIC:
        what = "calculix: a plastic truss must be parallel to an axis, and its nodes held across it"
        raise entry.error("pid", what, row)
    name = f"TRUSS{pid}"
    model.add(entry.keyword, eid, "T3D2", name, ends.tolist())
    model.expanded[ends] = True
    model.work += 1.0
    model.kicked = True
    head = f"*SOLID SECTION,ELSET={name},MATERIAL={of(model, material, 'BAR')}"
    return name, [head, real(section.a)]


def _axis(model: Model, ends: np.ndarray) -> int | None:
    """The axis to which a truss is parallel, if its nodes are held across it."""
    vector = np.abs(model.nodes.x0[ends[1]] - model.nodes.x0[ends[0]])
    axis = int(vector.argmax())
    across = [(axis + 1) % 3, (axis + 2) % 3]
    parallel = (vector[across] <= STRAIGHT * vector[axis]).all()
    return axis if parallel and model.held[ends][:, across].all() else None


def _side(length: float, area: float) -> float:
    """The side of the brick, in three digits: equal trusses, whose lengths differ by round-off, have equal bricks."""
    return min(float(np.sqrt(area)), float(f"{SLENDER * length:.3g}"))


def _section(model: Model, row: int, axis: int, side: float) -> list[int]:
    """The four corners of a section at a node, which are added once.

    Along the truss all move alike. Across it the corners (0, 0), (1, 0), (1, 1), (0, 1) of p and q move in pairs.
    """
    known = model.corners.setdefault(row, {})
    if side not in known:
        p, q = (axis + 1) % 3, (axis + 2) % 3
        known[side] = [model.nodes.ids.size + len(model.added) + k for k in (1, 2, 3)]
        for along_p, along_q in ((1, 0), (1, 1), (0, 1)):
            place = model.nodes.x0[row].copy()
            place[[p, q]] += side * along_p, side * along_q
            model.added.append(place)
        node, (right, far, left) = row + 1, known[side]
        alike = [(right, node, axis), (far, node, axis), (left, node, axis)]
        alike += [(right, node, q), (far, left, q), (left, node, p), (far, right, p)]
        for follows, leads, dof in alike:
            model.equations += ["*EQUATION", "2", f"{follows},{dof + 1},1.,{leads},{dof + 1},-1."]
    return [row + 1, *known[side]]
