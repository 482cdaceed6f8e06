"""Accounts that another program of this machine keeps: their keys, runs and pages.

The program listens on a Unix socket that the setting `account_service` names. Without
it, a server knows the tokens of its settings and of its file alone.
"""
