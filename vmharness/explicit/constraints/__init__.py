"""Constraints on nodes and on centres of rigid bodies: supports and prescribed motions."""
