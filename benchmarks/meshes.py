"""Meshes as decks in fixed format, and models of them in random motion that takes plastic laws beyond yield."""

import tempfile
from pathlib import Path

import numpy as np

from vmharness.deck import Deck, read, vocabulary
from vmharness.explicit.build import build
from vmharness.explicit.model.model import Model

HEAD = "*KEYWORD\n*CONTROL_TERMINATION\n       1.0\n*PART\np\n         1         1         1\n"


def sheet(material: str, side: int = 200) -> str:
    """side x side Belytschko-Tsay shells of three points."""
    n = grid(side)
    corners = quadrilaterals(n)
    section = "*SECTION_SHELL\n         1         2    0.8333         3\n       1.0"
    return "\n".join([section, *nodes(n), "*ELEMENT_SHELL", *rows(corners), material])


def block(material: str, elform: int = 1) -> str:
    """34 x 34 x 34 hexahedra."""
    n = np.arange(1, 35**3 + 1).reshape(35, 35, 35)
    low, high = slice(None, -1), slice(1, None)
    square = ((low, low), (high, low), (high, high), (low, high))
    corners = np.stack([n[i, j, k] for k in (low, high) for i, j in square], axis=-1).reshape(-1, 8)
    return "\n".join([f"*SECTION_SOLID\n1,{elform}", *nodes(n), "*ELEMENT_SOLID", *rows(corners), material])


def chain(material: str, section: str) -> str:
    """40 000 trusses or beams in a row along x, each of length 1; the third node of beams is the first of the row."""
    n = np.arange(1, 200**2 + 2)
    third = np.full(n.size - 1, n.size + 1)
    corners = np.stack([n[:-1], n[1:], third], axis=-1)
    off = [f"{n.size + 1:8d}{0.0:16.1f}{1e6:16.1f}{0.0:16.1f}       7       7"]
    return "\n".join([section, *nodes(n), *off, "*ELEMENT_BEAM", *rows(corners), material])


def grid(side: int) -> np.ndarray:
    """Numbers of the nodes of side x side quadrilaterals."""
    return np.arange(1, (side + 1) ** 2 + 1).reshape(side + 1, side + 1)


def quadrilaterals(n: np.ndarray) -> np.ndarray:
    """Corners of the quadrilaterals of a grid of nodes."""
    return np.stack([n[:-1, :-1], n[1:, :-1], n[1:, 1:], n[:-1, 1:]], axis=-1).reshape(-1, 4)


def nodes(numbers: np.ndarray) -> list[str]:
    """*NODE of a grid of unit spacing."""
    x = np.zeros((numbers.size, 3))
    x[:, : numbers.ndim] = np.indices(numbers.shape).reshape(numbers.ndim, -1).T
    return ["*NODE", *(f"{i:8d}{a:16.1f}{b:16.1f}{c:16.1f}" for i, (a, b, c) in enumerate(x.tolist(), 1))]


def rows(corners: np.ndarray, pid: int = 1, first: int = 1) -> list[str]:
    """Lines of elements of a part, numbered from `first`, in columns of eight."""
    return [
        f"{e:8d}{pid:8d}" + "".join(f"{i:8d}" for i in row) for e, row in enumerate(corners.tolist(), first)
    ]


def deck(text: str) -> Deck:
    """The deck of a mesh, read."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "deck.k"
        path.write_text(f"{HEAD}{text}\n*END\n")
        return read(path, vocabulary())


def moving(text: str) -> Model:
    """The model of a mesh, each node with a velocity of its own."""
    model = build(deck(text))
    model.state.v[:] = np.random.default_rng(1).normal(size=model.x0.shape) * 20.0
    return model
