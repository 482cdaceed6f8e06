"""Bodies of requests that are wrong, or right in an unusual way."""
