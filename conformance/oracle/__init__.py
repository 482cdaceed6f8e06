"""The expected answers, computed independently of the server. Sends nothing."""
