"""The error of a command line, apart from all that takes long to import.

Completion reads the command line at each Tab, and needs nothing else.
"""


class UsageError(Exception):
    """The command line is invalid; the message says why and what to use instead."""
