"""FlagEval's API as a profile."""
