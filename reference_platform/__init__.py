"""A challenge that people can enter: accounts, keys, tracks and hosted submissions.

A program beside the reference server. It uses the server's public API, and gives it the
accounts and keys over one interface; the server knows nothing of this package.
"""
