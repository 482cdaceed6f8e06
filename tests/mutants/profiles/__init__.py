"""Mutants of what a server may offer besides: a file for each profile."""
