"""Initial conditions: velocities at t = 0."""
