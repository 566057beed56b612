"""*CONTROL: what holds for the whole run."""
