"""The client side of the protocol: connections, retries, runs, sessions, turns."""
