"""Text databases of LS-DYNA: what a file holds is read to the digits that it has."""

import re

import numpy as np
import pytest

from vmharness import results
from vmharness.results import Key, ResultError, recognise

TIME = np.linspace(0.0, 2.0, 9)
MOTION = [
    f"{axis}-{quantity}"
    for quantity in ("displacement", "velocity", "acceleration", "coordinate")
    for axis in "xyz"
]
BODY = [
    *MOTION,
    *(f"{axis}-{q}" for q in ("rotation", "angular-velocity", "angular-acceleration") for axis in "xyz"),
]
FORCES, MOMENTS = [f"{axis}-force" for axis in "xyz"], [f"{axis}-moment" for axis in "xyz"]
STRESSES = [f"{axes}-stress" for axes in ("xx", "yy", "zz", "xy", "yz", "zx")]
FIBRES = ["axial-stress", "xy-stress", "zx-stress", "plastic-strain"]
RESULTANTS = ["axial-force", "s-shear", "t-shear", "s-moment", "t-moment", "torsion"]


def column(seed):
    """Values of both signs and of many magnitudes, which fill their fields: numbers touch, exponents have three digits."""
    random = np.random.default_rng(seed)
    return (
        random.choice([-1.0, 1.0], TIME.size)
        * random.uniform(1.0, 9.0, TIME.size)
        * 10.0 ** random.integers(-120, 120, TIME.size)
    )


def columns(names, seed=0):
    return {name: column(seed + place) for place, name in enumerate(names)}


def nodout(lsdyna, path):
    nodes = {7: columns(MOTION), 12345678: columns(MOTION, 50)}
    lsdyna.nodout(path, TIME, nodes, rotations=True)
    return {Key("node", name, n): values for n, each in nodes.items() for name, values in each.items()}


def glstat(lsdyna, path):
    names = {
        "kinetic energy": "kinetic", "internal energy": "internal", "spring and damper energy": "spring and damper",
        "hourglass energy": "hourglass", "system damping energy": "damping", "sliding interface energy": "sliding",
        "external work": "external work", "total energy": "total", "total energy / initial energy": "ratio",
    }  # fmt: skip
    energies = columns(names)
    lsdyna.glstat(path, TIME, energies)
    return {Key("energy", names[line]): values for line, values in energies.items()}


def matsum(lsdyna, path):
    names = [
        "internal",
        "kinetic",
        "hourglass",
        *(f"{a}-{q}" for q in ("momentum", "velocity") for a in "xyz"),
    ]
    parts = {1: columns(names), 34567: columns(names, 40)}
    lsdyna.matsum(path, TIME, parts)
    return {Key("part", name, n): values for n, each in parts.items() for name, values in each.items()}


def rcforc(lsdyna, path, sides=("slave ", "master")):
    contacts = {1: columns(FORCES), 77: columns(FORCES, 9)}
    lsdyna.rcforc(path, TIME, contacts, sides)
    return {Key("contact", name, n): values for n, each in contacts.items() for name, values in each.items()}


def rcforc_of_newer_versions(lsdyna, path):
    return rcforc(lsdyna, path, ("SURFA ", "SURFB "))


def spcforc(lsdyna, path):
    nodes = {3: columns([*FORCES, *MOMENTS]), 40: columns([*FORCES, *MOMENTS], 20)}
    lsdyna.spcforc(path, TIME, nodes)
    found = {Key("support", name, n): values for n, each in nodes.items() for name, values in each.items()}
    total = {Key("support", name): nodes[3][name] + nodes[40][name] for name in FORCES}
    return found | total


def rwforc(lsdyna, path, segments=0):
    walls = {1: column(1), 20: column(2)}
    lsdyna.rwforc(path, TIME, walls, segments)
    return {Key("wall", "normal-force", n): values for n, values in walls.items()}


def rwforc_with_segments(lsdyna, path):
    return rwforc(lsdyna, path, segments=3)


