"""Checks of sessions and turns: attach, lease, predict, faults."""
