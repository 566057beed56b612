"""*CONTROL_OUTPUT: what LS-DYNA prints."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

REALS = ("opifs", "gmdt", "cdetol")


def _card(names: str, optional: bool = True) -> Card:
    return Card(
        {name: real(0.0) if name in REALS else integer(0) for name in names.split()}, optional=optional
    )


CONTROL_OUTPUT = Keyword(
    "CONTROL_OUTPUT",
    _card("npopt neecho nrefup iaccop opifs ipnint ikedit iflush", optional=False),
    _card("iprtf ierode tet10s8 msgmax ipcurv gmdt ip1dblt eocs"),
    _card("tolev newleg frfreq minfo solsig msgflg cdetol igeom"),
    _card("phschng demden icrfile spc2bnd penout shlsig hisnout engout"),
    _card("insf isolsf ibsf issf mlkbag kineng isfcnt"),
    _card("ielogkey ielogini ielogsol"),
    single=True,
)
