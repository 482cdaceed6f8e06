"""The sessions of workers: their commands, their simulators, their work."""
