"""What nodes ask each other for themselves, and not for a client."""
