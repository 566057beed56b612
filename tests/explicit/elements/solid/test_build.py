"""From a deck to solids that run: forms of the card, options, refusals, channels, a wave in the time loop."""

import numpy as np
import pytest

from vmharness.deck import DeckError, read, vocabulary, write_long
from vmharness.explicit.build import build, review
from vmharness.explicit.elements.solid import Hexahedra
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import ProbeError, probe

HEAD = """*KEYWORD
*CONTROL_TERMINATION
{end},
*PART
block
1,1,1{hgid}
*MAT_ELASTIC
1,7850.0,2.1e11,0.3
"""
CUBE = """*NODE
11,0.0,0.0,0.0
12,2.0,0.0,0.0
13,2.0,3.0,0.0
14,0.0,3.0,0.0
15,0.0,0.0,5.0
16,2.0,0.0,5.0
17,2.0,3.0,5.0
18,0.0,3.0,5.0
"""
SECTION = "*SECTION_SOLID\n1,{}\n"
C = np.sqrt(2.1e11 * 0.7 / (1.3 * 0.4) / 7850.0)
TWO_ROWS = (
    "*ELEMENT_SOLID\n       7       1\n      11      12      13      14      15      16      17      18\n"
)
ONE_ROW = "*ELEMENT_SOLID\n       7       1      11      12      13      14      15      16      17      18\n"
COMMAS = "*ELEMENT_SOLID\n7,1,11,12,13,14,15,16,17,18\n"
COMMAS_TWO = "*ELEMENT_SOLID\n7,1\n11,12,13,14,15,16,17,18\n"


def text(elements=TWO_ROWS, elform=1, more="", end=1.0, hgid=""):
    return HEAD.format(end=end, hgid=hgid) + CUBE + SECTION.format(elform) + elements + more


@pytest.mark.parametrize("elements", [TWO_ROWS, ONE_ROW, COMMAS, COMMAS_TWO])
@pytest.mark.parametrize("elform", [1, 2])
def test_forms_of_the_card(deck, tmp_path, elements, elform):
    """The same element either way, and when written again."""
    first = deck(text(elements, elform))
    path = tmp_path / "again.k"
    path.write_text(write_long(first))
    for one in (first, read(path, vocabulary())):
        model = build(one)
        (block,) = model.forces
        assert isinstance(block, Hexahedra)
        assert (block.kind, block.pid, block.eid.tolist()) == ("solid", 1, [7])
        assert model.state.mass == pytest.approx(np.full(8, 7850.0 * 30 / 8))
        block.add(model.state)
        assert block.stable_step() == pytest.approx(2.0 / C)


def test_bulk_viscosity_of_shells_alone_is_said_to_have_no_effect(deck):
    (finding,) = review(deck(text(more="*CONTROL_BULK_VISCOSITY\n1.5,0.06,-1\n")))
    assert finding.idle
    assert "TYPE = -1: acts on shells, of which the deck has none" in str(finding)


def test_wedge_of_repeated_nodes(deck):
    model = build(
        deck(
            text("*ELEMENT_SOLID\n7,1,11,12,13,14,15,15,18,18\n").replace(
                "16,2.0,0.0,5.0\n17,2.0,3.0,5.0\n", ""
            )
        )
    )
    assert model.state.mass.sum() == pytest.approx(7850.0 * 15)


@pytest.mark.parametrize(
    ("elements", "elform", "more", "message"),
    [
        ("*ELEMENT_SOLID\n7,1,11,12,13,15,15,15,15,15\n", 1, "", "N1 = 11: a tetrahedron; supported: eight different nodes"),
        ("*ELEMENT_SOLID\n7,1,11,12,13,14,15,16,17,15\n", 1, "", "N1 = 11: nodes repeat; supported: eight different nodes, and wedges"),
        ("*ELEMENT_SOLID\n7,1,14,13,12,11,18,17,16,15\n", 1, "", "the solid has no volume, or is inside out"),
        ("*ELEMENT_SOLID\n7,1\n11,12,13,14,15,16,17,18,19,20\n", 1, "", "N9 = 19: only 0 is supported"),
        ("*ELEMENT_SOLID\n7,1,11,12,13,14,15,16,17,99\n", 1, "", "N8 = 99: no \\*NODE 99"),
        (TWO_ROWS, 10, "", "ELFORM = 10: not implemented; supported: 1 .one point., 2 .fully integrated."),
        (TWO_ROWS, 1, "*CONTROL_HOURGLASS\n6,0.1\n", "CONTROL_HOURGLASS: IHQ = 6: .*solids know 1, 2, 3 .viscous. and 4, 5"),
        (TWO_ROWS, 1, "*CONTROL_BULK_VISCOSITY\n1.5,0.06,-2\n", "TYPE = -2: only 1 is supported"),
        (TWO_ROWS + TWO_ROWS, 1, "", "EID"),
    ],
)  # fmt: skip
def test_refusals_name_the_field(deck, elements, elform, more, message):
    with pytest.raises(DeckError, match=message):
        build(deck(text(elements, elform, more)))


