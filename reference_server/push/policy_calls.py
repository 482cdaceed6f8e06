"""The interface of a policy for the driver, and its implementation for policy.yaml.

Another policy protocol is another class with the methods of `PolicyAdapter` and an
entry in `driver.PROTOCOLS`. Responses are checked here against the schemas; whether the
actions fit the benchmark is decided by the rules, as for any worker. It must not know
runs beyond the manifest, or sessions beyond their turns.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, Protocol, TypeVar

from pydantic import BaseModel, ValidationError

from reference_record.generated.answers import Turn
from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_record.texts.shortened_text import shortened
from reference_server.generated import models
from reference_server.http.bodies.bounded_parsing import read_structure
from reference_server.http.codec import JSON, pointer, validate, words_of
from reference_server.push.calls_with_retries import (
    HttpCalls,
    PolicyFault,
    ReadAnswer,
    read_members,
)
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Run

Answer = TypeVar("Answer", bound=BaseModel)
_ERRORS_SHOWN_MAX = 3
_ERROR_CHARS_MAX = 300


@dataclass(frozen=True, slots=True)
class Description:
    """max_sessions: sessions it plays in parallel. assumes: schema Assumptions."""

    max_sessions: int
    assumes: Mapping[str, Any] | None = None


class PolicyAdapter(Protocol):
    """The policy of one run.

    Every method raises PolicyFault, and takes no longer than the calls of the run's
    `policy_server` may. A turn belongs to the session of its `session_id`.
    """

    async def describe(self) -> Description:
        """Called before anything else, and after a fault to see whether it answers."""

    async def reset(self, turn: Turn) -> None:
        """Returns when the policy is ready for the attempt that the turn begins."""

    async def predict(self, turn: Turn) -> models.Predict:
        """The actions for a turn, with the turn's seq plus one."""


class ProctorPolicy:
    """A policy server that implements policy.yaml (PUSH-001)."""

    def __init__(self, run: Run, _config: PolicyServerConfig, calls: HttpCalls) -> None:
        self._run = run
        self._calls = calls

    async def describe(self) -> Description:
        read = self._reader(models.PolicyDescription, "describe_policy")
        answer = await self._calls.get("/v1/policy", read)
        received = self._read(models.PolicyDescription, answer, "describe_policy")
        supported = received.protocol
        ours = _number(PROTOCOL_VERSION)
        if not _number(supported.min) <= ours <= _number(supported.max):
            least, most = map(self._calls.redact_key, (supported.min, supported.max))
            raise PolicyFault(  # PUSH-019
                f"The policy server supports versions {least[:20]} to {most[:20]}, not "
                f"{PROTOCOL_VERSION}."
            )
        assumes = received.model_dump().get("assumes")
        return Description(received.max_sessions, assumes)

    async def reset(self, turn: Turn) -> None:
        """PUSH-006: returns once the acknowledgement names this very attempt."""
        run, episode = self._run, turn["episode"]
        manifest = {k: v for k, v in run.manifest.items() if k != "episodes"}
        body = {
            "session_id": turn["session_id"],
            "run_id": run.run_id,
            "benchmark": manifest
            | {"manifest_sha256": run.manifest_sha256, "unavailable_reason": None},
            "episode": episode,
        }
        read = self._reader(models.PolicyReset, "reset")
        answer = await self._calls.post(
            "/v1/policy/reset", body, read, has_state=True, waits_for_room=True
        )
        ready = self._read(models.PolicyReset, answer, "reset")
        received = (ready.session_id, ready.episode_id, ready.attempt)
        if received != (turn["session_id"], episode["episode_id"], episode["attempt"]):
            raise PolicyFault("The policy acknowledged a different reset.")

    async def predict(self, turn: Turn) -> models.Predict:
        read = partial(read_structure, models.Predict, media_type=JSON)
        try:
            answer = await self._calls.post(
                "/v1/policy/predict",
                turn,
                read,
                max_bytes=sys.maxsize,
                has_state=True,
            )
            predict = validate(models.Predict, answer)
        except Refused as refused:
            raise answer_fault(refused, self._calls) from refused
        if (predict.session_id, predict.seq) != (turn["session_id"], turn["seq"] + 1):
            raise PolicyFault("The policy answered a different turn.")
        return predict

    def _reader(self, model: type[BaseModel], operation: str) -> ReadAnswer:
        return read_members(
            model, lambda refused: self._mismatch(operation, refused.errors)
        )

    def _read(self, model: type[Answer], answer: Any, operation: str) -> Answer:
        """The response as its schema; members that the schema lacks are ignored."""
        try:
            return model.model_validate(answer, strict=True, extra="ignore")
        except ValidationError as error:
            faults = error.errors(include_url=False)
            errors = [(pointer(f["loc"]), words_of(f)) for f in faults]
            raise self._mismatch(operation, errors) from error

    def _mismatch(self, operation: str, errors: Any) -> PolicyFault:
        details = _format_errors(errors, self._calls)
        return PolicyFault(
            f"The policy's answer to {operation} does not match policy.yaml: {details}."
        )


def answer_fault(refused: Refused, calls: HttpCalls) -> PolicyFault:
    """The fault for an answer that the schema or the benchmark refuses (PUSH-010)."""
    details = _format_errors(refused.errors, calls) or refused.detail
    return PolicyFault(f"The policy's answer to predict was refused: {details}.")


def _format_errors(errors: Any, calls: HttpCalls) -> str:
    received = [
        shortened(calls.redact_key(f"{at or '/'} {text}"), _ERROR_CHARS_MAX)
        for at, text in list(errors)[:_ERRORS_SHOWN_MAX]
    ]
    return "".join(c if c.isprintable() else " " for c in "; ".join(received))


def _number(version: str) -> tuple[int, int]:
    major, _, minor = version.partition(".")
    return int(major[:9]), int(minor[:9])  # no version has more digits
