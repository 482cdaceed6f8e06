"""The contents of a record: its statement, manifest, episodes, score and verdicts."""
