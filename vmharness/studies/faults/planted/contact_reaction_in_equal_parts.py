"""A segment takes the reaction in equal parts, wherever it is touched."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.force"
SOUND = "f[nodes[i], j] -= weights[i] * force[j]"
FAULTY = "f[nodes[i], j] -= 0.25 * force[j]"
KEYWORDS = ("CONTACT_",)
