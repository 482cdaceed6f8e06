"""Runs in memory and the use cases on them."""
