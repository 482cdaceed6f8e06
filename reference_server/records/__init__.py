"""Recordings of episodes on disk, and the signed records of runs."""
