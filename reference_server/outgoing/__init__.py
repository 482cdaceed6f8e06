"""Connections of the server to other programs, and what is sent over them."""
