"""Connections of clients: how many there are, and what each may take."""
