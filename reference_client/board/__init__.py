"""The leaderboard of a server: entries, rankings, and whether its history is whole."""
