"""*LOAD_BODY_X, _Y, _Z: the acceleration of the base, felt as a force -m a in the body.

A positive value pulls toward the negative axis (d'Alembert): +386 on *LOAD_BODY_Z lets a ball fall toward -z.
"""

import numpy as np

from vmharness.deck import Card, Deck, Keyword
from vmharness.deck.field import integer, only, real
from vmharness.explicit.compiled import kernel
from vmharness.explicit.curve import Curve, time_curve
from vmharness.explicit.model import Model
from vmharness.explicit.state import Array, State


def _keyword(axis: str) -> Keyword:
    card = Card(
        lcid=integer(),
        sf=real(1.0, zero_is_default=True),
        lciddr=only(0),
        xc=only(0.0),
        yc=only(0.0),
        zc=only(0.0),
        cid=only(0),
    )
    return Keyword(f"LOAD_BODY_{axis}", card)


LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z = (_keyword(axis) for axis in "XYZ")


def build(deck: Deck, model: Model) -> None:
    """Add a force for each *LOAD_BODY_... of the deck."""
    for axis, keyword in enumerate((LOAD_BODY_X, LOAD_BODY_Y, LOAD_BODY_Z)):
        for entry in deck.all(keyword):
            curve = time_curve(deck, entry, "lcid", model.end_time)
            model.forces.append(BodyLoad(f"*{keyword.name}", axis, entry.sf, curve))


class BodyLoad:
    """f = -m SF LC(t) along one axis, on every node."""

    def __init__(self, name: str, axis: int, sf: float, curve: Curve) -> None:
        self.name, self.axis, self.sf, self.curve = name, axis, sf, curve
        self.energy = {"external work": np.zeros(1)}
        self.acceleration = -sf * curve(0.0)

    def add(self, state: State) -> None:
        """f += m b, and the work 1/2 m (b_n + b_{n+1}) dt v_{n+1/2}."""
        before, self.acceleration = self.acceleration, -self.sf * self.curve(state.t)
        pull(
            state.f,
            state.v,
            state.mass,
            self.axis,
            before,
            self.acceleration,
            state.dt,
            self.energy["external work"],
        )

    def stable_step(self) -> float:
        """A load sets no step."""
        return np.inf


@kernel
def pull(
    f: Array, v: Array, mass: Array, axis: int, before: float, now: float, dt: float, work: Array
) -> None:
    """Add m `now` to every node along `axis`; v is v_{n-1/2} of the step dt that is over."""
    momentum = 0.0
    for i in range(mass.size):
        f[i, axis] += mass[i] * now
        momentum += mass[i] * v[i, axis]
    work[0] += 0.5 * (before + now) * dt * momentum
