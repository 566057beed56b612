"""Faces for contact: all shells and all faces of solids, with what a penalty contact takes from their elements.

    shell   k = K A / d     d the longer diagonal, of a triangle the longest side
    solid   k = K A^2 / V   A of the face, V of the solid

K = E / (3 (1 - 2 nu)) is the bulk modulus; k is the stiffness before scale factors. (LS-DYNA theory manual, penalty
method.) A rigid part has E and PR of its material for this alone.
"""

from collections.abc import Iterator
from dataclasses import dataclass, fields

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck
from vmharness.explicit.elements.shell import shell_parts, thickness
from vmharness.explicit.elements.solid import ELFORMS, solid_parts, volume
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part
from vmharness.explicit.state import Array, Index
from vmharness.mesh.faces import area_vectors, faces_of_solids
from vmharness.mesh.surface import Faces, exterior


@dataclass(frozen=True)
class ContactFaces(Faces):
    """Columns over faces (n,); the normal of a solid's points outward."""

    penalty: Array  # k before scale factors
    thickness: Array  # of a shell, 0 of a solid
    depth: Array  # of the element behind the face: a shell's thickness, V / A of a solid
    rigid: NDArray[np.bool_]  # of *MAT_RIGID


def contact_faces(deck: Deck, model: Model) -> ContactFaces:
    """Every shell, and every face of every solid, also where two solids share it."""
    blocks = [*_shells(deck, model), *_solids(deck, model)]
    if not blocks:
        nodes, flags, numbers, values = (
            np.zeros((0, 4), np.intp),
            np.zeros(0, bool),
            np.zeros(0, int),
            np.zeros(0),
        )
        return ContactFaces(nodes, flags, numbers, numbers, values, values, values, flags)
    columns = [[getattr(block, column.name) for block in blocks] for column in fields(ContactFaces)]
    return ContactFaces(*(np.concatenate(column) for column in columns))


def _shells(deck: Deck, model: Model) -> Iterator[ContactFaces]:
    for corners in (4, 3):
        for part in shell_parts(deck, model, corners):
            nodes, t = part.nodes[:, [0, 1, 2, corners - 1]], thickness(part)
            x = model.x0[nodes]
            stiffness = bulk_modulus(part) * area(x) / diagonals(x).max(axis=1)
            yield _of_part(part, nodes, stiffness, t, t, np.arange(part.eid.size), shell=True)


def _solids(deck: Deck, model: Model) -> Iterator[ContactFaces]:
    for elform in ELFORMS:
        for part in solid_parts(deck, model, elform):
            nodes, solid = faces_of_solids(part.nodes)
            depth = volume(part, model.x0)[solid] / area(model.x0[nodes])
            stiffness = bulk_modulus(part) * area(model.x0[nodes]) / depth
            yield _of_part(part, nodes, stiffness, np.zeros(solid.size), depth, solid, shell=False)


def _of_part(
    part: Part, nodes: Index, penalty: Array, thickness: Array, depth: Array, element: Index, shell: bool
) -> ContactFaces:
    count = element.size
    return ContactFaces(
        nodes, np.full(count, shell), np.full(count, part.pid), part.eid[element],
        penalty, thickness, depth, np.full(count, part.rigid),
    )  # fmt: skip


def bulk_modulus(part: Part) -> float:
    """K = E / (3 (1 - 2 nu)) of the part's material."""
    return part.moduli.bulk


def area(corners: Array) -> Array:
    """Area (n,) of faces with `corners` (n, 4, 3)."""
    return np.asarray(np.linalg.norm(area_vectors(corners), axis=1))


def diagonals(corners: Array) -> Array:
    """Both diagonals (n, 2) of faces with `corners` (n, 4, 3); of a triangle the longest side, twice."""
    first, second, side = (
        np.linalg.norm(corners[:, j] - corners[:, i], axis=1) for i, j in ((0, 2), (1, 3), (0, 1))
    )
    longest = np.maximum(np.maximum(first, second), side)
    triangle = (corners[:, 2] == corners[:, 3]).all(axis=1)
    return np.where(triangle[:, None], longest[:, None], np.column_stack([first, second]))


def nodal_penalty(every: ContactFaces, tracked: Index, nodes: int) -> Array:
    """The largest k (nt,) of the faces at each tracked node; infinite where it has none. The model has `nodes`."""
    largest = _largest(every, every.penalty, nodes)[tracked]
    return np.where(largest > 0.0, largest, np.inf)


def nodal_thickness(every: ContactFaces, thickness: Array, tracked: Index, nodes: int) -> Array:
    """The largest `thickness` (n,) of the faces at each tracked node (nt,), 0 where it has none."""
    return _largest(every, thickness, nodes)[tracked]


def nodal_area(every: ContactFaces, x: Array, tracked: Index) -> Array:
    """The tributary area (nt,): the node's share of shells and outer faces of solids; infinite where it has none."""
    outer = every.only(exterior(every))
    triangle = outer.nodes[:, 2] == outer.nodes[:, 3]
    share, total = area(x[outer.nodes]) / np.where(triangle, 3.0, 4.0), np.zeros(x.shape[0])
    for corner in range(4):
        there = slice(None) if corner < 3 else ~triangle
        np.add.at(total, outer.nodes[there, corner], share[there])
    return np.where(total[tracked] > 0.0, total[tracked], np.inf)


def own_faces(every: ContactFaces, tracked: Index) -> tuple[Index, Index]:
    """The outer faces at each tracked node, as `faces_at` gives them; those of shells also turned over."""
    outer = every.only(exterior(every))
    return faces_at(np.concatenate([outer.nodes, outer.nodes[outer.shell][:, [0, 3, 2, 1]]]), tracked)


def faces_at(nodes: Index, tracked: Index) -> tuple[Index, Index]:
    """Of faces with `nodes` (n, 4), those at each tracked node t: found[first[t] : first[t + 1]] (m, 4)."""
    place = np.full(max(nodes.max(initial=-1), tracked.max(initial=-1)) + 1, -1)
    place[tracked] = np.arange(tracked.size)
    distinct = np.ones(nodes.shape, bool)
    distinct[:, 3] = nodes[:, 2] != nodes[:, 3]
    face, corner = np.nonzero((place[nodes] >= 0) & distinct)
    at = place[nodes[face, corner]]
    order = np.argsort(at, kind="stable")
    return nodes[face[order]], np.searchsorted(at[order], np.arange(tracked.size + 1))


def _largest(every: ContactFaces, values: Array, nodes: int) -> Array:
    largest = np.zeros(nodes)
    np.maximum.at(largest, every.nodes, values[:, None])
    return largest
