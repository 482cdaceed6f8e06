"""Before the first check: is there a Proctor server that this kit can check?

A problem here is no violation. The kit prints one sentence with the observation and
the remedy, and ends with exit code 2. It also measures the network, from which the
tolerances of all timing checks derive.
"""

import contextlib
import statistics
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import partial
from typing import Any

import httpx

from conformance.client.check_context import CheckContext
from conformance.client.connections.failure_texts import (
    describe_failure,
    describe_other_answer,
)
from conformance.client.connections.proxy_answers import find_nginx
from conformance.client.http_client import AnsweredByProxy, HttpClient, NoAnswer
from conformance.client.request_context import TOLERANCE_ROUND_TRIPS, SharedContext
from conformance.exchanges.answer import Answer, describe_body
from conformance.run_settings import Settings
from conformance.specification.document import load_spec, schema_faults
from conformance.specification.stages import BENCHMARKS, LAST, RUNS
from conformance.verdicts.expect import (
    OwnConnectionFailed,
    SetUpFailed,
    Violation,
    describe_answer,
)

_FAULTS_MAX = 12
_PROBES = 12
_REPEATS = 2
_TIMEOUT_S = 10.0
_TOLERANCE_MIN_S = 0.25
_NAMES = {"type": "array", "items": {"type": "string"}}
_SKEW_NOTED_S = 2.0
_SLOW_S = 1.0


class CannotJudge(Exception):
    """There is nothing to check; the text gives the reason."""


@dataclass(frozen=True)
class Findings:
    """The measurements of the preflight."""

    round_trip_p50_s: float
    round_trip_p95_s: float
    clock_skew_s: float
    unmet_needs: list[str] = field(default_factory=list)

    def notes(self) -> list[str]:
        """Give the notes for the operator."""
        notes = [*self.unmet_needs]
        if self.round_trip_p50_s > _SLOW_S:
            notes.append(
                f"the server takes {self.round_trip_p50_s:.1f} s to answer `GET /v1`: "
                "thousands of requests take hours, and rules about time get as lenient"
            )
        if abs(self.clock_skew_s) >= _SKEW_NOTED_S:
            skew = f"{self.clock_skew_s:+.1f} s"
            notes.append(f"server clock differs from this machine by {skew}")
        return notes


def inspect(settings: Settings) -> Findings:
    """Inspect the server, and complete the settings with its description."""
    with contextlib.closing(SharedContext.of(settings)) as shared:
        return _inspect(CheckContext(shared, "preflight"), settings)


def _inspect(context: CheckContext, settings: Settings) -> Findings:
    settings.service = _read_service(context)
    findings = _measure(context)
    settings.round_trip_s = findings.round_trip_p95_s
    settings.tolerance_s = max(
        _TOLERANCE_MIN_S, TOLERANCE_ROUND_TRIPS * findings.round_trip_p95_s
    )
    _require_version_overlap(settings.service)
    stage = settings.stage or LAST
    if stage >= RUNS:
        _require_accounts(context, settings)
    if stage >= BENCHMARKS:
        settings.benchmark = _read_calibration(context)
    if stage >= RUNS:
        _require_submit_allowed(context)
    return replace(findings, unmet_needs=_unmet_needs(settings))


def _unmet_needs(settings: Settings) -> list[str]:
    """Name the announced profiles without one that they need."""
    needs: dict[str, list[str]] = load_spec().document["x-needs"]
    return [
        f"profile {profile} needs {need}, which is not announced"
        for profile in settings.service.get("profiles", [])
        for need in needs.get(profile, ())
        if not settings.is_offered(need)
    ]


def _require_accounts(context: CheckContext, settings: Settings) -> None:
    _require_admitted(context.http_client, "--token or PROCTOR_TOKEN")
    if settings.token_2 is not None:
        if settings.token_2 == settings.token:
            raise CannotJudge(
                "PROCTOR_TOKEN_2 equals PROCTOR_TOKEN; it must belong to another "
                "account"
            )
        _require_admitted(context.second_account, "--token-2 or PROCTOR_TOKEN_2")
    if settings.token_read is not None:
        _require_admitted(
            context.read_only_account, "--token-read or PROCTOR_TOKEN_READ"
        )