def deforc(lsdyna, path):
    lines = ["x-force", "y-force", "z-force", "resultant force", "change in length"]
    springs = {5: columns(lines), 600: columns(lines, 8)}
    lsdyna.dotted(path, TIME, "spring/damper number", springs)
    names = {"force": "resultant force", "elongation": "change in length"}
    return {Key("discrete", name, n): springs[n][line] for n in springs for name, line in names.items()}


def jntforc(lsdyna, path):
    joints = {1: columns([*FORCES, *MOMENTS]), 2: columns([*FORCES, *MOMENTS], 30)}
    lsdyna.dotted(path, TIME, "joint number", joints)
    return {Key("joint", name, n): values for n, each in joints.items() for name, values in each.items()}


def sleout(lsdyna, path):
    contacts = {1: (column(1), column(2)), 9: (column(3),)}
    lsdyna.sleout(path, TIME, contacts)
    return {Key("contact", "energy", n): sum(sides) for n, sides in contacts.items()}


def rbdout(lsdyna, path):
    bodies = {2: columns(BODY), 31: columns(BODY, 60)}
    lsdyna.rbdout(path, TIME, bodies)
    return {Key("rigid", name, n): values for n, each in bodies.items() for name, values in each.items()}


def bndout(lsdyna, path):
    nodes = {4: columns(FORCES), 5: columns(FORCES, 70)}
    lsdyna.bndout(path, TIME, nodes)
    return {Key("driven node", name, n): values for n, each in nodes.items() for name, values in each.items()}


def elout(lsdyna, path):
    solids = {1: np.column_stack([column(k) for k in range(6)])}
    shells = {
        8: (
            np.stack([np.column_stack([column(10 * p + k) for k in range(6)]) for p in (1, 2)], 1),
            np.column_stack([column(3), column(4)]),
        )
    }
    beams = {
        30: (
            np.column_stack([column(k) for k in range(30, 36)]),
            np.stack([np.column_stack([column(40 + 4 * p + k) for k in range(4)]) for p in (1, 2)], 1),
        )
    }
    lsdyna.elout(path, TIME, solids, shells, beams)
    found = {Key("solid", name, 1, 1): solids[1][:, k] for k, name in enumerate(STRESSES)}
    found |= {
        Key("shell", name, 8, p + 1): shells[8][0][:, p, k] for k, name in enumerate(STRESSES) for p in (0, 1)
    }
    found |= {Key("shell", "plastic-strain", 8, p + 1): shells[8][1][:, p] for p in (0, 1)}
    found |= {Key("beam", name, 30): beams[30][0][:, k] for k, name in enumerate(RESULTANTS)}
    found |= {
        Key("beam", name, 30, p + 1): beams[30][1][:, p, k] for k, name in enumerate(FIBRES) for p in (0, 1)
    }
    return found


FORMATS = [
    nodout, glstat, matsum, rcforc, rcforc_of_newer_versions, spcforc, rwforc, rwforc_with_segments, deforc, jntforc,
    sleout, rbdout, bndout, elout,
]  # fmt: skip


@pytest.mark.parametrize("write", FORMATS, ids=lambda write: write.__name__)
def test_a_file_is_read_to_its_digits(lsdyna, tmp_path, write):
    path = tmp_path / "anything.txt"  # known by what is in it
    expected = write(lsdyna, path)
    form = recognise(path)
    assert write.__name__.split("_")[0] == form.NAME
    assert all(form.gives(key) for key in expected)
    found = {
        key: values for series in form.read(path, set(expected)) for key, values in series.columns.items()
    }
    assert found.keys() == expected.keys()
    digits = form.DIGITS or 4.0
    for key, values in expected.items():
        np.testing.assert_allclose(found[key], values, rtol=10.0 ** (1.0 - digits), err_msg=str(key))


@pytest.mark.parametrize("write", FORMATS, ids=lambda write: write.__name__)
def test_fortran_leaves_out_the_letter_of_a_long_exponent(lsdyna, tmp_path, write):
    path = tmp_path / "result"
    expected = write(lsdyna, path)
    text = path.read_text()
    changed = re.sub(r"E([+-]\d\d\d)", r"\1", text)
    assert changed != text
    path.write_text(changed)
    form = recognise(path)
    found = {
        key: values for series in form.read(path, set(expected)) for key, values in series.columns.items()
    }
    for key, values in expected.items():
        np.testing.assert_allclose(
            found[key], values, rtol=10.0 ** (1.0 - (form.DIGITS or 4.0)), err_msg=str(key)
        )


