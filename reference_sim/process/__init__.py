"""Simulator processes: the pool, the fork server, the program, image encoding."""