def _request(http_client: HttpClient, method: str, path: str, **how: Any) -> Answer:
    """Send a request, a GET again where its answer was lost. Raises CannotJudge."""
    send = partial(http_client.request, method, path, timeout_s=_TIMEOUT_S, **how)
    try:
        for _ in range(_REPEATS if method == "GET" else 0):
            try:
                return send()
            except NoAnswer as error:
                if not error.is_of_way:
                    raise
        return send()
    except (Violation, OwnConnectionFailed) as error:
        url, observed = http_client.base_url, getattr(error, "observed", error)
        text = f"no response from {url} ({observed}): start it or correct --url"
        if error.__cause__ is not None:
            text = describe_failure(error.__cause__, url)
        raise CannotJudge(f"{method} {path}: {text}") from error
    except SetUpFailed as error:
        raise CannotJudge(f"{method} {path}: {error.reason}") from error


def _read_service(context: CheckContext) -> dict[str, Any]:
    answer = _request(context.http_client, "GET", "/v1", token=None)
    if answer.status in (401, 403):
        # Whether it needs a token is judged by SVC-001.
        answer = _request(context.http_client, "GET", "/v1")
    url = context.http_client.base_url
    other = describe_other_answer(answer.status, answer.headers, answer.body, url)
    if other is not None:
        raise CannotJudge(other)
    needed = "GET /v1 must describe the service"
    if context.shared.settings.start_cmd is None:
        needed += "; is --url the base of a Proctor server?"
    if answer.status != 200 or not isinstance(answer.json, dict):
        found = "this is not a Proctor server"
        if answer.status == 200:
            found = f"GET /v1 does not describe a service: {describe_body(answer)}"
        elif answer.status in (401, 403):
            found += ", or it wants a token for GET /v1, against SVC-001"
        raise CannotJudge(f"{found}: {describe_answer(answer)}; {needed}")
    # Only the members that the kit itself needs; SVC-003 judges the rest.
    described = context.spec.schema("Service")["properties"]
    needs = {name: described[name] for name in ("protocol", "limits")}
    needs |= dict.fromkeys(("profiles", "encodings", "image_codecs"), _NAMES)
    schema = {"type": "object", "required": list(needs), "properties": needs}
    faults = schema_faults(schema, answer.json)
    if faults:
        listed = "; ".join(faults[:_FAULTS_MAX])
        raise CannotJudge(f"invalid response to GET /v1: {listed}; {needed}")
    service: dict[str, Any] = answer.json
    return service


def _measure(context: CheckContext) -> Findings:
    round_trips: list[float] = []
    skews: list[float] = []
    for _ in range(_PROBES):
        before = datetime.now(UTC)
        answer = _request(context.http_client, "GET", "/v1")
        round_trips.append(answer.elapsed_s)
        if isinstance(answer.json, dict):
            server_time = _read_time(answer.json.get("server_time"))
            if server_time is not None:
                half = answer.elapsed_s / 2
                skews.append((server_time - before).total_seconds() - half)
    round_trips.sort()
    return Findings(
        round_trip_p50_s=statistics.median(round_trips),
        round_trip_p95_s=round_trips[int(0.95 * (len(round_trips) - 1))],
        clock_skew_s=statistics.median(skews) if skews else 0.0,
    )


def _read_time(text: object) -> datetime | None:
    try:
        read = datetime.fromisoformat(str(text))
    except ValueError:
        return None
    return read if read.tzinfo is not None else None


def _require_version_overlap(service: dict[str, Any]) -> None:
    ours = load_spec().document["info"]["version"].rpartition(".")[0]
    low, high = service["protocol"]["min"], service["protocol"]["max"]
    if not _number(low) <= _number(ours) <= _number(high):
        needed = high if _number(high) < _number(ours) else low
        raise CannotJudge(
            f"server supports protocol {low} to {high}; this kit tests {ours}: "
            f"use the kit of Proctor {needed} (--version names what a kit tests)"
        )


