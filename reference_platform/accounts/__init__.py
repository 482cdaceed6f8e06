"""Accounts of people: sign-up, review, passwords, sessions, keys, devices."""
