"""Strain increments of a step in the element's frame at mid-step."""

from vmharness.explicit.compiled import kernel
from vmharness.explicit.hexahedron.rows import GRADIENT, MIDDLE, STRAIN, tensor
from vmharness.explicit.lanes import LANES, put
from vmharness.explicit.state import Array
from vmharness.explicit.turn import strain_in_frame
from vmharness.explicit.vector import scale


@kernel
def mean_strain(work: Array, dt: float) -> None:
    """STRAIN = dt D of the mean velocity gradient."""
    for e in range(LANES):
        normal, shear = strain_in_frame(tensor(work, MIDDLE, e), tensor(work, GRADIENT, e))
        put(work, STRAIN, e, scale(dt, normal))
        put(work, STRAIN + 3, e, scale(dt, shear))
