"""Requests to whichever server lives: lost, repeated, late, and cut by its end."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Awaitable, Callable
from typing import Any, Protocol

from reference_server.rules.refusal import Refused
from reference_server.runs.service import RunService
from reference_server.storage.runs.run_store import StoreFailed
from tests.simulation.world import Life, World

Request = Callable[[RunService], Awaitable[Any]]
DELAY_S = 0.02
# After so long a client gives up an answer; the server may still be at work.
TIMEOUT_S = 3.0
# A copy of a request arrives beside it, or long after its answer was read.
LATE_S = (DELAY_S, 2.0)


class NoAnswer(Exception):
    """The request may have been carried out, or not."""


class Server(Protocol):
    """What a network leads to. service: None while no server listens."""

    @property
    def service(self) -> RunService | None: ...

    @property
    def life(self) -> Life: ...


class Network:
    """unexpected: exceptions that no request may end with."""

    def __init__(self, world: World, server: Server) -> None:
        self._world, self._server = world, server
        self.unexpected: list[str] = []

    async def call(self, request: Request) -> Any:
        """The answer. Raises Refused, and NoAnswer."""
        world, chances = self._world, self._world.chances
        if world.happens(chances.request_repeated):
            copy = asyncio.ensure_future(self._arrive_late(request))
            self._server.life.tasks.add(copy)
        await world.delay(DELAY_S)
        if world.happens(chances.request_lost):
            await world.delay(TIMEOUT_S)
            raise NoAnswer
        answer = await self._arrive(request)
        await world.delay(DELAY_S)
        if world.happens(chances.answer_lost):
            raise NoAnswer
        return answer

    async def _arrive_late(self, request: Request) -> None:
        await self._world.delay(self._world.chance.choice(LATE_S))
        with contextlib.suppress(Refused, NoAnswer):
            await self._arrive(request)

    async def _arrive(self, request: Request) -> Any:
        service, life = self._server.service, self._server.life
        if service is None:
            raise NoAnswer
        handling = asyncio.ensure_future(self._handle(service, request))
        ended = asyncio.ensure_future(life.ended.wait())
        waiting = {handling, ended}
        life.tasks |= waiting
        await asyncio.wait(
            waiting, timeout=TIMEOUT_S, return_when=asyncio.FIRST_COMPLETED
        )
        ended.cancel()
        if life.is_over or not handling.done():
            raise NoAnswer
        answer = handling.result()
        if isinstance(answer, Exception):
            raise answer
        return answer

    async def _handle(self, service: RunService, request: Request) -> Any:
        """The answer or what was raised: perhaps it is never read."""
        try:
            return await request(service)
        except Refused as refused:
            if refused.code == "internal_error":
                self.unexpected.append(refused.detail)
            return refused
        except StoreFailed as error:  # as `http/dispatch.py` answers it
            return Refused("unavailable", str(error))
        except Exception as error:  # noqa: BLE001 - each is a finding
            self.unexpected.append(repr(error))
            return NoAnswer()
