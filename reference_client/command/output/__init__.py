"""What the command prints: messages, progress, tables, JSON."""
