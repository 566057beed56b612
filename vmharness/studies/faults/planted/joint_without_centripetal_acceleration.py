"""Joints leave out the centripetal acceleration of the joined points."""

KIND = "physics"
MODULE = "vmharness.explicit.rigid.couple"
SOUND = "add(cross(row(alpha, c), arm), cross(w, cross(w, arm)))"
FAULTY = "cross(row(alpha, c), arm)"
KEYWORDS = ("CONSTRAINED_JOINT_",)
