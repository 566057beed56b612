"""The cards by which *PART_INERTIA and *CONSTRAINED_NODAL_RIGID_BODY_INERTIA give mass, inertia and velocity."""

from vmharness.deck.field import Field, integer, only, real

# Centre of mass, or the node there; mass; whether the tensor is in global (0) or local (1) axes.
CENTRE: dict[str, Field] = {
    **{name: real(0.0) for name in ("xc", "yc", "zc")},
    "tm": real(above=0.0),
    "ircs": integer(0, choices=(0, 1)),
    "nodeid": integer(0, at_least=0),
}
TENSOR: dict[str, Field] = {
    "ixx": real(at_least=0.0),
    "ixy": real(0.0),
    "ixz": real(0.0),
    "iyy": real(at_least=0.0),
    "iyz": real(0.0),
    "izz": real(at_least=0.0),
}
VELOCITY: dict[str, Field] = {name: real(0.0) for name in ("vtx", "vty", "vtz", "vrx", "vry", "vrz")}
# The local x-axis, and a vector in the local x-y plane.
LOCAL: dict[str, Field] = {
    **{name: real(0.0) for name in ("xl", "yl", "zl", "xlip", "ylip", "zlip")},
    "cid2": only(0),
}
