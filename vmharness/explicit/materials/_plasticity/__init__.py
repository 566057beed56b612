"""Metal plasticity: von Mises yield, associated flow, isotropic and linear kinematic hardening, scaled by the rate.

With the deviator s, the back stress alpha (a deviator), xi = s - alpha and p the effective plastic strain

    yield         q = sqrt(3/2 xi : xi) <= r Y(p)
    flow          d(eps_p) = 3/2 dp xi / q,   dp >= 0
    back stress   d(alpha) = 2/3 C d(eps_p)
    rate          r = r(strain rate), 1 where the material does not depend on the rate

Y(p) is piecewise linear (piecewise_linear.py), r follows Cowper and Symonds or a curve (rate.py). A step is the
backward Euler rule: the flow direction is that of the end of the step, and the yield condition holds there.

    constants.py         E, nu, C, Y and r of the three kernels, by name
    solid.py             radial return: Krieg, Key 1976; J. C. Simo, T. J. R. Hughes, Computational Inelasticity (1998)
    plane_stress.py      the same with s_zz = 0: J. C. Simo, R. L. Taylor, Int. J. Numer. Meth. Engng 22 (1986) 649-670
    uniaxial.py          the same with one stress
    consistency.py       the yield condition of the radial and of the uniaxial return
    viscous.py           the yield condition where the yield stress depends on the plastic strain rate
    piecewise_linear.py  Y(p)
    rate.py              r
    long_curves.py       a step of many elements, each with its part of a long Y(p)

History: p, then the components of alpha if there is a C. No branch depends on the state of the point: Newton's rule
takes a fixed number of steps, and stays at dp = 0 where the trial stress is elastic. Strain and stress are components
in a frame that rotates with the element, so that alpha needs no rotation.
"""
