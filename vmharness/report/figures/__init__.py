"""The figures of a case's page."""
