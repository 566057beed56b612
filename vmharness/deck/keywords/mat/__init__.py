"""*MAT: materials."""
