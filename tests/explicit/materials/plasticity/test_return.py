"""The three laws against an independent integration of the rate equations, against each other, and at their limits."""

import numpy as np
import pytest

from vmharness.explicit.materials._plasticity.constants import Plastic
from vmharness.explicit.materials._plasticity.piecewise_linear import curve, line

HARDENING = {"none": (0.0, 0.0), "isotropic": (5.0, 0.0), "kinematic": (0.0, 5.0), "mixed": (3.0, 2.0)}
LEGS = (
    np.random.default_rng(7).normal(size=(4, 6)) * 4e-3
)  # several times the yield strain, tensor components
HALVES = np.array([1, 1, 1, 2, 2, 2])  # tensor to engineering shears
PLANE = [0, 1, 3, 4, 5]


def constants(laws, H, C, rate=None):
    return Plastic(laws.E, laws.NU, C or None, line(laws.SIGY, H), rate)


def path(legs, steps):
    """Each leg in so many equal increments."""
    return np.repeat(legs / steps, steps, axis=0)


def von_mises(s):
    """sqrt(3/2 s : s) of the deviators of tensors (..., 6)."""
    mean = s[..., :3].mean(axis=-1, keepdims=True)
    return np.sqrt(1.5 * np.sum((s[..., :3] - mean) ** 2, axis=-1) + 3 * np.sum(s[..., 3:] ** 2, axis=-1))


def errors(computed, exact):
    """Distance of the computed from the exact stress, in units of the yield stress, for two refinements."""
    return [np.abs(np.asarray(c) - exact).max() / 0.3 for c in computed]


@pytest.mark.parametrize("hardening", HARDENING)
def test_solid_follows_the_rate_equations(laws, hardening):
    """To 3e-4 of the yield stress in 1600 steps, and linearly in the step."""
    H, C = HARDENING[hardening]
    exact, alpha, p, _ = laws.integrate(LEGS, H, C)
    runs = [laws.run("solid", constants(laws, H, C), path(LEGS * HALVES, n)) for n in (200, 400)]
    coarse, fine = errors([stress[-1] for stress, _ in runs], exact)
    assert fine < 3e-4
    assert coarse / fine == pytest.approx(2, abs=0.1)
    history = runs[-1][1]
    assert history[0] == pytest.approx(p, rel=2e-3)
    if C:
        assert history[1:] == pytest.approx(alpha, abs=2e-4)


@pytest.mark.parametrize("hardening", HARDENING)
def test_plane_stress_follows_the_rate_equations(laws, hardening):
    H, C = HARDENING[hardening]
    exact, alpha, p, strain = laws.integrate(LEGS, H, C, free=[2])
    increments = (LEGS * HALVES)[:, PLANE]
    runs = [laws.run("plane", constants(laws, H, C), path(increments, n)) for n in (200, 400)]
    coarse, fine = errors([stress[-1] for stress, *_ in runs], exact[PLANE])
    assert exact[2] == pytest.approx(0, abs=1e-9)
    assert fine < 3e-4
    assert coarse / fine == pytest.approx(2, abs=0.1)
    _, history, thickness = runs[-1]
    assert thickness[-1] == pytest.approx(strain[2], rel=2e-3)
    assert history[0] == pytest.approx(p, rel=2e-3)
    if C:
        back = np.array([alpha[0] - alpha[2], alpha[1] - alpha[2], *alpha[3:]])
        assert history[1:6] == pytest.approx(back, abs=2e-4)


@pytest.mark.parametrize("hardening", HARDENING)
def test_uniaxial_is_exact(laws, hardening):
    """With linear hardening backward Euler is exact, however large the step."""
    H, C = HARDENING[hardening]
    exact, alpha, p, _ = laws.integrate(LEGS, H, C, free=[1, 2, 3, 4, 5])
    stress, history = laws.run("uniaxial", constants(laws, H, C), LEGS[:, 0])
    assert stress[-1] == pytest.approx(exact[0], rel=1e-8)
    assert history[0] == pytest.approx(p, rel=1e-8)
    if C:
        assert history[1] == pytest.approx(1.5 * alpha[0], rel=1e-8)


