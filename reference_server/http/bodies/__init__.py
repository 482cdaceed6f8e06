"""Bodies of requests: read within a size, and parsed in steps that block no other request."""
