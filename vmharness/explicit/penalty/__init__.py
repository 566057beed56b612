"""Penalty contact: nodes kept from passing through segments, the mechanics that all contact keywords share."""