@pytest.mark.parametrize("hardening", HARDENING)
def test_plane_stress_is_a_solid_without_normal_stress(laws, hardening):
    """The thickness strain that the plane-stress law returns leaves s_zz = 0 in the solid; one step, ten yields long."""
    H, C = HARDENING[hardening]
    increments = (LEGS * HALVES)[:, PLANE]
    stress, history, thickness = laws.run("plane", constants(laws, H, C), increments)
    whole = np.insert(increments, 2, np.diff(thickness), axis=1)
    solid, solid_history = laws.run("solid", constants(laws, H, C), whole)
    assert np.abs(solid[:, 2]).max() < 1e-12
    assert solid[:, PLANE] == pytest.approx(stress, abs=1e-12)
    assert solid_history[0] == pytest.approx(history[0], rel=1e-12)


@pytest.mark.parametrize("hardening", HARDENING)
@pytest.mark.parametrize("law", ["solid", "plane"])
def test_never_outside_the_yield_surface_and_never_gaining_energy(laws, law, hardening):
    """After steps of up to a hundred yield strains; at yield whenever p has grown; dissipation s : d(eps_p) >= 0."""
    H, C = HARDENING[hardening]
    generator = np.random.default_rng(3)
    for size in (1e-4, 1e-3, 1e-2, 0.1):
        legs = generator.normal(size=(30, 6)) * size
        increments = legs * HALVES if law == "solid" else (legs * HALVES)[:, PLANE]
        before = 0.0
        for n in range(1, 31):
            stress, history, *_ = laws.run(law, constants(laws, H, C), increments[:n])
            tensor = stress[-1] if law == "solid" else np.insert(stress[-1], 2, 0.0)
            back = history[1:7] if law == "solid" else np.insert(history[1:6], 2, 0.0)
            gap = von_mises(tensor - back) - (laws.SIGY + H * history[0])
            scale = laws.SIGY + laws.E * size
            assert gap < 1e-13 * scale
            assert history[0] >= before
            if history[0] > before:
                assert gap > -1e-13 * scale
            before = history[0]
        assert before > 0 or size < 1e-3


def test_elastic_until_yield(laws):
    """Below the yield stress every law is Hooke's, and leaves no trace."""
    c = constants(laws, 5.0, 3.0)
    small = LEGS[:1] * 0.05
    G = laws.E / (2 * (1 + laws.NU))
    stress, history = laws.run("solid", c, small * HALVES)
    mean = small[0, :3].mean()
    bulk = laws.E / (1 - 2 * laws.NU) * mean
    assert stress[-1, :3] == pytest.approx(2 * G * (small[0, :3] - mean) + bulk, rel=1e-12)
    assert stress[-1, 3:] == pytest.approx(2 * G * small[0, 3:], rel=1e-12)
    assert not history.any()
    assert von_mises(stress[-1]) < laws.SIGY
    plane, history, thickness = laws.run("plane", c, (small * HALVES)[:, PLANE])
    e = small[0]
    plate = laws.E / (1 - laws.NU**2)
    assert plane[-1, 0] == pytest.approx(plate * (e[0] + laws.NU * e[1]), rel=1e-12)
    assert thickness[-1] == pytest.approx(-laws.NU / (1 - laws.NU) * (e[0] + e[1]), rel=1e-12)
    assert not history.any()


def test_nothing_strained_is_nothing_stressed(laws):
    for law, shape in (("solid", (2, 6)), ("plane", (2, 5)), ("uniaxial", (2,))):
        stress, history, *_ = laws.run(
            law, constants(laws, 0.0, 1.0, (None, 1.0, 0.2, None)), np.zeros(shape), dt=0.0
        )
        assert not np.any(stress)
        assert not history.any()


@pytest.mark.parametrize("steps", [1, 7, 500])
def test_curve_in_uniaxial_stress(laws, steps):
    """s = Y(e - s/E), found from the points of the curve: with corners passed in one step, and beyond the last point."""
    p, y = np.array([0.0, 0.01, 0.03, 0.1, 0.2]), np.array([0.3, 0.4, 0.45, 0.5, 0.52])
    for strain in (0.009, 0.02, 0.09, 0.15, 0.5):
        c = Plastic(laws.E, laws.NU, None, curve(p, y), None)
        stress, history = laws.run("uniaxial", c, np.full(steps, strain / steps))
        total = p + y / laws.E  # the points as strain, with the last slope carried on
        slope = (y[-1] - y[-2]) / (total[-1] - total[-2])
        beyond = y[-1] + slope * (strain - total[-1])
        exact = beyond if strain > total[-1] else np.interp(strain, total, y)
        assert stress[-1] == pytest.approx(exact, rel=1e-12)
        assert history[0] == pytest.approx(strain - exact / laws.E, rel=1e-12)


