"""Operation of a host: what waits and is stuck, what is used, retention, backup."""
