"""Studies: many variants of a case, run to show that a pass means something."""
