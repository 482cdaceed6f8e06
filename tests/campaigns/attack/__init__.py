"""Attacks on one server from outside. Each is a small module in attacks/."""