def _number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


def _require_admitted(http_client: HttpClient, source: str) -> None:
    if http_client.token is None:
        raise CannotJudge(f"no token: set {source}")
    answer = _request(http_client, "GET", "/v1/benchmarks")
    if answer.status in (401, 403):
        raise CannotJudge(
            f"token from {source} was rejected: {describe_answer(answer)}"
        )


def _read_calibration(context: CheckContext) -> dict[str, Any]:
    answer = _request(context.http_client, "GET", "/v1/benchmarks/calibration")
    if answer.status == 200 and not isinstance(answer.json, dict):
        raise CannotJudge(
            "GET /v1/benchmarks/calibration does not describe a benchmark: "
            f"{describe_body(answer)}"
        )
    if answer.status != 200:
        raise CannotJudge(
            f"benchmark `calibration` is not offered: {describe_answer(answer)}; "
            "the kit needs it"
        )
    reason = answer.json.get("unavailable_reason")
    if reason is not None:
        raise CannotJudge(f"benchmark `calibration` is unavailable: {reason}")
    benchmark: dict[str, Any] = answer.json
    return benchmark


def _require_submit_allowed(context: CheckContext) -> None:
    body = context.submit_body()
    answer = _request(context.http_client, "POST", "/v1/runs", json=body)
    if answer.status in (401, 403):
        raise CannotJudge(
            f"token is not allowed to submit runs: {describe_answer(answer)}; the "
            "scopes `read` and `run` are required"
        )
    if answer.status == 201 and isinstance(answer.json, dict):
        run_id = str(answer.json.get("run_id", ""))
        if run_id:
            _require_endpoint(context.http_client, answer.json.get("endpoint"), run_id)
            _require_streams(context, answer, run_id)
            path = f"/v1/runs/{run_id}/stop"
            _request(context.http_client, "POST", path, json={"mode": "abort"})


def _require_streams(context: CheckContext, submitted: Answer, run_id: str) -> None:
    """Raise if nginx may keep event streams: each rule that reads one would fail.

    Without nginx, or with another fault, the rules themselves are judged.
    """
    nginx = find_nginx(submitted.headers)
    if nginx is None or not context.serves("stream_events"):
        return
    path = f"/v1/runs/{run_id}/events"
    try:
        context.http_client.request("GET", path, timeout_s=_TIMEOUT_S)
    except NoAnswer as error:
        if isinstance(error.__cause__, httpx.TimeoutException):
            raise CannotJudge(
                f"GET {path}: no event within {_TIMEOUT_S:g} s. {nginx}, in front of "
                "the server, keeps answers until they end, unless the server sends "
                "`X-Accel-Buffering: no` with them or `proxy_buffering off` is set"
            ) from error
    except AnsweredByProxy:
        return


def _require_endpoint(http_client: HttpClient, endpoint: object, run_id: str) -> None:
    """Raise if a proxy answers at the endpoint of runs: no rule could be judged there.

    Any other wrong endpoint is a violation of RUN-016, which its own check judges.
    """
    if not str(endpoint).startswith(("http://", "https://")):
        return
    path = f"/v1/runs/{run_id}/workers/preflight/predict"
    url = str(endpoint).rstrip("/") + path
    body = {"session_id": "preflight", "seq": 1, "actions": []}
    try:
        http_client.request("POST", url, json=body, timeout_s=_TIMEOUT_S)
    except AnsweredByProxy as error:
        raise CannotJudge(
            f"runs have the endpoint {endpoint}, which does not lead to the server at "
            f"{http_client.base_url}: {error.reason}. Start the server with that URL "
            "as its public URL (--public-url of the reference server), or let the "
            "proxy send the path as X-Forwarded-Prefix"
        ) from error
    except Violation as error:  # judged by RUN-016, unless the server has ended
        try:
            _request(http_client, "GET", "/v1")
        except CannotJudge as gone:
            text = f"`predict` got no answer ({error.observed}), and then {gone}"
            raise CannotJudge(text) from gone
