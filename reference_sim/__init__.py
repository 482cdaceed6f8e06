"""Simulators behind the protocol. Nothing here knows of servers, runs or sessions."""
