"""Bodies of requests: read within a size, parsed without blocking other requests."""
