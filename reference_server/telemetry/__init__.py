"""What the server says of itself: counters, spans, and lines of its log."""
