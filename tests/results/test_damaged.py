"""Whatever is in a file: it is read, or what is wrong with it is said with its name; never any other error."""

import contextlib
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from vmharness.results import Key, ResultError, formats, recognise

NAMES = [
    "nodout",
    "glstat",
    "matsum",
    "rcforc",
    "spcforc",
    "rwforc",
    "deforc",
    "jntforc",
    "sleout",
    "rbdout",
    "bndout",
    "elout",
    "binout",
    "d3plot",
    "T01",
    "ball.csv",
]
TIME = np.linspace(0.0, 1.0, 4)
KEYS = {
    *(Key(kind, f"{axis}-{name}", 5) for kind in ("node", "rigid") for axis in "xz" for name in ("displacement", "velocity")),
    *(Key(kind, "z-force", n) for kind in ("contact", "support", "joint", "driven node") for n in (0, 5)),
    *(Key("energy", name) for name in ("kinetic", "internal", "total", "ratio", "rigid wall")),
    *(Key("part", name, 5) for name in ("internal", "x-velocity", "hourglass")),
    *(Key(kind, "xx-stress", 5, 1) for kind in ("solid", "shell")),
    Key("contact", "energy", 5), Key("wall", "normal-force", 5), Key("discrete", "force", 5), Key("beam", "axial-force", 5),
    Key("column", "z"),
}  # fmt: skip


def files(lsdyna, binary, folder) -> dict[str, bytes]:
    """A file of every format."""
    one = np.linspace(1.0, -2.0, TIME.size)
    forces = {f"{axis}-force": one for axis in "xyz"}
    motion = np.ones((TIME.size, 1, 3))
    writers: dict[str, Callable[..., None]] = {
        "nodout": lambda path: lsdyna.nodout(path, TIME, {5: {"z-displacement": one}}),
        "glstat": lambda path: lsdyna.glstat(path, TIME, {"kinetic energy": one}),
        "matsum": lambda path: lsdyna.matsum(path, TIME, {5: {"internal": one}}),
        "rcforc": lambda path: lsdyna.rcforc(path, TIME, {5: forces}),
        "spcforc": lambda path: lsdyna.spcforc(path, TIME, {5: forces}),
        "rwforc": lambda path: lsdyna.rwforc(path, TIME, {5: one}),
        "deforc": lambda path: lsdyna.dotted(path, TIME, "spring/damper number", {5: {"resultant force": one}}),
        "jntforc": lambda path: lsdyna.dotted(path, TIME, "joint number", {5: forces}),
        "sleout": lambda path: lsdyna.sleout(path, TIME, {5: (one, one)}),
        "rbdout": lambda path: lsdyna.rbdout(path, TIME, {5: {"z-velocity": one}}),
        "bndout": lambda path: lsdyna.bndout(path, TIME, {5: forces}),
        "elout": lambda path: lsdyna.elout(path, TIME, {5: np.ones((TIME.size, 6))}, {}, {5: (np.ones((TIME.size, 6)), None)}),
        "binout": lambda path: binary.binout(
            path, TIME, {"/nodout": ({"ids": [5]}, {"z_displacement": motion[:, :, 2]}), "/glstat": ({}, {"kinetic_energy": one})}
        ),
        "d3plot": lambda path: binary.d3plot(path, TIME, ([5], [motion] * 3), np.zeros((1, 3)), np.ones((TIME.size, 6))),
        "T01": lambda path: binary.t01(
            path, TIME, 0.1, np.ones((TIME.size, 12)), ([5], [1], np.ones((TIME.size, 1, 1))), ([5], [3, 6], motion[:, :, :2])
        ),
        "ball.csv": lambda path: path.write_text("time,z\n0,1\n1,2\n2,3\n"),
    }  # fmt: skip
    found = {}
    for name, write in writers.items():
        write(folder / name)
        found[name] = (folder / name).read_bytes()
    return found


@pytest.fixture(scope="module")
def whole(lsdyna, binary, tmp_path_factory):
    """The content of a file, by its name."""
    return files(lsdyna, binary, tmp_path_factory.mktemp("whole")).__getitem__


def test_there_is_a_file_of_every_format(whole, tmp_path):
    names = set()
    for name in NAMES:
        (tmp_path / name).write_bytes(whole(name))
        form = recognise(tmp_path / name)
        assert form.read(tmp_path / name, {key for key in KEYS if form.gives(key)})
        names.add(form.NAME)
    assert names == {form.NAME for form in formats()}


WORDS = [b"\xff\xff\xff\xff", b"\x7f\xff\xff\xff", b"\0\0\0\0", b"\xff\xff\xff\x7f"]
TEXTS = [b"NaN", b"****", b"1e999", b"-", b"9" * 400, b"1_0", "²".encode(), b"\r", b"\n", b" "]
CHANGES = st.tuples(
    st.sampled_from(["byte", "word", "cut", "drop", "twice", "text"]),
    st.floats(0.0, 1.0),
    st.integers(0, 255),
)


def damaged(content: bytes, change: str, part: float, number: int) -> bytes:
    """The content, changed after a part of it."""
    at = int(part * len(content))
    before, behind = content[:at], content[at:]
    return {
        "byte": before + bytes([number]) + behind[1:],
        "word": before + WORDS[number % len(WORDS)] + behind[4:],
        "cut": before,
        "drop": before + behind[number:],
        "twice": before + behind[:number] + behind,
        "text": before + TEXTS[number % len(TEXTS)] + behind,
    }[change]


@settings(max_examples=200)
@given(name=st.sampled_from(NAMES), changes=st.lists(CHANGES, min_size=1, max_size=4))
def test_a_damaged_file_is_read_or_refused(whole, tmp_path_factory, name, changes):
    content = whole(name)
    for change in changes:
        content = damaged(content, *change)
    path = tmp_path_factory.mktemp("damaged") / name
    path.write_bytes(content)
    form = recognise(path)
    if form is None:
        return
    with contextlib.suppress(ResultError):
        for series in form.read(path, {key for key in KEYS if form.gives(key)}):
            assert np.all(np.diff(series.time) > 0.0)
            assert all(np.all(np.isfinite(values)) for values in series.columns.values())
