"""Keywords that cannot change results, each with a sentence that says so."""

from vmharness.deck import Keyword
from vmharness.deck.keywords import database
from vmharness.deck.keywords.comment import COMMENT
from vmharness.deck.keywords.control.accuracy import CONTROL_ACCURACY
from vmharness.deck.keywords.control.dynamic_relaxation import CONTROL_DYNAMIC_RELAXATION
from vmharness.deck.keywords.control.energy import CONTROL_ENERGY
from vmharness.deck.keywords.control.output import CONTROL_OUTPUT
from vmharness.deck.keywords.control.running import CONTROL_CPU, RUNNING
from vmharness.deck.keywords.control.solution import CONTROL_SOLUTION
from vmharness.deck.keywords.control.units import CONTROL_UNITS
from vmharness.deck.keywords.define import coordinate
from vmharness.deck.keywords.define.other import KEYWORDS as OTHER_DEFINITIONS
from vmharness.deck.keywords.parameter_duplication import PARAMETER_DUPLICATION
from vmharness.deck.keywords.set.other import KEYWORDS as OTHER_SETS
from vmharness.deck.keywords.set.solid import SET_BEAM, SET_DISCRETE, SET_SOLID
from vmharness.deck.keywords.title import TITLE
from vmharness.deck.rule import among, no_effect, only
from vmharness.deck.support import supports, without_effect

REASONS: dict[Keyword, str] = {
    **dict.fromkeys(database.KEYWORDS, "asks for output files; no effect on results."),
    COMMENT: "comment text; no effect on results.",
    TITLE: "title; no effect on results.",
    CONTROL_ENERGY: "every energy is always computed.",
    CONTROL_OUTPUT: "asks for print-outs; no effect on results.",
    CONTROL_UNITS: "the units are those of the numbers; no effect on results.",
    PARAMETER_DUPLICATION: "a second definition of a parameter is always an error.",
    **dict.fromkeys(
        (
            coordinate.DEFINE_BOX,
            coordinate.DEFINE_COORDINATE_NODES,
            coordinate.DEFINE_COORDINATE_SYSTEM,
            coordinate.DEFINE_COORDINATE_VECTOR,
            coordinate.DEFINE_VECTOR,
            SET_BEAM,
            SET_DISCRETE,
            SET_SOLID,
        ),
        "nothing that is supported refers to it.",
    ),
    **dict.fromkeys(
        (*OTHER_DEFINITIONS, *OTHER_SETS), "kept unread; nothing that is supported can refer to it."
    ),
    **dict.fromkeys((CONTROL_CPU, *RUNNING), "asks for how LS-DYNA runs; no effect on results."),
}

SUPPORTS = (
    *(without_effect(keyword, sentence) for keyword, sentence in REASONS.items()),
    without_effect(
        CONTROL_ACCURACY,
        "the stress update is always of second order (OSU = 1).",
        osu=among(0, 1),
        inn=only(1),
        pidos=only(0),
        iacc=only(0),
        exacc=only(0.0),
        srtflg=among(0, 1),
    ),
    without_effect(CONTROL_DYNAMIC_RELAXATION, "nothing is relaxed with IDRFLG = 0.", idrflg=only(0)),
    supports(
        CONTROL_SOLUTION,
        soln=only(0),  # structures
        nlq=no_effect("sets a vector length inside LS-DYNA"),
        isnan=no_effect("a run that diverges ends in any case"),
        lcint=no_effect("curves are used as they are"),
        lcacc=no_effect("curves are used as they are"),
        ncdcf=no_effect("acts in thermal analysis only"),
        nocop=no_effect("acts in thermal analysis only"),
    ),
)
