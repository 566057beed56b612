"""Faults of the deck and of the solver, planted one at a time, and which results notice them."""
