"""The time step beyond the elements' own: its limits, and mass scaling."""
