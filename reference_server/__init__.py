"""The reference evaluation server: it obeys `spec/` and has no rule of its own."""
