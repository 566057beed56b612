"""Compilation of kernels and its cache, threads, vectors, rotations, elements side by side."""
