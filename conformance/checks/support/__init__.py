"""Shared by several checks: given states, samples, generated requests."""
