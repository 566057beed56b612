"""*DAMPING_PART_STIFFNESS: damping in proportion to stiffness.

To the stress s of the law comes beta times its rate in the element's own frame, so that rigid motions are not damped:

    tau_n = s_n + beta (s_n - s_{n-1}) / dt        zeta = beta omega / 2 for a mode of frequency omega

Beams of resultants have the rate of these. Forces are those of tau, which is also the stress that is shown; its work is
internal energy, stored and damped (as that of bulk viscosity is): with the damping the internal energy does not return
to zero. What the law does not bear is not damped: hourglass and viscous forces. Where the law flows, only the part of
the strain that changes its stress is damped.

    COEF < 0   beta = -COEF, a time
    COEF > 0   beta = COEF 2/omega_max, with 2/omega_max the element's stable step in the beginning: COEF is the
               fraction of critical damping of the element's highest mode. LS-DYNA does not publish its formula for
               this, so that this is our definition; 0.01 to 0.25 is what it recommends.

The rate is half a step old, so that the motion is accurate to the first order in dt, and the stable step h of the
undamped element becomes shorter (M - dt/2 C - dt^2/4 K must be positive definite):

    dt <= h (sqrt(1 + zeta^2) - zeta),   zeta = beta/h

    law.py     laws with damping around those without
    build.py   from the deck

Source: LS-DYNA keyword manual, the card; R. W. Clough, J. Penzien, Dynamics of Structures, Rayleigh damping.
"""

from vmharness.deck.keywords.damping import DAMPING_PART_STIFFNESS
from vmharness.explicit.damping.stiffness.build import build

__all__ = ["DAMPING_PART_STIFFNESS", "build"]
