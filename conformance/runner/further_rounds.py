"""Plays generated histories again and again, always others, while a run has time.

A whole run on a fast server is over long before the time that it is promised to take.
Each process of the kit has rounds of its own: number n of count plays n, n + count, …
"""

import itertools
import time
from collections.abc import Generator

import pytest

from conformance.run_settings import Settings
from conformance.runner.pytest_plugin import (
    is_crash,
    play_round,
    seconds_of_round,
)

# A first round of a check that has taken an unknown time begins so long before the end.
_UNKNOWN_S = 15.0


class FurtherRounds:
    """A pytest plugin that plays on after the checks, where one process runs them."""

    def __init__(self, settings: Settings) -> None:
        self._until = settings.rounds_until if settings.has_room_for_rounds else 0.0
        # A command of the operator kills the server under test itself: once is enough.
        self._may_kill = settings.restart_cmd is None

    @pytest.hookimpl(wrapper=True)
    def pytest_runtestloop(
        self, session: pytest.Session
    ) -> Generator[None, object, object]:
        """Play after the last check."""
        result = yield
        if not session.config.option.collectonly:
            self.play(session, 1, 1)
        return result

    def play(self, session: pytest.Session, number: int, count: int) -> None:
        """Play the rounds of one process; one that is not passed ends its check's."""
        spent_s = {
            item: 0.0
            for item in session.items
            if item.get_closest_marker("histories")
            and (self._may_kill or not is_crash(item))
        }
        rounds = {item: itertools.count(number, count) for item in spent_s}
        while not session.shouldstop:
            left_s = self._until - time.monotonic()
            fitting = [i for i in spent_s if seconds_of_round(i, _UNKNOWN_S) < left_s]
            if not fitting:
                return
            item = min(fitting, key=spent_s.__getitem__)
            if play_round(item, next(rounds[item])):
                spent_s[item] += seconds_of_round(item, _UNKNOWN_S)
            else:
                del spent_s[item]
