"""Mutants of tokens, limits, encodings, and what carries requests and answers."""
