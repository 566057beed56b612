"""The picture of a model, of every case: it fills its figure, and no text lies on another or is cut."""

import re
from functools import cache
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath

from vmharness.case import read
from vmharness.case.deck import read_deck
from vmharness.deck import read as read_text
from vmharness.deck import vocabulary
from vmharness.mesh.view import view_of
from vmharness.report.figures import model
from vmharness.report.figures.model.entries import entries, right_edge
from vmharness.report.figures.model.frame import Box, fit
from vmharness.report.figures.model.walls import patch

CASES = Path(__file__).parents[2] / "cases"
IDS = sorted(path.parent.name for path in CASES.glob("*/case.toml"))
SVG = "{http://www.w3.org/2000/svg}"
WIDTH, HEIGHT = 6.6 * 72, 3.6 * 72


@cache
def view(id):
    return view_of(read_deck(read(CASES / id)))


@cache
def drawing(id):
    return ElementTree.fromstring(model.draw(view(id), id, "m/s2"))


def texts(id):
    """The text of each line, and the box of its ink as the font of the tests draws it."""
    found = []
    for element in drawing(id).iter(f"{SVG}text"):
        style = dict(part.split(": ") for part in element.get("style").split("; "))
        font = FontProperties(
            family="DejaVu Sans",
            size=9,
            weight=style.get("font-weight", "normal"),
            style=style.get("font-style", "normal"),
        )
        ink = TextPath((0, 0), element.text, prop=font).get_extents()
        x, y = float(element.get("x")), HEIGHT - float(element.get("y"))
        if style["text-anchor"] == "middle":
            x -= 0.5 * ink.x1
        found.append((element.text, Box(x + ink.x0, y + ink.y0, x + ink.x1, y + ink.y1)))
    return found


@pytest.mark.parametrize("id", IDS)
def test_no_text_lies_on_another_or_outside_the_figure(id):
    found = texts(id)
    assert found
    for text, box in found:
        assert box.inside(Box(0.0, 0.0, WIDTH, HEIGHT)), text
    for (one, first), (other, second) in combinations(found, 2):
        assert not first.meets(second), f"{one!r} lies on {other!r}"


@pytest.mark.parametrize("id", IDS)
def test_the_model_fills_the_figure(id):
    edge = right_edge(entries(view(id), "m/s2"))
    points = [(float(use.get("x")), float(use.get("y"))) for use in drawing(id).iter(f"{SVG}use")]
    for path in drawing(id).iter(f"{SVG}path"):
        points += [tuple(map(float, pair)) for pair in re.findall(r"[ML] (\S+) (\S+)", path.get("d"))]
    inside = [(x, y) for x, y in points if edge < x < WIDTH and 0 < y < HEIGHT]
    covered = np.ptp(np.array(inside), axis=0) / [WIDTH, HEIGHT]
    assert covered.max() >= 0.6


def test_the_picture_names_what_the_case_is_about():
    assert {"1 rigid body", "ball", "contact: 2000 nodes", "initial velocity"} <= {
        text for text, _ in texts("D-26")
    }
    assert {"spherical joint 1", "rod", "centre of mass"} <= {text for text, _ in texts("D-31")}
    assert {"wall 1 (right)", "wall 2 (left)", "2 rigid walls"} <= {text for text, _ in texts("D-70")}
    assert {"moving wall 1 (block)", "1 spring"} <= {text for text, _ in texts("VM-083")}
    assert {"wall 1 (stop)"} <= {text for text, _ in texts("VM-085")}
    assert {"wall 1"} <= {text for text, _ in texts("VM-265")}
    assert {"1 supported node", "40 beam elements"} <= {text for text, _ in texts("D-51-beam")}
    assert {"1 spring", "1 damper"} <= {text for text, _ in texts("VM-072")}


@pytest.mark.parametrize("id", ["D-20", "D-28-shell", "D-43", "VM-075"])
def test_every_node_of_a_small_model_has_its_number(id):
    shown = {int(word) for text, _ in texts(id) for word in re.findall(r"\b\d+\b", text)}
    assert set(view(id).ids[view(id).rows].tolist()) <= shown


