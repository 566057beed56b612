"""Beams of ELFORM 2 as corotational elastic beams with lumped mass, and trusses of ELFORM 3 as corotational trusses."""

import numpy as np

from vmharness.backends.opensees.model import Command, Model
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

SUPPORTS = (
    supports(ELEMENT_BEAM, **RELEASES),
    supports(
        SECTION_BEAM,
        elform=implemented({RESULTANT: "elastic beam", TRUSS: "truss"}),
        nsm=only(0.0),
        stress=only(0.0),
        ist=only(0.0),
    ),
    supports(MAT_ELASTIC, da=only(0.0), db=only(0.0)),
    supports(MAT_PLASTIC_KINEMATIC, src=only(0.0), srp=only(0.0), fs=only(0.0)),
)


def add(deck: Deck, model: Model) -> None:
    """Add a beam or truss for each element; the law of a truss once for each material."""
    laws: dict[int, int] = {}
    for table in deck.all(ELEMENT_BEAM):
        rows = model.nodes.corners(table, table.keyword.corners)
        for i, ends in enumerate(rows):
            part = deck.find(PART, pid=int(table.pid[i]), referred_by=(table, "pid", i))
            section = deck.find(SECTION_BEAM, secid=part.secid, referred_by=(part, "secid"))
            material = deck.find(MAT_ELASTIC, MAT_PLASTIC_KINEMATIC, mid=part.mid, referred_by=(part, "mid"))
            first, second = int(ends[0]), int(ends[1])
            length = model.length(first, second)
            model.join(first, second, material.e * section.a / length)
            model.mass[ends] += 0.5 * material.ro * section.a * length
            name = [int(table.eid[i]), model.id(first), model.id(second)]
            if section.elform == TRUSS:
                if part.mid not in laws:
                    laws[part.mid] = model.next()
                    model.materials.append(_law(material, laws[part.mid]))
                truss = ["element", "corotTruss", *name, section.a, laws[part.mid]]
                model.elements.append([*truss, "-rho", material.ro * section.a])
            else:
                third = model.nodes.row(table, "n3", int(table.n3[i]), i)
                _beam(model, name, ends, third, section, material)


def _law(material: Entry, tag: int) -> Command:
    """Elastic, or with linear hardening: H = E ET/(E - ET), the share BETA of it isotropic."""
    if material.keyword is MAT_ELASTIC:
        return ["uniaxialMaterial", "Elastic", tag, material.e]
    hardening = material.e * material.etan / (material.e - material.etan)
    shares = [material.beta * hardening, (1.0 - material.beta) * hardening]
    return ["uniaxialMaterial", "Hardening", tag, material.e, material.sigy, *shares]


def _beam(
    model: Model, name: list[int], ends: np.ndarray, third: int, section: Entry, material: Entry
) -> None:
    """An elastic beam: s lies in the plane of N3, ISS is about s and ITT about t = r x s, which is local z there.

    Its rotary inertia is that of the cross-section, rho I L/2 at each node; the elements of OpenSees bring none.
    """
    if material.keyword is not MAT_ELASTIC:
        raise material.error("mid", "opensees: beams are elastic")
    x = model.nodes.x0
    t = np.cross(x[ends[1]] - x[ends[0]], x[third] - x[ends[0]])
    transformation, per_length = model.next(), material.ro * section.a
    model.elements.append(["geomTransf", "Corotational", transformation, *(t / np.linalg.norm(t)).tolist()])
    moduli = [material.e, material.e / (2.0 * (1.0 + material.pr)), section.j, section.iss, section.itt]
    beam = ["element", "elasticBeamColumn", *name, section.a, *moduli, transformation]
    model.elements.append([*beam, "-mass", per_length])
    length = model.length(int(ends[0]), int(ends[1]))
    model.inertia[ends] += 0.5 * material.ro * (section.iss + section.itt) * length
    model.implicit = True
