"""Sandboxes on the machines of a Ray cluster: the same sandbox, elsewhere."""