@pytest.mark.parametrize("points", [2, 3, 8, 9, 60])
def test_any_number_of_points(laws, points):
    """A line through many points is the line; a curve is met at the end of each step, in each law."""
    p = np.linspace(0, 0.2, points)
    straight = curve(p, 0.3 + 2 * p)
    for law, legs in (
        ("solid", LEGS * HALVES),
        ("plane", (LEGS * HALVES)[:, PLANE]),
        ("uniaxial", LEGS[:, 0]),
    ):
        one = laws.run(law, Plastic(laws.E, laws.NU, None, straight, None), legs)[0]
        two = laws.run(law, constants(laws, 2.0, 0.0), legs)[0]
        assert one == pytest.approx(two, rel=1e-12, abs=1e-14)
    steep = curve(p, 0.3 + np.sqrt(p))
    for law, legs in (("solid", LEGS * HALVES), ("plane", (LEGS * HALVES)[:, PLANE])):
        stress, history, *_ = laws.run(law, Plastic(laws.E, laws.NU, None, steep, None), path(legs, 20))
        tensor = stress[-1] if law == "solid" else np.insert(stress[-1], 2, 0.0)
        assert von_mises(tensor) == pytest.approx(np.interp(history[0], p, 0.3 + np.sqrt(p)), rel=1e-12)


def test_cowper_symonds(laws):
    """1 + (100 / 40.4)^(1/5) = 2.198737 at a rate of 100, in tension, in each law; and half as fast, 2.043561."""
    rate = (None, 1 / 40.4, 1 / 5, None)
    for speed, factor in ((100.0, 2.198737), (50.0, 2.043561)):
        steps, strain = 400, 0.02
        dt = strain / steps / speed
        c = constants(laws, 0.0, 0.0, rate)
        stress, _ = laws.run("uniaxial", c, np.full(steps, strain / steps), dt)
        assert stress[-1] / laws.SIGY == pytest.approx(factor, abs=1e-6)
        # in flow the volume stays, so that lateral strains are -1/2
        plane = np.outer(np.full(steps, strain / steps), [1, -0.5, 0, 0, 0])
        stress, *_ = laws.run("plane", c, plane, dt)
        assert von_mises(np.insert(stress[-1], 2, 0.0)) / laws.SIGY == pytest.approx(factor, abs=1e-6)
        shear = np.outer(np.full(steps, strain * np.sqrt(3) / steps), [0, 0, 0, 1, 0, 0])
        stress, _ = laws.run("solid", c, shear, dt)
        assert stress[-1, 3] * np.sqrt(3) / laws.SIGY == pytest.approx(factor, abs=1e-6)


def test_rate_curve(laws):
    """Factors between the points of a curve, and beyond by the last slope."""
    rate = (curve(np.array([0.0, 10.0, 100.0]), np.array([1.0, 1.5, 2.0])), 0.0, 0.0, None)
    for speed, factor in ((5.0, 1.25), (46.0, 1.7), (190.0, 2.5)):
        stress, _ = laws.run("uniaxial", constants(laws, 0.0, 0.0, rate), np.full(100, 1e-3), 1e-3 / speed)
        assert stress[-1] / laws.SIGY == pytest.approx(factor, rel=1e-12)


@pytest.mark.parametrize("beta", [0.0, 0.25, 1.0])
def test_uniaxial_cycle(laws, beta):
    """To the strain 0.02 and back: reverse yield at s_max - 2 Y(p), which is -s_max or s_max - 2 SIGY; slope Et on it."""
    Et = 2.0
    Ep = laws.E * Et / (laws.E - Et)
    c = Plastic(laws.E, laws.NU, (1 - beta) * Ep, line(laws.SIGY, beta * Ep), None)
    strain = np.concatenate([np.linspace(0, 0.02, 2001), np.linspace(0.02, -0.02, 4001)[1:]])
    stress, _ = laws.run("uniaxial", c, np.diff(strain))
    peak = laws.SIGY + Et * (0.02 - laws.SIGY / laws.E)
    assert stress.max() == pytest.approx(peak, rel=1e-12)
    p = (peak - laws.SIGY) / Ep
    reverse = peak - 2 * (laws.SIGY + beta * Ep * p)
    yields = 0.02 - (peak - reverse) / laws.E
    back = strain[2000:]
    exact = np.where(back > yields, peak - laws.E * (0.02 - back), reverse - Et * (yields - back))
    assert stress[2000:] == pytest.approx(exact, rel=1e-9, abs=1e-12)
    assert reverse == pytest.approx({0.0: peak - 2 * laws.SIGY, 1.0: -peak}.get(beta, reverse))


