"""Surfaces touch at the sum of both thicknesses, not at half of it."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.projection"
SOUND = "0.5 * (node["
FAULTY = "1.0 * (node["
KEYWORDS = ("CONTACT_",)
