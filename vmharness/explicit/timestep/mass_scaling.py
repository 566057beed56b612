"""*CONTROL_TIMESTEP DT2MS < 0: mass added where the time step is small.

An element whose stable step h is below |DT2MS| has its density, and with it mass and rotary inertia, raised by

    phi = (|DT2MS| / h)^2        h = L/c, c ~ 1/sqrt(density)

so that its step becomes |DT2MS|, and that of the run TSSFAC |DT2MS|. With MS1ST = 1 this is done once, at the
beginning. With MS1ST = 0 it is repeated at every t_n at which the step of an element is below |DT2MS|. Mass that is
added during the run is at rest before, and moves with its node after: the momentum of the node is conserved,

    m' v' = m v        v_{n-1/2}, a_n and v_n are multiplied by m/m'

and that of rotation in the same way. (If the velocity were kept, momentum and energy would come out of nothing.) The
kinetic energy that a node loses, 1/2 m v_n^2 (1 - m/m'), is energy "damping". Degrees of freedom that a support or a
prescribed motion rules keep their velocity; the motion does the "external work" 1/2 (m' - m) v_n^2 on the new mass.

Springs and dampers have no mass to scale and keep their step. Bulk viscosity shortens the step of solids further. The
added mass is a fact of the run. (LS-DYNA keyword manual, *CONTROL_TIMESTEP; it does not say whether nodes keep velocity
or momentum.)
"""

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.deck.keywords.control.timestep import CONTROL_TIMESTEP
from vmharness.deck.rule import above, among, at_least, no_effect, only, unless
from vmharness.deck.support import supports
from vmharness.explicit.constraints.prescribed_motion import PrescribedMotion
from vmharness.explicit.force import Elements, Scalable
from vmharness.explicit.model.contents import shells, solids
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Flags, State


def _no_scaling(deck: Deck, entry: Entry) -> str:
    control = deck.first(CONTROL_TIMESTEP)
    return "" if control and control.dt2ms else "no mass is added without DT2MS"


def _no_erosion(deck: Deck, entry: Entry) -> str:
    control = deck.first(CONTROL_TERMINATION)
    return "" if control and control.dtmin else "nothing is eroded without DTMIN"


SUPPORTS = (
    supports(
        CONTROL_TIMESTEP,
        dtinit=at_least(0.0),
        tssfac=above(0.0),
        isdo=among(0, 1, 2, alike=unless(shells, "the deck has no shells")),
        tslimt=only(0.0, idle=unless(shells, "the deck has no shells")),
        lctm=at_least(0),
        erode=only(0, idle=_no_erosion),
        ms1st=among(0, 1, idle=_no_scaling),
        **{name: only(0, idle=_no_scaling) for name in ("dt2msf", "dt2mslc", "emscl", "rmavg")},
        imscl=only(0),  # selective mass scaling
        rmscl=only(0.0),
        ihdo=only(0, idle=unless(solids, "the deck has no solids")),
        igado=no_effect("acts on isogeometric elements"),
        dtusr=only(0),
        dtdynv=no_effect("affects output only"),
    ),
    supports(
        CONTROL_TERMINATION,
        endtim=above(0.0),
        endcyc=at_least(0),
        dtmin=at_least(0.0),
        endeng=only(0.0),
        endmas=among(0.0, 1.0e8, idle=_no_scaling),
        nosol=only(0),
    ),
)


def build(deck: Deck, model: Model) -> None:
    """Scale the mass of elements now, and at every t_n unless MS1ST = 1; add the added mass to the facts."""
    control = deck.first(CONTROL_TIMESTEP)
    if control is None or control.dt2ms == 0.0:
        return
    if control.dt2ms > 0.0:
        raise control.error("dt2ms", "a positive DT2MS is not supported; give a negative value")
    scaling = MassScaling(model, _blocks(model, control), -control.dt2ms)
    for block in scaling.blocks:
        scaling.add_mass(block)
    if control.ms1st == 0:
        scaling.free = _free(model, control)
        model.constraints.append(scaling)


