"""Kinds of contact, one a file. Contract of a module: `NAME`, and `build(deck, model)`, which adds its contacts."""
