"""uvicorn's server, which ends in order: it drains before it stops listening.

The first SIGTERM, SIGHUP, Ctrl-C or notice of a batch system begins: nothing new is
taken in, and the turns in progress are finished and answered, for a bounded time in
which the server still listens and `/readyz` says that it ends. A second signal ends at
once. Other modules decide which requests are refused meanwhile.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import math
import socket
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import dataclass
from types import FrameType

import uvicorn

from reference_record.command_line.closed_output import (
    ended_by,
    ending_signals_taken,
)

log = logging.getLogger("proctor.app")

LOOK_INTERVAL_S = 0.02
# uvicorn makes the header Date of its answers so often.
DATE_INTERVAL_S = 1.0
# Time to send the answers that are ready when the time of the turns is over.
SEND_S = 1.0


@dataclass(frozen=True, slots=True)
class Drain:
    """How a server ends.

    begin: refuses what is new from then on. turns_in_progress: how many are left.
    notice_s: how long the server listens in any case. limit_s: how long, after that, it
    waits for turns and answers.
    """

    begin: Callable[[], Awaitable[None]]
    turns_in_progress: Callable[[], int]
    notice_s: float
    limit_s: float


def _names_a_task(record: logging.LogRecord) -> bool:
    """Not the error of uvicorn that it has cancelled 0 tasks, after a second signal."""
    return not (str(record.msg).startswith("Cancel ") and record.args == (0,))


class DrainingServer(uvicorn.Server):
    """startup_message: is printed when the server accepts requests."""

    def __init__(
        self, config: uvicorn.Config, startup_message: str, drain: Drain
    ) -> None:
        super().__init__(config)
        self._startup_message = startup_message
        self._drain = drain
        logging.getLogger("uvicorn.error").addFilter(_names_a_task)

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            print(self._startup_message, flush=True)  # noqa: T201 - for its user

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Also those of a terminal that is closed and of a batch system."""
        with super().capture_signals(), ending_signals_taken(self.handle_exit):
            yield

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        if self.should_exit:
            self.force_exit = True
        super().handle_exit(ended_by(sig), frame)

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        left_s = await self._finish_turns()
        # Whole seconds; 0 ends what is left at once.
        self.config.timeout_graceful_shutdown = math.ceil(left_s)
        await super().shutdown(sockets)

    async def _finish_turns(self) -> float:
        """Returns when no turn is in progress, or the time is over; what is left."""
        now = asyncio.get_running_loop().time
        drain = self._drain
        await drain.begin()
        begun = drain.turns_in_progress()
        log.info("shutting down with %d turns in progress", begun)
        listens_until = now() + drain.notice_s
        ends_at = listens_until + drain.limit_s
        dated_at = now()
        while not self.force_exit and (
            now() < listens_until or (drain.turns_in_progress() and now() < ends_at)
        ):
            await asyncio.sleep(LOOK_INTERVAL_S)  # a signal sets no event
            if now() >= dated_at + DATE_INTERVAL_S:
                dated_at = now()
                await self.on_tick(0)
        return 0.0 if self.force_exit else max(SEND_S, ends_at - now())
