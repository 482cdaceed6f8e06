"""Connections to a server: kept ones, those through proxies, and bare sockets."""
