"""*INITIAL: initial conditions."""
