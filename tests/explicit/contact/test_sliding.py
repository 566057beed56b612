"""Flat sliding: a block on a plank loses v = mu g t and nothing else, whatever its edges sweep over.

The nodes of the plank lie in the penetration, just within the edges of the block: its leading faces reach them first.
"""

import itertools

import numpy as np
import pytest

from vmharness.explicit.build import build
from vmharness.explicit.energy import STORED, accounts
from vmharness.explicit.loop import steps

H, G, THICK = 0.05, 9.81, 0.01  # size of elements, gravity, thickness of shells
SPEED = 1.3


def place(cells, centre, turn):
    """Corners (n, 3) of a regular mesh of `cells` about the vertical axis of `centre`, turned; x runs fastest."""
    ranges = [H * np.arange(n + 1) - 0.5 * H * n * (axis < 2) for axis, n in enumerate(cells)]
    x = np.array([(a, b, c) for c, b, a in itertools.product(*reversed(ranges))])
    cosine, sine = np.cos(turn), np.sin(turn)
    return x @ np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]]) + centre


def elements(cells, first, pid):
    """Lines of the elements of such a mesh, shells where it is flat, whose nodes begin with `first`."""
    nx, ny, nz = cells
    for k, j, i in itertools.product(range(max(nz, 1)), range(ny), range(nx)):
        low = first + i + (nx + 1) * (j + (ny + 1) * k)
        high = low + (nx + 1) * (ny + 1)
        below, above = ([n, n + 1, n + nx + 2, n + nx + 1] for n in (low, high))
        yield ",".join(map(str, [low, pid, *below, *(above if nz else [])]))


def slide(planks, block, velocity, mu=0.0, kind="AUTOMATIC_SURFACE_TO_SURFACE", end=0.05, sides="2,1,2,2"):
    """A deck of planks and one block, each (cells, centre, turn, rigid); planks are held from below."""
    bodies = [*planks, block]
    text = f"*KEYWORD\n*CONTROL_TERMINATION\n{end}\n*CONTROL_TIMESTEP\n0,0.6\n*SECTION_SOLID\n1,1\n"
    text += f"*SECTION_SHELL\n2,2\n{THICK}\n*LOAD_BODY_Z\n1,{G}\n*DEFINE_CURVE\n1\n0,1\n1000,1\n"
    for number, (cells, centre, turn, rigid) in enumerate(bodies):
        held, first, solid = number < len(planks), 1 + 1000 * number, cells[2] > 0
        pid, x = number + 1, place(cells, centre, turn)
        text += f"*PART\nbody\n{pid},{1 if solid else 2},{pid}\n"
        text += f"*MAT_RIGID\n{pid},1000,1e8,0.3\n{'1,7,7' if held else '0'}\n\n" if rigid else ""
        text += "" if rigid else f"*MAT_ELASTIC\n{pid},1000,1e8,0.3\n"
        text += "*NODE\n" + "".join(
            f"{first + n},{a!r},{b!r},{c!r}\n" for n, (a, b, c) in enumerate(x.tolist())
        )
        lines = "\n".join(elements(cells, first, pid))
        text += f"*ELEMENT_{'SOLID' if solid else 'SHELL'}\n{lines}\n"
        if held and not rigid:
            lowest = first + np.flatnonzero(x[:, 2] < x[:, 2].min() + 0.5 * H)
            text += "*BOUNDARY_SPC_NODE\n" + "".join(f"{n},0,1,1,1,1,1,1\n" for n in lowest)
    text += "*SET_PART_LIST\n1\n" + ",".join(str(n + 1) for n in range(len(planks)))
    text += f"\n*SET_PART_LIST\n2\n{len(bodies)}\n"
    text += f"*INITIAL_VELOCITY_GENERATION\n{len(bodies)},2,0,{velocity[0]},{velocity[1]},0\n\n"
    return f"{text}*CONTACT_{kind}\n{sides}\n{mu},{mu},0,0,20\n\n"


