"""Energy kept over many steps of free motion, by central differences as the time loop takes them."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay import Hourglass


def vibrate(bench, block, s, mass, dt, steps):
    """Total energy (steps,) at t_1, t_2, ...: kinetic from v_n, internal and hourglass from the block."""
    u = np.hstack([s.v, s.omega])
    s.dt, total = 0.0, []
    for n in range(steps):
        force = -np.hstack(bench.internal_forces(block, s))
        half = u
        u = u + (dt if n else dt / 2) * force / mass
        kinetic = 0.5 * np.sum(mass * ((half + u) / 2) ** 2)
        if n:
            total.append(kinetic + block.energy["internal"][0] + block.energy["hourglass"][0])
        s.v[:], s.omega[:] = u[:, :3], u[:, 3:]
        s.x += dt * s.v
        s.dt = dt
    return np.array(total)


def sheet(bench, control):
    x, nodes = bench.rectangles(6, 6, 1.0, 1.0)
    block, s = bench.shells(x, nodes, 0.02, nip=2, hourglass=control), bench.state(x)
    s.dt = 0.0
    bench.internal_forces(block, s)
    return x, block, s, bench.lumped(x, nodes, 0.02), block.stable_step()


@pytest.mark.parametrize("control", [Hourglass(ihq=4), Hourglass(ihq=2)])
def test_vibrating_spinning_sheet(bench, control):
    """A smooth bending and stretching motion over a tumbling one; the energy is kept and the error falls with dt^2."""
    errors = []
    for fraction in (0.8, 0.4):
        x, block, s, mass, stable = sheet(bench, control)
        w = np.array([20.0, -10.0, 30.0])
        s.v[:] = np.cross(w, x)
        s.omega[:] = w
        s.v[:, 2] += 20 * np.cos(np.pi * x[:, 0])
        s.omega[:, 1] += 20 * np.pi * np.sin(np.pi * x[:, 0])
        s.v[:, 0] += 10 * np.cos(np.pi * x[:, 1])
        start = 0.5 * np.sum(mass * np.hstack([s.v, s.omega]) ** 2)
        total = vibrate(bench, block, s, mass, fraction * stable, round(400 / fraction))
        errors.append(np.abs(total / start - 1).max())
        assert block.energy["internal"][0] > 0
    assert errors[0] < 1e-3
    assert errors[1] < errors[0] / 3


def test_viscous_control_only_takes_energy(bench):
    x, block, s, mass, stable = sheet(bench, Hourglass(ihq=2))
    i, j = np.divmod(np.arange(len(x)), 7)
    s.v[:, 0] = (-1.0) ** (i + j)  # the pattern of every element
    start = 0.5 * np.sum(mass[:, :3] * s.v**2)
    total = vibrate(bench, block, s, mass, 0.5 * stable, 200)
    assert block.energy["hourglass"][0] > 0.9 * start
    assert total[-1] == pytest.approx(start, rel=0.01)
