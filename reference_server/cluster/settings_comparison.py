"""Settings that should be equal on all nodes: each shows its own, and logs differences.

So it does with its clock, which should be that of the database.

They do no lasting harm where they differ, as while they are changed at one node after
another. Those that do are compared by `records/shared_folder.py`.
"""

from __future__ import annotations

import json
import logging
import time
from collections.abc import Callable, Iterable, Mapping

from reference_server.storage.node_store import ListedNode

log = logging.getLogger("proctor.cluster")

# A file that all nodes read is read by one of them first.
SETTLED_S = 5.0
# The tokens, as a digest: the value is not shown.
TOKENS = "tokens, or those of tokens_file"
_VALUE_CHARS_MAX = 80
# Times that people compare, in records and in the history, are wrong by more than this.
CLOCK_DIFFERENCE_S = 5.0


class SettingsComparison:
    """read: the values of this node now, by name; tokens as a digest."""

    def __init__(
        self,
        read: Callable[[], Mapping[str, str]],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._read, self._clock = read, clock
        # URL of a node → how it differs, and since when; never once that was logged.
        self._seen: dict[str, tuple[str, float]] = {}
        self._is_clock_wrong = False

    def text(self) -> str:
        """The values of this node, as the other nodes read them."""
        return json.dumps(self._read())

    def compare(self, others: Iterable[ListedNode]) -> None:
        """Log how each node differs, once it does for some time."""
        mine, now = self._read(), self._clock()
        for other in others:
            url, difference = other.node.url, _describe(mine, other.settings)
            before, since = self._seen.get(url, ("", now))
            if difference != before:
                self._seen[url] = difference, now
            elif difference and now > since + SETTLED_S:
                self._seen[url] = difference, float("inf")
                log.warning(
                    "settings differ from those of the node at %s, and a request may "
                    "reach either: %s; set them equal on all nodes",
                    url,
                    difference,
                )

    def compare_clock(self, asked_at: float, read_at: float, now: float) -> None:
        """Log once that the clock of this node is wrong, until it was right again.

        read_at: of the database, between the other two, which are of this node.
        """
        ahead_s = max(0.0, asked_at - read_at) - max(0.0, read_at - now)
        is_wrong = abs(ahead_s) > CLOCK_DIFFERENCE_S
        if is_wrong and not self._is_clock_wrong:
            log.warning(
                "the clock of this node is %.0f s %s that of the database, and signed "
                "records have its times: synchronize the clocks of all machines",
                abs(ahead_s),
                "ahead of" if ahead_s > 0 else "behind",
            )
        self._is_clock_wrong = is_wrong


def _describe(mine: Mapping[str, str], text: str) -> str:
    theirs = json.loads(text) if text else mine
    return "; ".join(
        name
        if name == TOKENS
        else f"{name} is {_shown(value)} here, {_shown(theirs.get(name))} there"
        for name, value in mine.items()
        if value != theirs.get(name)
    )


def _shown(value: str | None) -> str:
    text = repr(value)
    return text if len(text) <= _VALUE_CHARS_MAX else f"{text[:_VALUE_CHARS_MAX]}…"
