"""Beams of ELFORM 2 as B31, which CalculiX expands to solids C3D8I, and trusses of ELFORM 3."""

import numpy as np

from vmharness.backends.calculix import trusses
from vmharness.backends.calculix.materials import of
from vmharness.backends.calculix.model import Model, table
from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.element.beam import ELEMENT_BEAM
from vmharness.deck.keywords.mat.elastic import MAT_ELASTIC
from vmharness.deck.keywords.mat.plastic_kinematic import MAT_PLASTIC_KINEMATIC
from vmharness.deck.keywords.part import PART
from vmharness.deck.keywords.section.beam import SECTION_BEAM
from vmharness.deck.rule import implemented, only
from vmharness.deck.support import supports

RESULTANT, TRUSS = 2, 3  # ELFORM
RELEASES = {name: only(0) for name in ("rt1", "rr1", "rt2", "rr2")}
CLOSE = 0.01  # of the constants of a rectangle

SUPPORTS = (
    supports(ELEMENT_BEAM, **RELEASES),
    supports(
        SECTION_BEAM,
        elform=implemented({RESULTANT: "beam of rectangular section", TRUSS: "truss"}),
        nsm=only(0.0),
        stress=only(0.0),
        ist=only(0.0),
    ),
)


def add(deck: Deck, model: Model) -> None:
    """Add the beams and trusses, and a section for each part and direction."""
    sections: set[str] = set()
    for entry in deck.all(ELEMENT_BEAM):
        for i, ends in enumerate(model.nodes.corners(entry, entry.keyword.corners)):
            part = deck.find(PART, pid=int(entry.pid[i]), referred_by=(entry, "pid", i))
            section = deck.find(SECTION_BEAM, secid=part.secid, referred_by=(part, "secid"))
            material = deck.find(MAT_ELASTIC, MAT_PLASTIC_KINEMATIC, mid=part.mid, referred_by=(part, "mid"))
            length = model.length(int(ends[0]), int(ends[1]))
            if section.elform == TRUSS:
                name, lines = trusses.add(model, entry, i, ends, section, material)
            else:
                third = model.nodes.row(entry, "n3", int(entry.n3[i]), i)
                sides, s = _rectangle(section, material), _across(model, ends, third)
                name = f"BEAM{part.pid}N{third}X{ends[0]}"
                lines = [
                    f"*BEAM SECTION,ELSET={name},MATERIAL={of(model, material)},SECTION=RECT",
                    *table(sides, 2),
                    *table(s, 3),
                ]
                model.add(entry.keyword, int(entry.eid[i]), "B31", name, ends)
                model.rotating[ends] = model.expanded[ends] = True
                model.work += 1.0
                model.kicked = True
            if name not in sections:
                model.sections += lines
                sections.add(name)
            model.join(int(ends[0]), int(ends[1]), material.e * section.a / length)
            model.mass[ends] += 0.5 * material.ro * section.a * length


def _across(model: Model, ends: np.ndarray, third: int) -> np.ndarray:
    """The direction s (3,): across the beam, toward its third node."""
    x = model.nodes.x0
    r = x[ends[1]] - x[ends[0]]
    r /= np.linalg.norm(r)
    to = x[third] - x[ends[0]]
    s = to - (to @ r) * r
    return np.asarray(s / np.linalg.norm(s))


def _rectangle(section: Entry, material: Entry) -> tuple[float, float]:
    """The sides along s and t of the rectangle with ISS = b_s b_t^3/12 and ITT = b_t b_s^3/12.

    Raises DeckError where A = b_s b_t or the torsion constant of that rectangle is another one.
    """
    if material.keyword is not MAT_ELASTIC:
        raise material.error("mid", "calculix: beams are elastic")
    t, s = (float(np.sqrt(12.0 * inertia / section.a)) for inertia in (section.iss, section.itt))
    if abs(s * t - section.a) > CLOSE * section.a:
        what = f"calculix: no rectangle has this A with ISS and ITT, which ask for A = {s * t:g}"
        raise section.error("a", what)
    long, short = max(s, t), min(s, t)
    n = np.arange(1, 20, 2)
    series = (np.tanh(0.5 * np.pi * n * long / short) / n**5).sum()
    torsion = long * short**3 / 3.0 * (1.0 - 192.0 / np.pi**5 * short / long * series)
    if abs(torsion - section.j) > CLOSE * torsion:
        raise section.error("j", f"calculix: the rectangle {s:g} x {t:g} has J = {torsion:g}")
    return s, t
