"""The time step beyond the elements' own: its limits, mass scaling, the step that contacts need."""
