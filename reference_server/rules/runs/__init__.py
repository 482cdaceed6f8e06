"""Decisions about one run: its state, its commands, what they change, its events."""
