"""The stable step of the whole model, where it is below the elements' own.

The elements' own step h is LS-DYNA's: a length over a wave speed. It is a bound for a mesh that is large, or held. It
is none for a free cube, which at nu = 0.3 is stable up to 0.734 of it only. The step of the run is therefore

    dt = min(TSSFAC h, max(TSSFAC, SAFE) r h_0, max(TSSFAC, 1) r_K h)

with h_0 = h at the last estimate and r h_0 = 2/omega_max of the model. It is LS-DYNA's wherever that is stable. With
TSSFAC > 1 the user asks for more than the stable step; the run then takes it.

The ratio r is found at the start (highest_mode.py), and again when the own step of an element near the shortest has
changed by more than CHANGE. The damping of springs, of hourglass control and of *DAMPING_PART_STIFFNESS is part of r,
and bulk viscosity as far as it acts in the highest mode alone. Where elements are compressed steadily it acts at all
times and shortens h itself; the last term follows that, with r_K by stiffness alone.

A step that varies in time with a mode drives it, even where each step alone is stable (parametric resonance). With bulk
viscosity h falls by 6 % whenever an element is compressed, and h follows the vibrations of shells. A step near the
stable one may vary by SWING; when it has varied more, it is the least one of the last WINDOW cycles or twice as many.
"""

import numpy as np

from vmharness.explicit.force import Elements, Scalable
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array
from vmharness.explicit.timestep.highest_mode import Mode, highest_mode, response

SAFE = 0.95  # of 2/omega_max: it is found to 1 %, and changes by CHANGE until it is found again
CHANGE = 0.02  # of an element's own step
CHECK_EVERY, PAUSE = 20, 200  # cycles; the pause after an estimate, which takes some 30 evaluations of forces
NEAR_BOUND = 0.8  # of r h_0: longer steps must not vary much
SWING, WINDOW = 5e-4, 500
NEAR = 2.0  # times the shortest step: elements with a longer one do not limit the step, since r is above 0.5
REPEATS = 6  # where damping makes r depend on dt
SETTLED = 1.01  # of theta = (dt/dt_stable)^2


class StableStep:
    """The longest stable step of a model, as its state changes."""

    def __init__(self, model: Model) -> None:
        self.model, self.blocks = model, model.blocks
        self.ratio = self.stiff = np.inf  # r, r_K
        self.bound = np.inf  # r h_0
        self.where = "the elements"  # the one that limits the step
        self._at: Array | None = None  # the elements' own steps at the last estimate
        self._own = np.inf  # the shortest of them, h_0
        self._mode: Mode | None = None
        self._check = 0  # the cycle of the next look at the steps
        self._fraction = 1.0  # the smallest of LS-DYNA's step that was taken
        self._window = 0  # when the present window began
        self._before = self._least = np.inf  # the least step of the window before, and of this one
        self._varies = False
        self._used = 0.0  # the largest step that was taken, over r h_0

    def limited(self, dt: float) -> float:
        """The step `dt`, or the stable one where that is shorter: then a fact of the run says so."""
        if not self.blocks:
            return dt
        cycle, tssfac = self.model.state.cycle, self.model.step_factor
        if cycle >= self._check:
            self._check = cycle + CHECK_EVERY
            with np.errstate(all="ignore"):  # where the motion has diverged
                self._renew()
            self.bound = self.ratio * self._own
        own = min(block.stable_step() for block in self.blocks)
        longest = min(max(tssfac, SAFE) * self.bound, max(tssfac, 1.0) * self.stiff * own)
        if longest < 0.999 * self._fraction * dt:
            self._fraction = longest / dt
            self.model.facts["Stable step"] = (
                f"{self._fraction:.3g} of LS-DYNA's step, since this mesh is stable only up to {self.ratio:.3g} of "
                f"the step of its elements; {self.where} limits it"
            )
        step = self._steady(min(dt, longest))
        self._used = max(self._used, step / self.bound)
        return step

    def _steady(self, dt: float) -> float:
        """The step `dt`, kept from varying where it is near the stable one."""
        if dt <= NEAR_BOUND * self.bound:
            return dt
        if self.model.state.cycle >= self._window + WINDOW:
            self._window, self._before, self._least = self.model.state.cycle, self._least, np.inf
        least = min(self._before, self._least)
        self._varies = self._varies or dt > (1.0 + SWING) * least
        self._least = min(dt, self._least)
        return min(dt, least) if self._varies else dt

    def blame(self) -> str:
        """How the steps compare with the stable one, for the message of a run that has diverged."""
        tssfac, used = self.model.step_factor, self._used
        if used == 0.0:
            return f"no element limits the step, TSSFAC = {tssfac:g}"
        advice = (
            f"TSSFAC = {SAFE:g} or less is stable"
            if used > 1.0
            else "the elements bear it; a smaller TSSFAC shows whether contact, spring or load does not"
        )
        return f"the step was up to {used:.3g} of the stable one of {self.where}, with TSSFAC = {tssfac:g}: {advice}"

    def _renew(self) -> None:
        """Find r, unless the steps of the elements are as they were."""
        steps = own_steps(self.model, self.blocks)
        if not np.isfinite(steps.min()):
            return
        if self._at is not None:
            near = np.minimum(steps, self._at) < NEAR * steps.min()
            if (np.abs(steps - self._at)[near] <= CHANGE * self._at[near]).all():
                return
        self._at, self._own = steps, float(steps.min())
        self._check += PAUSE if self._mode else 0
        self._estimate()

    def _estimate(self) -> None:
        dt, start = self._own, self._mode.z if self._mode else None
        for _ in range(REPEATS):
            mode = highest_mode(self.model, dt, start)
            if not mode.theta > 0.0:
                return  # nothing vibrates, or the motion has diverged
            if mode.theta <= SETTLED:
                break
            dt, start = dt / mode.theta**0.5, mode.z
        self._mode = mode
        self.ratio = float(dt / self._own / mode.theta**0.5)
        self.stiff = float(dt / self._own / mode.stiff**0.5) if mode.stiff > 0.0 else np.inf
        self.where = largest_share(self.model, mode, dt)


def own_steps(model: Model, blocks: list[Elements]) -> Array:
    """The own steps of all elements without bulk viscosity; one for all springs and dampers of a part."""
    steps = [
        block.steps(model.state.x) if isinstance(block, Scalable) else np.array([block.stable_step()])
        for block in blocks
    ]
    return np.concatenate(steps)


def largest_share(model: Model, mode: Mode, dt: float) -> str:
    """The element whose nodes take most power from its part in the mode."""
    shares = []
    for block in model.blocks:
        power = -np.sum(mode.velocity * response(model, [block], mode.velocity, dt), axis=1)
        power = np.append(power, 0.0)
        of_elements = power[block.nodes].sum(axis=1)  # the last, 0, is that of the ground
        element = int(np.argmax(of_elements))
        shares.append((float(of_elements[element]), f"{block.kind} {block.eid[element]} of part {block.pid}"))
    return max(shares)[1]
