"""Clients that use a server meanwhile, and what they know of its runs."""
