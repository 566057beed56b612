"""ISTUPD = 1: exact thickness, force and work of a sheet that is pulled, and the moment of a bent one."""

import numpy as np
import pytest

from vmharness.explicit.elements.shell.belytschko_tsay import BelytschkoTsay
from vmharness.explicit.materials import Moduli, plastic_kinematic
from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import line
from vmharness.explicit.materials.elastic import Elastic, plane_stress
from vmharness.explicit.probes import probe

E, NU, T = 210.0, 0.3, 0.5
SIDES = (2.0, 3.0)
T0 = 0.1  # of the wall


def pulled(bench, strain, steps, lateral, stress=None, **options):
    """A rectangle 2 x 3 under the logarithmic strains strain and lateral strain; the block, its state and the work done."""
    x, nodes = bench.rectangles(1, 1, *SIDES)
    block = BelytschkoTsay("", nodes, x, np.full(1, T), 1.0, thinning=True, nip=3, **options)
    if stress is not None:
        block.stress = stress
    s = bench.state(x)
    s.dt, work, before = 0.0, 0.0, 0.0
    block.add(s)
    for n in range(1, steps + 1):
        new = x * np.exp(np.array([strain, lateral, 0.0]) * n / steps)
        s.dt, s.v = 1.0, new - s.x
        s.x = new
        f, _ = bench.internal_forces(block, s)
        work += 0.5 * np.sum((before + f) * s.v)
        before = f
    return block, s, work


def elastic(**options):
    return dict(law=plane_stress, constants=Elastic(E, NU), moduli=Moduli(E, NU), **options)


def test_uniaxial_stretch(bench):
    """t = t0 exp(-nu eps), s = E eps, f = s t w, work = E eps^2/2 of a volume that grows as exp((1 - 2 nu) eps)."""
    strain = 0.4
    block, s, work = pulled(bench, strain, 400, -NU * strain, **elastic())
    t = block.probe(0, 1, "thickness")()
    assert t == pytest.approx(T * np.exp(-NU * strain), rel=1e-6)
    assert block.stress[0, :, 0] == pytest.approx(E * strain, rel=1e-6)
    width = SIDES[1] * np.exp(-NU * strain)
    right = s.x[:, 0] > 1.0
    assert -s.f[right, 0].sum() == pytest.approx(E * strain * t * width, rel=1e-6)
    k = 1 - 2 * NU
    volume = T * SIDES[0] * SIDES[1]
    exact = volume * E * (np.exp(k * strain) * (k * strain - 1) + 1) / k**2  # int E e exp(k e) de
    assert block.energy["internal"][0] == pytest.approx(exact, rel=1e-5)
    assert work == pytest.approx(block.energy["internal"][0], rel=1e-5)


def test_work_of_forces_is_second_order(bench):
    """Work of the nodes' forces against stress work: the difference falls as the square of the step."""
    gaps = []
    for steps in (20, 40):
        block, _, work = pulled(bench, 0.4, steps, 0.2, **elastic())
        gaps.append(abs(work - block.energy["internal"][0]))
    assert gaps[0] / gaps[1] == pytest.approx(4, rel=0.1)


def test_plastic_flow_keeps_the_volume(bench):
    """Perfectly plastic, biaxial: t = t0 exp(-eps_x - eps_y + elastic part (1 - 2 nu)/E (s_xx + s_yy))."""
    strain, lateral = 0.3, 0.1
    block, _, _ = pulled(
        bench, strain, 300, lateral,
        law=plastic_kinematic.plane_stress, constants=Plastic(E, NU, 0.0, line(0.3, 0.0), None),
        moduli=Moduli(E, NU), history=6, channels={"plastic-strain": 0},
    )  # fmt: skip
    stress = block.stress[0, 0]
    elastic_volume = (1 - 2 * NU) / E * (stress[0] + stress[1])
    t = block.probe(0, 2, "thickness")()
    assert t == pytest.approx(T * np.exp(-strain - lateral + elastic_volume), rel=1e-6)
    assert block.probe(0, 3, "plastic-strain")() == pytest.approx(
        2 / np.sqrt(3) * np.sqrt(strain**2 + strain * lateral + lateral**2), rel=5e-3
    )


def test_thickness_stays_by_default(bench):
    x, nodes = bench.rectangles(1, 1, *SIDES)
    block = bench.shells(x, nodes, T)
    s = bench.state(x)
    s.v[2:, 0] = 0.1
    block.add(s)
    assert block.probe(0, 1, "thickness")() == T
    assert block.stress[0, 0, 0] > 0


def test_moment_falls_with_the_square_of_the_thickness(bench):
    """M = int z s dz = t^2/6 for s = zeta, which a sheet without stiffness keeps."""
    stress = np.zeros((1, 3, 5))
    stress[0, :, 0] = np.polynomial.legendre.leggauss(3)[0]
    soft = Moduli(1e-12, NU)
    block, s, _ = pulled(
        bench, 0.4, 50, 0.0, stress=stress, law=plane_stress, constants=Elastic(*soft), moduli=soft
    )
    t = block.probe(0, 1, "thickness")()
    assert t < 0.9 * T
    right = s.x[:, 0] > 1.0
    assert abs(s.moment[right, 1].sum()) == pytest.approx(t**2 / 6 * SIDES[1], rel=1e-9)


@pytest.mark.parametrize("istupd", [0, 1])
def test_from_the_deck(wall_and, istupd):
    """ISTUPD of *CONTROL_SHELL: a steel sheet far beyond yield thins by its plastic strain, or not at all."""
    sheet = "*PART\np\n2,1,2\n*ELEMENT_SHELL\n2,2,1,2,3,4\n"
    steel = "*MAT_PLASTIC_KINEMATIC\n2,1e-4,3.0,0.3,1e-6\n\n"
    model = wall_and(f"*CONTROL_SHELL\n20.0,,,{istupd}\n" + steel + sheet)
    model.state.v[1:3, 0], model.state.v[2:, 1] = (
        0.2,
        0.2,
    )  # equal strains of a square of side 2, from -dt/2 on
    model.state.dt = 1e-3
    model.forces[1].add(model.state)
    strain = 0.2 * 1e-3 / 2
    assert probe(model, shell=2, component="plastic-strain")() == pytest.approx(2 * strain, rel=0.02)
    thinned = T0 * (1 - 2 * strain) if istupd else T0
    assert probe(model, shell=2, component="thickness")() == pytest.approx(thinned, rel=1e-6)
