"""Checks of entries, rankings and the history of a leaderboard."""
