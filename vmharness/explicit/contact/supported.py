"""What contacts can do with the fields of their cards, by kind of contact."""

from vmharness.deck import Deck, Entry
from vmharness.deck.rule import Rule, Why, above, always, among, anything, at_least, no_effect, only
from vmharness.deck.support import Support, supports
from vmharness.explicit.contact.build import Kind
from vmharness.explicit.contact.cards import control_of
from vmharness.explicit.contact.without_effect import of_cards, reason

Kinds = tuple[int, ...]  # of surfaces, as SURFATYP numbers them

SEGMENTS: Kinds = (0, 1, 2, 3, 5, 6)  # have segments
NODES: Kinds = (*SEGMENTS, 4)
NONE: Kinds = ()  # no second side

NOT_NEGATIVE = ("fs", "fd", "dc", "vc", "vdc", "bt", "sast", "sbst", "penmax")
POSITIVE = ("dt", "sfsa", "sfsb", "sfsat", "sfsbt", "fsf", "vsf", "sofscl")
DEFAULT_ALONE = """saboxid sbboxid lcidab thkopt isym i2d3d sldthk sldstf dprfac dtstif edgek flangl
q2tri dtpchk sfnbr fnlscl dnlscl tcso tiedid sharec cparm8 ipback srnde icor ftorq region
pstiff ignroff binr2d ssftyp swtpr tetfac shloff maxpar frcfrq fricsf fstol"""
REASONED = ("sapr", "sbpr", "cid_rcf", "bsort", "igap", "sbopt", "depth", "surfa", "surfb")


def contact(kind: Kind, a: Kinds, b: Kinds) -> Support:
    """The rules of a kind of contact whose sides may be surfaces of the kinds `a` and `b`."""
    keyword, two_way = kind.keyword, kind.two_way
    rules: dict[str, Rule] = {
        "surfatyp": among(*a),
        "surfbtyp": among(*b) if b else no_effect("a single surface has no second side"),
        "penchk": only(0) if kind.automatic else among(0, 1, 2),
        **{name: at_least(0.0, idle=_idle(name, two_way)) for name in NOT_NEGATIVE},
        **{name: above(0.0, idle=_idle(name, two_way)) for name in POSITIVE},
        **{name: only(keyword.default(name)) for name in DEFAULT_ALONE.split()},
        **{name: anything(_idle(name, two_way)) for name in REASONED},
        "soft": among(0, 1),
        "shlthk": among(0, 1, 2, idle=_idle("shlthk", two_way)),
        "snlog": among(0, 1),
        "ignore": among(0, 1, 2),
        "shledg": among(0, 2, alike=always("edges are always round")),
    }
    return supports(keyword, **rules)


def _idle(field: str, two_way: bool) -> Why:
    """Why a field does not act beside the other fields of its contact."""

    def why(deck: Deck, entry: Entry) -> str:
        return reason(of_cards(entry, control_of(deck), two_way), field)

    return why
