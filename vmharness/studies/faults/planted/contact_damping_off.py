"""Contacts have no damping."""

KIND = "physics"
MODULE = "vmharness.explicit.contact.damping"
SOUND = "return float(0.02 * vdc * min(m_s, m_m)"
FAULTY = "return float(0.0 * vdc * min(m_s, m_m)"
KEYWORDS = ("CONTACT_",)
