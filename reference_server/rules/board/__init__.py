"""What is decided of the leaderboard: its entries, and their ranking. Pure."""
