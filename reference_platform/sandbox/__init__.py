"""Plays a policy that is not trusted: its only opening is one Unix socket."""