def run(model):
    """Velocity (3,) and rise of the block's centre at the end, and the relative change of the total energy."""
    s = model.state
    block = np.flatnonzero(model.ids > (model.ids.max() // 1000) * 1000)
    share = s.lumped[block] / s.lumped[block].sum()
    items = [*model.forces, *model.constraints]
    totals, heights = [], []
    for _ in steps(model):
        stored = sum(account.item() for kind in STORED for account in accounts(items, kind))
        work = sum(account.item() for account in accounts(items, "external work"))
        totals.append(model.kinetic() + stored - work)
        heights.append(share @ s.x[block, 2])
    return share @ s.v[block], max(heights) - heights[0], totals[-1] / totals[0] - 1.0


ON = [0.0, 0.0, H]  # on a plank of one layer of solids
DIRECTION = np.array([1.2, 0.5]) / SPEED
# (plank, block): cells, whether they are rigid. Flat meshes are shells; their mid-surfaces are apart by thicknesses.
PAIRS = {
    "deformable": (((8, 6, 1), False), ((2, 2, 2), False)),
    "rigid block": (((8, 6, 1), False), ((2, 2, 2), True)),
    "rigid plank": (((8, 6, 1), True), ((2, 2, 2), False)),
    "shells": (((8, 6, 0), False), ((2, 2, 0), False)),
    "shell on solid": (((8, 6, 1), False), ((2, 2, 0), False)),
    "solid on shell": (((8, 6, 0), False), ((2, 2, 2), False)),
}


@pytest.mark.parametrize("mu", [0.0, 0.2])
@pytest.mark.parametrize("offset", [0.0, 0.0123])  # nodes in the planes of the block's faces, or anywhere
@pytest.mark.parametrize("pair", PAIRS)
def test_a_block_loses_what_friction_takes_and_nothing_else(deck, pair, offset, mu):
    (plank, plank_rigid), (block, block_rigid) = PAIRS[pair]
    apart = (H if plank[2] else THICK / 2) + (0 if block[2] else THICK / 2)
    on = [offset, 0.7 * offset, apart]
    bodies = [(plank, [0.0, 0.0, 0.0], 0.0, plank_rigid)], (block, on, 0.0, block_rigid)
    velocity, rise, change = run(build(deck(slide(*bodies, SPEED * DIRECTION, mu))))
    np.testing.assert_allclose(velocity[:2], (SPEED - mu * G * 0.05) * DIRECTION, atol=3e-4 * SPEED)
    assert rise < 1e-6
    assert abs(change) < 1e-5


@pytest.mark.parametrize("turn", [0.3, np.pi / 4])
def test_a_block_slides_corner_first(deck, turn):
    bodies = [((8, 6, 1), [0.0, 0.0, 0.0], 0.0, False)], ((2, 2, 2), ON, turn, False)
    velocity, rise, change = run(build(deck(slide(*bodies, [SPEED, 0.0], 0.2))))
    np.testing.assert_allclose(velocity[:2], [SPEED - 0.2 * G * 0.05, 0.0], atol=3e-4 * SPEED)
    assert rise < 1e-6
    assert abs(change) < 1e-5


@pytest.mark.parametrize(
    ("kind", "sides"),
    [("SURFACE_TO_SURFACE", "2,1,2,2"), ("AUTOMATIC_SINGLE_SURFACE", "0,0,5,0")],
)
def test_other_contacts_of_surfaces_do_the_same(deck, kind, sides):
    bodies = [((8, 6, 1), [0.0, 0.0, 0.0], 0.0, False)], ((2, 2, 2), ON, 0.0, False)
    model = build(deck(slide(*bodies, SPEED * DIRECTION, 0.2, kind, sides=sides)))
    velocity, rise, _ = run(model)
    np.testing.assert_allclose(velocity[:2], (SPEED - 0.2 * G * 0.05) * DIRECTION, atol=3e-4 * SPEED)
    assert rise < 1e-6


def test_a_block_slides_over_the_joint_of_two_planks(deck):
    # The second plank begins with an edge: faces of its own that look at the leading face of the block.
    planks = [((4, 6, 1), [x, 0.0, 0.0], 0.0, False) for x in (-2.0 * H, 2.0 * H)]
    block = ((2, 2, 2), [-0.7 * H, 0.1 * H, H], 0.0, False)
    velocity, rise, _ = run(build(deck(slide(planks, block, [SPEED, 0.0]))))
    np.testing.assert_allclose(velocity[:2], [SPEED, 0.0], atol=3e-4 * SPEED)
    assert rise < 1e-6


def test_a_block_that_slides_off_the_end_is_not_pushed(deck):
    # It leaves the plank over its end, with the last nodes of both within the penetration; then it falls.
    bodies = [((4, 4, 1), [0.0, 0.0, 0.0], 0.0, False)], ((2, 2, 1), [1.9 * H, 0.0, H], 0.0, False)
    model = build(deck(slide(*bodies, [3.0, 0.0], end=0.06)))
    velocity, rise, change = run(model)
    assert velocity[0] == pytest.approx(3.0, rel=3e-3)
    assert velocity[1] == pytest.approx(0.0, abs=1e-6)
    assert velocity[2] < -0.1
    assert rise < 1e-6
    assert abs(change) < 1e-4


@pytest.mark.parametrize("kind", ["AUTOMATIC_SURFACE_TO_SURFACE", "ONE_WAY_SURFACE_TO_SURFACE"])
def test_a_wide_block_slides_across_a_narrow_plank(deck, kind):
    # Nodes of the block come onto the plank from its side, in the penetration, and leave it at the other.
    bodies = [((8, 2, 1), [0.0, 0.0, 0.0], 0.7, False)], ((5, 5, 1), ON, 0.0, True)
    model = build(deck(slide(*bodies, SPEED * DIRECTION, kind=kind, end=0.03)))
    velocity, rise, _ = run(model)
    np.testing.assert_allclose(velocity[:2], SPEED * DIRECTION, atol=3e-3 * SPEED)
    assert rise < 1e-5
