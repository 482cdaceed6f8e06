"""Answers for the operator's tools: whether the server lives, is ready; metrics."""
