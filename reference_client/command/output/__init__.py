"""The output of the command: messages, progress, tables, JSON."""
