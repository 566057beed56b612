"""The default step is stable for every free mesh, and LS-DYNA's where that is stable."""

import numpy as np
import pytest

from vmharness.explicit.build import build
from vmharness.explicit.energy import accounts, stored
from vmharness.explicit.error import SolverError
from vmharness.explicit.loop import steps
from vmharness.explicit.timestep.stable_step import StableStep

SOLIDS = [f"{shape} of ELFORM {elform}" for shape in ("hexahedra", "wedges") for elform in (1, 2)]
SHELLS = [f"{shape} with ISDO {isdo}" for shape in ("quadrilaterals", "triangles") for isdo in (0, 1, 2)]
CYCLES, MEAN = 2000, 200


def energies(model):
    """The total energy less the external work, at every cycle."""
    items = [*model.forces, *model.constraints]
    inside, work = stored(items), accounts(items, "external work")
    total = [
        model.kinetic() + sum(a.item() for a in inside) - sum(a.item() for a in work) for _ in steps(model)
    ]
    return np.array(total)


@pytest.mark.parametrize("extra", [False, True], ids=["alone", "with springs, bars and masses"])
@pytest.mark.parametrize("kind", [*SOLIDS, *SHELLS, "beams", "trusses"])
def test_random_free_meshes_keep_their_energy(deck, free_mesh, kind, extra):
    """Waves of all lengths: an unstable one would grow by many orders of magnitude in 2000 cycles."""
    for seed in range(4):
        energy = energies(build(deck(free_mesh(kind, seed, CYCLES, extra))))
        assert len(energy) == CYCLES + 1
        assert energy[-MEAN:].mean() <= 1.02 * energy[:MEAN].mean(), f"mesh {seed}"


CUBES = """*KEYWORD
*CONTROL_TERMINATION
1.0,{cycles}
*CONTROL_TIMESTEP
0.0,{tssfac}
*PART
block
1,1,1
*SECTION_SOLID
1,{elform}
*MAT_ELASTIC
1,7800.0,2.0e11,{nu}
*CONTROL_BULK_VISCOSITY
1.5,{q2}
*CONTROL_HOURGLASS
4,0.1
"""


def cubes(cells, elform=1, nu=0.3, q2=0.0, tssfac=0.9, cycles=10, cards=""):
    """A free block of cubes of side 1, at rest unless `cards` move it."""
    count = np.array(cells) + 1
    n = np.arange(1, count.prod() + 1).reshape(count)
    nodes = "".join(f"{n[i, j, k]},{float(i)},{float(j)},{float(k)}\n" for i, j, k in np.ndindex(*count))
    low = [n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]]
    corners = np.stack([c[..., :-1] for c in low] + [c[..., 1:] for c in low], axis=-1).reshape(-1, 8)
    solids = "".join(f"{e},1,{','.join(map(str, row))}\n" for e, row in enumerate(corners, 1))
    head = CUBES.format(cycles=cycles, tssfac=tssfac, elform=elform, nu=nu, q2=q2)
    return f"{head}*NODE\n{nodes}*ELEMENT_SOLID\n{solids}{cards}*END\n"


def own_step(nu):
    """L/c of the cube."""
    return np.sqrt(7800.0 * (1 + nu) * (1 - 2 * nu) / (2.0e11 * (1 - nu)))


def first_step(model):
    stepping = steps(model)
    next(stepping)
    return next(stepping).dt


@pytest.mark.parametrize("elform", [1, 2])
@pytest.mark.parametrize("nu", [0.0, 0.3, 0.45])
def test_a_free_cube_gets_its_exact_limit(deck, elform, nu):
    """2/omega_max = sqrt((1 - nu)/(1 + nu)) L/c of the mode that stretches it in all directions."""
    model = build(deck(cubes((1, 1, 1), elform, nu)))
    limit = np.sqrt((1 - nu) / (1 + nu))
    assert first_step(model) == pytest.approx(min(0.9, 0.95 * limit) * own_step(nu), rel=1e-3)
    assert ("Stable step" in model.facts) is (nu > 0.0)


@pytest.mark.parametrize(
    ("cells", "limit"), [((4, 1, 1), 0.805), ((4, 4, 1), 0.891), ((2, 2, 2), 0.939), ((3, 3, 3), 0.932)]
)
def test_free_blocks_of_cubes_get_theirs(deck, cells, limit):
    """As of R. Kolman, J. Plesek, D. Gabriel (2012) for 2 x 2 x 2, and by eigenvalues for the others."""
    model = build(deck(cubes(cells)))
    stable = StableStep(model)
    next(steps(model))
    stable.limited(1.0)
    assert stable.ratio == pytest.approx(limit, abs=0.004)


def test_linear_viscosity_shortens_the_step_by_half_its_effect(deck):
    """dt^2/4 K + dt/2 C/2 = M for the mode that stretches the cube, since it is compressed every other step only.

    With h = L/c: K/M = 4/(s h)^2 with s^2 = (1 - nu)/(1 + nu), and C/K = Q2 h rho c^2/K_bulk. With r = dt/h,

        (r/s)^2 (1 + Q2 rho c^2/K_bulk / r) = 1
    """
    q2, nu = 0.06, 0.3
    s2, share = (1 - nu) / (1 + nu), 3 * (1 - nu) / (1 + nu)
    r = np.roots([1.0, q2 * share, -s2]).max()
    assert first_step(build(deck(cubes((1, 1, 1), q2=q2)))) == pytest.approx(
        0.95 * r * own_step(nu), rel=2e-3
    )


