"""The model as read from the deck, in isometric view: what a case is about, to be seen before its numbers are read.

All is placed in points: `frame.py` finds the scale at which the model fills the canvas, `labels.py` places for labels.
"""

import numpy as np

from vmharness.mesh.view import View
from vmharness.report.figures import svg
from vmharness.report.figures.model.arrows import Arrow, arrows, draw_arrows, draw_directions
from vmharness.report.figures.model.bodies import draw_bodies, draw_joints, name_bodies
from vmharness.report.figures.model.entries import draw_key, entries, right_edge
from vmharness.report.figures.model.faces import draw_faces
from vmharness.report.figures.model.frame import Box, Frame, fit
from vmharness.report.figures.model.labels import Labels
from vmharness.report.figures.model.lines import draw_beams, draw_contacts
from vmharness.report.figures.model.marks import draw_marks, number_nodes
from vmharness.report.figures.model.springs import draw_discrete, to_ground
from vmharness.report.figures.model.walls import draw_walls, patch

SIZE = (6.6, 3.6)  # inches
POINT = 72.0  # points in an inch
BORDER = 4.0  # points
REACH = (10.0, 18.0)  # points that marks reach from a node, to the side, and up and down


def draw(view: View, case: str, acceleration: str) -> str:
    """SVG of the model: elements, rigid bodies, joints, walls, supports, contact, loads; accelerations in that unit."""
    from matplotlib.figure import Figure

    with svg.style(f"{case}-model"):
        figure = Figure(figsize=SIZE)
        width, height = (POINT * side for side in SIZE)
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, width), ylim=(0.0, height))
        axes.set_axis_off()
        key = entries(view, acceleration)
        room = Box(right_edge(key), BORDER, width - BORDER, height - BORDER)
        acting = list(arrows(view))
        frame, labels = _frame(view, acting, room), Labels(axes, room)
        draw_faces(axes, view, frame, labels)
        draw_contacts(axes, view, frame, labels)
        draw_beams(axes, view, frame, labels)
        draw_discrete(axes, view, frame, labels)
        draw_bodies(axes, view, frame, labels)
        draw_marks(axes, view, frame, labels)
        draw_arrows(axes, acting, frame, labels)
        draw_walls(axes, view, frame, labels)
        draw_joints(axes, view, frame, labels)
        name_bodies(view, frame, labels)
        number_nodes(view, frame, labels)
        draw_directions(axes)
        draw_key(axes, key, top=height - 10.0)
        return svg.text(figure, "The model as read from the deck, in isometric view")


def _frame(view: View, acting: list[Arrow], room: Box) -> Frame:
    """The scale at which nodes with their marks, centres of mass, walls, springs and arrows fill the room."""
    centres = [body.centre for body in view.bodies if body.centre is not None and not body.fixed]
    marks = np.array([[-REACH[0], -REACH[1]], REACH])
    grounded = view.discrete.nodes[:, 1] < 0
    places = [
        *((x, marks) for x in (*view.x[view.rows], *centres)),
        *((corner, BORDER * np.sign(marks)) for wall in view.walls for corner in patch(view, wall)),
        *((arrow.at, np.array([arrow.tail, arrow.head])) for arrow in acting),
        *(
            (view.x[first], to_ground(direction) + marks)
            for (first, _), direction in zip(
                view.discrete.nodes[grounded], view.discrete.direction[grounded], strict=True
            )
        ),
    ]
    x, ends = (np.array([place[k] for place in places]) for k in (0, 1))
    return fit(x, ends.min(axis=1), ends.max(axis=1), room)
