"""The protocol as a client speaks it: sessions, turns, retries, connections."""
