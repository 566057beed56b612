"""The penalty stiffness of a solid's face is K A / V, not K A^2 / V."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.surface.facets"
SOUND = "bulk_modulus(part) * area(model.x0[nodes]) / depth"
FAULTY = "bulk_modulus(part) / depth"
KEYWORDS = ("CONTACT_",)
