"""Material laws, one a file, named after the *MAT_... card; `_law.py` is the contract that each of them fulfils.

A new law needs one file, and no list is edited. _plasticity/ holds the kernels that the laws of metals share.
"""

from vmharness.explicit.materials._law import (
    ContinuumLaw,
    Law,
    Moduli,
    PlaneStress,
    Solid,
    Spring,
    SpringLaw,
    Uniaxial,
    continuum_law,
    law_of,
    material_of,
)
from vmharness.explicit.materials._plasticity.long_curves import has_long_curve, with_law

__all__ = [
    "ContinuumLaw", "Law", "Moduli", "PlaneStress", "Solid", "Spring", "SpringLaw", "Uniaxial",
    "continuum_law", "has_long_curve", "law_of", "material_of", "with_law",
]  # fmt: skip
