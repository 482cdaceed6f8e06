"""Decisions on the leaderboard: its entries, and their ranking. Pure."""
