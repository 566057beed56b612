"""*LOAD: loads over time."""
