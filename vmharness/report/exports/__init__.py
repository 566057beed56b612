"""Export formats: each module of this folder renders all runs as one text."""
