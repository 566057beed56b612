"""*CONSTRAINED: rigid bodies, joints."""
