"""Export formats: each module of this folder renders the results of a run as one text."""
