"""Runs in the database: their rows, and the statements that read and write them."""
