"""The cards by which *PART_INERTIA and *CONSTRAINED_NODAL_RIGID_BODY_INERTIA give mass, inertia and velocity."""

from vmharness.deck.field import Field, integer, real

# Centre of mass, or the node there; mass; whether the tensor is in global (0) or local (1) axes.
CENTRE: dict[str, Field] = {
    **{name: real(0.0) for name in ("xc", "yc", "zc")},
    "tm": real(),
    "ircs": integer(0),
    "nodeid": integer(0),
}
TENSOR: dict[str, Field] = {
    "ixx": real(),
    "ixy": real(0.0),
    "ixz": real(0.0),
    "iyy": real(),
    "iyz": real(0.0),
    "izz": real(),
}
VELOCITY: dict[str, Field] = {name: real(0.0) for name in ("vtx", "vty", "vtz", "vrx", "vry", "vrz")}
# The local x-axis, and a vector in the local x-y plane.
LOCAL: dict[str, Field] = {
    **{name: real(0.0) for name in ("xl", "yl", "zl", "xlip", "ylip", "zlip")},
    "cid2": integer(0),
}