def test_hourglass_and_viscosity_of_the_part_overrule_the_control_cards(deck):
    """*HOURGLASS IHQ 4 QM 0 Q1 2 Q2 0.5: a step in compression tells Q1 and Q2."""
    cards = "*CONTROL_HOURGLASS\n1,0.05\n*CONTROL_BULK_VISCOSITY\n1.0,0.1\n"
    D = 60.0
    for hgid, more, q1, q2 in (
        ("", cards, 1.0, 0.1),
        (",,5", cards + "*HOURGLASS\n5,4,0.02,,2.0,0.5\n", 2.0, 0.5),
        ("", "", 1.5, 0.06),
    ):
        model = build(deck(text(more=more, hgid=hgid)))
        model.state.v[:] = -D / 3 * model.x0
        (block,) = model.forces
        block.add(model.state)
        Q = q2 * C + q1 * 2.0 * D
        assert block.stable_step() == pytest.approx(2.0 / (Q + np.hypot(Q, C)))


def test_channels(deck):
    """Stress in space of a bar pulled along y and turned: s_yy, pressure -s/3, von Mises s."""
    model = build(deck(text()))
    (block,) = model.forces
    s = model.state
    e, nu = 1e-6, 0.3
    s.dt, s.v[:] = 1.0, model.x0 * [-nu * e, e, -nu * e]
    s.x += 0.5 * s.v
    block.add(s)
    sigma = 2.1e11 * e
    expected = {
        "xx-stress": 0.0,
        "yy-stress": sigma,
        "xy-stress": 0.0,
        "pressure": -sigma / 3,
        "von-mises": sigma,
    }
    for component, value in expected.items():
        assert probe(model, solid=7, component=component)() == pytest.approx(
            value, rel=1e-5, abs=1e-5 * sigma
        )
    quarter = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    show = probe(model, solid=7, component="xx-stress")
    start = s.x.copy()
    s.x[:] = start @ quarter.T
    s.v[:] = s.x - start
    block.add(s)
    assert show() == pytest.approx(sigma, rel=1e-5)
    with pytest.raises(ProbeError, match=r"no 'axial-force' of a solid; there are: xx-stress, .*von-mises"):
        probe(model, solid=7, component="axial-force")
    with pytest.raises(ProbeError, match="no point 2; the solid has 1"):
        probe(model, solid=7, component="xx-stress", point=2)


def column(n, elform, more=""):
    """A column of n cubes along x with all sides held, given v_x = 1 over its first half."""
    lines = ["*NODE"]
    for i in range(n + 1):
        lines += [
            f"{4 * i + k + 1},{i / n},{y / n},{z / n},5,7"
            for k, (y, z) in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)])
        ]
    lines.append("*ELEMENT_SOLID")
    for i in range(n):
        a, b = 4 * i, 4 * i + 4
        # z is the third direction of the element: its sides 1234 and 5678 are the planes x = const, turned left
        lines.append(
            ",".join(map(str, [i + 1, 1, *(a + k for k in (1, 2, 3, 4)), *(b + k for k in (1, 2, 3, 4))]))
        )
    lines.append("*INITIAL_VELOCITY_NODE")
    lines += [f"{j + 1},{1.0 if j < 2 * n else 0.5 if j < 2 * n + 4 else 0.0}" for j in range(4 * n + 4)]
    return HEAD.format(end=0.25 / C, hgid="") + SECTION.format(elform) + "\n".join(lines) + "\n" + more


@pytest.mark.parametrize("elform", [1, 2])
def test_wave_at_the_dilatational_speed(deck, elform):
    """Uniaxial strain after impact at v = 1: the front runs at c_L, v = 1/2 behind it, s = -rho c_L / 2 (cases D45)."""
    n = 100
    model = build(deck(column(n, elform)))
    ratio = probe(model, energy="ratio")
    seen = []
    for s in steps(model):
        v = s.v[::4, 0]
        front = np.interp(-0.25, -v[n // 2 :], np.arange(n // 2, n + 1) / n)
        seen.append((s.t, front))
    t, front = np.array(seen[20:]).T
    speed = np.polyfit(t, front, 1)[0]
    assert speed == pytest.approx(C, rel=0.01)
    assert ratio() == pytest.approx(1.0, abs=2e-3)
    stress = model.forces[0].stress[:, :, 0].mean(axis=1)
    plateau = slice(int(0.35 * n), int(0.65 * n))
    assert stress[plateau].mean() == pytest.approx(-7850.0 * C / 2, rel=0.005)
    assert v[plateau].mean() == pytest.approx(0.5, rel=0.005)


@pytest.mark.parametrize("elform", [1, 2])
@pytest.mark.parametrize("hourglass", ["", "*CONTROL_HOURGLASS\n2,0.2\n"])
def test_mass_scaling(deck, elform, hourglass):
    """DT2MS makes the element's step three times as long by nine times the mass; hourglass viscosity keeps its fraction."""
    step = 3 * 2.0 / C
    model = build(deck(text(elform=elform, more=f"*CONTROL_TIMESTEP\n,,,,{-step:.9g},,,1\n" + hourglass)))
    (block,) = model.forces
    block.add(model.state)
    assert model.state.mass == pytest.approx(np.full(8, 9 * 7850.0 * 30 / 8), rel=1e-6)
    limit = 3 * np.cbrt(30.0) / (8 * 0.2 * C) if hourglass and elform == 1 else np.inf
    assert block.stable_step() == pytest.approx(min(step, limit), rel=1e-6)
