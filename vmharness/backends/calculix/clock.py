"""The steps of CalculiX, and curves over its time.

A load that acts from the start kicks a C3D8I of CalculiX 2.20, and with it S4, B31 and T3D2: a free one starts up to
six times too fast, then vibrates about the right motion for ever. It seems that its incompatible modes have inertia,
and that no load acts on them. So the run of such a model starts half a step before t = 0, without load; the first step
goes from no load at t = -dt/2 to the load at t = dt/2, which is the impulse of a load from t = 0.
"""

from dataclasses import dataclass

import numpy as np

from vmharness.backends.calculix.model import Lines, Model, table
from vmharness.deck.keywords.control.termination import CONTROL_TERMINATION
from vmharness.mesh.nodes import Array


@dataclass(frozen=True)
class Clock:
    """`count` steps of the length `dt` from t = -`before` to the end of the run."""

    count: int
    dt: float
    before: float

    @property
    def times(self) -> Array:
        """The ends (count,) of the steps."""
        return np.asarray(self.dt * np.arange(1, self.count + 1) - self.before, float)


def clock(model: Model, count: int) -> Clock:
    """The clock of a model for so many steps; with initial velocities it starts at t = 0."""
    end = model.deck.one(CONTROL_TERMINATION).endtim
    share = 0.5 if model.kicked and not model.velocities.any() else 0.0
    dt = end / (count - share)
    return Clock(count, dt, share * dt)


def amplitude(name: str, t: Array, value: Array, clock: Clock) -> Lines:
    """*AMPLITUDE of a curve."""
    if clock.before:
        first = clock.dt - clock.before
        later = t > first
        value = np.concatenate([[0.0, np.interp(first, t, value)], value[later]])
        t = np.concatenate([[0.0, clock.dt], t[later] + clock.before])
    return [f"*AMPLITUDE,NAME={name}", *table(np.column_stack([t, value]).ravel(), 8)]
