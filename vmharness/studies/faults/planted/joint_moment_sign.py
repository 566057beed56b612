"""The forces of joints turn their bodies the wrong way."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.couple"
SOUND = "turned[b, k] += amount * turning[r, side, k]"
FAULTY = "turned[b, k] -= amount * turning[r, side, k]"
KEYWORDS = ("CONSTRAINED_JOINT_",)
