"""Before the first check: is there a Proctor server that this kit can judge?

Whatever is wrong here is no violation. The kit says in one sentence what it saw and
what to do about it, and ends with exit code 2. It also measures the network, from
which the tolerances of all timing checks derive.
"""

import contextlib
import statistics
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import Any

from jsonschema import Draft202012Validator

from conformance.cli.settings import Settings
from conformance.client.check_context import Context, Story
from conformance.client.http_client import Answer, Wire
from conformance.specification.document import load_spec
from conformance.verdicts.expect import Violation, told

_PROBES = 12
_TIMEOUT_S = 10.0
_TOLERANCE_LEAST_S = 0.25
_TOLERANCE_ROUND_TRIPS = 20
_NAMES = {"type": "array", "items": {"type": "string"}}
_SKEW_WORTH_A_WORD_S = 2.0


class CannotJudge(Exception):
    """There is nothing to judge here, and why."""


@dataclass(frozen=True)
class Findings:
    """What the preflight measured."""

    round_trip_p50_s: float
    round_trip_p95_s: float
    clock_skew_s: float

    def notes(self) -> list[str]:
        """Say what an operator should know."""
        if abs(self.clock_skew_s) < _SKEW_WORTH_A_WORD_S:
            return []
        return [f"the server's clock is {self.clock_skew_s:+.1f} s off this machine's"]


def inspect(settings: Settings) -> Findings:
    """Look at the server; fills in what the checks need of it."""
    with contextlib.closing(Context.of(settings)) as context:
        return _inspect(Story(context, "preflight"), settings)


def _inspect(story: Story, settings: Settings) -> Findings:
    settings.service = _service(story)
    findings = _measure(story)
    settings.round_trip_s = findings.round_trip_p95_s
    settings.tolerance_s = max(
        _TOLERANCE_LEAST_S, _TOLERANCE_ROUND_TRIPS * findings.round_trip_p95_s
    )
    _versions_overlap(settings.service)
    _is_admitted(story.wire, "--token or PROCTOR_TOKEN")
    if settings.token_2 is not None:
        if settings.token_2 == settings.token:
            raise CannotJudge(
                "the second token is the first: PROCTOR_TOKEN_2 must be one of "
                "another account"
            )
        _is_admitted(story.wire_2, "--token-2 or PROCTOR_TOKEN_2")
    if settings.token_read is not None:
        _is_admitted(story.wire_read, "--token-read or PROCTOR_TOKEN_READ")
    settings.benchmark = _calibration(story)
    _may_submit(story)
    return findings


def _ask(wire: Wire, method: str, path: str, **how: Any) -> Answer:
    try:
        return wire.request(method, path, timeout_s=_TIMEOUT_S, **how)
    except Violation as error:
        raise CannotJudge(
            f"nothing answers {method} {wire.base_url}{path} ({error.observed}): "
            "start the server, or correct --url"
        ) from error


def _service(story: Story) -> dict[str, Any]:
    answer = _ask(story.wire, "GET", "/v1", token=None)
    if answer.status in (401, 403):
        answer = _ask(story.wire, "GET", "/v1")  # which is for SVC-001 to judge
    needed = "GET /v1 must describe the service; is --url the base of a Proctor server?"
    if answer.status != 200 or not isinstance(answer.json, dict):
        raise CannotJudge(f"this is not a Proctor server: {told(answer)}; {needed}")
    # Only what the kit itself needs; the rest is for SVC-003 to judge.
    described = story.spec.schema("Service")["properties"]
    needs = {name: described[name] for name in ("protocol", "limits")}
    needs |= dict.fromkeys(("profiles", "encodings", "image_codecs"), _NAMES)
    schema = {"type": "object", "required": list(needs), "properties": needs}
    faults = list(Draft202012Validator(schema).iter_errors(answer.json))
    if faults:
        raise CannotJudge(
            f"what GET /v1 says cannot be used: {faults[0].json_path} "
            f"{faults[0].message}; {needed}"
        )
    service: dict[str, Any] = answer.json
    return service


def _measure(story: Story) -> Findings:
    trips: list[float] = []
    skews: list[float] = []
    for _ in range(_PROBES):
        before = datetime.now(UTC)
        answer = _ask(story.wire, "GET", "/v1")
        trips.append(answer.elapsed_s)
        if isinstance(answer.json, dict):
            server_time = _read_time(answer.json.get("server_time"))
            if server_time is not None:
                half = answer.elapsed_s / 2
                skews.append((server_time - before).total_seconds() - half)
    trips.sort()
    return Findings(
        round_trip_p50_s=statistics.median(trips),
        round_trip_p95_s=trips[int(0.95 * (len(trips) - 1))],
        clock_skew_s=statistics.median(skews) if skews else 0.0,
    )


def _read_time(text: object) -> datetime | None:
    try:
        read = datetime.fromisoformat(str(text))
    except ValueError:
        return None
    return read if read.tzinfo is not None else None


def _versions_overlap(service: dict[str, Any]) -> None:
    ours = load_spec().document["info"]["version"].rpartition(".")[0]
    low, high = service["protocol"]["min"], service["protocol"]["max"]
    if not _number(low) <= _number(ours) <= _number(high):
        raise CannotJudge(
            f"the server speaks Proctor {low} to {high}, this kit judges {ours}: "
            "use the kit of a version that the server speaks"
        )


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def _is_admitted(wire: Wire, source: str) -> None:
    if wire.token is None:
        raise CannotJudge(f"no token was given: use {source}")
    answer = _ask(wire, "GET", "/v1/runs", params={"limit": 1})
    if answer.status in (401, 403):
        raise CannotJudge(
            f"the token given by {source} is refused: {told(answer)}; give one that "
            "the server knows"
        )


def _calibration(story: Story) -> dict[str, Any]:
    answer = _ask(story.wire, "GET", "/v1/benchmarks/calibration")
    if answer.status != 200 or not isinstance(answer.json, dict):
        raise CannotJudge(
            f"the benchmark `calibration` is not offered: {told(answer)}; without it "
            "the kit cannot judge a server"
        )
    reason = answer.json.get("unavailable_reason")
    if reason is not None:
        raise CannotJudge(f"the benchmark `calibration` cannot run: {reason}")
    benchmark: dict[str, Any] = answer.json
    return benchmark


def _may_submit(story: Story) -> None:
    body = story.submit_body()
    answer = _ask(story.wire, "POST", "/v1/runs", json=body)
    if answer.status in (401, 403):
        raise CannotJudge(
            f"the token may not submit runs: {told(answer)}; it needs the scopes "
            "`read` and `run`"
        )
    if answer.status == 201 and isinstance(answer.json, dict):
        run_id = str(answer.json.get("run_id", ""))
        if run_id:
            path = f"/v1/runs/{run_id}/stop"
            _ask(story.wire, "POST", path, json={"mode": "abort"})
