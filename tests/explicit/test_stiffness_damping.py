"""*DAMPING_PART_STIFFNESS: the damping of a mode, in every kind of element; its step; what is refused."""

from itertools import pairwise

import numpy as np
import pytest

from vmharness.deck import DeckError
from vmharness.explicit.build import build
from vmharness.explicit.damping.stiffness import damped_step
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.probes import probe

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n{end}\n*CONTROL_TIMESTEP\n0.0,{tssfac}\n*PART\np\n1,1,1\n"
ELASTIC = "*MAT_ELASTIC\n1,1.0,100.0,0.0\n"  # E = 100, rho = 1: c = 10
N = 8  # elements in a row, each a cube of side 1


def damping(coef):
    return f"*DAMPING_PART_STIFFNESS\n1,{coef}\n"


def rows(keyword, lines):
    return keyword + "\n" + "".join(",".join(map(str, line)) + "\n" for line in lines)


def bars(tc=5, rc=7):
    """A row of bars along x, fixed at the left; the others slide along it."""
    nodes = [(i + 1, i, 0, 0, 7 if i == 0 else tc, rc) for i in range(N + 1)]
    return (
        rows("*NODE", nodes)
        + "*SECTION_BEAM\n1,3\n1.0\n"
        + rows("*ELEMENT_BEAM", [(i, 1, i, i + 1) for i in range(1, N + 1)])
    )


def beams():
    """The same of beams of square section, clamped at the left, which bend in the x-y plane."""
    nodes = [(i + 1, i, 0, 0, 7 if i == 0 else 3, 7 if i == 0 else 4) for i in range(N + 1)]
    return (
        rows("*NODE", [*nodes, (99, 0, 1, 0, 7, 7)])
        + "*SECTION_BEAM\n1,2\n1.0,0.0833333,0.0833333,0.14\n"
        + rows("*ELEMENT_BEAM", [(i, 1, i, i + 1, 99) for i in range(1, N + 1)])
    )


def shells():
    """A strip of shells along x, clamped at the left, which bends out of its plane."""
    nodes = [(2 * i + j + 1, i, j, 0, *((7, 7) if i == 0 else (4, 6))) for i in range(N + 1) for j in (0, 1)]
    corners = [(i, 1, 2 * i - 1, 2 * i + 1, 2 * i + 2, 2 * i) for i in range(1, N + 1)]
    return rows("*NODE", nodes) + "*SECTION_SHELL\n1,2,0.8333,2\n0.5\n" + rows("*ELEMENT_SHELL", corners)


def solids(elform):
    """A column of solids along x, fixed at the left; the others slide along it."""
    square = ((0, 0), (1, 0), (1, 1), (0, 1))
    nodes = [
        (4 * i + k + 1, i, j, h, 7 if i == 0 else 5) for i in range(N + 1) for k, (j, h) in enumerate(square)
    ]
    at = [(i, 1, *range(4 * i - 3, 4 * i + 5)) for i in range(1, N + 1)]
    off = "*CONTROL_BULK_VISCOSITY\n0.0,0.0\n"
    return off + rows("*NODE", nodes) + f"*SECTION_SOLID\n1,{elform}\n" + rows("*ELEMENT_SOLID", at)


def vibrating(deck, mesh, axis, coef=None, tssfac=0.02, end=40.0, speed=1e-3):
    """A model whose nodes start with a velocity that grows from the fixed end."""
    text = HEAD.format(end=end, tssfac=tssfac) + ELASTIC + mesh + (damping(coef) if coef else "")
    model = build(deck(text))
    x = model.x0[:, 0]
    shape = np.sin(np.pi * x / (2 * N)) if axis == 0 else (x / N) ** 2 * (1.5 - 0.5 * x / N)
    model.state.v[:, axis] = speed * shape
    return model


def history(model, axis):
    """t and displacement of the last node of the row, and the total energy."""
    tip, total = np.argmax(model.x0[:, 0]), probe(model, energy="total")
    x0 = model.x0[tip, axis]
    return np.array([(s.t, s.x[tip, axis] - x0, total()) for s in steps(model)]).T


def decay(t, u):
    """omega and zeta of a damped oscillation from its zeros and extrema."""
    zeros = np.flatnonzero(np.diff(np.sign(u[1:]))) + 1
    at = t[zeros] - u[zeros] * (t[zeros + 1] - t[zeros]) / (u[zeros + 1] - u[zeros])
    peaks = np.array([np.abs(u[a : b + 1]).max() for a, b in pairwise(zeros)])
    omega = np.pi / np.diff(at).mean()
    delta = -np.polyfit(np.arange(peaks.size), np.log(peaks), 1)[0] / np.pi
    zeta = delta / np.sqrt(1.0 + delta**2)
    return omega / np.sqrt(1.0 - zeta**2), zeta


MESHES = {
    "bars": (bars, 0, 20.0, 0.1), "beams": (beams, 1, 120.0, 0.6), "shells": (shells, 2, 250.0, 0.6),
    "one-point solids": (lambda: solids(1), 0, 15.0, 0.2), "full solids": (lambda: solids(2), 0, 15.0, 0.2),
}  # fmt: skip


@pytest.mark.parametrize("kind", MESHES)
def test_zeta_is_half_beta_omega(deck, kind):
    """The first mode of every kind of element; half a step of lag shows in the second order of zeta."""
    mesh, axis, end, tssfac = MESHES[kind]
    free, _ = decay(*history(vibrating(deck, mesh(), axis, end=end, tssfac=tssfac), axis)[:2])
    beta = 2 * 0.04 / free
    model = vibrating(deck, mesh(), axis, -beta, end=end, tssfac=tssfac)
    t, u, energy = history(model, axis)
    omega, zeta = decay(t, u)
    assert omega == pytest.approx(free, rel=5e-3)
    assert zeta == pytest.approx(0.5 * beta * free, rel=0.02)
    np.testing.assert_allclose(energy, energy[0], rtol=2e-3)


