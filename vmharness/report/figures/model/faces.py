"""Faces of shells, solids and rigid bodies, painted from far to near."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.faces import area_vectors, faces_of_solids, outside
from vmharness.mesh.view import View
from vmharness.report.figures.model.frame import VIEWER, Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import EDGE, FACE, MANY, RIGID, RIGID_EDGE
from vmharness.round_off import ROUND_OFF, ordered

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Index = NDArray[np.intp]

SEVERAL = 200  # faces whose edges labels avoid; among more they have no better place


def draw_faces(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """All faces that can be seen; those of rigid bodies in their own shade."""
    from matplotlib.collections import PolyCollection

    rigid = [body.faces for body in view.bodies]
    faces = np.concatenate([_before(view), view.shells, *rigid])
    if not faces.size:
        return
    deformable = np.arange(len(faces)) < len(faces) - sum(map(len, rigid))
    order = far_first(faces, view.x, VIEWER)
    corners = frame.at(view.x[faces[order]])
    for corner in corners[:SEVERAL]:
        labels.avoid_line(corner[[0, 1, 2, 3, 0]])
    axes.add_collection(
        PolyCollection(
            list(corners),
            facecolors=[FACE if deformable[face] else RIGID for face in order],
            edgecolors=[EDGE if deformable[face] else RIGID_EDGE for face in order],
            linewidths=0.4 if len(faces) > MANY else 1.2,
            zorder=1,
        )
    )


def _before(view: View) -> Index:
    """The outer faces of solids whose outward normals point at the eye; the others are hidden behind them."""
    faces, _ = faces_of_solids(view.solids)
    faces = faces[outside(faces)]
    area = area_vectors(view.x[faces])
    return faces[area @ VIEWER > ROUND_OFF * np.linalg.norm(area, axis=1)]


def far_first(faces: Index, x: NDArray[np.float64], viewer: NDArray[np.float64]) -> list[int]:
    """The faces in the order of painting: their middles by the direction `viewer` (3,) toward the eye.

    Those as far as each other keep their order.
    """
    depth = (x[faces].mean(axis=1) @ viewer).tolist()
    least = ROUND_OFF * float(np.abs(x).max(initial=0.0))
    return ordered(range(len(faces)), depth.__getitem__, least)
