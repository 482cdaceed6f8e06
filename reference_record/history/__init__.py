"""The history of a leaderboard: its tree, its checkpoint, the seeds drawn from it."""
