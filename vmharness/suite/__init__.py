"""Runs of many cases: selection, worker processes, outcomes and exit codes."""
