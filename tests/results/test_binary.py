"""Binary result files: what is written is read, in single and in double precision, also where a file ends too early."""

import numpy as np
import pytest

from vmharness import results
from vmharness.results import Key, ResultError, recognise

TIME = np.linspace(0.0, 2.0, 9)
RANDOM = np.random.default_rng(4)


def some(*shape):
    return RANDOM.normal(size=(TIME.size, *shape)) * 10.0 ** RANDOM.integers(-20, 20)


def forces(count):
    return {f"{axis}_force": some(count) for axis in "xyz"}


def branches():
    """Every database: numbers, variables; and the quantities that these are."""
    found, expected = {}, {}
    motion = {
        f"{axis}_{name}": some(2)
        for axis in "xyz"
        for name in ("displacement", "velocity", "acceleration", "coordinate")
    }
    found["/nodout"] = ({"ids": [5, 70]}, motion)
    expected[Key("node", "y-velocity", 70)] = motion["y_velocity"][:, 1]
    expected[Key("node", "z-coordinate", 5)] = motion["z_coordinate"][:, 0]
    energies = {
        "kinetic_energy": some(),
        "energy_ratio": some(),
        "stonewall_energy": some(3),
        "global_x_velocity": some(),
    }
    found["/glstat"] = ({}, energies)
    expected |= {
        Key("energy", "kinetic"): energies["kinetic_energy"],
        Key("energy", "ratio"): energies["energy_ratio"],
    }
    expected[Key("energy", "rigid wall")] = energies["stonewall_energy"].sum(axis=1)
    expected[Key("model", "x-velocity")] = energies["global_x_velocity"]
    parts = {"internal_energy": some(2), "x_momentum": some(2), "y_rbvelocity": some(2)}
    found["/matsum"] = ({"ids": [1, 2]}, parts)
    expected[Key("part", "internal", 2)] = parts["internal_energy"][:, 1]
    expected[Key("part", "y-velocity", 1)] = parts["y_rbvelocity"][:, 0]
    contacts = forces(4)
    found["/rcforc"] = ({"ids": [1, 1, 9, 9], "side": [0, 1, 0, 1]}, contacts)
    expected[Key("contact", "z-force", 9)] = contacts["z_force"][:, 2]  # of side A
    sides = {"slave": some(3), "master": some(2)}
    found["/sleout"] = ({"ids": [1, 5, 9], "single_sided": [0, 1, 0]}, sides)
    expected[Key("contact", "energy", 1)] = sides["slave"][:, 0] + sides["master"][:, 0]
    expected[Key("contact", "energy", 5)] = sides["slave"][:, 1]  # of a single surface
    expected[Key("contact", "energy", 9)] = sides["slave"][:, 2] + sides["master"][:, 1]
    reactions = {
        **forces(2),
        **{f"{axis}_moment": some(1) for axis in "xyz"},
        **{f"{axis}_resultant": some() for axis in "xyz"},
    }
    found["/spcforc"] = ({"force_ids": [3, 4], "moment_ids": [4]}, reactions)
    expected[Key("support", "x-force", 4)] = reactions["x_force"][:, 1]
    expected[Key("support", "z-moment", 4)] = reactions["z_moment"][:, 0]
    expected[Key("support", "y-force")] = reactions["y_resultant"]
    walls = {"normal_force": some(2)}
    found["/rwforc/forces"] = ({"ids": [1, 2]}, walls)
    expected[Key("wall", "normal-force", 2)] = walls["normal_force"][:, 1]
    springs = {"resultant_force": some(1), "displacement": some(1)}
    found["/deforc"] = ({"ids": [11]}, springs)
    expected[Key("discrete", "elongation", 11)] = springs["displacement"][:, 0]
    joints = forces(2)
    found["/jntforc/joints"] = ({"ids": [1, 2]}, joints)
    expected[Key("joint", "y-force", 2)] = joints["y_force"][:, 1]
    bodies = {"global_x": some(1), "global_dz": some(1), "global_rvy": some(1)}
    found["/rbdout"] = ({"ids": [2]}, bodies)
    expected |= {
        Key("rigid", "x-coordinate", 2): bodies["global_x"][:, 0],
        Key("rigid", "z-displacement", 2): bodies["global_dz"][:, 0],
    }
    expected[Key("rigid", "y-angular-velocity", 2)] = bodies["global_rvy"][:, 0]
    driven = {f"{axis}force": some(2) for axis in "xyz"}
    found["/bndout/velocity/nodes"] = ({"ids": [8, 9]}, driven)
    expected[Key("driven node", "z-force", 9)] = driven["zforce"][:, 1]
    stress = {"sig_xx": some(3), "plastic_strain": some(3)}
    found["/elout/shell"] = (
        {},
        {**stress, "ids": np.full((TIME.size, 2), [4, 7]), "nip": np.full((TIME.size, 2), [1, 2])},
    )
    expected[Key("shell", "xx-stress", 7, 2)] = stress["sig_xx"][:, 2]
    expected[Key("shell", "plastic-strain", 4, 1)] = stress["plastic_strain"][:, 0]
    return found, expected


