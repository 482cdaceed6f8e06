"""How a program reaches a server: proxies, certificates, addresses, tokens.

Written by hand, for the clients. `make generate` copies this folder to the kit, which
imports no client. Nothing here sends a request or knows the protocol.
"""