def _blocks(model: Model, control: Entry) -> list[Scalable]:
    """The elements that can be scaled; raises DeckError for others that have mass."""
    blocks: list[Scalable] = []
    for force in model.forces:
        if isinstance(force, Scalable):
            blocks.append(force)
        elif isinstance(force, Elements) and force.kind == "discrete":
            model.facts["Mass scaling"] = (
                "none of springs and dampers: they have no mass, and keep their step"
            )
        elif isinstance(force, Elements):
            raise control.error("dt2ms", f"mass scaling of {force.name} is not implemented")
    return blocks


def _free(model: Model, control: Entry) -> Flags:
    """Degrees of freedom (n, 6) that no constraint rules."""
    free = np.ones((model.ids.size, 6), bool)
    for constraint in model.constraints:
        if isinstance(constraint, PrescribedMotion) and not constraint.throughout(model.end_time):
            what = f"not supported with {constraint.name}, which is not throughout; with MS1ST = 1 it is"
            raise control.error("ms1st", what)
        free &= ~constraint.fixed
    return free


class MassScaling:
    """Raises densities so that no element has a step below `aim`; as a constraint it does so at every t_n."""

    name = "mass scaling"

    def __init__(self, model: Model, blocks: list[Scalable], aim: float) -> None:
        self.model, self.blocks, self.aim = model, blocks, aim
        self.energy = {"damping": np.zeros(1), "external work": np.zeros(1)}
        self.fixed = self.free = np.zeros((model.ids.size, 6), bool)
        # By block, the added mass (ne,) of each element over its own mass.
        self._added = {block.name: np.zeros(block.mass.size) for block in blocks}

    def add_mass(self, block: Scalable) -> None:
        """Raise the density of those elements of a block whose step is below the aim."""
        phi = np.maximum((self.aim / block.steps(self.model.state.x)) ** 2, 1.0)
        added = self._added[block.name]
        more = (phi - 1.0) * (1.0 + added)
        if not more.any():
            return
        block.scale_density(phi)
        added += more
        for corner in block.nodes.T:
            self.model.add_mass(corner, more * block.mass, more * block.inertia)
        total, own = block.nodes.shape[1] * float(added @ block.mass), block.nodes.shape[1] * block.mass.sum()
        self.model.facts[f"Mass added to {block.name}"] = (
            f"{total:.6g} ({100.0 * total / own:.4g} %), at {(added > 0.0).sum()} of {added.size} elements"
        )

    def accelerate(self, state: State) -> None:
        """Add mass where a step has become too small, and conserve the momentum of the nodes."""
        short = [block for block in self.blocks if block.stable_step() < self.aim]
        if not short:
            return
        s, mass, inertia = state, state.mass.copy(), state.inertia.copy()
        for block in short:
            self.add_mass(block)
        np.copyto(s.lumped, s.mass, where=s.mass > 0.0)  # nodes of rigid bodies keep their shares
        self._conserve_momentum(s.v, s.a, mass, s.mass, self.free[:, :3], self.model.inverse_mass)
        self._conserve_momentum(
            s.omega, s.alpha, inertia, s.inertia, self.free[:, 3:], self.model.inverse_inertia
        )

    def _conserve_momentum(
        self, v: Array, a: Array, before: Array, after: Array, free: Flags, inverse: Array
    ) -> None:
        """Multiply v and a of the heavier nodes by m/m' where these are free; add lost energy and external work."""
        rows = np.flatnonzero(after > before)
        m, added = before[rows, None], (after - before)[rows, None]
        ratio = np.where(free[rows], m / (m + added), 1.0)
        now = v[rows] + 0.5 * self.model.state.dt * a[rows]
        self.energy["damping"] += 0.5 * np.sum(m * now**2 * (1.0 - ratio))
        self.energy["external work"] += 0.5 * np.sum(added * now**2, where=~free[rows])
        v[rows] *= ratio
        a[rows] *= ratio
        inverse[rows] = 1.0 / after[rows]

    def move(self, state: State, dt: float) -> None:
        """Nothing to do: velocities changed when mass was added."""
