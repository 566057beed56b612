"""Faults of the deck and of the solver, planted one at a time, and the results that catch them."""
