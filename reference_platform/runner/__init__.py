"""Plays submissions: a sandbox with the policy, and a push run of the server on it."""
