"""Recordings of episodes: their messages, parts and files, and how they are read."""
