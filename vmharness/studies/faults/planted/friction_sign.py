"""Friction pushes along the sliding, not against it."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.friction"
SOUND = "return scale(-k, slip)"
FAULTY = "return scale(k, slip)"
KEYWORDS = ("CONTACT_",)
