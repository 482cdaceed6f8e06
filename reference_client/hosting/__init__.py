"""Hosted submissions: handed in, and followed to their results."""
