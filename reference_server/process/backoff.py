"""Pauses between attempts of this server, the one policy for all that it tries again.

Each pause is twice the last one, up to a maximum, and varied at random by a fifth, so
that many that failed together do not return together. Three series exist, because
three parties are waited for: a policy server that does not answer (`between_calls`:
slow, it may be restarting, and another operator pays for its load); this server's own
free simulators, or the next session after a fault (`between_sessions`: fast, it is
local); and its database (`of_database`: never long, as runs and the lock of the server
wait for it).

A request that a client repeats is the client's: its policy is
reference_client/protocol/retry_policy.py.
"""

from __future__ import annotations

import random

CALL_PAUSE_MAX_S = 30.0
_CALL_PAUSE_S = 0.5
_SESSION_PAUSE_S = 0.2
_SESSION_PAUSE_MAX_S = 5.0
_DATABASE_PAUSE_S = 0.5
_DATABASE_PAUSE_MAX_S = 1.0


class Backoff:
    """One series of pauses, in seconds."""

    def __init__(self, first_s: float, max_s: float) -> None:
        self._first_s = self._next_s = first_s
        self._max_s = max_s

    @classmethod
    def between_calls(cls) -> Backoff:
        """The pauses between repeated calls of a policy server."""
        return cls(_CALL_PAUSE_S, CALL_PAUSE_MAX_S)

    @classmethod
    def between_sessions(cls) -> Backoff:
        """The pauses of a worker after a refused session or a fault of the policy."""
        return cls(_SESSION_PAUSE_S, _SESSION_PAUSE_MAX_S)

    @classmethod
    def of_database(cls) -> Backoff:
        """The pauses of work that no request waits for, while the database is away."""
        return cls(_DATABASE_PAUSE_S, _DATABASE_PAUSE_MAX_S)

    def next_s(self) -> float:
        """The next pause."""
        pause_s = self._next_s * random.uniform(0.8, 1.2)
        self._next_s = min(2 * self._next_s, self._max_s)
        return pause_s

    def reset(self) -> None:
        """Start the series again, after a success."""
        self._next_s = self._first_s
