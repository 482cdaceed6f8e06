"""Runs the checks under pytest, and the servers that they may kill."""
