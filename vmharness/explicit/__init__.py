"""The built-in solver: keywords -> model -> time loop -> states."""
