"""Small models for tests of the solver."""

from collections.abc import Callable
from pathlib import Path

import pytest

from vmharness.deck import Deck, read, vocabulary
from vmharness.deck.finding import refuse_unsupported
from vmharness.explicit.build import build
from vmharness.explicit.model.model import Model
from vmharness.explicit.supported import review_cards

# One fixed square shell of side 2 at z = 0 with nodes 1 to 4, which sets the time step; nothing else.
# K A / d = E/(3 (1 - 2 nu)) 4/(2 sqrt 2) with E = 3, nu = 0: sqrt(2).
WALL = """*KEYWORD
*CONTROL_TERMINATION
{end}
*PART
wall
1,1,1
*SECTION_SHELL
1,2,1.0,2
0.1
*MAT_ELASTIC
1,{density},3.0,0.0
*ELEMENT_SHELL
1,1,1,2,3,4
*NODE
1,-1.0,-1.0,0.0,7,7
2,1.0,-1.0,0.0,7,7
3,1.0,1.0,0.0,7,7
4,-1.0,1.0,0.0,7,7
*DEFINE_CURVE
1
0.0,1.0
1000.0,1.0
"""


@pytest.fixture
def deck(tmp_path: Path) -> Callable[[str], Deck]:
    """Read a deck from text; DeckError for what is ill-formed, and for cards that the solver does not support."""

    def from_text(text: str) -> Deck:
        path = tmp_path / "deck.k"
        path.write_text(text)
        found = read(path, vocabulary())
        refuse_unsupported(review_cards(found))
        return found

    return from_text


@pytest.fixture
def wall_and(deck: Callable[[str], Deck]) -> Callable[..., Model]:
    """The model of the fixed wall and further keywords."""

    def model(keywords: str, end: float = 1.0, density: float = 1e-4) -> Model:
        return build(deck(WALL.format(end=end, density=density) + keywords))

    return model
