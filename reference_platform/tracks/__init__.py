"""Tracks: what a challenge evaluates, when, for whom, and how often."""
