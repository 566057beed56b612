"""Rigid motions, force as the gradient of the energy, balance, exact stiffness, a beam rolled to a circle."""

import numpy as np
import pytest

X = np.array([[0.1, -0.2, 0.3], [0.5, 0.3, 0.1]])
NODES = [[0, 1]]
SHEARED = 1e-4  # a shear area


def test_a_rigid_motion_through_a_full_turn_gives_no_force(bench):
    """36 steps of 10 degrees about a skew axis while it flies."""
    block, s = bench.beams(X, NODES), bench.at_rest(X)
    axis = np.array([1.0, 2.0, -1.0]) / np.sqrt(6)
    for k in range(1, 37):
        x = X @ bench.rotation(2 * np.pi * k / 36 * axis).T + 0.3 * k
        bench.internal(block, s, x, np.tile(2 * np.pi / 36 * axis, (2, 1)))
        assert np.abs(block.resultants[0, 0]) < 1e-13 * bench.E * bench.RECTANGLE.a
        assert np.abs(block.resultants[0, 1:]).max() < 1e-11 * bench.E * bench.RECTANGLE.iss
    assert block.energy["internal"][0] < 1e-12 * bench.E * bench.RECTANGLE.iss


def deformed(bench, section=None):
    """A beam far from its first place, bent, twisted and stretched by several degrees and per cent."""
    turn = np.array([0.7, -1.1, 0.4])
    x = X @ bench.rotation(turn).T + np.array([[0, 0, 0], [0.02, -0.01, 0.03]])
    block, s = bench.beams(X, NODES, section or bench.RECTANGLE), bench.at_rest(X)
    bench.internal(block, s, X @ bench.rotation(turn).T, np.tile(turn, (2, 1)))
    assert block.energy["internal"][0] < 1e-9
    return block, s, x, np.array([[0.1, -0.05, 0.2], [-0.15, 0.12, 0.07]])


def test_force_is_minus_the_gradient_of_the_energy(bench):
    block, s, x, bend = deformed(bench)
    f = bench.internal(block, s, x, bend)
    for node, k in np.ndindex(2, 6):

        def energy(sign, node=node, k=k):
            again, state, place, turn = deformed(bench)
            bench.internal(again, state, place, turn)
            d = np.zeros((2, 6))
            d[node, k] = sign * 1e-5
            bench.internal(again, state, place + d[:, :3], d[:, 3:])
            return again.energy["internal"][0]

        slope = (energy(1) - energy(-1)) / 2e-5
        assert f[node, k] == pytest.approx(slope, rel=1e-6, abs=1e-6 * np.abs(f[:, 3 * (k > 2) :]).max())


def test_forces_and_moments_balance(bench):
    block, s, x, bend = deformed(bench)
    f = bench.internal(block, s, x, bend)
    assert f[:, :3].sum(axis=0) == pytest.approx(np.zeros(3), abs=1e-12 * np.abs(f).max())
    about_origin = f[:, 3:].sum(axis=0) + np.cross(x, f[:, :3]).sum(axis=0)
    assert about_origin == pytest.approx(np.zeros(3), abs=1e-12 * np.abs(f).max())


@pytest.mark.parametrize("sa", [0.0, SHEARED])
def test_stiffness_is_that_of_the_textbook(bench, sa):
    """All 144 terms, for a beam along x with s along z (t along -y), short enough for shear to matter."""
    a, iss, itt, j = 2e-4, 6.667e-9, 1.6667e-9, 4.578e-9
    section, L = bench.section(a, iss, itt, j, sa), 0.05
    x = np.array([[0.0, 0, 0], [L, 0, 0]])
    K = np.zeros((12, 12))

    def put(rows, block):
        K[np.ix_(rows, rows)] += block

    bar = np.array([[1.0, -1], [-1, 1]])
    put([0, 6], bench.E * a / L * bar)
    put([3, 9], bench.G * j / L * bar)
    # bending in the x-z plane turns the section about y, that is about t; in the x-y plane about s
    for moment, w, turn, sign in ((iss, 1, 5, 1), (itt, 2, 4, -1)):
        phi = 12 * bench.E * moment / (bench.G * sa * L**2) if sa else 0.0
        k = bench.E * moment / (L**3 * (1 + phi))
        near, far = (4 + phi) * L**2, (2 - phi) * L**2
        c = sign * 6 * L
        put(
            [w, turn, w + 6, turn + 6],
            k * np.array([[12, c, -12, c], [c, near, -c, far], [-12, -c, 12, -c], [c, far, -c, near]]),
        )
    computed = bench.stiffness_matrix(x, NODES, section)
    scale = np.sqrt(np.outer(np.diag(K), np.diag(K)))
    assert computed / scale == pytest.approx(K / scale, abs=1e-7)


