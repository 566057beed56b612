"""What kernels are made of: compilation and its cache, threads, vectors, rotations, elements side by side."""
