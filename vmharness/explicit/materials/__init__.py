"""Material laws, one a file, named after the *MAT_... card; `_law.py` is the contract that each of them fulfils."""

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

__all__ = [
    "ContinuumLaw", "Law", "Moduli", "PlaneStress", "Solid", "Spring", "SpringLaw", "Uniaxial",
    "continuum_law", "law_of", "material_of",
]  # fmt: skip
