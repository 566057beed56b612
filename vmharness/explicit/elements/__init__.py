"""Elements, one formulation a file or folder. Contract of a module: `NAME`, `build(deck, model)`, which adds them."""
