"""What the server needs of the operating system: files, their limits and its log."""
