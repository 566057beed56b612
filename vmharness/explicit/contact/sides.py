"""The sides of a contact, A and B: nodes that are tracked, and segments that they may touch."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.explicit.contact.records import Segments, Tracked
from vmharness.explicit.contact.surface.choice import facets_of_surface, nodes_of_surface
from vmharness.explicit.contact.surface.facets import Facets
from vmharness.explicit.contact.surface.nodal import nodal_area, nodal_penalty, nodal_thickness
from vmharness.explicit.contact.surface.orient import faces_away, turned
from vmharness.explicit.contact.thickness import capped, contact_thickness, release_depth
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index
from vmharness.mesh.surface import ALL, SEGMENT_SET

SEGMENTS_STIFFNESS = 2  # PENOPT


@dataclass(frozen=True)
class Sides:
    """What a contact card says of its sides "a" and "b"; `every` facet of the deck."""

    deck: Deck
    model: Model
    entry: Entry
    control: Mapping[str, Any]
    every: Facets
    automatic: bool  # thickness counts, and shells are touched from both sides
    single: bool  # side A touches itself

    def nodes(self, side: str) -> Index:
        """Rows (nt,) of the nodes of a side."""
        return nodes_of_surface(self.deck, self.model, self.every, self.entry, *self._named(side))

    def facets(self, side: str) -> Facets:
        """The facets of a side."""
        return facets_of_surface(self.deck, self.model, self.every, self.entry, *self._named(side))

    def tracked(self, side: str, nodes: Index) -> Tracked:
        """The nodes (nt,) with what they have from the elements at them; k = SLSFAC SFSA or SFSB times theirs."""
        x, count = self.model.x0, self.model.ids.size
        penalty = self._scale(side) * nodal_penalty(self.every, nodes, count)
        if self.control["penopt"] == SEGMENTS_STIFFNESS:
            penalty = np.full(nodes.size, np.inf)
        thickness = nodal_thickness(self.every, self._thickness(side, self.every), nodes, count)
        return Tracked(nodes, penalty, thickness, nodal_area(self.every, x, nodes))

    def segments(self, side: str, facets: Facets, opposite: Index) -> Segments:
        """The facets as segments; shells that act from one side face the `opposite` nodes, if ORIEN says so."""
        x, thickness = self.model.x0, self._thickness(side, facets)
        return Segments(
            nodes=facets.nodes if self.automatic else self._facing(side, facets, opposite),
            penalty=self._scale(side) * facets.penalty,
            thickness=thickness,
            release=release_depth(facets, thickness, x, self.entry, self.control, self.automatic),
            two_sided=facets.shell & self.automatic,
        )

    def _named(self, side: str) -> tuple[str, int]:
        """The field that names the surface, and its kind; a single surface without a name is all of the deck."""
        field, kind = f"surf{side}", getattr(self.entry, f"surf{side}typ")
        return field, ALL if self.single and getattr(self.entry, field) == 0 else kind

    def _scale(self, side: str) -> float:
        return float(self.control["slsfac"] * getattr(self.entry, f"sfs{side}"))

    def _thickness(self, side: str, facets: Facets) -> Array:
        thickness = contact_thickness(facets, self.entry, side, self.control, self.automatic)
        cap = self.single and not self.control["ssthk"]
        return capped(thickness, facets, self.model.x0) if cap else thickness

    def _facing(self, side: str, facets: Facets, opposite: Index) -> Index:
        """Corners (ns, 4), those of shells turned over where the opposite nodes lie, on the whole, behind them.

        ORIEN = 1 does so with parts and shell sets, 2 with segment sets too, 4 never.
        """
        _, kind = self._named(side)
        orien = self.control["orien"]
        shells = facets.nodes[facets.shell]
        if (
            orien > 2
            or (orien == 1 and kind == SEGMENT_SET)
            or not faces_away(shells, self.model.x0, opposite)
        ):
            return facets.nodes
        nodes = facets.nodes.copy()
        nodes[facets.shell] = turned(shells)
        return nodes
