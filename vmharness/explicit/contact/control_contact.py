"""What contacts can do with the fields of *CONTROL_CONTACT, and what of it acts on no contact of the deck."""

from vmharness.deck import Deck, Entry
from vmharness.deck.keywords.control.contact import CONTROL_CONTACT
from vmharness.deck.rule import Why, above, among, anything, at_least, only
from vmharness.deck.support import supports
from vmharness.explicit.contact.cards import contacts_of
from vmharness.explicit.contact.without_effect import of_control_cards, reason

DEFAULT_ALONE = """thkchg enmass usrstr usrfrc interm sfric dfric edc vfc th th_sf pen_sf spotstp spotdel spothin
dir_tie isym nserod rwgdth icov swradf ithoff shledg pstiff ithcnt tdcnof shltrw igactc irevspt cohtiem
tieopt strobj befblk ptscl rwksf"""
OFF_OR_ON = "ssthk ecdt tiedprj frceng skiprwg outseg rwgaps ftall"


def _idle(field: str) -> Why:
    """Why a field does not act on the contacts of the deck."""

    def why(deck: Deck, entry: Entry) -> str:
        return reason(of_control_cards(contacts_of(deck)), field)

    return why


SUPPORTS = (
    supports(
        CONTROL_CONTACT,
        slsfac=above(0.0, idle=_idle("slsfac")),
        rwpnal=at_least(0.0),
        islchk=among(1, 2, idle=_idle("islchk")),
        penopt=among(1, 2, idle=_idle("penopt")),
        orien=among(1, 2, 4, idle=_idle("orien")),
        nsbcs=anything(_idle("nsbcs")),
        xpene=above(0.0, idle=_idle("xpene")),
        **{name: among(0, 1, 2, idle=_idle(name)) for name in ("shlthk", "ignore")},
        **{name: among(0, 1, idle=_idle(name)) for name in OFF_OR_ON.split()},
        **{name: only(CONTROL_CONTACT.default(name)) for name in DEFAULT_ALONE.split()},
    ),
)
