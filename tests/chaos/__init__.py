"""Faults of a cluster while it is used: `python -m tests.chaos`."""
