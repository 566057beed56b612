"""Head of a d3plot: control words, geometry, and the numbers of nodes, elements and parts; and how words are read."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from vmharness.results._lines import ResultError

END = -999999.0
TITLES = {90001: 19, 90002: 19, 90100: 20}  # words of a part, a contact, a line of the deck
KINDS = (1, 5)  # word 11: d3plot, d3part
CONTROL = {
    "ndim": 15, "numnp": 16, "nglbv": 18, "it": 19, "iu": 20, "iv": 21, "ia": 22, "nel8": 23, "nv3d": 27, "nel2": 28,
    "nv1d": 30, "nel4": 31, "nv2d": 33, "neiph": 34, "neips": 35, "maxint": 36, "nmsph": 37, "narbs": 39, "nelt": 40,
    "nv3dt": 42, "ioshl1": 43, "ioshl2": 44, "ialemat": 47, "ncfdv1": 48, "nadapt": 50, "nmmat": 51, "npefg": 54,
    "nel48": 55, "idtdt": 56, "extra": 57,
}  # fmt: skip
FLAGS = (
    "ndim",
    "it",
    "iu",
    "iv",
    "ia",
    "maxint",
    "ioshl1",
    "ioshl2",
    "idtdt",
)  # control words that count nothing
NOT_READ = {"nmsph": "SPH", "ncfdv1": "CFD", "nadapt": "adapted elements", "npefg": "particles of airbags"}


@dataclass(frozen=True)
class Words:
    """How words are written."""

    integer: np.dtype[np.signedinteger]
    real: np.dtype[np.floating]

    @property
    def size(self) -> int:
        """Bytes of a word."""
        return self.integer.itemsize


@dataclass
class Model:
    """What the head of the family says: numbers of things, and where a state has their values."""

    words: Words
    control: Mapping[str, int]
    x0: NDArray[np.floating]  # (numnp, 3)
    ids: Mapping[str, NDArray[np.signedinteger]]  # by kind: node, solid, beam, part
    rigid_shells: int
    states: int  # byte at which states may begin in the first file


def words_of(head: bytes) -> Words | None:
    """How the words of a family are written, by the kind of file in word 11; None if it is none."""
    for order in "<>":
        for size in (4, 8):
            integer = np.dtype(f"{order}i{size}")
            word = head[11 * size : 12 * size]
            dimensions = head[15 * size : 16 * size]
            there = len(dimensions) == size and np.frombuffer(word, integer)[0] in KINDS
            if there and 2 <= np.frombuffer(dimensions, integer)[0] <= 9:
                return Words(integer, np.dtype(f"{order}f{size}"))
    return None


def model_of(file: BinaryIO, name: str) -> Model:
    """Read control words, geometry and numbers; raises ResultError for what is not read here."""
    words = words_of(file.read(1 << 12))
    assert words is not None  # recognised
    control = {each: int(integers(file, words, place, 1, name)[0]) for each, place in CONTROL.items()}
    for each, what in NOT_READ.items():
        if control[each]:
            raise ResultError(f"{name}: has {what}, which are not read")
    most = file.seek(0, 2) // words.size
    for each, count in control.items():
        if each not in FLAGS and (abs(count) > most or (count < 0 and each != "nel8")):
            raise ResultError(
                f"{name}: {each.upper()} is {count} in the control words, of a file of {most} words"
            )
    if control["ndim"] not in (4, 5, 7):
        raise ResultError(f"{name}: NDIM is {control['ndim']}: expected 4, 5 or 7, of a model in space")
    place, rigid_shells = 64 + control["extra"], 0
    if control["ndim"] in (5, 7):  # kinds of materials
        rigid_shells = _count(file, words, place, name)
        place += 2 + _count(file, words, place + 1, name)
    place += control["ialemat"]
    nodes, solids = control["numnp"], abs(control["nel8"])
    x0 = reals(file, words, place, 3 * nodes, name).reshape(nodes, 3)
    place += 3 * nodes + 9 * solids + (2 * solids if control["nel8"] < 0 else 0)
    place += 9 * control["nelt"] + 6 * control["nel2"] + 5 * control["nel4"]
    ids, place = _ids(file, words, place, control, name)
    place += 5 * control["nel48"]
    return Model(words, control, x0, ids, rigid_shells, _titles(file, words, place, name) * words.size)


def _ids(
    file: BinaryIO, words: Words, place: int, control: Mapping[str, int], name: str
) -> tuple[dict[str, NDArray[np.signedinteger]], int]:
    """Numbers of nodes, solids, beams and parts, and the place behind them; 1, 2, ... if the file has none."""
    counts = {"node": control["numnp"], "solid": abs(control["nel8"]), "beam": control["nel2"]}
    if not control["narbs"]:
        counts["part"] = control["nmmat"]
        return {kind: np.arange(1, count + 1) for kind, count in counts.items()}, place
    has_parts = integers(file, words, place, 1, name)[0] < 0
    at, ids = place + (16 if has_parts else 10), {}
    for kind, count in counts.items():
        ids[kind] = integers(file, words, at, count, name)
        at += count
    at += control["nel4"] + control["nelt"]
    ids["part"] = (
        integers(file, words, at, control["nmmat"], name) if has_parts else np.arange(1, control["nmmat"] + 1)
    )
    return ids, place + control["narbs"]


def _titles(file: BinaryIO, words: Words, place: int, name: str) -> int:
    """The place behind titles of parts and contacts, which follow a word that ends the geometry."""
    if not is_end(file, words, place):
        return place
    place += 1
    while (kind := _peek(file, words, place)) is not None:
        if kind == 90000:
            place += 1 + 18
        elif kind in TITLES:
            place += 2 + TITLES[kind] * _count(file, words, place + 1, name)
        else:
            break
    return place + 1 if is_end(file, words, place) else place


def _count(file: BinaryIO, words: Words, place: int, name: str) -> int:
    """A word that counts things; raises ResultError if there cannot be so many."""
    count = int(integers(file, words, place, 1, name)[0])
    if not 0 <= count <= file.seek(0, 2) // words.size:
        raise ResultError(f"{name}: word {place} counts {count} things")
    return count


def is_end(file: BinaryIO, words: Words, place: int) -> bool:
    file.seek(place * words.size)
    content = file.read(words.size)
    return len(content) == words.size and np.frombuffer(content, words.real)[0] == END


def _peek(file: BinaryIO, words: Words, place: int) -> int | None:
    file.seek(place * words.size)
    content = file.read(words.size)
    return int(np.frombuffer(content, words.integer)[0]) if len(content) == words.size else None


def integers(file: BinaryIO, words: Words, place: int, count: int, name: str) -> NDArray[np.signedinteger]:
    return np.frombuffer(_content(file, words, place, count, name), words.integer)


def reals(file: BinaryIO, words: Words, place: int, count: int, name: str) -> NDArray[np.floating]:
    return np.frombuffer(_content(file, words, place, count, name), words.real)


def _content(file: BinaryIO, words: Words, place: int, count: int, name: str) -> bytes:
    file.seek(place * words.size)
    content = file.read(count * words.size)
    if len(content) < count * words.size:
        raise ResultError(f"{name}: the file ends at word {place + len(content) // words.size}")
    return content
