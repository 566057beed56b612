"""Contact damping, VDC in percent of critical.

    c = VDC/100 * 2 m w      w = sqrt(k (m_s + m_m)/(m_s m_m))      m = min(m_s, m_m)

m_s is the node's mass, m_m that of the segment where it is touched, sum N_i m_i; nodes of rigid bodies have shares of
the body's mass (rigid/bearing.py). A segment without mass is held, as is one that is much heavier: then
c = VDC/100 * 2 sqrt(k m_s), the critical damping of the node on its spring. It acts on the velocity of the gap at t_n,
v_{n-1/2} + dt/2 a_{n-1}, which keeps the order of the time integration.

Spring and damper together do not pull: a node is released at zero force, not at zero penetration, so that a fraction z
of critical damping gives back a little more than exp(-pi z / sqrt(1 - z^2)) of the velocity.
"""

import numpy as np

from vmharness.explicit.kernels.vector import inlined


@inlined
def coefficient(vdc: float, k: float, m_s: float, m_m: float) -> float:
    """c of a touch with stiffness k; zero for a node and a segment without mass."""
    if m_s <= 0.0 or m_m <= 0.0:
        return float(0.02 * vdc * np.sqrt(k * max(m_s, m_m)))
    return float(0.02 * vdc * min(m_s, m_m) * np.sqrt(k * (1.0 / m_s + 1.0 / m_m)))
