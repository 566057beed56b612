"""The force of a contact: one pass of nodes against segments, or two with the roles exchanged.

A two-way contact treats both passes alike, each with the whole stiffness: nodes of A against segments of B, then nodes
of B against segments of A. Surfaces that meet node on node are twice as stiff as in a one-way contact.
"""

from collections.abc import Sequence

import numpy as np

from vmharness.explicit.contact.one_way import OneWay
from vmharness.explicit.contact.parameters import Options
from vmharness.explicit.contact.penetration import penetrations
from vmharness.explicit.contact.segments import Segments
from vmharness.explicit.contact.tracked import Tracked
from vmharness.explicit.model.state import Array, State


class Contact:
    """A penalty contact: (tracked A, segments B), and for a two-way contact also (tracked B, segments A)."""

    def __init__(self, number: int, passes: Sequence[tuple[Tracked, Segments]], options: Options) -> None:
        """`number` is CID, or the contact's place in the deck."""
        self.number, self.name, self.options = number, f"contact {number}", options
        self.passes = [OneWay(tracked, segments, options) for tracked, segments in passes]
        self.tracked = np.concatenate([tracked.nodes for tracked, _ in passes])  # (nt,) rows
        self.segments = np.concatenate([segments.nodes for _, segments in passes])  # (ns, 4) rows
        # One pass keeps the account itself; two are added up.
        self.account = self.passes[0].account if len(passes) == 1 else np.zeros(6)
        self.energy = {
            "contact": self.account[:1], "friction": self.account[1:2], "released": self.account[5:],
        }  # fmt: skip
        self.force = self.account[2:5]  # (3,) resultant on surface A
        forces = [one.nodes["force"] for one in self.passes]
        self.forces = (
            forces[0] if len(forces) == 1 else np.concatenate(forces)
        )  # (nt, 3) on the tracked nodes

    def add(self, state: State) -> None:
        """Add the forces at t_n, and the work of the step that led to it."""
        if not self.options.bt <= state.t < self.options.dt:
            for one in self.passes:
                one.rest(state)
        else:
            for one in self.passes:
                one.add(state)
        if len(self.passes) == 2:
            first, second = self.passes
            self.account[:] = first.account + second.account
            self.account[2:5] = first.account[2:5] - second.account[2:5]
            np.concatenate([first.nodes["force"], second.nodes["force"]], out=self.forces)

    def initial_penetrations(self, x: Array) -> list[tuple[int, Array]]:
        """Nodes that begin deeper than round-off: (row, the displacement (3,) that brings it to the surface)."""
        return [
            found
            for one in self.passes
            for found in penetrations(x, one.nodes, one.segments, self.options.maxpar)
        ]

    def area(self) -> float:
        """Sum of the areas of the tracked nodes that are in contact; a node without shell or solid has none."""
        touching = [one.nodes["area"][one.nodes["count"] > 0] for one in self.passes]
        return float(sum(area.sum(where=np.isfinite(area)) for area in touching))

    def touching(self) -> int:
        """How many tracked nodes are in contact."""
        return sum(int(np.count_nonzero(one.nodes["count"])) for one in self.passes)
