"""Friction has its static coefficient at any speed."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.friction"
SOUND = "mu = fd + (fs - fd) * np.exp(-dc * speed) if fs != fd else fs"
FAULTY = "mu = fs"
KEYWORDS = ("CONTACT_",)
