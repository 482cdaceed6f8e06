"""How many files, sockets included, this process may have open, and who may use them.

Connections take at most what is left after simulators and the database: a full server
refuses a client, and never fails to start a simulator.
"""

from __future__ import annotations

import contextlib
import sys

# More is never needed here, and some systems have no limit at all.
OPEN_FILES_MAX = 2**16
# The database, listeners, calls to policy servers, logs, and connections that close.
RESERVED = 192
# Files of a simulator: its socket and the memory of its images, in this and old
# episodes.
FILES_PER_SIMULATOR = 4
CONNECTIONS_MIN = 16


def raise_limit() -> int:
    """Raise the soft limit of open files as far as allowed; returns what it is then."""
    if sys.platform == "win32":
        return OPEN_FILES_MAX
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    if soft == resource.RLIM_INFINITY:
        return OPEN_FILES_MAX
    wanted = OPEN_FILES_MAX
    if hard != resource.RLIM_INFINITY:
        wanted = min(hard, OPEN_FILES_MAX)
    if wanted > soft:
        with contextlib.suppress(OSError, ValueError):  # some systems allow less
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))
    return resource.getrlimit(resource.RLIMIT_NOFILE)[0]


def connections_allowed(open_files: int, simulators: int) -> int:
    """How many connections leave enough open files for everything else."""
    left = open_files - RESERVED - FILES_PER_SIMULATOR * simulators
    return max(left, CONNECTIONS_MIN)
