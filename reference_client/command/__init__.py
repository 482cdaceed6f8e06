"""The command `proctor`, built on the rest of this client.

It starts the server and the kit as programs of their own and imports neither.
"""
