"""Examples and requests that libraries generate."""
