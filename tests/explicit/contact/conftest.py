"""Decks with shells, solids and contacts between them."""

import pytest

from vmharness import plugins
from vmharness.explicit.build import build
from vmharness.explicit.contact.cards import control_of
from vmharness.explicit.contact.sides import Sides
from vmharness.explicit.contact.surface.faces import contact_faces

# K = E / (3 (1 - 2 nu)) = 1 of the shells, 2 of the solids. A triangle of part 1 joins its quadrilateral; the two bricks
# are parts 2 and 3, 1 x 1 x 2 and 1 x 1 x 1, one on the other.
BODIES = """*KEYWORD
*CONTROL_TERMINATION
1.0
*PART
shells
1,1,1
*PART
lower
2,2,2
*PART
upper
3,2,2
*SECTION_SHELL
1,2,1.0,2
0.1
*SECTION_SOLID
2,1
*MAT_ELASTIC
1,1.0,3.0,0.0
2,1.0,6.0,0.0
*ELEMENT_SHELL
1,1,1,2,3,4
2,1,2,5,3,3
*ELEMENT_SOLID
11,2,11,12,13,14,21,22,23,24
12,3,21,22,23,24,31,32,33,34
*NODE
1,0.0,0.0,0.0
2,2.0,0.0,0.0
3,2.0,2.0,0.0
4,0.0,2.0,0.0
5,4.0,0.0,0.0
11,0.0,0.0,1.0
12,1.0,0.0,1.0
13,1.0,1.0,1.0
14,0.0,1.0,1.0
21,0.0,0.0,3.0
22,1.0,0.0,3.0
23,1.0,1.0,3.0
24,0.0,1.0,3.0
31,0.0,0.0,4.0
32,1.0,0.0,4.0
33,1.0,1.0,4.0
34,0.0,1.0,4.0
*SET_PART_LIST
5
2,3
*SET_SHELL_LIST
6
2
*SET_SEGMENT
7
14,13,12,11
*SET_NODE_LIST
8
5,11,31
"""


@pytest.fixture
def bodies(deck):
    """The deck of the bodies with further keywords."""
    return lambda keywords: deck(BODIES + keywords)


@pytest.fixture
def sides(bodies):
    """The sides of the only contact of such a deck, which is built without it."""
    modules = plugins.modules("vmharness.explicit.contact.kinds", "KIND")
    kinds = {module.KIND.keyword.name: module.KIND for module in modules}

    def of(keywords, single=False):
        found, alone = bodies(keywords), bodies("")
        model = build(alone)
        (entry,) = [entry for entry in found.entries if entry.keyword.name.startswith("CONTACT_")]
        kind = kinds[entry.keyword.name]
        every = contact_faces(alone, model)
        return Sides(found, model, entry, control_of(found), every, kind.automatic, single)

    return of
