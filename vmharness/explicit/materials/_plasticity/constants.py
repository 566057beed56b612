"""The constants of the three laws of plasticity."""

from typing import NamedTuple

from vmharness.explicit.kernels.vector import inlined
from vmharness.explicit.materials._plasticity.piecewise_linear import Curve
from vmharness.explicit.materials._plasticity.rate import Rate


class Plastic(NamedTuple):
    """Elastic moduli E and nu, kinematic modulus C, yield stress Y(p) and rate factor r.

    C is None without kinematic hardening, `rate` where the yield stress does not depend on the strain rate: the
    compiled law then has no trace of them.
    """

    E: float
    nu: float
    C: float | None
    Y: Curve
    rate: Rate | None


@inlined
def modulus(C: float | None) -> float:
    """C, or 0 without kinematic hardening."""
    if C is None:
        return 0.0
    return C
