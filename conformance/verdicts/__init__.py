"""From what was observed to a verdict. Sends nothing."""