@pytest.mark.parametrize(("letter", "digits"), [("f", 7), ("d", 16)])
def test_every_database_of_a_binout_is_read(binary, tmp_path, letter, digits):
    found, expected = branches()
    if letter == "f":
        found = {
            k: (about, {n: np.float32(v * 1e-10) if v.max() > 1e10 else v for n, v in each.items()})
            for k, (about, each) in found.items()
        }
    path = tmp_path / "binout"
    binary.binout(path, TIME, found, letter)
    form = recognise(path)
    assert form.NAME == "binout"
    series = form.read(path, set(expected))
    assert {each.solver for each in series} == {"LS-DYNA R14.1"}
    assert all(each.digits == pytest.approx(digits, abs=0.5) for each in series)
    read = {key: values for each in series for key, values in each.columns.items()}
    assert read.keys() == expected.keys()
    if letter == "d":
        for key, values in expected.items():
            np.testing.assert_array_equal(read[key], values, err_msg=str(key))


def motion_of(binary, path, letter="d"):
    z = some(2)
    binary.binout(
        path, TIME, {"/nodout": ({"ids": [5, 70]}, {"z_displacement": z, "x_displacement": some(2)})}, letter
    )
    return {Key("node", "z-displacement", 5): z[:, 0], Key("node", "z-displacement", 70): z[:, 1]}


