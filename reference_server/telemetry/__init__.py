"""Counters, spans and log lines, by which the server is observed."""
