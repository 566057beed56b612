"""No field is lost: the solver reads it, or says that it has no effect, or refuses what is not its default."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from vmharness.case import read as read_case
from vmharness.case.deck import read_deck
from vmharness.deck import Deck, Keyword, read, vocabulary
from vmharness.deck.rule import Rule
from vmharness.deck.support import Support
from vmharness.explicit import build
from vmharness.explicit.supported import supported

CASES = sorted((Path(__file__).parents[2] / "cases").glob("*/case.toml"))

NODES = "".join(f"{i + 1},{i % 2}.0,{i // 2 % 2}.0,{i // 4}.0\n" for i in range(8)) + "9,7.0,0.0,0.0\n"
TIME = (
    "*CONTROL_TERMINATION\n1.0\n*CONTROL_TIMESTEP\n0.0,0.9,,,,1\n*DEFINE_CURVE\n1\n0.0,0.5\n9.0,0.5\n"
    "*CONTROL_PARALLEL\n1\n*CONTROL_HOURGLASS\n1\n*CONTROL_SHELL\n,,,1\n"
)
MATERIAL = "*MAT_RIGID\n2,1.0,1.0,0.3\n\n\n*SECTION_SHELL\n1,2\n1.0\n"
RIGID = MATERIAL + "*PART\na\n1,1,2\n"
SHELL = (
    "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,4,3\n1.0\n2,2,5,6,8,7\n1.0\n"
    "*PART\nb\n2,1,3\n*MAT_PIECEWISE_LINEAR_PLASTICITY\n3,1.0,1.0,0.3,1.0\n1.0,1.0\n{table}\n\n"
)
CONTACT = "{sides}\n0.5,0.2,1.0,0.1,10.0\n0.5,{more}\n"
SEGMENTS = "*SET_SEGMENT\n1\n1,2,4,3\n*SET_SHELL_LIST\n1\n2\n"
SPRINGS = (
    "*PART\ns\n4,4,4\n*SECTION_DISCRETE\n4\n\n*MAT_DAMPER_NONLINEAR_VISCOUS\n4,5\n"
    "*DEFINE_CURVE\n5\n-9.0,-9.0\n9.0,9.0\n"
    "*ELEMENT_DISCRETE\n1,4,1,2,1\n2,4,5,6,2\n*DEFINE_SD_ORIENTATION\n1,0,1.0\n2,2,,,,5,6\n"
    "*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n5,5,1.0\n6,6,1.0\n"
)
INERTIA = "0.5,0.5,0.0,9.0,1,{node}\n1.0,0.0,0.0,1.0,0.0,1.0\n1.0\n1.0,0.0,0.0,0.0,1.0\n"

DECKS = [
    RIGID + SHELL.format(table="") + "*CONSTRAINED_NODAL_RIGID_BODY\n8,0,8\n*SET_NODE_GENERAL\n8\nNODE,5,6,7,8\n"
    "*LOAD_RIGID_BODY\n1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n8,1,0,1\n*INITIAL_VELOCITY_RIGID_BODY\n1,1.0\n",
    RIGID + "*ELEMENT_SHELL\n1,1,1,2,4,3\n*ELEMENT_SHELL\n2,7,5,6,8,7\n*PART\nc\n7,1,2\n"
    "*CONSTRAINED_RIGID_BODIES\n1,7\n*LOAD_BODY_PARTS\n9\n*SET_PART_LIST\n9\n1,7\n"
    "*LOAD_BODY_RX\n1\n*LOAD_BODY_RY\n1\n*LOAD_BODY_RZ\n1\n",
    RIGID + "*ELEMENT_SHELL\n1,1,1,2,4,3\n*ELEMENT_SHELL\n2,7,5,6,8,7\n*PART\nc\n7,1,2\n"
    "*CONSTRAINED_EXTRA_NODES_NODE\n1,9\n*NODE\n10,7.0,0.0,0.0\n11,7.0,1.0,0.0\n12,7.0,1.0,0.0\n"
    "*CONSTRAINED_EXTRA_NODES_SET\n7,8\n*SET_NODE_LIST\n8\n10,11\n*CONSTRAINED_EXTRA_NODES_NODE\n1,12\n"
    "*CONSTRAINED_JOINT_REVOLUTE\n9,10,12,11\n",
    "*PART_INERTIA\nb\n7,1,2\n" + INERTIA.format(node=0) + MATERIAL + "*ELEMENT_SHELL\n1,7,1,2,4,3\n"
    "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n8,0,8\n" + INERTIA.format(node=5) + "*SET_NODE_LIST\n8\n5,6\n",
    SHELL.format(table="0.0,1.0\n1.0,2.0").replace("2,2,5", "2,1,5") + "*PART\na\n1,1,1\n*SECTION_SHELL\n1,2\n1.0\n"
    "*MAT_PLASTIC_KINEMATIC\n1,1.0,1.0,0.3,1.0\n1.0,1.0,0.0,1.0\n"
    "*INITIAL_VELOCITY\n0,8\n1.0\n2.0\n*SET_NODE_LIST\n8\n5,6\n*BOUNDARY_SPC_NODE\n1,0,1,1,1,1,1,1\n"
    "*LOAD_SEGMENT\n1,1.0,0.0,1,2,4,3\n*DAMPING_PART_MASS\n1,1,1.0,1\n1.0\n",
    SHELL.format(table="") + "*PART\na\n1,1,3\n*SECTION_SHELL\n1,2\n1.0\n*INITIAL_VELOCITY_GENERATION\n"
    "1,2,1.0\n0.0,0.0,0.0,0.0,0.0,1.0\n*RIGIDWALL_PLANAR_FINITE\n0\n0,0,-1,0,0,1\n1,0,-1,1,1\n"
    "*RIGIDWALL_PLANAR_FINITE_MOVING\n0\n0,0,-2,0,0,1\n1,0,-2,1,1\n1.0,1.0\n",
    *(
        SHELL.format(table="") + SEGMENTS + "*PART\na\n1,1,3\n*SECTION_SHELL\n1,2\n1.0\n"
        f"*CONTACT_{name}\n" + CONTACT.format(sides=sides, more="0.5,0.1,0.1" if "," in sides else ",0.1")
        for name, sides in (
            ("AUTOMATIC_SINGLE_SURFACE", "0"),
            ("AUTOMATIC_SURFACE_TO_SURFACE", "1,2,3,3"),
            ("ONE_WAY_SURFACE_TO_SURFACE", "1,2,3,3"),
            ("SURFACE_TO_SURFACE", "1,1,0,1"),
        )
    ),
    RIGID + "*ELEMENT_SHELL\n1,1,1,2,4,3\n*ELEMENT_SHELL\n2,7,5,6,8,7\n*PART\nc\n7,1,2\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + CONTACT.format(sides="1,7,3,3", more=""),
    SHELL.format(table="") + "*PART\na\n1,1,3\n*SECTION_SHELL\n1,2\n1.0\n*SET_NODE_COLUMN\n1\n1\n2\n"
    "*SET_NODE_ADD\n2\n1\n*BOUNDARY_SPC_SET\n2,0,1\n*SET_PART_LIST_GENERATE\n1\n1,1\n*SET_PART_ADD\n2\n1\n"
    "*INITIAL_VELOCITY_GENERATION\n2,1,1.0\n,,,1.0\n*SET_SHELL_LIST_GENERATE\n1\n2,2\n"
    "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,1,2,1\n\n\n",
    SPRINGS,
    "*ELEMENT_BEAM_ORIENTATION\n1,1,1,2\n0.0,1.0,0.0\n*PART\nb\n1,1,1\n*MAT_ELASTIC\n1,1.0,1.0\n"
    "*SECTION_BEAM\n1,2\n1.0,1.0,1.0,1.0\n",
]  # fmt: skip

# Labels; and cards that are there for values of another field which are refused.
LABELS = {"eid", "heading"}
REFUSED_CARDS = {
    "BOUNDARY_PRESCRIBED_MOTION_NODE": "offset1 offset2 lrb node1 node2",
    "BOUNDARY_PRESCRIBED_MOTION_RIGID": "offset1 offset2 lrb node1 node2",
    "BOUNDARY_PRESCRIBED_MOTION_SET": "offset1 offset2 lrb node1 node2",
    "MAT_ELASTIC": "efunc cnvt iterlm",
    "MAT_PIECEWISE_LINEAR_PLASTICITY": "fail",  # all values that are not refused are: no failure
    "SECTION_BEAM": "vol iner cid ca offset rrcon srcon trcon ts1 ts2 tt1 tt2 print itoff nsloc ntloc",
    "SECTION_SHELL": " ".join(f"b{i}" for i in range(1, 201)),
}


class Heard(dict):
    """The values of an entry, which remember what is asked of them."""

    def __init__(self, values, names):
        super().__init__(values)
        self.names = names

    def __getitem__(self, name):
        self.names.add(name)
        return super().__getitem__(name)

    def get(self, name, default=None):
        self.names.add(name)
        return super().get(name, default)


@pytest.fixture(scope="module")
def heard(tmp_path_factory) -> dict[str, set[str]]:
    """By keyword: the fields for which building the models of all decks asks, the review of the cards apart."""
    folder, found = tmp_path_factory.mktemp("decks"), {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(build, "review_cards", lambda deck: [])
        for deck in _decks(folder):
            for entry in deck.entries:
                entry.values = Heard(entry.values, found.setdefault(entry.keyword.name, set()))
                for card in entry.keyword.cards:
                    assert card.when is None or card.when(entry) in (True, False)
            build.assemble(deck)
    return found


def _decks(folder: Path) -> Iterator[Deck]:
    yield from (read_deck(read_case(path.parent)) for path in CASES)
    for text in DECKS:
        path = folder / "deck.k"
        path.write_text(f"*KEYWORD\n*NODE\n{NODES}{TIME}{text}*END\n")
        yield read(path, vocabulary())


def _is_said(rule: Rule | None) -> bool:
    """Whether each value but the default is refused, or said to have no effect."""
    return rule is not None and bool(rule.idle or rule.alike or (rule.brief and "," not in rule.brief))


def _fields(keyword: Keyword) -> set[str]:
    flat = {card.flat for card in keyword.rows if getattr(card, "flat", "")}
    fields = {name for card in (*keyword.cards, *keyword.rows) for name in card.defaults()}
    return flat | {name for name in fields if not any(re.fullmatch(rf"{one}\d+", name) for one in flat)}


@pytest.mark.parametrize(
    "support", [s for s in supported().values() if not s.effect], ids=lambda s: s.keyword.name
)
def test_every_field_is_read_or_refused_or_said(heard: dict[str, set[str]], support: Support) -> None:
    name = support.keyword.name
    refused = set(REFUSED_CARDS.get(name, "").split())
    lost = _fields(support.keyword) - heard.get(name, set()) - refused - LABELS
    assert {field for field in lost if not _is_said(support.rules.get(field))} == set()


def test_a_field_that_nobody_reads_would_be_found(heard: dict[str, set[str]]) -> None:
    assert "da1" not in heard["SET_NODE_LIST"]
    assert not _is_said(None)
    assert _is_said(supported()["SET_NODE_LIST"].rules["da1"])


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("*MAT_RIGID\n9,1.0,1.0,0.3\n0,7,7\n\n", ["CON1 = 7: CMO = 0 holds nothing", "CON2 = 7: CMO = 0 holds nothing"]),
        ("*MAT_PLASTIC_KINEMATIC\n9,1.0,1.0,0.3,1.0,0.0,1.0\n\n", ["BETA = 1.0: ETAN = 0: no hardening"]),
        (
            "*MAT_PIECEWISE_LINEAR_PLASTICITY\n9,1.0,1.0,0.3,1.0,0.5\n,,1,,1.0\n\n\n",
            [f"{name}: the yield stress is given by LCSS, or by EPS and ES" for name in ("SIGY = 1.0", "ETAN = 0.5")]
            + ["VP = 1.0: acts with C and P"],
        ),
        ("*DAMPING_GLOBAL\n1,2.0\n", ["VALDMP = 2.0: LCID is used instead"]),
        ("*INITIAL_VELOCITY_GENERATION\n0,2,,1.0\n1.0\n", ["STYP = 2: ID = 0 is all nodes", "XC = 1.0: no rotation"]),
        ("*DEFINE_SD_ORIENTATION\n1,0,1.0,,,5,6\n", [f"{n}: acts with IOP = 2 or 3" for n in ("NID1 = 5", "NID2 = 6")]),
        ("*SET_NODE_GENERAL\n1\nALL,5\n", ["E1 = 5: ALL is all nodes"]),
        ("*SET_SEGMENT\n1,2.0,,,,,4\n1,2,4,3\n", ["DA1 = 2.0: nothing here uses attributes of sets", "ITS = 4: is of"]),
        ("*CONTACT_SURFACE_TO_SURFACE\n,,5,5\n\n\n\n\n\n,,,,,,,2\n", ["SHLEDG = 2: edges are always round"]),
        ("*CONTROL_SHELL\n,,,1\n*CONTROL_BULK_VISCOSITY\n1.0\n", ["ISTUPD = 1: the deck has no shells", "Q1 = 1.0: the"]),
    ],
)  # fmt: skip
def test_a_field_that_does_not_act_beside_others_is_said(tmp_path: Path, text: str, said: list[str]) -> None:
    path = tmp_path / "deck.k"
    path.write_text(f"*KEYWORD\n*NODE\n{NODES}*CONTROL_TERMINATION\n1.0\n{text}*END\n")
    idle = [
        str(finding).partition(": *")[2].partition(": ")[2]
        for finding in build.review(read(path, vocabulary()))
        if finding.idle
    ]
    found = [one for one in idle if not one.startswith("NID = 1:")]
    assert len(found) == len(said)
    assert all(one.startswith(start) for one, start in zip(found, said, strict=True))
