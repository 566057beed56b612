"""A pass: tracked nodes against segments."""

import numpy as np

from vmharness.explicit.contact.cycle import cycle, fastest, rest
from vmharness.explicit.contact.neighbours import neighbours
from vmharness.explicit.contact.parameters import Options
from vmharness.explicit.contact.records import MOST, TOUCH, node_records, segment_records
from vmharness.explicit.contact.rule import rule_of
from vmharness.explicit.contact.search import candidates, size_of
from vmharness.explicit.contact.segments import Segments
from vmharness.explicit.contact.sliding import ROWS
from vmharness.explicit.contact.tracked import Tracked
from vmharness.explicit.kernels.simd import LANES
from vmharness.explicit.model.state import Array, State

MARGIN = 0.3  # of the size of a segment; a wider one sorts less often, and leaves more to look at
CYCLES = 8  # that a sort serves at least


class OneWay:
    """Nodes kept from passing through segments."""

    def __init__(self, tracked: Tracked, segments: Segments, options: Options) -> None:
        self.nodes, self.segments = node_records(tracked), segment_records(segments)
        self.touches = np.zeros((MOST, tracked.nodes.size), TOUCH)  # the first of all nodes side by side
        self.first, self.beside = neighbours(np.ascontiguousarray(segments.nodes))
        self.near_first, self.near = np.zeros(tracked.nodes.size + 1, np.intp), np.zeros(0, np.intp)
        self.rows = np.unique(segments.nodes)
        self.rule = rule_of(options)
        self.account = np.zeros(
            6
        )  # energies "contact", "friction"; force on the tracked nodes; energy "released"

        self.work, self.lanes = np.ones(ROWS * LANES), np.zeros((LANES, 2), np.intp)

    def add(self, s: State) -> None:
        """Add the forces at t_n, and the work of the step that led to it."""
        if not self._cycle(s, False):
            self.sort(s)
            self._cycle(s, True)

    def _cycle(self, s: State, sorted_now: bool) -> bool:
        return cycle(
            s.f, s.x, s.v, s.a, s.lumped, s.dt, self.nodes, self.segments, self.touches, self.first, self.beside,
            self.near_first, self.near, self.rows, self.rule, self.account, self.work, self.lanes, sorted_now,
        )  # fmt: skip

    def sort(self, s: State) -> None:
        """Find what each node can touch until surfaces have moved by a margin, and in the step that led here."""
        step = s.dt * fastest(s.v, self.nodes, self.rows)
        margin = max(MARGIN * size_of(s.x, self.segments), CYCLES * step)
        self.near_first, self.near = candidates(s.x, self.nodes, self.segments, margin + step)
        self.rule["travel"], self.rule["margin"] = 0.0, margin

    def rest(self, s: State) -> None:
        """Let all nodes go: before birth, after death."""
        rest(s.x, s.v, s.dt, self.nodes, self.segments, self.touches, self.rule, self.account)

    @property
    def force(self) -> Array:
        """Sum (3,) of the forces on the tracked nodes."""
        return self.account[2:5]
