"""A policy as the driver asks it, and the one that speaks policy.yaml.

Another protocol is another class with these methods and a line in `protocols`. What a
policy answers is checked here against the schema; whether its actions fit the benchmark
is decided where it always is, in `protocol`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from pydantic import BaseModel, ValidationError

from reference_server.generated import models
from reference_server.http.codec import pointer, validate
from reference_server.http.dispatch import VERSION
from reference_server.push.http_calls import HttpCalls, PolicyFault
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run

Turn = Mapping[str, Any]
Answer = TypeVar("Answer", bound=BaseModel)
_ERRORS_SHOWN_MAX = 3


@dataclass(frozen=True, slots=True)
class Description:
    """max_sessions: episodes it plays at a time. assumes: schema Assumptions."""

    max_sessions: int
    assumes: Mapping[str, Any] | None = None


class PolicyAdapter(Protocol):
    """One run's. Every method raises PolicyFault, and none takes longer than the run's
    order allows. Sessions are told apart by the `session_id` of their turns."""

    async def describe(self) -> Description:
        """Asked before anything else, and again after a fault: is it there?"""

    async def reset(self, turn: Turn) -> None:
        """Returns when the policy is ready for the attempt that the turn begins."""

    async def predict(self, turn: Turn) -> models.Predict:
        """The actions for a turn, under the seq after its own."""


class ProctorPolicy:
    """A policy server of policy.yaml."""

    def __init__(self, run: Run, _config: PolicyServerConfig, calls: HttpCalls) -> None:
        self._run = run
        self._calls = calls

    async def describe(self) -> Description:
        answer = await self._calls.get("/v1/policy")
        received = self._read(models.PolicyDescription, answer, "describe_policy")
        supported = received.protocol
        if not _number(supported.min) <= _number(VERSION) <= _number(supported.max):
            least, most = map(self._calls.redact_key, (supported.min, supported.max))
            raise PolicyFault(
                f"The policy server speaks {least[:20]} to {most[:20]}, not {VERSION}."
            )
        assumes = received.model_dump().get("assumes")
        return Description(received.max_sessions, assumes)

    async def reset(self, turn: Turn) -> None:
        run, episode = self._run, turn["episode"]
        manifest = {k: v for k, v in run.manifest.items() if k != "episodes"}
        body = {
            "session_id": turn["session_id"],
            "run_id": run.run_id,
            "benchmark": manifest
            | {"manifest_sha256": run.manifest_sha256, "unavailable_reason": None},
            "episode": episode,
        }
        answer = await self._calls.post("/v1/policy/reset", body)
        ready = self._read(models.PolicyReset, answer, "reset")
        received = (ready.session_id, ready.episode_id, ready.attempt)
        if received != (turn["session_id"], episode["episode_id"], episode["attempt"]):
            raise PolicyFault("The policy acknowledged another reset than it was sent.")

    async def predict(self, turn: Turn) -> models.Predict:
        answer = await self._calls.post("/v1/policy/predict", turn)
        try:
            predict = validate(models.Predict, answer)
        except Refused as refused:
            raise answer_fault(refused, self._calls) from refused
        if (predict.session_id, predict.seq) != (turn["session_id"], turn["seq"] + 1):
            raise PolicyFault("The policy answered another turn than it was asked for.")
        return predict

    def _read(self, model: type[Answer], answer: Any, operation: str) -> Answer:
        """An answer by its schema, with what the schema does not know passed over."""
        try:
            return model.model_validate(answer, strict=True, extra="ignore")
        except ValidationError as error:
            faults = error.errors(include_url=False, include_context=False)
            errors = [(pointer(f["loc"]), f["msg"]) for f in faults]
            details = _format_errors(errors, self._calls)
            raise PolicyFault(
                f"The policy's answer to {operation} is not as policy.yaml says: "
                f"{details}."
            ) from error


def answer_fault(refused: Refused, calls: HttpCalls) -> PolicyFault:
    """An answer of predict that the schema or the benchmark refuses (PUSH-010)."""
    details = _format_errors(refused.errors, calls) or refused.detail
    return PolicyFault(f"The policy's answer to predict was refused: {details}.")


def _format_errors(errors: Any, calls: HttpCalls) -> str:
    received = [f"{at or '/'} {text}" for at, text in list(errors)[:_ERRORS_SHOWN_MAX]]
    text = calls.redact_key("; ".join(received))[:500]
    return "".join(c if c.isprintable() else " " for c in text)


def _number(version: str) -> tuple[int, int]:
    major, _, minor = version.partition(".")
    return int(major[:9]), int(minor[:9])  # longer ones are nobody's versions