HELD = "*BOUNDARY_SPC_NODE\n" + "".join(
    f"{n},0,1,1,{1 if n in (1, 3, 5, 7) else 0},0,0,0\n" for n in range(1, 9)
)


RIGID = """*PART
light
2,1,2
*MAT_RIGID
2,{density},2.0e11,0.3


*NODE
21,0.0,0.0,2.0
22,1.0,0.0,2.0
23,1.0,1.0,2.0
24,0.0,1.0,2.0
*ELEMENT_SOLID
9,2,2,6,8,4,21,22,23,24
*INITIAL_VELOCITY_NODE
1,1.0,-1.0,0.5
"""


@pytest.mark.parametrize("density", [1.0, 7800.0, 7.8e5])
def test_a_cube_on_a_rigid_body_is_stable_up_to_its_own_limit(deck, density):
    """The body takes part with its mass and inertia, however light: 2 % above the limit the run diverges."""
    text = cubes((1, 1, 1), cycles=2000, cards=RIGID.format(density=density))
    energy = energies(model := build(deck(text)))
    assert energy[-MEAN:].mean() <= 1.01 * energy[:MEAN].mean()
    stable = StableStep(model)
    limit = stable.limited(1.0) / 0.95
    curve = f"*DEFINE_CURVE\n1\n0.0,{1.02 * limit}\n10.0,{1.02 * limit}\n*CONTROL_TIMESTEP\n,9.0,,,,1\n"
    text = cubes((1, 1, 1), cycles=20000, cards=RIGID.format(density=density)).replace(
        "*CONTROL_TIMESTEP\n0.0,0.9\n", curve
    )
    with pytest.raises(SolverError, match=r"(diverged|vanished).* of the stable one of solid 1 of part 1"):
        list(steps(build(deck(text))))


def test_a_held_element_and_a_shorter_step_of_the_user_keep_ls_dynas_step(deck):
    """Uniaxial strain: the limit is sqrt(2) L/c or more, and the step is TSSFAC L/c."""
    for tssfac in (0.9, 0.95):
        model = build(deck(cubes((1, 1, 1), tssfac=tssfac, cards=HELD)))
        assert first_step(model) == pytest.approx(tssfac * own_step(0.3), rel=1e-12)
        assert "Stable step" not in model.facts
    free = build(deck(cubes((1, 1, 1), tssfac=0.6)))
    assert first_step(free) == pytest.approx(0.6 * own_step(0.3), rel=1e-12)
    assert "Stable step" not in free.facts


def test_the_fact_names_factor_and_element(deck):
    model = build(deck(cubes((1, 1, 1))))
    first_step(model)
    expected = (
        "0.775 of LS-DYNA's step, since this mesh is stable only up to 0.734 of the step of its elements"
    )
    assert model.facts["Stable step"] == f"{expected}; solid 1 of part 1 limits it"


def test_a_mesh_that_has_deformed_is_looked_at_again(deck):
    """A cube that is stretched in all directions: h grows with L, but 2/omega_max falls with L^-1/2."""
    model = build(deck(cubes((1, 1, 1))))
    stable, s = StableStep(model), model.state
    next(steps(model))
    limit = stable.limited(1.0)
    s.x *= 1.05
    s.cycle = 1000
    model.blocks[0].add(s)
    assert stable.limited(1.0) == pytest.approx(limit / 1.05**0.5, rel=1e-3)


def test_a_run_that_diverges_names_the_element_its_share_and_tssfac(deck):
    move = "*INITIAL_VELOCITY_NODE\n1,1e-6,0.0,0.0\n"
    with pytest.raises(SolverError) as error:
        list(steps(build(deck(cubes((1, 1, 1), tssfac=1.3, cycles=5000, cards=move)))))
    message = str(error.value)
    assert (
        "up to 1.3 of the stable one of solid 1 of part 1, with TSSFAC = 1.3: TSSFAC = 0.95 or less is"
        in message
    )
    assert "LCTM" not in message


def test_finding_the_step_changes_no_state(deck, free_mesh):
    for kind in (*SOLIDS[:2], *SHELLS[:1], "beams", "trusses"):
        model = build(deck(free_mesh(kind, 1, 50, True)))
        for s in steps(model):
            if s.cycle == 30:
                break
        kept = {
            name: getattr(s, name).copy() for name in ("x", "v", "omega", "f", "moment", "mass", "inertia")
        }
        energy = [a.copy() for a in stored([*model.forces, *model.constraints])]
        other = [block.__dict__.copy() for block in model.blocks]
        arrays = [{k: v.copy() for k, v in one.items() if isinstance(v, np.ndarray)} for one in other]
        StableStep(model).limited(1.0)
        for name, value in kept.items():
            np.testing.assert_array_equal(getattr(s, name), value)
        for a, b in zip(stored([*model.forces, *model.constraints]), energy, strict=True):
            assert a == b
        for block, one in zip(model.blocks, arrays, strict=True):
            for name, value in one.items():
                if name != "_work":
                    np.testing.assert_array_equal(getattr(block, name), value)
