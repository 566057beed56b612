"""The key of the picture: each kind of entity, how many of it there are, and the body load."""

import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np

from vmharness.mesh.view import View
from vmharness.report.figures.characters import unit as raised
from vmharness.report.figures.key import SAMPLE, Entry, sample
from vmharness.report.figures.model.arrows import CORNER, draw_arrow, unit
from vmharness.report.figures.model.frame import ISOMETRIC
from vmharness.report.figures.model.style import (
    BEAM,
    BODY,
    CENTRE,
    CONTACT,
    DAMPER,
    INITIAL,
    JOINT,
    LOAD,
    MASS,
    MOVE,
    PLANE,
    SEGMENT,
    SHELL,
    SPRING,
    SUPPORT,
)
from vmharness.report.figures.note import width

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEFT, GAP = 10.0, 8.0  # points
LINE, BETWEEN = 11.7, 10.0  # points: a line of text, and the room between entries
LETTERS = 19  # of a line


def entries(view: View, acceleration: str) -> list[Entry]:
    """The entries of the key, from the top."""
    tracked = sum(nodes.size for nodes, _ in view.contacts)
    segments = sum(segments.shape[0] for _, segments in view.contacts)
    held = np.intersect1d(view.supports, view.rows).size
    dampers = int(view.discrete.damper.sum())
    springs = len(view.discrete.nodes) - dampers
    centres = sum(body.centre is not None and not body.fixed for body in view.bodies)
    found = [
        (view.masses.size, _counted(view.masses.size, "mass element"), MASS),
        (view.shells.shape[0], _counted(view.shells.shape[0], "shell element"), SHELL),
        (len(view.solids), _counted(len(view.solids), "solid element"), SHELL),
        (len(view.beams), _counted(len(view.beams), "beam element"), BEAM),
        (springs, _counted(springs, "spring"), SPRING),
        (dampers, _counted(dampers, "damper"), DAMPER),
        (len(view.bodies), _counted(len(view.bodies), "rigid body"), BODY),
        (centres, "centre of mass", CENTRE),
        (len(view.joints), _counted(len(view.joints), "joint"), JOINT),
        (len(view.walls), _counted(len(view.walls), "rigid wall"), PLANE),
        (held, _counted(held, "supported node"), SUPPORT),
        (
            tracked,
            f"contact: {_counted(tracked, 'node')}\non {_counted(segments, 'segment')}",
            CONTACT | SEGMENT,
        ),
        *(
            (len(at), f"{what} at {_counted(len(at), 'place')}", _arrow(LOAD))
            for what, (at, _) in view.arrows.items()
            if what not in INITIAL
        ),
        *((1, what, _arrow(MOVE, heads)) for what, heads in INITIAL.items() if what in view.arrows),
        (np.any(view.gravity), _body_load(view, acceleration), _arrow(LOAD, along=tuple(view.gravity))),
    ]
    return [(_wrapped(label), style) for count, label, style in found if count]


def right_edge(found: list[Entry]) -> float:
    """The right edge of the key, in points; at least that of the directions below it."""
    lines = [line for label, _ in found for line in label.split("\n")]
    return max(2.0 * CORNER[0], LEFT + SAMPLE + 8.0 + max((width(line) for line in lines), default=0.0)) + GAP


def _arrow(colour: str, heads: int = 1, along: tuple[float, ...] = (1.0, -1.0, 0.0)) -> dict[str, Any]:
    """An arrow of the key in the direction `along` in space: by default to the right."""
    return {"arrow": {"colour": colour, "heads": heads}, "along": along}


def draw_key(axes: "Axes", found: list[Entry], top: float) -> None:
    """Write the entries from `top` downward."""
    y = top
    for label, style in found:
        lines = label.count("\n") + 1
        middle = y - 0.5 * LINE * lines
        if "arrow" in style:
            along = np.array(style["along"])
            half = 0.5 * SAMPLE * unit(ISOMETRIC @ along / np.linalg.norm(along))
            at = np.array([LEFT + 0.5 * SAMPLE, middle])
            draw_arrow(axes, at - half, at + half, **style["arrow"])
            style = {"linestyle": "none"}
        sample(axes, label, style, LEFT, middle)
        y -= LINE * lines + BETWEEN


def _body_load(view: View, acceleration: str) -> str:
    """The body load, a line for each of its components."""
    pulls = [
        f"{axis}: {value:+.6g} {raised(acceleration)}".replace("-", "−")
        for axis, value in zip("xyz", view.gravity, strict=True)
        if value
    ]
    return "\n".join(["body load", *pulls])


def _wrapped(label: str) -> str:
    return "\n".join(part for line in label.split("\n") for part in textwrap.wrap(line, LETTERS))


def _counted(count: int, what: str) -> str:
    several = what.removesuffix("y") + "ies" if what.endswith("y") else f"{what}s"
    return f"{count} {what if count == 1 else several}"
