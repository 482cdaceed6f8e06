"""The error of a command line, apart from all that takes long to import.

Completion reads the command line at each Tab, and needs nothing else.
"""

from reference_record.command_line.click_commands import WrongUsage


class UsageError(WrongUsage):
    """A command cannot do what was asked; the message says what to use instead."""
