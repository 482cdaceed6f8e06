"""Mail: stored with what it is about, and sent afterwards."""
