"""Strain increments of a step in the element's frame at mid-step."""

from vmharness.explicit.elements.solid._rows import GRADIENT, MIDDLE, STRAIN, tensor
from vmharness.explicit.kernels.compiled import kernel
from vmharness.explicit.kernels.rotation import strain_in_frame
from vmharness.explicit.kernels.simd import LANES, put
from vmharness.explicit.kernels.vector import scale
from vmharness.explicit.model.state import Array


@kernel
def mean_strain(work: Array, dt: float) -> None:
    """STRAIN = dt D of the mean velocity gradient."""
    for e in range(LANES):
        normal, shear = strain_in_frame(tensor(work, MIDDLE, e), tensor(work, GRADIENT, e))
        put(work, STRAIN, e, scale(dt, normal))
        put(work, STRAIN + 3, e, scale(dt, shear))
