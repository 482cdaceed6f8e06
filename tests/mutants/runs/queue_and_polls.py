"""Mutants of waiting: in the queue for a place, and by requests for a change."""

from __future__ import annotations

import asyncio
import json
import time
from typing import Any

from reference_server.http import (
    handlers,
)
from reference_server.http.handlers import Handlers
from reference_server.rules.runs import effects
from reference_server.rules.runs.run import Run
from reference_server.runs.admission.run_admission import RunAdmission
from reference_server.runs.memory.run_changes import RunChanges
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from tests.mutants import instead_of, mutant, put


@mutant("RUN-008")
def omits_the_queue_position() -> None:
    """A user cannot estimate the time in the queue."""
    put(RunAdmission, "queue_position", lambda _self, _run: None)


@mutant("LIFE-801", through=instead_of(effects, "admit"))
def forgets_runs_that_were_held_in_the_queue(
    right: Any, run: Run, now_wall: float
) -> Any:
    """A queued run never starts."""
    is_held = bool(run.submission.get("options", {}).get("queue_s"))
    return not is_held and right(run, now_wall)


@mutant(
    *("LIFE-504", "LIFE-604", "LIFE-810", "RUN-012"),
    through=instead_of(effects, "resume"),
)
def lets_a_resumed_run_out_of_the_queue_at_once(
    right: Any, run: Run, _queue_until_wall: float
) -> None:
    """A run that is resumed overtakes those that wait."""
    right(run, 0.0)


@mutant("LIFE-811", through=instead_of(RunService, "resume_run"))
async def forgets_to_end_the_queue_of_before_a_resume(
    right: Any, self: RunService, account: str, run_id: str
) -> Any:
    """A run that its submitter has resumed and stopped begins."""
    run = await self.registry.get(run_id, account)

    def start() -> None:
        if run.state == "stopped":
            run.state = "ready"
            self.registry.writer.commit_later(run)

    if run.state == "queued":
        wait_s = max(0.0, run.queue_until_wall - time.time())
        asyncio.get_running_loop().call_later(wait_s, start)
    return await right(self, account, run_id)


@mutant("RUN-011", "RUN-012", "RUN-013")
def ignores_etags() -> None:
    """Every poll transfers the whole answer."""
    put(handlers, "_matches", lambda _wanted, _etag: False)


@mutant("RUN-012", "RUN-030", through=instead_of(handlers, "_etag"))
def keeps_the_etag_while_a_run_makes_progress(right: Any, view: bytes) -> Any:
    """A page that shows a run stands still until the run ends."""
    body = json.loads(view)
    for name in ("updated_at", "progress", "runs_played_before"):
        body.pop(name, None)
    return right(json.dumps(body).encode())


@mutant("RUN-031", through=instead_of(Handlers, "get_run"))
async def waits_although_the_run_has_changed(
    right: Any, self: Handlers, call: Any
) -> Any:
    """A client that was late for one change waits for the next."""
    response = await right(self, call)
    wait_s = float(call.headers.get("prefer", "wait=0").removeprefix("wait="))
    if "if-none-match" in call.headers and response.status_code == 200:
        await asyncio.sleep(wait_s if 5 < wait_s <= 10 else 0)
    return response


@mutant("LEASE-011", "RUN-012", through=instead_of(RunRegistry, "wait_for_change"))
async def answers_long_polls_only_at_their_end(
    _right: Any, _self: RunRegistry, _change_events: asyncio.Event, timeout_s: float
) -> Any:
    """A long poll is no faster than polling at intervals."""
    await asyncio.sleep(timeout_s)
    return True


@mutant("RUN-013")
def waits_anew_when_another_run_changes() -> None:
    """On a busy server a wait that was to be short never ends."""
    right, changes = RunRegistry.wait_for_change, [0]
    changed = RunChanges.changed

    def wrong_changed(self: RunChanges, run: Run) -> None:
        changes[0] += 1
        changed(self, run)

    async def wrong(self: RunRegistry, change: Any, timeout_s: float) -> bool:
        seen = -1
        while seen != changes[0]:
            seen = changes[0]
            if await right(self, change, timeout_s):
                return True
        return False

    put(RunChanges, "changed", wrong_changed)
    put(RunRegistry, "wait_for_change", wrong)
