"""Views of the API, as plain data in the spec's schemas: no HTTP, no state."""
