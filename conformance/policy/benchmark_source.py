"""The benchmark that a policy server is judged on: a file, or a name and a server.

The evaluation server describes the benchmark; nothing is played on it.
"""

import contextlib
import json
import re
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
from conformance.policy.turn_builder import calibration
from conformance.specification.document import load_policy_spec

DEFAULT_SERVER = "http://127.0.0.1:8460"
_NAME = re.compile(r"[a-z][a-z0-9_]{0,63}")
_TIMEOUT_S = 10.0


def read_benchmark(
    source: str | None, server: str, token: str | None
) -> dict[str, Any]:
    """The response of get_benchmark. Raises BadArguments.

    source: a file that holds it, or the id of a benchmark of `server`; None is
    calibration, which needs neither.
    """
    if source is None:
        return calibration()
    if _NAME.fullmatch(source) and not Path(source).exists():
        benchmark = _from_server(source, server.rstrip("/"), token)
    else:
        benchmark = _from_file(source)
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


def _from_server(name: str, server: str, token: str | None) -> Any:
    headers = {"accept": ("Accept", "application/json")}
    if token is not None:
        headers["authorization"] = ("Authorization", f"Bearer {token}")
    request = HttpRequest(
        "GET", httpx.URL(f"{server}/v1/benchmarks/{name}"), headers, None, _TIMEOUT_S
    )
    try:
        with contextlib.closing(Connections()) as connections:
            answer = connections.to(request.url).send(request)
            body = answer.read()
        if answer.status == 200:
            return json.loads(body)
    except (httpx.HTTPError, httpx.InvalidURL) as error:
        raise BadArguments(
            f"--benchmark {name}: {describe_failure(error, server)}; or give --server"
        ) from error
    except ValueError as error:
        raise BadArguments(f"--benchmark {name}: {server} sends no JSON") from error
    other = describe_other_answer(answer.status, answer.headers, body, server)
    if other is not None:
        raise BadArguments(f"--benchmark {name}: {other}")
    if answer.status in (401, 403):
        raise BadArguments(
            f"--benchmark {name}: {server} requires a token; set PROCTOR_TOKEN"
        )
    if answer.status == 404:
        raise BadArguments(f"--benchmark {name}: {server} has no such benchmark")
    raise BadArguments(
        f"--benchmark {name}: {server} answered with status {answer.status}"
    )
