"""Rigid bodies and their joints."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from vmharness.mesh.bodies import Body
from vmharness.mesh.view import View
from vmharness.report.figures.model.arrows import SHORT
from vmharness.report.figures.model.frame import ISOMETRIC, Frame
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.style import (
    CENTRE,
    INK,
    JOINT,
    LINK,
    MANY,
    RIGID,
    RIGID_EDGE,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = NDArray[np.float64]


def draw_bodies(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """Beams of rigid bodies, or lines to their nodes, or the outline of many; then the centre of mass with the name."""
    from matplotlib.collections import LineCollection

    for body in view.bodies:
        if body.fixed:
            continue  # drawn as a support
        lines = list(frame.at(_lines(view, body)))
        axes.add_collection(
            LineCollection(lines, zorder=2, colors=LINK["color"], linewidths=LINK["linewidth"])
        )
        for line in lines:
            labels.avoid_line(line)
        if not body.faces.size and not lines:
            corners = outline(frame.at(view.x[body.nodes]))
            axes.fill(*corners.T, facecolor=RIGID, edgecolor=RIGID_EDGE, linewidth=1.2, zorder=1.2)
            labels.avoid_line(np.concatenate([corners, corners[:1]]))
        if body.centre is not None:
            axes.plot(*frame.at(body.centre), zorder=5.5, **CENTRE)
            labels.avoid_mark(frame.at(body.centre), 5.0)


def name_bodies(view: View, frame: Frame, labels: Labels) -> None:
    """Write the name of each body that moves beside its centre."""
    for body in view.bodies:
        if not body.fixed:
            at = view.x[body.nodes].mean(axis=0) if body.centre is None else body.centre
            labels.place(body.name or f"rigid body {body.number}", frame.at(at)[None], 5.0, color=INK)


def _lines(view: View, body: Body) -> Array:
    """Lines (n, 2, 3) of a body: its beams; without elements those from the centre to its nodes, if they are few."""
    if body.lines.size:
        return view.x[body.lines]
    if body.faces.size or body.nodes.size > MANY:
        return np.zeros((0, 2, 3))
    nodes = view.x[body.nodes]
    centre = nodes.mean(axis=0) if body.centre is None else body.centre
    return np.stack([np.broadcast_to(centre, nodes.shape), nodes], axis=1)


def outline(points: Array) -> Array:
    """The corners (n, 2) of the convex hull of points, counter-clockwise (Andrew 1979).

    >>> outline(np.array([[0.0, 0], [2, 0], [1, 1], [2, 2], [0, 2]])).tolist()
    [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]
    """
    ordered = sorted(set(map(tuple, np.round(points, 3).tolist())))
    halves = []
    for half in (ordered, ordered[::-1]):
        corners: list[tuple[float, ...]] = []
        for point in half:
            while len(corners) > 1 and _turn(corners[-2], corners[-1], point) <= 0.0:
                corners.pop()
            corners.append(point)
        halves += corners[:-1] or corners
    return np.array(halves)


def _turn(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...]) -> float:
    """Positive where the way from a over b to c turns left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def draw_joints(axes: "Axes", view: View, frame: Frame, labels: Labels) -> None:
    """A ring for each joint with its name, and a line along the axis of a revolute one."""
    for joint in view.joints:
        at = frame.at(view.x[joint.node])
        if joint.axis is not None:
            along = SHORT * ISOMETRIC @ joint.axis / (np.linalg.norm(joint.axis) or 1.0)
            line = np.array([at - along, at + along])
            axes.plot(*line.T, color=INK, linewidth=1.0, linestyle=(0, (6, 2, 1, 2)), zorder=5.8)
            labels.avoid_line(line)
        axes.plot(*at, zorder=6, **JOINT)
        labels.avoid_mark(at, 5.0)
        labels.place(joint.name, at[None], 5.0, color=INK)
