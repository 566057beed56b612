"""Solids have no linear bulk viscosity."""

KIND = "physics"
MODULE = "vmharness.explicit.elements.solid._viscosity"
SOUND = "q1 * rho * length * D * D - q2 * (modulus * rho) ** 0.5 * D"
FAULTY = "q1 * rho * length * D * D"
KEYWORDS = ("ELEMENT_SOLID",)
