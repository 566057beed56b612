"""What shows that a pass means something, and where a difference comes from."""
