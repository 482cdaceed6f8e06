"""Mutants of how runs and episodes are shown, alone and in the pages of a list."""

from __future__ import annotations

import json
from typing import Any

from starlette.responses import Response

from reference_server.http import (
    handlers,
)
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules.runs.run import Episode, Run, RunHead
from reference_server.runs.service import RunService
from tests.mutants import Json, instead_of, mutant, put
from tests.mutants.server_changes import (
    change_run,
)


@mutant("RUN-014", "RUN-022", through=change_run)
def counts_episodes_in_play_twice(body: Json, _run: Run) -> None:
    """Progress exceeds a hundred per cent."""
    progress = body["progress"]
    progress["episodes_pending"] += progress["episodes_in_progress"]


@mutant("RUN-033", through=change_run)
def shows_an_endpoint_with_a_final_slash(body: Json, _run: Run) -> None:
    """A client that appends a path gets two slashes, and `not_found`."""
    body["endpoint"] += "/"


@mutant("RUN-016", "RUN-033", through=change_run)
def names_an_endpoint_without_a_host(body: Json, _run: Run) -> None:
    """A client cannot reach the data plane."""
    body["endpoint"] = "/"


@mutant("RUN-018", through=change_run)
def drops_what_a_policy_says_of_itself(body: Json, _run: RunHead) -> None:
    """A leaderboard cannot say whose policy it was."""
    body["policy"].pop("submitter", None)


@mutant("RUN-021", through=change_run)
def forgets_the_last_change_when_a_run_is_left(body: Json, run: RunHead) -> None:
    """A client that asks for what is new since its last visit misses a run."""
    if not run.live_sessions:
        body["updated_at"] = body["created_at"]


@mutant("RUN-023", through=change_run)
def calls_stopped_runs_retryable(body: Json, run: RunHead) -> None:
    """A client resumes what its user has stopped."""
    if run.state == "stopped":
        body["retryable"] = True


@mutant("FAULT-015", through=change_run)
def calls_every_fault_final(body: Json, run: RunHead) -> None:
    """A client submits a run again that a resume would have completed."""
    if run.state == "failed" and "faulted" in (run.reason or ""):
        body["retryable"] = False


@mutant("RUN-024")
def numbers_episodes_with_two_digits() -> None:
    """Results of two episodes are filed under one id."""
    put(Episode, "episode_id", property(lambda self: f"e{self.index % 100:02d}"))


@mutant("RUN-019", through=instead_of(RunService, "list_runs"))
async def lists_runs_without_their_progress(
    right: Any, self: RunService, *arguments: Any
) -> Any:
    """A table of all runs shows none of them as played."""
    page = await right(self, *arguments)
    for _, body in page:
        progress = body["progress"]
        progress["episodes_pending"] += progress["episodes_scored"]
        progress["episodes_scored"] = 0
    return page


@mutant("RUN-025")
def lists_everything_without_a_limit() -> None:
    """A page that shows the newest runs loads all of them."""
    put(handlers, "PAGE", 1000)


@mutant("EPI-006", "RUN-009", "SVC-003", through=instead_of(handlers, "_number"))
def repeats_an_episode_between_pages(right: Any, cursor: str | None) -> Any:
    """An episode seems to be scored twice."""
    number = right(cursor)
    return number - 1 if number is not None else None


@mutant("EPI-006", "RUN-009")
def never_ends_the_pages_of_a_list() -> None:
    """A script that reads all pages reads empty ones for ever."""
    for operation, cursor in (("list_runs", "0"), ("list_episodes", "1000000")):
        right = getattr(Handlers, operation)

        async def wrong(
            self: Handlers, call: OperationCall, right: Any = right, last: str = cursor
        ) -> Response:
            page = json.loads(bytes((await right(self, call)).body))
            return call.answer(page | {"next_cursor": page["next_cursor"] or last})

        put(Handlers, operation, wrong)
