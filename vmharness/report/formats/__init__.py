"""Formats of the manual: each module of this folder renders the page of a case and the index."""