def test_a_drawing_is_as_large_as_the_room_and_keeps_what_is_about_its_points():
    x = np.array([[0.0, 0, 0], [0, 0, 2.0]])
    low, high = np.array([[-5.0, -10], [-20, -5]]), np.array([[5.0, 5], [20, 30]])
    room = Box(100.0, 0.0, 300.0, 200.0)
    frame = fit(x, low, high, room)
    at = frame.at(x)
    assert (at + low)[:, 1].min() == pytest.approx(0.0, abs=1e-4)
    assert (at + high)[:, 1].max() == pytest.approx(200.0, abs=1e-4)
    assert (at + low)[:, 0].min() >= 100.0
    assert (at + high)[:, 0].max() <= 300.0


def test_the_patch_of_a_wall_lies_in_its_plane_before_the_nodes():
    (wall,) = view("VM-265").walls
    corners = patch(view("VM-265"), wall)
    assert corners[:, 0] == pytest.approx(10.01)
    assert corners[:, 1].min() < 0.0 < corners[:, 1].max()


MASS = "*KEYWORD\n*NODE\n7,1.0,2.0,3.0\n*ELEMENT_MASS\n1,7,2.0\n"
GROUNDED = """*ELEMENT_DISCRETE
3,1,7,0,4
*DEFINE_SD_ORIENTATION
4,0,0.0,0.0,1.0
*PART
spring
1,1,1
"""


def picture(tmp_path, text):
    (tmp_path / "deck.k").write_text(text)
    return model.draw(view_of(read_text(tmp_path / "deck.k", vocabulary())), "one", "m/s2")


def test_a_model_of_one_node_can_be_drawn(tmp_path):
    assert ">7</text>" in picture(tmp_path, MASS)


def test_a_spring_to_the_ground_stands_on_a_support(tmp_path):
    drawn = ElementTree.fromstring(picture(tmp_path, MASS + GROUNDED))
    assert "1 spring" in {text.text for text in drawn.iter(f"{SVG}text")}
    used = [(float(use.get("x")), float(use.get("y"))) for use in drawn.iter(f"{SVG}use")]
    (x,) = {x for x, _ in used if x > 0.3 * WIDTH}  # of the node, and of the ground below it
    node, ground = sorted({y for at, y in used if at == x})
    assert ground - node == pytest.approx(46.0, abs=0.02)
    assert ground < HEIGHT


HOSTILE = """*KEYWORD
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
*SET_NODE_LIST
9
1,2
*ELEMENT_SHELL
1,1,1,2,3,4
*PART
$NAME
1,1,1
*SECTION_SHELL
1,2
1.0
*MAT_RIGID
1,1.0,1.0,0.3
0
0.0
*RIGIDWALL_PLANAR_ID
1,NAME
9
0.0,0.0,0.0,-1.0,-1.0,1.0
*INITIAL_VELOCITY
0
-1.0,-1.0,1.0
*DEFINE_CURVE
1
0.0,9.81
1.0,9.81
*LOAD_BODY_X
1
*LOAD_BODY_Y
1
*LOAD_BODY_Z
1,-1.0
"""


@pytest.mark.parametrize(
    "name", ["a $x_1$ {", "$\\nosuch$", "a\x1b[2Jb", "<b>&amp;", "球体", "n" * 70, "word " * 14]
)
def test_a_name_is_shown_as_it_is_and_what_points_at_the_eye_is_drawn(tmp_path, name):
    text = picture(tmp_path, HOSTILE.replace("$NAME", f" {name}").replace("NAME", name))
    drawn = ElementTree.fromstring(text)
    shown = " ".join(element.text for element in drawn.iter(f"{SVG}text"))
    assert name.replace("\x1b", "\ufffd")[:8].strip() in shown
    assert "nan" not in text
    for element in drawn.iter(f"{SVG}text"):
        assert float(element.get("x")) < WIDTH
