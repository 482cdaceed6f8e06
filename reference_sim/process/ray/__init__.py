"""Simulators on a Ray cluster: one actor each, used as if it were a local process."""
