"""Checks of the service: discovery, accounts, errors, encodings."""
