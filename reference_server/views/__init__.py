"""What the API shows, as plain data in the spec's schemas: no HTTP, no state."""
