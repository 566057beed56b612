"""Parts of the deck: elements of one kind with their section and material."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from vmharness.deck import Deck, DeckError, Entry, Keyword
from vmharness.deck.error import refuse
from vmharness.deck.keywords.mat.rigid import MAT_RIGID
from vmharness.deck.keywords.part import PART
from vmharness.deck.rule import above, among, anything, at_least, no_effect, only, where
from vmharness.deck.support import supports
from vmharness.explicit.materials import Moduli, continuum_law, material_of
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import Index
from vmharness.explicit.threads import shares

SUPPORTS = (
    supports(
        PART,
        eosid=only(0),
        hgid=at_least(0),
        grav=only(0),
        adpopt=only(0),
        tmid=no_effect("acts in thermal analysis only"),
        tm=above(0.0),
        ircs=among(0, 1),
        nodeid=at_least(0),
        **{
            name: anything(where(lambda entry: entry.nodeid, "NODEID gives the centre"))
            for name in ("xc", "yc", "zc")
        },
        **{name: at_least(0.0) for name in ("ixx", "iyy", "izz")},
        cid2=only(0),
    ),
)


@dataclass(frozen=True)
class Part:
    """The elements of one kind (shells, solids, beams, ...) of one part."""

    deck: Deck
    part: Entry
    section: Entry
    material: Entry
    eid: NDArray[np.int64]  # (ne,)
    nodes: Index  # (ne, corners) rows of the state's arrays; -1 is the ground
    table: Index  # (ne,) which of `tables` has the element
    row: Index  # (ne,) its row there
    tables: Sequence[Entry]

    @property
    def pid(self) -> int:
        """The part's number."""
        return int(self.part.pid)

    @property
    def rigid(self) -> bool:
        """Whether its material is *MAT_RIGID."""
        return self.material.keyword is MAT_RIGID

    @property
    def moduli(self) -> Moduli:
        """E and nu of the material; raises DeckError for a value that is out of its range."""
        return continuum_law(self.material).moduli(self.deck, self.material)

    @property
    def density(self) -> float:
        """Mass per volume of the material."""
        return continuum_law(self.material).density(self.deck, self.material)

    def only(self, chosen: NDArray[np.bool_], corners: int) -> "Part":
        """The part with the `chosen` (ne,) of its elements alone, and with their first `corners`."""
        kept = {name: getattr(self, name)[chosen] for name in ("eid", "table", "row")}
        return replace(self, nodes=self.nodes[chosen, :corners], **kept)

    def column(self, field: str, absent: float = 0.0) -> NDArray[np.float64]:
        """A field of the elements (ne,), `absent` in tables that do not have it."""
        column = np.full(self.eid.size, absent, float)
        for number, table in enumerate(self.tables):
            if field in table.values:
                chosen = self.table == number
                column[chosen] = table.values[field][self.row[chosen]]
        return column


def parts(deck: Deck, model: Model, elements: Sequence[Keyword], sections: Keyword) -> Iterator[Part]:
    """Yield every part that has such elements, in the order of their first element; a large one in shares for threads.

    `sections` is the *SECTION_... that their part must have. Parts that lack something are passed over; in the end
    DeckError is raised for all of them.
    """
    tables = deck.all(*elements)
    if not tables:
        return
    pid, eid = (np.concatenate([getattr(table, name) for table in tables]) for name in ("pid", "eid"))
    nodes = np.concatenate([model.corners(table, table.keyword.corners, ground=True) for table in tables])
    number = np.concatenate([np.full(table.eid.size, i) for i, table in enumerate(tables)])
    row = np.concatenate([np.arange(table.eid.size) for table in tables])
    wrong: list[DeckError] = []
    for one in dict.fromkeys(pid.tolist()):
        chosen = np.flatnonzero(pid == one)
        first = (tables[number[chosen[0]]], "pid", int(row[chosen[0]]))
        try:
            part = deck.find(PART, pid=one, referred_by=first)
            section = deck.find(sections, secid=part.secid, referred_by=(part, "secid"))
            material = material_of(deck, part)
        except DeckError as error:
            wrong.append(error)
            continue
        for share in shares(chosen.size, model.ncpu):
            some = chosen[share]
            yield Part(deck, part, section, material, eid[some], nodes[some], number[some], row[some], tables)
    refuse(wrong)