# By the plastic rate (VP = 1): C, P and what goes with z, SIGY or Y.
SRC, SRP = 40.4, 5.0


def by_plastic_rate(laws, constant):
    return None, 1 / SRC, 1 / SRP, (SRC, SRP, constant * laws.SIGY, 1.0 - constant)


@pytest.mark.parametrize("constant", [0.0, 1.0])
def test_flow_at_a_constant_plastic_rate(laws, constant):
    """Without hardening all strain of steady flow is plastic: r = 2.198737 at 100, exactly, in each law."""
    c = constants(laws, 0.0, 0.0, by_plastic_rate(laws, constant))
    dt, rate = 1e-5, 100.0
    n = 80  # 8 % of strain: long enough to be steady
    r = 1 + (rate / SRC) ** (1 / SRP)
    assert r == pytest.approx(2.198737, rel=1e-6)
    bar, _ = laws.run("uniaxial", c, np.full(n, rate * dt), dt)
    assert bar[-1] == pytest.approx(r * laws.SIGY, rel=1e-12)
    shear = np.sqrt(3) * rate * dt  # effective rate gamma / sqrt(3)
    solid = laws.run("solid", c, np.tile([0, 0, 0, shear, 0, 0], (n, 1)), dt)[0]
    plane = laws.run("plane", c, np.tile([0, 0, shear, 0, 0], (n, 1)), dt)[0]
    np.testing.assert_allclose([solid[-1, 3], plane[-1, 2]], r * laws.SIGY / np.sqrt(3), rtol=1e-10)


def test_flow_with_hardening_at_a_constant_plastic_rate(laws):
    """In a bar dp/dt = rate E/(E + H) once it is steady: s = SIGY + H p + SIGY z(dp/dt)."""
    H, dt, rate = 2.0, 1e-5, 100.0
    stress, history = laws.run(
        "uniaxial", constants(laws, H, 0.0, by_plastic_rate(laws, 1.0)), np.full(200, rate * dt), dt
    )
    z = (rate * laws.E / (laws.E + H) / SRC) ** (1 / SRP)
    assert stress[-1] == pytest.approx(laws.SIGY * (1 + z) + H * history[0], rel=1e-9)


@pytest.mark.parametrize("law", ["uniaxial", "solid", "plane"])
@pytest.mark.parametrize("constant", [0.0, 1.0])
@pytest.mark.parametrize("dt", [1e-6, 1e-3, 10.0])
def test_the_yield_condition_holds_at_the_end_of_any_step(laws, law, constant, dt):
    """q = Y(p) + (A + B Y(p)) z with the step's own dp/dt, for small and large steps, fast and slow."""
    H = 2.0
    c = constants(laws, H, 0.0, by_plastic_rate(laws, constant))
    rng = np.random.default_rng(1)
    for size in (1e-4, 3e-3, 0.05):
        path = size * rng.normal(size=(30, {"solid": 6, "plane": 5, "uniaxial": 1}[law]))
        before = np.zeros(7)
        for n in range(1, 31):
            stress, history, *_ = laws.run(law, c, path[:n, 0] if law == "uniaxial" else path[:n], dt)
            dp, y = history[0] - before[0], laws.SIGY + H * history[0]
            before = history
            r = y + (constant * laws.SIGY + (1 - constant) * y) * (dp / dt / SRC) ** (1 / SRP)
            q = effective(law, stress[-1])
            assert dp >= 0.0
            assert q <= r * (1 + 1e-9)
            if dp > 0.0:
                assert q == pytest.approx(r, rel=1e-9)


def effective(law, s):
    """Mises stress."""
    if law == "uniaxial":
        return abs(s)
    if law == "plane":
        xx, yy, xy, yz, zx = s
        return np.sqrt(xx * xx + yy * yy - xx * yy + 3 * (xy * xy + yz * yz + zx * zx))
    xx, yy, zz, xy, yz, zx = s
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * normal + 3 * (xy * xy + yz * yz + zx * zx))


def test_a_slow_flow_by_the_plastic_rate_is_the_static_one(laws):
    c = constants(laws, 2.0, 0.0, by_plastic_rate(laws, 1.0))
    static, _ = laws.run("uniaxial", constants(laws, 2.0, 0.0), np.full(50, 1e-3), 1e30)
    slow, _ = laws.run("uniaxial", c, np.full(50, 1e-3), 1e30)
    np.testing.assert_allclose(slow, static, rtol=1e-6)
