"""*INITIAL_VELOCITY: velocities of nodes at t = 0."""

from vmharness.deck.card import Card
from vmharness.deck.field import integer, real
from vmharness.deck.keyword import Keyword

INITIAL_VELOCITY = Keyword(
    "INITIAL_VELOCITY",
    Card(nsid=integer(0), nsidex=integer(0), boxid=integer(0), irigid=integer(0), icid=integer(0)),
    Card(vx=real(0.0), vy=real(0.0), vz=real(0.0), vxr=real(0.0), vyr=real(0.0), vzr=real(0.0)),
    Card(
        vxe=real(0.0),
        vye=real(0.0),
        vze=real(0.0),
        vxre=real(0.0),
        vyre=real(0.0),
        vzre=real(0.0),
        when=lambda entry: entry.nsidex > 0,
    ),
)

INITIAL_VELOCITY_NODE = Keyword(
    "INITIAL_VELOCITY_NODE",
    Card(
        nid=integer(),
        vx=real(0.0),
        vy=real(0.0),
        vz=real(0.0),
        vxr=real(0.0),
        vyr=real(0.0),
        vzr=real(0.0),
        icid=integer(0),
    ),
    repeat=True,
)
