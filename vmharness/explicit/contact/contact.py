"""The force of a contact: one pass of tracked nodes against segments, or two with the roles exchanged.

A two-way contact treats both passes alike, each with the whole stiffness: nodes of A against segments of B, then nodes
of B against segments of A. Surfaces that meet node on node are twice as stiff as in a one-way contact.
"""

from collections.abc import Sequence

import numpy as np

from vmharness.explicit.contact.cycle import cycle, deactivate, relative_speed_bound
from vmharness.explicit.contact.neighbours import find_neighbours
from vmharness.explicit.contact.parameters import Options, parameters_of
from vmharness.explicit.contact.records import (
    CONTACT,
    CONTACT_STATE,
    FORCE,
    FRICTION,
    MAX_CONTACTS,
    RELEASED,
    Segments,
    Tracked,
    node_records,
    segment_records,
)
from vmharness.explicit.contact.search import find_candidates, mean_size
from vmharness.explicit.contact.tracking_simd import buffers
from vmharness.explicit.state import State

MARGIN = 0.3  # of the size of a segment; a wider one sorts less often, and leaves more candidates to test
CYCLES = 8  # that a sort suffices for at least


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
        places = {"contact": CONTACT, "friction": FRICTION, "released": RELEASED}
        self.energy = {name: self.account[i : i + 1] for name, i in places.items()}
        self.force = self.account[FORCE : FORCE + 3]  # (3,) resultant on surface A
        forces = [one.nodes["force"] for one in self.passes]
        self.forces = (
            forces[0] if len(forces) == 1 else np.concatenate(forces)
        )  # (nt, 3) on the tracked nodes

    def add(self, state: State) -> None:
        """Add the forces at t_n, and the work of the step that led to it."""
        if not self.options.bt <= state.t < self.options.dt:
            for one in self.passes:
                one.deactivate(state)
        else:
            for one in self.passes:
                one.add(state)
        if len(self.passes) == 2:
            first, second = self.passes
            np.add(first.account, second.account, out=self.account)
            np.subtract(first.force, second.force, out=self.force)
            np.concatenate([first.nodes["force"], second.nodes["force"]], out=self.forces)

    def area(self) -> float:
        """Sum of the areas of the tracked nodes that are in contact; a node without shell or solid has none."""
        areas = [one.nodes["area"][one.nodes["count"] > 0] for one in self.passes]
        return float(sum(area.sum(where=np.isfinite(area)) for area in areas))

    def nodes_in_contact(self) -> int:
        """Number of tracked nodes that are in contact."""
        return sum(int(np.count_nonzero(one.nodes["count"])) for one in self.passes)


class OneWay:
    """A pass: tracked nodes kept from passing through segments."""

    def __init__(self, tracked: Tracked, segments: Segments, options: Options) -> None:
        self.nodes, self.segments = node_records(tracked), segment_records(segments)
        # Row k has contact k of each node: the first contacts of all nodes lie side by side.
        self.states = np.zeros((MAX_CONTACTS, tracked.nodes.size), CONTACT_STATE)
        self.first, self.neighbours = find_neighbours(np.ascontiguousarray(segments.nodes))
        self.own = np.ascontiguousarray(tracked.faces)
        self.candidate_first, self.candidates = (
            np.zeros(tracked.nodes.size + 1, np.intp),
            np.zeros(0, np.intp),
        )
        self.rows = np.unique(segments.nodes)
        self.parameters = parameters_of(options)
        self.account = np.zeros(6)  # see CONTACT, FRICTION, FORCE, RELEASED
        self.force = self.account[FORCE : FORCE + 3]  # (3,) sum of the forces on the tracked nodes
        self.work, self.lanes = buffers()

    def add(self, s: State) -> None:
        """Add the forces at t_n, and the work of the step that led to it."""
        if not self._cycle(s, sorted_now=False):
            self.sort(s)
            self._cycle(s, sorted_now=True)

    def _cycle(self, s: State, sorted_now: bool) -> bool:
        return cycle(
            s.lumped, self.segments, self.first, self.neighbours, self.own, self.rows,
            self.candidate_first, self.candidates, sorted_now,
            s.x, s.v, s.a, s.dt,
            s.f, self.nodes, self.states, self.parameters, self.account,
            self.work, self.lanes,
        )  # fmt: skip

    def sort(self, s: State) -> None:
        """Find the candidates of each node for a margin of relative motion, and for the step that led here."""
        step = s.dt * relative_speed_bound(s.v, self.nodes, self.rows)
        margin = max(MARGIN * mean_size(s.x, self.segments), CYCLES * step)
        self.candidate_first, self.candidates = find_candidates(s.x, self.nodes, self.segments, margin + step)
        self.parameters["travel"], self.parameters["margin"] = 0.0, margin

    def deactivate(self, s: State) -> None:
        """End all contacts: before birth, after death."""
        deactivate(self.segments, self.parameters, s.x, s.v, s.dt, self.nodes, self.states, self.account)