@pytest.mark.parametrize("write", FORMATS, ids=lambda write: write.__name__)
def test_of_a_file_that_is_cut_off_the_complete_states_are_used(lsdyna, tmp_path, write):
    """Wherever it ends: never a wrong number, at most the last state and the one that is cut are missing."""
    path = tmp_path / "result"
    expected = write(lsdyna, path)
    content, form = path.read_bytes(), recognise(path)
    for part in np.linspace(0.55, 0.999, 12):
        path.write_bytes(content[: int(part * len(content))])
        for series in form.read(path, set(expected)):
            count = series.time.size
            assert (part - 0.3) * TIME.size <= count + 1 <= TIME.size + 1
            for key, values in series.columns.items():
                np.testing.assert_allclose(
                    values, expected[key][:count], rtol=10.0 ** (1.0 - (form.DIGITS or 4.0))
                )
            if count < TIME.size and content[int(part * len(content)) - 1 :][:1] != b"\n":
                assert any("the file ends within the state at t = " in note for note in series.notes)


@pytest.mark.parametrize("write", FORMATS, ids=lambda write: write.__name__)
def test_a_restart_replaces_the_states_from_its_beginning(lsdyna, tmp_path, write):
    path = tmp_path / "result"
    expected = write(lsdyna, path)
    once = path.read_text()
    path.write_text(once + once)
    form = recognise(path)
    for series in form.read(path, set(expected)):
        np.testing.assert_allclose(series.time, TIME, atol=1e-3)
        assert any(
            "time goes back from 2 to 0: a restart, which replaces 9 states" in note for note in series.notes
        )


@pytest.mark.parametrize("write", FORMATS, ids=lambda write: write.__name__)
@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("NaN", "is nan"),
        ("*****", r"the number did not fit its field"),
        ("1.2.3", "expected a number|left over|in place of|expected .time"),
    ],
)
def test_what_is_no_number_is_named_with_its_line(lsdyna, tmp_path, write, text, why):
    path = tmp_path / "result"
    expected = write(lsdyna, path)
    content = path.read_text().split("\n")
    last = max(
        k for k, line in enumerate(content) if re.search(r"\d\.\d+E[+-]\d+", line) and _is_wanted(write, line)
    )
    numbers = list(re.finditer(r"-?\d\.\d+E[+-]\d\d+", content[last]))
    at = numbers[PLACE.get(write.__name__, -1)]
    content[last] = (
        content[last][: at.start()] + text.rjust(at.end() - at.start()) + content[last][at.end() :]
    )
    path.write_text("\n".join(content))
    with pytest.raises(ResultError, match=rf"result:{last + 1}: .*({why})"):
        results.recognise(path).read(path, set(expected))


# Of a line with several numbers: one that is read.
PLACE = {
    "matsum": 0,
    "rwforc": 1,
    "rwforc_with_segments": 1,
    "rcforc": 1,
    "rcforc_of_newer_versions": 1,
    "bndout": 1,
    "elout": 1,
}


def _is_wanted(write, line):
    """Whether a line holds numbers that are read, and not totals and the like."""
    words = {
        "nodout": "^ *12345678", "glstat": "total energy / initial", "matsum": "hgeng", "rcforc": "slave",
        "rcforc_of_newer_versions": "SURFA", "spcforc": "force resultants", "rwforc": "^ *[0-9]", "sleout": "^ {8,}[0-9]",
        "rwforc_with_segments": "^ *[0-9.]+E[+0-9]+ +20 ", "deforc": "change in length", "jntforc": "z-moment", "rbdout": "velocities:.*E.*E",
        "bndout": "nd#", "elout": "^ +2-  2 plastic",
    }  # fmt: skip
    wanted = re.search(words[write.__name__], line) is not None
    return wanted and "9.0000E+00" not in line
