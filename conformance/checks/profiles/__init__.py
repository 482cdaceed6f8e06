"""Checks of profiles: what a server announces beyond the core."""
