"""EBench's API as a profile."""
