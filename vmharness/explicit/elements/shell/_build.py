"""A part of the deck -> the force of its shells, and their mass."""

from collections.abc import Callable

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.shell import CONTROL_SHELL
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.keywords.section.shell import SECTION_SHELL
from vmharness.deck.rule import (
    above,
    always,
    among,
    at_least,
    implemented,
    no_effect,
    only,
    unless,
    without_deformable_parts,
)
from vmharness.deck.support import supports
from vmharness.explicit.elements.shell._parts import thickness
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.materials import law_of
from vmharness.explicit.model.contents import shells
from vmharness.explicit.model.model import Model
from vmharness.explicit.model.parts import Part

ELFORM = 2

SUPPORTS = (
    supports(
        SECTION_SHELL,
        elform=implemented({ELFORM: "Belytschko-Tsay"}, idle=without_deformable_parts),
        shrf=above(0.0),
        nip=above(0),
        propt=no_effect("affects output only"),
        qr=only(0.0),
        icomp=only(0),
        setyp=only(1),
        **{f"t{i}": at_least(0.0) for i in range(1, 5)},
        nloc=only(0.0),
        marea=only(0.0),
        idof=only(0.0),
        edgset=only(0),
    ),
    supports(
        CONTROL_SHELL,
        unless(shells, "the deck has no shells"),
        wrpang=no_effect("affects output only"),
        esort=among(0, 1, alike=always("degenerate shells are always C0 triangles")),
        irnxx=among(-2, -1, 0, alike=always("ELFORM 2 has no fibre directions")),
        istupd=among(0, 1),
        theory=only(2),
        bwc=only(2),
        miter=only(1),
        proj=only(0),
        rotascl=only(1.0),
        intgrd=only(0),
        lamsht=only(0),
        cstyp6=no_effect("acts on shells of ELFORM 6"),
        thshel=no_effect("acts in thermal analysis only"),
        pstupd=only(0),
        sidt4tu=no_effect("affects output only"),
        cntco=only(0),
        itsflg=no_effect("acts on triangles of other formulations"),
        irquad=no_effect("acts on quadratic shells"),
        w_mode=only(0.0),
        stretch=only(0.0),
        icrq=only(0),
        nfail1=only(0),
        nfail4=only(0),
        psnfail=only(0),
        keepcs=no_effect("no shell fails"),
        delfr=no_effect("no shell fails"),
        drcpsid=only(0),
        drcprm=no_effect("acts with DRCPSID"),
        intperr=no_effect("of stresses that are read at the beginning"),
        drcmth=no_effect("acts with DRCPSID"),
        lispsid=only(0),
        nlocdt=only(0),
        iswshl=only(0),
    ),
)


def add_part(deck: Deck, model: Model, part: Part, name: str, shells: Callable[..., Shells]) -> None:
    """Add the force of a part, which `shells` makes, and its lumped mass; `name` is that of such elements.

    Nothing is added for a rigid part: see rigid/element_mass.py.
    """
    if part.rigid:
        return
    section, timestep = part.section, deck.first(CONTROL_TIMESTEP)
    control = deck.first(CONTROL_SHELL)
    if section.elform != ELFORM:
        raise section.error("elform", f"not implemented; supported: {ELFORM} (Belytschko-Tsay)")
    _check_shear_factor(section, part.moduli.nu)
    t = thickness(part)
    law = law_of(part.material, "plane_stress", part.part)
    try:
        block = shells(
            name=f"{name} of part {part.pid}",
            nodes=part.nodes,
            x=model.x0,
            thickness=t,
            density=part.density,
            law=law.plane_stress,
            constants=law.constants(deck, part.material),
            moduli=part.moduli,
            nip=section.nip,
            shrf=section.shrf,
            isdo=timestep.isdo if timestep else 0,
            thinning=bool(control and control.istupd),
            history=law.HISTORY["plane_stress"],
            channels=law.CHANNELS,
            eid=part.eid,
            pid=part.pid,
        )
    except ValueError as error:
        raise part.part.error(None, str(error)) from None
    model.forces.append(block)
    for corner in part.nodes.T:
        model.add_mass(corner, block.mass, block.inertia)


def _check_shear_factor(section: Entry, nu: float) -> None:
    """Above this factor the rotary inertia that keeps shear slower than the membrane is negative: see mass.py."""
    pole = 2 * (1 + abs(nu)) / (1 - nu)
    if section.shrf >= pole:
        raise section.error("shrf", f"must be less than 2 (1 + |PR|)/(1 - PR) = {pole:.6g}; 5/6 is usual")
