"""The time loop: central differences in leapfrog form (Belytschko, Liu & Moran, Nonlinear Finite Elements, box 6.1)."""

import math
from collections.abc import Callable, Iterator

from vmharness.explicit.error import SolverError
from vmharness.explicit.kernels import integrate
from vmharness.explicit.model.model import Model
from vmharness.explicit.state import State
from vmharness.explicit.threads import ThreadPool
from vmharness.explicit.timestep.stable_step import StableStep
from vmharness.explicit.watch import Watch

MOST_CYCLES = 1e11  # a step with which the run would take more cycles counts as vanished


def steps(model: Model, watch: Watch | None = None) -> Iterator[State]:
    """Yield the state at t_0, t_1, ... until the end time is reached.

        a_n       = M^-1 f(t_n, x_n, v_{n-1/2})
        v_{n+1/2} = v_{n-1/2} + 1/2 (dt_{n-1} + dt_n) a_n        v_{1/2} = v_0 + 1/2 dt_0 a_0
        x_{n+1}   = x_n + dt_n v_{n+1/2}

    The state is one object, updated in place. Its `x`, `a` and forces are at t_n, its `v` is v_{n-1/2};
    `energy.kinetic` and the probes bring the velocity to t_n. Raises SolverError where the step vanishes, the motion is
    no longer finite, or the energy balance is lost. `watch` knows at the end which energies cannot be.
    """
    s, shortest = model.state, 0.0
    stable = StableStep(model)
    watch = watch or Watch(model)
    threads = ThreadPool(model.forces, s, model.ncpu)
    accelerate = threads.over_nodes(integrate.accelerate)
    advance_velocity = threads.over_nodes(integrate.advance_velocity)
    advance_position = threads.over_nodes(integrate.advance_position)
    while True:
        integrate.clear(s.f, s.moment)
        threads.add_forces()

        size = accelerate(s.a, s.alpha, s.f, s.moment, model.inverse_mass, model.inverse_inertia)
        if not math.isfinite(size):
            what = "the motion is no longer finite: the run has diverged"
            raise SolverError(s, what, f"{model.largest_acceleration()}; {watch.blame() or stable.blame()}")
        for constraint in model.constraints:
            constraint.accelerate(s)

        yield s
        ended = s.t >= model.end_time or s.cycle >= model.end_cycle
        if excess := watch.look(ended):
            raise SolverError(s, excess, f"{model.largest_acceleration()}; {watch.blame() or stable.blame()}")
        if ended:
            return

        dt = stable.limited(model.next_step())
        check_step(model, dt, shortest, stable.blame)
        watch.contacts.look(dt, stable.bound)
        shortest = shortest or model.dtmin * dt
        advance_velocity(s.v, s.omega, s.a, s.alpha, 0.5 * (s.dt + dt))
        for constraint in model.constraints:
            constraint.move(s, dt)

        advance_position(s.x, s.v, dt)
        s.t, s.dt, s.cycle = s.t + dt, dt, s.cycle + 1


def check_step(model: Model, dt: float, shortest: float, blame: Callable[[], str]) -> None:
    """Raise SolverError if nothing sets the step `dt`, if it is not above `shortest`, or does not change the time."""
    s = model.state
    if math.isinf(dt):
        raise SolverError(s, "no element limits the time step: nothing sets it; *CONTROL_TIMESTEP LCTM can")
    if not dt > shortest or dt * MOST_CYCLES < model.end_time - s.t:
        where = f"{model.controlling()}; {blame()}" if s.cycle else model.controlling()
        raise SolverError(s, f"the time step has vanished: {dt:.3g} after {s.dt:.3g}", where)
    if s.t + dt == s.t:
        raise SolverError(s, f"the step {dt:.3g} is below the round-off of the time, which no longer grows")
