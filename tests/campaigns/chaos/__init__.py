"""Faults of a cluster while it is used; each happens, is there, and is repaired."""
