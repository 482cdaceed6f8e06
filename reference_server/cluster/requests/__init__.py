"""Requests that nodes send each other for themselves, and not for a client."""
