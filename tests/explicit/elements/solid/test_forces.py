"""Forces are the gradient of the energy; momentum and angular momentum; energy over many steps."""

import numpy as np
import pytest

from vmharness.explicit.elements.solid.one_point import Hourglass

CUBE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
NODES = np.arange(8)[None]
KINDS = [(1, Hourglass(ihq=4)), (1, Hourglass(ihq=2)), (2, None)]


@pytest.mark.parametrize(("elform", "control"), [KINDS[0], KINDS[2]])
def test_force_is_the_gradient_of_the_energy(bench, elform, control):
    """f = dU/dx by central differences about a strained distorted element, hourglass energy included."""
    rng = np.random.default_rng(3)
    x, u = CUBE + 0.25 * rng.uniform(-1, 1, (8, 3)), 1e-6 * rng.normal(size=(8, 3))

    def moved(u):
        block, s = bench.solids(x, NODES, elform, control), bench.state(x)
        s.v[:] = u
        s.x += s.v
        f = bench.internal_forces(block, s)
        return f, block.energy["internal"][0] + block.energy["hourglass"][0]

    f, _ = moved(u)
    for place in np.ndindex(8, 3):
        d = np.zeros((8, 3))
        d[place] = 1e-6
        slope = (moved(u + d)[1] - moved(u - d)[1]) / 2e-6
        assert slope == pytest.approx(f[place], abs=1e-5 * np.abs(f).max())


@pytest.mark.parametrize(("elform", "control"), KINDS)
def test_forces_and_moments_balance(bench, elform, control):
    """In large motion of a distorted element, hourglass and bulk viscosity at work."""
    rng = np.random.default_rng(4)
    x = CUBE + 0.25 * rng.uniform(-1, 1, (8, 3))
    block, s = bench.solids(x, NODES, elform, control, viscous=(1.5, 0.06)), bench.state(x)
    for _ in range(5):
        s.v[:] = 0.05 * rng.normal(size=x.shape) - 0.03 * (s.x - s.x.mean(axis=0))
        s.x += s.v
        f = bench.internal_forces(block, s)
        assert np.abs(f.sum(axis=0)).max() < 1e-13 * np.abs(f).max()
        assert np.abs(np.cross(s.x, f).sum(axis=0)).max() < 1e-13 * np.abs(f).max() * 8


def vibrate(bench, block, s, mass, dt, steps):
    """Total energy and what is stored of it (steps,) at t_1, t_2, ...: kinetic from v_n, the rest from the block."""
    s.dt, total, stored = 0.0, [], []
    for n in range(steps):
        a = -bench.internal_forces(block, s) / mass
        half = s.v.copy()
        s.v += (dt if n else dt / 2) * a
        kinetic = 0.5 * np.sum(mass * ((half + s.v) / 2) ** 2)
        if n:
            stored.append(block.energy["internal"][0] + block.energy["hourglass"][0])
            total.append(kinetic + stored[-1])
        s.x += dt * s.v
        s.dt = dt
    return np.array(total), np.array(stored)


@pytest.mark.parametrize(("elform", "control"), KINDS)
def test_vibrating_tumbling_block_keeps_its_energy(bench, elform, control):
    """The error falls with dt^2; angular momentum stays to round-off."""
    errors = []
    for fraction in (0.8, 0.4):
        x, nodes = bench.boxes(4, 3, 3, 0.4, 0.3, 0.3)
        x -= x.mean(axis=0)
        block, s, mass = bench.solids(x, nodes, elform, control), bench.state(x), bench.lumped(x, nodes)
        s.v[:] = np.cross([200.0, -100.0, 300.0], x)
        s.v[:, 0] += 20 * np.cos(np.pi * x[:, 1] / 0.3) + 10 * np.sin(np.pi * x[:, 0] / 0.4)
        s.v[:, 2] += 15 * np.sin(np.pi * x[:, 2] / 0.3)
        s.dt = 0.0
        block.add(s)
        dt = fraction * block.stable_step()
        start = 0.5 * np.sum(mass * s.v**2)
        momentum = np.sum(mass * np.cross(s.x, s.v), axis=0)
        total, stored = vibrate(bench, block, s, mass, dt, round(300 / fraction))
        errors.append(np.abs(total / start - 1).max())
        assert stored.max() > 0.02 * start
        after = np.sum(mass * np.cross(s.x, s.v), axis=0)
        assert after == pytest.approx(momentum, rel=1e-11)
    assert errors[0] < 0.02
    assert errors[1] < errors[0] / 3


def test_bulk_viscosity_takes_energy_from_the_motion_and_gives_it_to_internal(bench):
    """A cube thrown together: q = rho l (Q1 l D^2 - Q2 c D); its work is kept, and none is done in expansion."""
    dt, D = 1e-9, 50.0
    for sign in (-1, 1):
        block, s = bench.solids(CUBE, NODES, viscous=(1.5, 0.06)), bench.state(CUBE, dt)
        s.v[:] = sign * D / 3 * (CUBE - 0.5)
        s.x[:] = CUBE + 0.5 * dt * s.v
        f = bench.internal_forces(block, s)
        c = np.sqrt(bench.E * 0.7 / (1.3 * 0.4) / bench.RHO)
        q = bench.RHO * (1.5 * D**2 + 0.06 * c * D) if sign < 0 else 0.0
        elastic = sign * bench.E / (3 * (1 - 2 * bench.NU)) * D * dt
        assert f[6] == pytest.approx(np.full(3, (elastic - q) / 4), rel=1e-6)
        work = 0.5 * elastic * sign * D * dt + 0.5 * q * D * dt
        assert block.energy["internal"][0] == pytest.approx(work, rel=1e-6)
