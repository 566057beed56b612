"""Belytschko-Tsay shells of one part, as a force."""

from collections.abc import Callable
from typing import Any

from vmharness.explicit.elements.shell._kind import Kind
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import Hourglass
from vmharness.explicit.elements.shell.belytschko_tsay.hourglass import moduli as hourglass_moduli
from vmharness.explicit.elements.shell.belytschko_tsay.lanes import corners
from vmharness.explicit.elements.shell.belytschko_tsay.length import LENGTHS
from vmharness.explicit.elements.shell.belytschko_tsay.mass import area, nodal_mass
from vmharness.explicit.elements.shell.belytschko_tsay.step import force, hourglass_force, strain
from vmharness.explicit.kernels.simd import Indices, by_element
from vmharness.explicit.materials import Moduli
from vmharness.explicit.model.state import Array

QUADRILATERAL = Kind(area, nodal_mass, corners, LENGTHS, strain, hourglass_force, force)


class BelytschkoTsay(Shells):
    """Shells (ne, 4) as in shell/part.py, with `hourglass` control that takes E and nu of `moduli`."""

    def __init__(
        self,
        name: str,
        nodes: Indices,
        x: Array,
        thickness: Array,
        density: float,
        law: Callable[..., Any],
        constants: tuple[Any, ...],
        moduli: Moduli,
        nip: int = 2,
        shrf: float = 1.0,
        hourglass: Hourglass | None = None,
        isdo: int = 0,
        **options: Any,
    ) -> None:
        control = hourglass or Hourglass()
        super().__init__(
            QUADRILATERAL, name, nodes, x, thickness, density, law, constants, moduli, nip, shrf, isdo,
            hourglass_moduli=lambda: hourglass_moduli(x[nodes], thickness, density, moduli, shrf, control).T,
            viscous=control.viscous, forces=5, **options,
        )  # fmt: skip

    @property
    def hourglass(self) -> Array:
        """Hourglass forces x, y, z and moments x, y (ne, 5) in the elements' frames."""
        return by_element(self._hourglass, self.elements)
