"""Contact damping pulls where it exceeds the penalty."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.force"
SOUND = "pressing = max(0.0, pressing - coefficient"
FAULTY = "pressing = (pressing - coefficient"
KEYWORDS = ("CONTACT_",)
