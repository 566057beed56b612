"""Friction sticks however large it is."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.friction"
SOUND = "if k * length <= most:"
FAULTY = "if length >= 0.0:"
KEYWORDS = ("CONTACT_",)
