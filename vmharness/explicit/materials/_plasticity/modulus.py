"""The kinematic modulus C in equations that hold with and without kinematic hardening."""

from vmharness.explicit.kernels.vector import inlined


@inlined
def modulus(C: float | None) -> float:
    """C, or 0 without kinematic hardening."""
    if C is None:
        return 0.0
    return C
