"""The sides of a contact, A and B: tracked nodes and segments."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from vmharness.deck import Deck, Entry
from vmharness.explicit.contact.records import Segments, Tracked
from vmharness.explicit.contact.surface.choice import faces_of_surface, lies_behind, nodes_of_surface, reverse
from vmharness.explicit.contact.surface.faces import (
    ContactFaces,
    nodal_area,
    nodal_penalty,
    nodal_thickness,
    own_faces,
)
from vmharness.explicit.contact.thickness import capped, contact_thickness, release_depth
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Array, Index
from vmharness.mesh.surface import ALL, SEGMENT_SET

SEGMENTS_STIFFNESS = 2  # PENOPT


@dataclass(frozen=True)
class Sides:
    """What a contact card says of its sides "a" and "b"; `every` face of the deck."""

    deck: Deck
    model: Model
    entry: Entry
    control: Mapping[str, Any]
    every: ContactFaces
    automatic: bool  # thickness counts, and contact with shells is on both sides
    single: bool  # side A is tracked against itself

    def nodes(self, side: str) -> Index:
        """Rows (nt,) of the nodes of a side."""
        return nodes_of_surface(self.deck, self.model, self.every, self.entry, *self._named(side))

    def faces(self, side: str) -> ContactFaces:
        """The faces of a side."""
        return faces_of_surface(self.deck, self.model, self.every, self.entry, *self._named(side))

    def tracked(self, side: str, nodes: Index) -> Tracked:
        """The nodes (nt,) with what they have from the elements at them; k = SLSFAC SFSA or SFSB times theirs."""
        x, count = self.model.x0, self.model.ids.size
        penalty = self._scale(side) * nodal_penalty(self.every, nodes, count)
        if self.control["penopt"] == SEGMENTS_STIFFNESS:
            penalty = np.full(nodes.size, np.inf)
        thickness = nodal_thickness(self.every, self._thickness(side, self.every), nodes, count)
        faces, first_face = own_faces(self.every, nodes)
        return Tracked(nodes, penalty, thickness, nodal_area(self.every, x, nodes), faces, first_face)

    def segments(self, side: str, faces: ContactFaces, opposite: Index) -> Segments:
        """The faces as segments; shells that act from one side face the `opposite` nodes, if ORIEN says so."""
        x, thickness = self.model.x0, self._thickness(side, faces)
        return Segments(
            nodes=faces.nodes if self.automatic else self._facing(side, faces, opposite),
            penalty=self._scale(side) * faces.penalty,
            thickness=thickness,
            release=release_depth(faces, thickness, x, self.entry, self.control, self.automatic),
            two_sided=faces.shell & self.automatic,
        )

    def _named(self, side: str) -> tuple[str, int]:
        """The field that names the surface, and its kind; a single surface without a name is all of the deck."""
        field, kind = f"surf{side}", getattr(self.entry, f"surf{side}typ")
        return field, ALL if self.single and getattr(self.entry, field) == 0 else kind

    def _scale(self, side: str) -> float:
        return float(self.control["slsfac"] * getattr(self.entry, f"sfs{side}"))

    def _thickness(self, side: str, faces: ContactFaces) -> Array:
        thickness = contact_thickness(faces, self.entry, side, self.control, self.automatic)
        cap = self.single and not self.control["ssthk"]
        return capped(thickness, faces, self.model.x0) if cap else thickness

    def _facing(self, side: str, faces: ContactFaces, opposite: Index) -> Index:
        """Corners (ns, 4), those of shells turned over where the opposite nodes lie, on the whole, behind them.

        ORIEN = 1 does so with parts and shell sets, 2 with segment sets too, 4 never.
        """
        _, kind = self._named(side)
        orien = self.control["orien"]
        shells = faces.nodes[faces.shell]
        if (
            orien > 2
            or (orien == 1 and kind == SEGMENT_SET)
            or not lies_behind(shells, self.model.x0, opposite)
        ):
            return faces.nodes
        nodes = faces.nodes.copy()
        nodes[faces.shell] = reverse(shells)
        return nodes