def test_a_bar_follows_the_difference_equation_exactly(deck):
    """u'' = -omega^2 (u_n + beta (u_n - u_{n-1})/dt) in the first mode of a fixed bar with lumped masses."""
    beta = 0.2
    model = vibrating(deck, bars(), 0, -beta, tssfac=0.5, end=20.0, speed=1e-6)
    t, u, _ = history(model, 0)
    dt, w = t[1], 20.0 * np.sin(np.pi / (4 * N))  # 2 c/L sin(k L/2)
    v = 1e-6
    expected, past = [0.0, dt * v], 0.0
    for _ in t[2:]:
        now = expected[-1]
        v -= dt * w**2 * (now + beta * (now - past) / dt)
        past = now
        expected.append(now + dt * v)
    np.testing.assert_allclose(u, expected, atol=1e-5 * np.abs(u).max())


def test_step_is_that_of_the_lagged_damping(deck):
    for coef, zeta in ((-0.03, 0.3), (0.25, 0.25)):
        model = vibrating(deck, bars(), 0, coef, tssfac=0.9, end=1.0, speed=1e-9)
        t, *_ = history(model, 0)
        assert t[1] == pytest.approx(0.9 * damped_step(0.1, zeta), rel=1e-6)


@pytest.mark.parametrize(("fraction", "stable"), [(0.99, True), (1.01, False)])
def test_the_step_is_sharp_for_a_free_bar(deck, fraction, stable):
    """One free element has the highest mode itself: nodes against each other, omega = 2/h."""
    mesh = "*NODE\n1,0,0,0,5,7\n2,1,0,0,5,7\n*SECTION_BEAM\n1,3\n1.0\n*ELEMENT_BEAM\n1,1,1,2\n"
    model = build(deck(HEAD.format(end=200.0, tssfac=fraction) + ELASTIC + mesh + damping(-0.05)))
    model.state.v[:, 0] = 1e-9, -1e-9
    if stable:
        assert max(abs(s.x[1, 0] - 1.0) for s in steps(model)) < 1e-9
    else:
        with pytest.raises(SolverError, match="diverged"):
            for _ in steps(model):
                pass


def test_coef_is_the_fraction_of_critical_damping_of_the_highest_mode(deck):
    mesh = "*NODE\n1,0,0,0,5,7\n2,1,0,0,5,7\n*SECTION_BEAM\n1,3\n1.0\n*ELEMENT_BEAM\n1,1,1,2\n"
    model = build(deck(HEAD.format(end=3.0, tssfac=0.01) + ELASTIC + mesh + damping(0.1)))
    model.state.v[:, 0] = 1e-6, -1e-6
    t, u = np.array([(s.t, s.x[1, 0] - 1.0) for s in steps(model)]).T
    omega, zeta = decay(t, u)
    assert omega == pytest.approx(20.0, rel=2e-3)
    assert zeta == pytest.approx(0.1, rel=0.02)


def test_a_bar_that_spins_under_tension_is_not_damped(deck):
    """N = m omega^2 L/2 of each end: constant in the bar's own frame, so that nothing is lost."""
    mesh = "*NODE\n1,-0.5,0,0,0,7\n2,0.5,0,0,0,7\n*SECTION_BEAM\n1,3\n1.0\n*ELEMENT_BEAM\n1,1,1,2\n"
    w, m = 0.5, 0.5  # at each end
    stretched = 1.0 + m * w**2 * 0.5 / 100.0
    text = HEAD.format(end=30.0, tssfac=0.1) + ELASTIC + mesh + damping(-0.1)
    model = build(deck(text))
    model.state.v[:, 1] = -0.5 * w * stretched, 0.5 * w * stretched
    kinetic = probe(model, energy="kinetic")
    energy = np.array([kinetic() for _ in steps(model)])
    late = energy[energy.size // 2 :]
    assert np.ptp(late) < 1e-6 * energy[0]
    assert late[-1] == pytest.approx(energy[0], rel=3e-3)


def test_zero_damps_nothing(deck):
    plain = history(vibrating(deck, bars(), 0, end=2.0), 0)
    zero = HEAD.format(end=2.0, tssfac=0.02) + ELASTIC + bars() + damping(0.0)
    model = build(deck(zero))
    model.state.v[:, 0] = 1e-3 * np.sin(np.pi * model.x0[:, 0] / (2 * N))
    assert np.array_equal(history(model, 0), plain)


def test_what_is_refused(deck):
    spring = "*NODE\n1,0,0,0,7,7\n2,1,0,0\n*ELEMENT_MASS\n1,2,1.0\n*SECTION_DISCRETE\n1\n\n"
    spring += "*MAT_SPRING_ELASTIC\n1,5.0\n*ELEMENT_DISCRETE\n1,1,1,2\n"
    with pytest.raises(DeckError, match=r"PID = 1: damping of springs and dampers of part 1 by stiffness"):
        build(deck(HEAD.format(end=1.0, tssfac=0.9) + spring + damping(-0.1)))
    with pytest.raises(DeckError, match=r"PID = 7: no \*PART with PID = 7"):
        build(deck(HEAD.format(end=1.0, tssfac=0.9) + ELASTIC + bars() + "*DAMPING_PART_STIFFNESS\n7,0.1\n"))
