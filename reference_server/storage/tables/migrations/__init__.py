"""Upgrades of databases that older versions of the server have made."""
