"""HTTP of the platform, on one Unix socket: its API, and what the server asks."""
