"""Answers to the operator's tools: whether the server lives and is ready, metrics."""
