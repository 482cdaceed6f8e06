"""Mutants of runs: their states, episodes, scores and lists."""
