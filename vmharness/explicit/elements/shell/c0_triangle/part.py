"""C0 triangles of one part, as a force."""

from typing import Any

from vmharness.explicit.elements.shell._kind import Kind
from vmharness.explicit.elements.shell._shells import Shells
from vmharness.explicit.elements.shell.c0_triangle.lanes import triangle
from vmharness.explicit.elements.shell.c0_triangle.length import HEIGHTS
from vmharness.explicit.elements.shell.c0_triangle.mass import area, nodal_mass
from vmharness.explicit.elements.shell.c0_triangle.step import force_triangles, no_hourglass, strain_triangles

TRIANGLE = Kind(area, nodal_mass, triangle, HEIGHTS, strain_triangles, no_hourglass, force_triangles)


class C0Triangle(Shells):
    """Shells (ne, 3) as in shell/part.py."""

    def __init__(self, *given: Any, **options: Any) -> None:
        super().__init__(TRIANGLE, *given, **options)
