"""Mutants of submitting a run: what is accepted, what is granted, what is answered."""

from __future__ import annotations

import json
from typing import Any

from reference_server.http import (
    codec,
    handlers,
)
from reference_server.http.handlers import Handlers
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.rules.refusal import Refused
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.service import RunService
from reference_sim import benchmark_registry
from tests.mutants import Json, instead_of, mutant, put


@mutant("RUN-001", through=instead_of(Handlers, "submit_run"))
async def returns_a_wrong_location_after_submit(
    right: Any, self: Handlers, call: Any
) -> Any:
    """A client that follows Location does not find its run."""
    response = await right(self, call)
    response.headers["Location"] = "/v1/runs/run_elsewhere"
    return response


@mutant(
    "RUN-002",
    "RUN-019",
    "RUN-008",
    "LIFE-802",
    through=instead_of(Handlers, "submit_run"),
)
async def calls_a_new_run_running(right: Any, self: Handlers, call: Any) -> Any:
    """A client believes that a worker is attached."""
    response = await right(self, call)
    body = json.loads(bytes(response.body)) | {"state": "running"}
    answer = codec.encode_response(body, status=201)
    answer.headers["Location"] = response.headers["Location"]
    return answer


@mutant("RUN-006", through=instead_of(Benchmarks, "resolve"))
async def points_at_the_wrong_member(
    right: Any, self: Benchmarks, submission: Any, *drawn: Any
) -> Any:
    """A user looks for the mistake in the wrong place."""
    try:
        return await right(self, submission, *drawn)
    except Refused as refused:
        refused.errors = tuple(
            ("/benchmark" if p == "/benchmark_id" else p, d) for p, d in refused.errors
        )
        raise


@mutant("RUN-007", through=instead_of(Benchmarks, "resolve"))
async def ignores_options_that_do_not_apply(
    right: Any, self: Benchmarks, submission: Any, *drawn: Any
) -> Any:
    """A submitter believes that the options were applied."""
    if submission["benchmark_id"] != "calibration":
        submission = {k: v for k, v in submission.items() if k != "options"}
    return await right(self, submission, *drawn)


@mutant("RUN-017", through=instead_of(Benchmarks, "_resolved"))
def replaces_an_image_choice_it_does_not_offer(
    right: Any, self: Benchmarks, name: str, options: Any, images: Any, *choices: Any
) -> Any:
    """A policy is evaluated on other images than requested."""
    try:
        return right(self, name, options, images, *choices)
    except benchmark_registry.InvalidChoice as error:
        if not error.pointer.startswith("/images"):
            raise
        return right(self, name, options, None, *choices)


@mutant("LEASE-007", "RUN-015", through=instead_of(RunService, "prepare_run"))
async def grants_any_number_of_workers_and_any_lease(
    right: Any, self: RunService, account: str, submission: Json
) -> Any:
    """One submitter takes every simulator, and keeps it for a day after a crash."""
    limited = ("max_workers", "idle_timeout_s")
    wanted = {name: submission.pop(name) for name in limited if name in submission}
    run = await right(self, account, submission)
    for name, value in wanted.items():
        setattr(run, name, value)
    submission.update(wanted)
    return run


@mutant("RUN-032")
def accepts_push_runs_that_nothing_plays() -> None:
    """A run waits without end for calls that the server never makes."""
    announced = tuple(name for name in handlers.PROFILES if name != "push")
    put(handlers, "PROFILES", announced)

    async def wrong(_self: object, submission: Json, _account: str) -> Json:
        return {
            name: value
            for name, value in submission.items()
            if name not in ("mode", "policy_server")
        }

    put(PolicyServerValidator, "validate_and_encrypt", wrong)
