"""Decisions about the leaderboard: its entries, and their ranking. Pure."""
