"""Clients of the APIs of other systems, for the checks of their profiles."""
