"""The benchmark that a policy server is judged on: a file, or a name and a server.

The evaluation server describes the benchmark. Only a turn has an instruction, so a
worker attaches to a run that is submitted for it, and sends no action: nothing is
played. The run is then stopped, and deleted where the server deletes runs.
"""

import contextlib
import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx

from conformance.cli.kit_command import BadArguments
from conformance.client.connections.connection_pool import Connections
from conformance.client.connections.failure_texts import (
    describe_failure,
    describe_other_answer,
)
from conformance.client.connections.kept_connection import HttpRequest
from conformance.client.connections.transport.text_file import read_text_file
from conformance.policy.turn_builder import Beginning, calibration
from conformance.specification.document import JSON, load_policy_spec

DEFAULT_SERVER = "http://127.0.0.1:8460"
_NAME = re.compile(r"[a-z][a-z0-9_]{0,63}")
_TIMEOUT_S = 10.0
_ATTACH_TIMEOUT_S = 60.0  # a simulator may have to start, and to draw
_WORKER = "kit"
_OWN_WORDS = "give the instruction of an episode with --instruction TEXT"


def read_benchmark(
    source: str | None, instruction: str | None, server: str, token: str | None
) -> tuple[dict[str, Any], Beginning]:
    """The response of get_benchmark, and how its episodes begin. Raises BadArguments.

    source: a file that holds it, or the id of a benchmark of `server`; None is
    calibration, which needs neither. instruction: in place of that of the server.
    """
    if source is None:
        return calibration(), Beginning.of(calibration(), instruction)
    if not _NAME.fullmatch(source) or Path(source).exists():
        benchmark = _require_benchmark(source, _from_file(source))
        try:
            return benchmark, Beginning.of(benchmark, instruction)
        except ValueError as error:
            raise BadArguments(f"--benchmark {source}: {error}; {_OWN_WORDS}") from None
    with contextlib.closing(Connections()) as connections:
        host = _EvaluationServer(source, server.rstrip("/"), token, connections)
        benchmark = _require_benchmark(source, host.read_benchmark())
        if instruction is not None:
            return benchmark, Beginning.of(benchmark, instruction)
        return benchmark, host.read_beginning(benchmark)


def _require_benchmark(source: str, benchmark: Any) -> dict[str, Any]:
    required = load_policy_spec().schema("Benchmark")["required"]
    if not isinstance(benchmark, dict) or not set(required) <= set(benchmark):
        raise BadArguments(
            f"--benchmark {source}: not a response of get_benchmark; it needs "
            f"{', '.join(required)}"
        )
    return benchmark


def _from_file(path: str) -> Any:
    try:
        return json.loads(read_text_file(path))
    except (OSError, ValueError) as error:
        raise BadArguments(f"--benchmark {path}: {error}") from error


class _EvaluationServer:
    """The server that has the benchmark; each refusal is raised as BadArguments."""

    def __init__(
        self, name: str, url: str, token: str | None, connections: Connections
    ) -> None:
        self._name, self._url, self._connections = name, url, connections
        self._headers = {"accept": ("Accept", JSON)}
        if token is not None:
            self._headers["authorization"] = ("Authorization", f"Bearer {token}")

    def read_benchmark(self) -> Any:
        status, body = self._send("GET", f"{self._url}/v1/benchmarks/{self._name}")
        if status == 404:
            raise self._bad(f"{self._url} has no such benchmark")
        return self._require(status, body)

    def read_beginning(self, benchmark: dict[str, Any]) -> Beginning:
        """How the first episode of a run begins, by the turn that a worker gets."""
        if benchmark["unavailable_reason"] is not None:
            reason = f"{self._url} cannot play it: {benchmark['unavailable_reason']}"
            raise self._bad(f"{reason}; {_OWN_WORDS}")
        if "physical" in benchmark:
            raise self._bad(f"a robot plays it, and would have to begin; {_OWN_WORDS}")
        with self._submitted_run() as worker_url:
            body = json.dumps({"attach_key": "kit"}).encode()
            status, answer = self._send("PUT", worker_url, body, _ATTACH_TIMEOUT_S)
            turn = self._require(status, answer)
        try:
            view, state = turn["episode"], turn["observation"]["state"]
            return Beginning(view["task"], view["instruction"], state)
        except (KeyError, TypeError):
            reason = f"{self._url} sends no first turn of it"
            raise self._bad(f"{reason}; {_OWN_WORDS}") from None

    @contextlib.contextmanager
    def _submitted_run(self) -> Iterator[str]:
        """Give the URL of a worker of a run, which is gone or stopped afterwards."""
        wanted = {"benchmark_id": self._name, "policy": {"name": "conformance kit"}}
        status, answer = self._send(
            "POST", f"{self._url}/v1/runs", json.dumps(wanted).encode()
        )
        run = self._require(status, answer)
        path = f"{self._url}/v1/runs/{run['run_id']}"
        try:
            endpoint = str(run["endpoint"]).rstrip("/")
            yield f"{endpoint}/v1/runs/{run['run_id']}/workers/{_WORKER}"
        finally:
            self._send("POST", f"{path}/stop", b'{"mode": "abort"}')
            self._send("DELETE", path)

    def _send(
        self,
        method: str,
        url: str,
        body: bytes | None = None,
        timeout_s: float = _TIMEOUT_S,
    ) -> tuple[int, bytes]:
        headers = self._headers
        if body is not None:
            headers = headers | {"content-type": ("Content-Type", JSON)}
        try:
            request = HttpRequest(method, httpx.URL(url), headers, body, timeout_s)
            answer = self._connections.to(request.url).send(request)
            content = answer.read()
        except (httpx.HTTPError, httpx.InvalidURL) as error:
            reason = describe_failure(error, self._url)
            raise self._bad(f"{reason}; or give --server") from error
        other = describe_other_answer(answer.status, answer.headers, content, self._url)
        if other is not None:
            raise self._bad(other)
        return answer.status, content

    def _require(self, status: int, body: bytes) -> Any:
        """Give the JSON of a success. Raises BadArguments with the server's words."""
        if status == 401 and "authorization" in self._headers:
            raise self._bad(f"{self._url} refused the token of PROCTOR_TOKEN")
        if status == 401:
            raise self._bad(f"{self._url} requires a token; set PROCTOR_TOKEN")
        try:
            answer = json.loads(body)
        except ValueError:
            raise self._bad(f"{self._url} sends no JSON") from None
        if status in (200, 201):
            return answer
        detail = answer.get("detail") if isinstance(answer, dict) else None
        said = f"answered with status {status}" + (f": {detail}" if detail else "")
        raise self._bad(f"{self._url} {said}")

    def _bad(self, reason: str) -> BadArguments:
        return BadArguments(f"--benchmark {self._name}: {reason}")
