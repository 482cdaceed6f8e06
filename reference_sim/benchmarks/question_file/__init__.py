"""Questions in words from a file of JSON lines, each answered by one action."""
