"""Studies: many runs of variants of a case, which test the case and its tolerances."""
