"""The work that sessions do: one thing at a time each, whatever becomes of its caller.

While a simulator executes nothing is locked (PRED-022, FAULT-004). A request that
repeats what is executed waits for its end. Work that fails by no fault of the policy
ends its session. This module knows nothing of turns and episodes.
"""

from __future__ import annotations

import asyncio
import logging
import time
from collections.abc import Awaitable, Coroutine
from typing import Any, TypeVar

from reference_server.cells.robot_attempts import RobotAttempts
from reference_server.process.background_work import shielded
from reference_server.process.inline_work import InlineWork
from reference_server.rules.refusal import Refused
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run, Session
from reference_server.runs.registry import RunRegistry
from reference_server.runs.sessions.session_resources import (
    ResourceManager,
    SessionResources,
)
from reference_sim.process.pool import AttemptDiverged, NoCapacity, NoRoomToRecord

log = logging.getLogger("proctor.sessions")
Result = TypeVar("Result")


class SessionWork:
    """The work of every session of this process."""

    def __init__(
        self, registry: RunRegistry, resources: ResourceManager, robots: RobotAttempts
    ) -> None:
        self._registry, self._resources, self._robots = registry, resources, robots

    async def execute(
        self, resources: SessionResources, work: Coroutine[Any, Any, Result]
    ) -> Result:
        """Do the work of a session; it goes on if the caller is cancelled."""
        if self._robots.plays(resources.run):
            task = self.start(resources, work)
            await self._robots.await_turn(resources)
            return await shielded(task)
        ended: asyncio.Future[None] = resources.loop.create_future()
        resources.task = ended
        guarded = self._run_guarded(resources, work, ended)
        return await InlineWork(guarded, resources.loop)

    def start(
        self, resources: SessionResources, work: Coroutine[Any, Any, Result]
    ) -> asyncio.Task[Result]:
        """Begin work for which no request waits."""
        task = asyncio.create_task(self._run_guarded(resources, work))
        resources.task = task
        # Its exception is retrieved also when its caller has disconnected.
        task.add_done_callback(lambda task: task.cancelled() or task.exception())
        return task

    async def wait_for_end(self, run: Run, session: Session) -> Run:
        """Return the run after the work; the caller decides again then."""
        resources = self._resources.find(session)
        if resources is not None and resources.task is not None:
            await self._robots.await_turn(resources)
        else:
            await asyncio.sleep(0)
        return await self._registry.get(run.run_id)

    async def _run_guarded(
        self,
        resources: SessionResources,
        work: Awaitable[Result],
        ended: asyncio.Future[None] | None = None,
    ) -> Result:
        """Let no session stay busy for ever, whatever fails.

        ended: wakes the requests that wait for the work.
        """
        try:
            return await work
        except NoCapacity as error:
            self.abort(resources, str(error))
            raise Refused("no_capacity", f"{error}.") from error
        except NoRoomToRecord as error:  # no fault, and no attempt
            self.abort(resources, str(error))
            raise Refused("unavailable", f"The server: {error}.") from error
        except AttemptDiverged as error:
            # CRASH-002: as if the session had ended with the process before.
            log.warning("run %s: a session cannot go on: %s", resources.run_id, error)
            self.abort(resources, str(error))
            resources.ensure_live()
            raise AssertionError("the session has ended") from error
        except Refused as refused:
            self.abort(resources, refused.detail)
            raise
        except Exception as error:
            log.exception("a turn of run %s failed", resources.run.run_id)
            self.abort(resources, "its turn failed")
            raise Refused(
                "internal_error", "The turn could not be carried out."
            ) from error
        finally:
            resources.wait.end()
            if ended is not None:
                ended.set_result(None)

    def abort(self, resources: SessionResources, cause: str) -> None:
        """End a session whose work failed by no fault of its policy."""
        session = resources.session
        if session.ended_by is None:
            run = resources.run
            must_store = effects.abort_session(run, session, time.time())
            self._resources.release_sessions([session], cause=cause)
            if must_store:
                self._registry.writer.commit_later(run)
            else:
                self._registry.notify(run)
