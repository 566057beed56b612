"""A deck as arrays: nodes, state, parts, sets, curves, degrees of freedom."""
