"""What the registry keeps in memory beside the runs: it awaits and stores nothing."""
