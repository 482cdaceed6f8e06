"""Reports of the server on itself: counters, spans, and lines of its log."""
