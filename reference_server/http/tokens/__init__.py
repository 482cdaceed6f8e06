"""Tokens that are made, kept in files, and managed from the command line."""
