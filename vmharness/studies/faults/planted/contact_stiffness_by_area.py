"""The penalty stiffness of a shell in contact is K A, not K A / d."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.surface.facets"
SOUND = "bulk_modulus(part) * area(x) / diagonals(x).max(axis=1)"
FAULTY = "bulk_modulus(part) * area(x)"
KEYWORDS = ("CONTACT_",)
