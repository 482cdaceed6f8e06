"""What the operator's tools ask: whether the server lives and is ready, and metrics."""