def test_a_beam_rolls_up_to_a_full_circle(bench):
    """Twelve sides of a polygon: every element bears just M = EI phi / L, without any force."""
    n, L = 12, 0.1
    x, nodes = bench.line([L] * n)
    block, s = bench.beams(x, nodes), bench.at_rest(x)
    for bend in np.linspace(0, 2 * np.pi / n, 13)[1:]:  # of each element; its axis s is z, so it bends in x-y
        angle = bend * (np.arange(n) + 0.5)
        corners = np.vstack(
            [np.zeros(3), np.cumsum(L * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle]), axis=0)]
        )
        turn = np.zeros_like(x)
        turn[:, 2] = 2 * np.pi / n / 12 * np.arange(n + 1)
        f = bench.internal(block, s, corners, turn)
    assert corners[-1] == pytest.approx(np.zeros(3), abs=1e-12)
    moment = bench.E * bench.RECTANGLE.iss * 2 * np.pi / n / L
    assert f[-1, 5] == pytest.approx(moment, rel=1e-9)
    assert f[0, 5] == pytest.approx(-moment, rel=1e-9)
    assert np.abs(f[1:-1]).max() < 1e-6 * moment
    for element in (0, n // 2):
        for end in (1, 2):
            assert block.probe(element, end, "s-moment")() == pytest.approx(moment, rel=1e-9)
            assert block.probe(element, end, "t-shear")() == pytest.approx(0.0, abs=1e-6 * moment)


def test_resultants_of_a_cantilever_with_a_force_at_its_end(bench):
    """F along t: deflection F L^3 / 3 EI_ss, rotation F L^2 / 2 EI_ss; shear F, moment about s -F (L - r)."""
    L, F = 0.5, 1e-3
    x = np.array([[0.0, 0, 0], [L, 0, 0]])
    block, EI = (
        bench.beams(x, NODES, orientation=(0.0, 1.0, 0.0)),
        bench.E * bench.RECTANGLE.iss,
    )  # s = y, t = z
    turn = np.array([[0.0, 0, 0], [0, -F * L**2 / (2 * EI), 0]])
    bench.internal(block, bench.at_rest(x), x + np.array([[0.0, 0, 0], [0, 0, F * L**3 / (3 * EI)]]), turn)
    read = {
        name: [block.probe(0, end, name)() for end in (1, 2)]
        for name in ("t-shear", "s-moment", "s-shear", "t-moment", "torsion")
    }
    assert read["t-shear"] == pytest.approx([F, F], rel=1e-6)
    assert read["s-moment"] == pytest.approx([-F * L, 0.0], rel=1e-6, abs=1e-6 * F * L)
    for name in ("s-shear", "t-moment", "torsion"):
        assert read[name] == pytest.approx([0.0, 0.0], abs=1e-9 * F)


def test_axial_force_and_torsion(bench):
    """EA strain and G J twist / L, tension and right-handed twist positive."""
    L = 0.5
    x = np.array([[0.0, 0, 0], [L, 0, 0]])
    block = bench.beams(x, NODES)
    bench.internal(block, bench.at_rest(x), x * 1.001, np.array([[0.0, 0, 0], [0.2, 0, 0]]))
    assert block.probe(0, 1, "axial-stress")() == pytest.approx(bench.E * 0.001)
    assert block.probe(0, 2, "axial-force")() == pytest.approx(bench.E * bench.RECTANGLE.a * 0.001)
    assert block.probe(0, 2, "torsion")() == pytest.approx(bench.G * bench.RECTANGLE.j * 0.2 / L)


def test_probe_says_what_there_is(bench):
    block = bench.beams(X, NODES)
    with pytest.raises(
        ValueError, match="no 'xx-stress' of a beam; there are: axial-force, axial-stress, s-shear"
    ):
        block.probe(0, 1, "xx-stress")
    with pytest.raises(ValueError, match="no point 3; a beam has its ends 1 and 2"):
        block.probe(0, 3, "torsion")
