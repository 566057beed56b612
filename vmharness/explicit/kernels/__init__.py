"""Compilation of kernels and its cache, vectors, rotations, elements side by side, updates of the time loop."""
