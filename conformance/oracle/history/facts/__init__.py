"""The facts that exchanges showed: runs, episodes, sessions, in intervals of time."""
