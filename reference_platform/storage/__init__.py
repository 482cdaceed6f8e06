"""The SQLite file that has everything of the platform, and its tables."""