def test_of_a_binout_that_is_cut_off_the_complete_states_are_used(binary, tmp_path):
    path = tmp_path / "binout"
    expected = motion_of(binary, path)
    content = path.read_bytes()
    for end in range(len(content) - 1, len(content) // 2, -37):
        path.write_bytes(content[:end])
        (series,) = recognise(path).read(path, set(expected))
        assert 3 <= series.time.size < TIME.size
        assert any("table of symbols" in note for note in series.notes)
        for key, values in series.columns.items():
            np.testing.assert_array_equal(values, expected[key][: series.time.size])


def test_a_file_that_continues_a_binout_is_read_with_it(binary, tmp_path):
    path = tmp_path / "binout"
    expected = motion_of(binary, path)
    z = np.column_stack(list(expected.values()))
    binary.binout(path, TIME[:4], {"/nodout": ({"ids": [5, 70]}, {"z_displacement": z[:4]})}, "d")
    rest = tmp_path / "binout%001"
    binary.binout(rest, TIME[4:], {"/nodout": ({}, {"z_displacement": z[4:]})}, "d")
    form = recognise(path)
    (series,) = form.read(path, set(expected))
    np.testing.assert_array_equal(series.time, TIME)
    for key, values in expected.items():
        np.testing.assert_array_equal(series.columns[key], values)
    assert form.read(rest, set(expected)) == []


def test_a_number_that_is_none_is_named_with_its_place(binary, tmp_path):
    path = tmp_path / "binout"
    z = some(1)
    z[6] = np.nan
    binary.binout(path, TIME, {"/nodout": ({"ids": [5]}, {"z_displacement": z})})
    with pytest.raises(
        ResultError, match="binout: /nodout/d000007: z-displacement of node 5 is nan: the run has diverged"
    ):
        recognise(path).read(path, {Key("node", "z-displacement", 5)})


def family(binary, path, **options):
    numbers, x0 = [5, 70, 900], RANDOM.normal(size=(3, 3))
    motion = [x0 + some(3, 3) * 1e-3, some(3, 3), some(3, 3)]
    globals_, of_parts, stress, axial = some(6), some(2, 7), some(2, 7), some(1, 6)
    binary.d3plot(
        path,
        TIME,
        (numbers, motion),
        x0,
        globals_,
        ([1, 8], of_parts),
        ([30, 31], stress),
        ([44], axial),
        **options,
    )
    return {
        Key("node", "x-coordinate", 70): motion[0][:, 1, 0],
        Key("node", "y-displacement", 900): motion[0][:, 2, 1] - x0[2, 1],
        Key("node", "z-velocity", 5): motion[1][:, 0, 2],
        Key("node", "x-acceleration", 900): motion[2][:, 2, 0],
        Key("energy", "kinetic"): globals_[:, 0],
        Key("energy", "total"): globals_[:, 2],
        Key("model", "y-velocity"): globals_[:, 4],
        Key("part", "internal", 8): of_parts[:, 1, 0],
        Key("part", "z-velocity", 1): of_parts[:, 0, 4],
        Key("part", "hourglass", 8): of_parts[:, 1, 6],
        Key("solid", "yz-stress", 31, 1): stress[:, 1, 4],
        Key("solid", "plastic-strain", 30, 1): stress[:, 0, 6],
        Key("beam", "t-shear", 44): axial[:, 0, 2],
    }


@pytest.mark.parametrize("letter", ["f", "d"])
@pytest.mark.parametrize("files", [1, 3])
@pytest.mark.parametrize("titles", [False, True])
def test_a_d3plot_is_read_with_the_files_that_continue_it(binary, tmp_path, letter, files, titles):
    path = tmp_path / "d3plot"
    RANDOM.bit_generator.state = np.random.default_rng(7).bit_generator.state
    expected = family(binary, path, letter=letter, files=files, titles=titles)
    form = recognise(path)
    assert form.NAME == "d3plot"
    (series,) = form.read(path, set(expected))
    np.testing.assert_allclose(series.time, TIME, rtol=1e-7)
    assert series.columns.keys() == expected.keys()
    for key, values in expected.items():
        close = (
            {"rtol": 1e-6, "atol": 1e-6 * np.abs(values).max()}
            if letter == "f"
            else {"rtol": 1e-12, "atol": 1e-15}
        )
        np.testing.assert_allclose(series.columns[key], values, **close, err_msg=str(key))


def test_a_state_of_zeros_is_none_only_at_the_end_of_a_file(binary, tmp_path):
    motion = np.zeros((3, TIME.size, 1, 3))
    motion[0, :, 0, 0] = TIME
    path = tmp_path / "d3plot"
    binary.d3plot(path, TIME, ([1], motion), np.zeros((1, 3)), np.zeros((TIME.size, 6)), files=2)
    (series,) = recognise(path).read(path, {Key("node", "x-displacement", 1)})
    np.testing.assert_allclose(series.time, TIME)


def test_of_a_d3plot_that_is_cut_off_the_complete_states_are_used(binary, tmp_path):
    path = tmp_path / "d3plot"
    expected = family(binary, path)
    content = path.read_bytes()[: -512 * 4]
    path.write_bytes(content[:-50])
    (series,) = recognise(path).read(path, set(expected))
    assert series.time.size == TIME.size - 1
    assert series.notes == ("d3plot: the file ends within a state, which is left out",)


def history(binary, path, **options):
    globals_, of_parts, motion = some(12), some(2, 3), some(3, 5)
    binary.t01(
        path,
        TIME,
        0.01,
        globals_,
        ([1, 8], [1, 2, 7], of_parts),
        ([5, 70, 900], [1, 3, 6, 7, 18], motion),
        **options,
    )
    return {
        Key("energy", "internal"): globals_[:, 0],
        Key("energy", "kinetic"): globals_[:, 1] + globals_[:, 7],  # of translation and of rotation
        Key("energy", "external work"): globals_[:, 8],
        Key("energy", "hourglass"): globals_[:, 11],
        Key("model", "y-momentum"): globals_[:, 3],
        Key("part", "kinetic", 8): of_parts[:, 1, 1],
        Key("part", "hourglass", 1): of_parts[:, 0, 2],
        Key("node", "z-displacement", 70): motion[:, 1, 1],
        Key("node", "x-acceleration", 5): motion[:, 0, 3],
        Key("node", "z-coordinate", 900): motion[:, 2, 4],
        Key("node", "z-velocity", 5): motion[:, 0, 2],
    }


@pytest.mark.parametrize(("version", "title"), [(4021, 100), (3050, 100), (3041, 80), (3040, 40)])
def test_a_t01_is_read_and_its_velocities_are_those_of_half_a_step_before(binary, tmp_path, version, title):
    path = tmp_path / "caseT01"
    expected = history(binary, path, version=version, title=title)
    form = recognise(path)
    assert form.NAME == "T01"
    still, moving = form.read(path, set(expected))
    np.testing.assert_allclose(still.time, TIME)
    np.testing.assert_allclose(moving.time, [0.0, *(TIME[1:] - 0.005)], rtol=1e-6)
    read = {**still.columns, **moving.columns}
    assert read.keys() == expected.keys()
    for key, values in expected.items():
        np.testing.assert_allclose(
            read[key], values, rtol=1e-6, atol=1e-6 * np.abs(values).max(), err_msg=str(key)
        )


def test_of_a_t01_that_is_cut_off_the_complete_instants_are_used(binary, tmp_path):
    path = tmp_path / "caseT01"
    expected = history(binary, path)
    path.write_bytes(path.read_bytes()[:-11])
    for series in recognise(path).read(path, set(expected)):
        assert series.time.size == TIME.size - 1
        assert series.notes == ("caseT01: the file ends within instant 9, which is left out",)


def test_a_file_of_no_known_format_is_recognised_as_none(tmp_path):
    for content in (b"", b"\0" * 4096, b"hello\n", bytes(range(256)) * 20):
        (tmp_path / "file").write_bytes(content)
        assert results.recognise(tmp_path / "file") is None
