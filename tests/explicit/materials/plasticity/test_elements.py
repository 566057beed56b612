"""Plastic laws in elements: a bar wave, a driven cycle, and back stress that turns with the element."""

import numpy as np
import pytest

from vmharness.explicit.build import build
from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay
from vmharness.explicit.elements.solid import Hexahedra
from vmharness.explicit.elements.solid import one_point as hexa_one_point
from vmharness.explicit.loop import steps
from vmharness.explicit.materials import Moduli, plastic_kinematic
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import line
from vmharness.explicit.probes import probe
from vmharness.explicit.state import State

E, NU, SIGY, ET = 210.0, 0.3, 0.3, 2.1  # GPa, as in mm, ms, kg
BAR = """*KEYWORD
*CONTROL_TERMINATION
{end}
*PART
bar
1,1,1
*SECTION_BEAM
1,3
1.0
*MAT_PLASTIC_KINEMATIC
1,7.85e-6,210.0,0.3,0.3,2.1,{beta}

*DEFINE_CURVE
1
{points}
*BOUNDARY_PRESCRIBED_MOTION_NODE
1,1,{vad},1
"""


def bar(count, length, fixed, **card):
    """A deck of trusses along x; node 1 is driven, the last one `fixed` or free, the others slide along x."""
    nodes = [f"{i + 1},{i * length / count},0.0,0.0,5,7" for i in range(count + 1)]
    nodes[-1] = nodes[-1].replace(",5,7", ",7,7" if fixed else ",5,7")
    elements = [f"{i},1,{i},{i + 1}" for i in range(1, count + 1)]
    return "\n".join([BAR.format(**card) + "*NODE", *nodes, "*ELEMENT_BEAM", *elements])


def test_bar_wave(deck):
    """Struck at V, a bar has two fronts: sy at c, and sy + rho c1 (V - sy/(rho c)) behind one at c1 = sqrt(Et/rho).

    V = 10 m/s: stress 310.6017 MPa and strain 6.477e-3 behind the plastic front.
    """
    length, rho, V = 200.0, 7.85e-6, 10.0
    c, c1 = np.sqrt(E / rho), np.sqrt(ET / rho)
    end = 0.9 * length / c
    model = build(deck(bar(400, length, False, end=end, beta=1.0, vad=0, points=f"0.0,{V}\n{2 * end},{V}")))
    probes = [
        (probe(model, beam=i, component="axial-stress"), probe(model, beam=i, component="plastic-strain"))
        for i in range(1, 401)
    ]
    ratio = probe(model, energy="ratio")
    for state in steps(model):
        last = state
    stress, p = np.array([[one() for one in pair] for pair in probes]).T
    x = (np.arange(400) + 0.5) * length / 400
    behind = x < 0.8 * c1 * last.t
    plateau = SIGY + rho * c1 * (V - SIGY / (rho * c))
    assert plateau == pytest.approx(0.3106017, abs=1e-7)
    assert -stress[behind] == pytest.approx(plateau, rel=2e-3)
    between = (x > 1.4 * c1 * last.t) & (x < 0.9 * c * last.t)
    assert -stress[between] == pytest.approx(SIGY, rel=1e-3)
    strain = p[behind] + plateau / E
    assert strain == pytest.approx((SIGY / E) + (plateau - SIGY) / ET, rel=0.02)
    front = np.interp(-0.5 * p[behind].mean(), -p, x)  # where half the plastic strain is reached
    assert front == pytest.approx(c1 * last.t, rel=0.02)
    assert ratio() == pytest.approx(1, abs=1e-3)


@pytest.mark.parametrize("beta", [0.0, 0.5, 1.0])
def test_cycle_of_a_driven_truss(deck, beta):
    """Strain 0.01 and back to -0.01: reverse yield at s_max - 2 (SIGY + BETA Ep p), then the slope Et."""
    stretch = 1000.0 * (np.exp([0, 0.01, -0.01]) - 1)
    points = "\n".join(f"{t},{-u:.12f}" for t, u in zip((0.0, 10.0, 40.0), stretch, strict=True))
    model = build(deck(bar(1, 1000.0, True, end=30.0, beta=beta, vad=2, points=points)))
    read = probe(model, beam=1, component="axial-stress")
    rows = np.array([(np.log(1 - s.x[0, 0] / 1000.0), read()) for s in steps(model)])
    strain, stress = rows.T
    Ep, top = E * ET / (E - ET), strain.max()
    assert top == pytest.approx(0.01, rel=0.02)  # the step passes the turn of the curve
    peak = SIGY + ET * (top - SIGY / E)
    p = (peak - SIGY) / Ep
    reverse = peak - 2 * (SIGY + beta * Ep * p)
    assert stress.max() == pytest.approx(peak, rel=1e-7)
    turned = np.argmax(strain)
    yielded = strain[turned:] < top - (peak - reverse) / E
    assert yielded.sum() > 20
    back, s = strain[turned:][yielded], stress[turned:][yielded]
    assert s == pytest.approx(reverse - ET * (top - (peak - reverse) / E - back), rel=1e-6)


def turning(block, x, angle, dt=1.0, count=600):
    """Stretch to 0.03, back to -0.02, while the body turns about a skew axis by `angle`; the block at the end."""
    axis = np.array([1.0, 2.0, 2.0]) / 3
    K = np.cross(np.eye(3), axis)
    n = len(x)
    s = State(x.copy(), np.zeros((n, 3)), np.zeros((n, 3)), np.ones(n), np.ones(n), dt=0.0)
    block.add(s)
    s.dt, s.omega = dt, np.tile(axis * angle / count / dt, (n, 1))
    for i in range(1, count + 1):
        e = np.interp(i / count, [0, 0.4, 1], [0, 0.03, -0.02])
        theta = angle * i / count
        R = np.eye(3) + np.sin(theta) * K + (1 - np.cos(theta)) * K @ K
        new = x * np.exp([e, -0.4 * e, -0.5 * e]) @ R.T
        s.v, s.x = (new - s.x) / dt, new
        block.add(s)
    return block


MATERIAL = dict(constants=Plastic(E, NU, 5.0, line(SIGY, 2.0), None))


def test_back_stress_turns_with_a_solid():
    """A cycle of a body that turns by 120 degrees ends with the same back stress in its own frame."""
    x = np.array([[i, j, k] for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))], float)

    def block():
        law = plastic_kinematic.solid
        return Hexahedra("", hexa_one_point.step, law, np.arange(8)[None], x, 1.0, E, history=7, **MATERIAL)

    still, turned = turning(block(), x, 0.0), turning(block(), x, 2 * np.pi / 3)
    assert np.abs(still.history[0, 0, 1:]).max() > 0.05
    assert turned.history == pytest.approx(still.history, rel=2e-4, abs=2e-5)


def test_back_stress_turns_with_a_shell():
    x = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)

    def stress(angle):
        block = BelytschkoTsay(
            "", np.arange(4)[None], x, np.ones(1), 1.0, plastic_kinematic.plane_stress,
            moduli=Moduli(E, NU), history=6, channels=plastic_kinematic.CHANNELS, **MATERIAL,
        )  # fmt: skip
        turning(block, x, angle)
        return [
            block.probe(0, 1, name)() for name in ("xx-stress", "yy-stress", "xy-stress", "plastic-strain")
        ]

    still = stress(0.0)
    assert still[3] > 0.05
    assert stress(2 * np.pi / 3) == pytest.approx(still, rel=1e-3, abs=1e-4)
