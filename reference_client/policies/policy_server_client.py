"""A policy server of policy.yaml, asked by this client: `proctor:http://host:8470`.

The turns of the evaluation server go to it as they came, and its actions go back: the
same bodies in both directions. A call that was not answered is made again with the same
body, which such a server answers as before.
"""

from __future__ import annotations

import os
import time
from typing import Any

import msgspec
import urllib3
from proctor_client import Benchmark

from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk
from reference_client.errors import POLICY_FAILED, ProctorError

PAUSE_S = 0.2
FIRST_CONTACT_S = 3.0  # a mistyped URL is told before there is a run
CALL_S = 600.0  # the first answer may take minutes, while a network is compiled
_RETRY_STATUSES = (429, 500, 502, 503, 504)


class PolicyServerClient:
    """Makes a policy for each worker: a session with the server at `url`.

    PROCTOR_POLICY_KEY of the environment is sent as its key. retry_timeout_s: how long a
    server is waited for that is not there.
    """

    def __init__(self, url: str, *, retry_timeout_s: float = 60.0) -> None:
        self._url = url.rstrip("/")
        self._retry_timeout_s = retry_timeout_s
        self._pool = urllib3.PoolManager(maxsize=64, retries=False)
        self._benchmark: dict[str, Any] | None = None

    def check(self, benchmark: Benchmark) -> None:
        """Take note of what is played. Raises ProctorError if no server is there."""
        self._benchmark = benchmark.to_dict()
        reported = self.call("GET", "", None, FIRST_CONTACT_S)
        session_limit = reported.get("max_sessions")
        if not isinstance(session_limit, int) or session_limit < 1:
            raise self.failed("does not describe itself as policy.yaml says")

    def __call__(self) -> PolicySession:
        if self._benchmark is None:
            raise self.failed("was not told which benchmark is played")
        return PolicySession(self, self._benchmark)

    def post(self, operation: str, body: Any) -> Any:
        """The answer to an operation. Raises ProctorError `policy_failed`."""
        content = msgspec.json.encode(body)
        return self.call("POST", f"/{operation}", content, self._retry_timeout_s)

    def call(
        self, method: str, path: str, content: bytes | None, retry_timeout_s: float
    ) -> Any:
        """One call, made again while nobody answers or the server asks for that."""
        deadline = time.monotonic() + retry_timeout_s
        while True:
            try:
                answer = self._pool.request(
                    method,
                    f"{self._url}/v1/policy{path}",
                    body=content,
                    headers=_headers(content),
                    timeout=urllib3.Timeout(connect=5.0, read=CALL_S),
                    redirect=False,
                )
            except urllib3.exceptions.HTTPError as error:
                last = f"does not answer ({error})"
            else:
                if answer.status == 200:
                    return self._read(answer.data)
                last = f"answered with status {answer.status}{_detail(answer.data)}"
                if answer.status not in _RETRY_STATUSES:
                    raise self.failed(last)
            if time.monotonic() > deadline:
                raise self.failed(last)
            time.sleep(PAUSE_S)

    def _read(self, data: bytes) -> Any:
        try:
            value = msgspec.json.decode(data)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            raise self.failed(f"answered what is no JSON ({error})") from error
        if not isinstance(value, dict):
            raise self.failed("answered what is no object")
        return value

    def failed(self, what: str) -> ProctorError:
        return ProctorError(POLICY_FAILED, f"The policy server at {self._url} {what}.")


class PolicySession:
    """The policy of one worker; its sessions are those of the evaluation server."""

    def __init__(self, server: PolicyServerClient, benchmark: dict[str, Any]) -> None:
        self._server = server
        self._benchmark = benchmark
        self._is_new = True

    def reset(self, instruction: str) -> None:
        self._is_new = True  # its turn tells more than its instruction

    def act(self, observation: Observation) -> Chunk:
        turn = observation.turn
        assert turn is not None, "what a worker plays came in a turn"
        if self._is_new:
            self._reset(turn)
            self._is_new = False
        answer = self._server.post("predict", turn)
        reported = (answer.get("session_id"), answer.get("seq"))
        if reported != (turn.session_id, turn.seq + 1):
            raise self._server.failed("answered another turn than it was asked for")
        try:
            return [action["values"] for action in answer["actions"]]
        except (KeyError, TypeError) as error:
            raise self._server.failed("answered without actions") from error

    def _reset(self, turn: Any) -> None:
        body = {
            "session_id": turn.session_id,
            "benchmark": self._benchmark,
            "episode": turn.episode,
        }
        ready = self._server.post("reset", body)
        reported = tuple(ready.get(n) for n in ("session_id", "episode_id", "attempt"))
        episode = turn.episode
        if reported != (turn.session_id, episode.episode_id, episode.attempt):
            raise self._server.failed("acknowledged another reset than it was sent")


def _headers(content: bytes | None) -> dict[str, str]:
    headers = {"Accept": "application/json"}
    if content is not None:
        headers["Content-Type"] = "application/json"
    key = os.environ.get("PROCTOR_POLICY_KEY")
    return headers | ({"Authorization": f"Bearer {key}"} if key else {})


def _detail(data: bytes) -> str:
    """What a problem says, for the policy's author."""
    try:
        problem = msgspec.json.decode(data[:65536])
    except (msgspec.DecodeError, UnicodeDecodeError):
        return ""
    detail = problem.get("detail") if isinstance(problem, dict) else None
    return f" ({detail[:300]})" if isinstance(detail, str) else ""
