"""The benchmark that a policy server is judged on: a file, or a name and a server.

The evaluation server describes the benchmark; nothing is played on it.
"""

import json
import re
from pathlib import Path
from typing import Any

import httpx

from conformance.cli.arguments import BadArguments
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
        return json.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise BadArguments(f"--benchmark {path}: {error}") from error


def _from_server(name: str, server: str, token: str | None) -> Any:
    headers = {} if token is None else {"Authorization": f"Bearer {token}"}
    url = f"{server}/v1/benchmarks/{name}"
    try:
        answer = httpx.get(url, headers=headers, timeout=_TIMEOUT_S)
        if answer.status_code == 200:
            return answer.json()
    except (httpx.HTTPError, httpx.InvalidURL, ValueError) as error:
        raise BadArguments(
            f"--benchmark {name}: no description from {server} ({error}); start the "
            "evaluation server, or give --server"
        ) from error
    if answer.status_code in (401, 403):
        raise BadArguments(
            f"--benchmark {name}: {server} requires a token; set PROCTOR_TOKEN"
        )
    if answer.status_code == 404:
        raise BadArguments(f"--benchmark {name}: {server} has no such benchmark")
    raise BadArguments(
        f"--benchmark {name}: {server} answered with status {answer.status_code}"
    )
