"""The answers that the rules allow, given the facts: one subject per file."""
