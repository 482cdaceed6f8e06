"""The command `proctor`: what a policy author types, built on the rest of this client.

It starts the server and the kit as programs of their own and imports neither.
"""
