"""A client of policy.yaml, for policies given as `proctor:http://host:8470`.

Turns of the evaluation server are forwarded unchanged, and the actions are returned. A
request without a response is repeated with the same body, which the policy server
answers as before, without executing it again.
"""

from __future__ import annotations

import functools
from typing import Any

import msgspec
import urllib3
from proctor_client import Assumptions, Benchmark
from proctor_client.transport.fault_texts import is_of_proctor

from reference_client.api.assumed_conventions import check_assumptions
from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk
from reference_client.errors import ProctorError
from reference_client.policies.servers.bounded_answers import HttpAnswer
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.http_policy_client import (
    FIRST_ANSWER_S,
    KEY,
    RETRY_STATUSES,
    request_once,
    wrong_server,
)
from reference_client.policies.servers.server_faults import (
    beginning,
    failed,
    key_of,
)
from reference_client.policies.servers.server_transport import (
    Unreached,
    first_contact,
    http_connections,
    in_its_place,
    repeat_until_reached,
)
from reference_client.policies.servers.wire_settings import ANSWER_S, FIRST_CONTACT_S
from reference_record.texts.shortened_text import shortened

# Members of describe_policy that say which policy it is.
_OF_POLICY = ("name", "version", "assumes")
_DETAIL_CHARS_MAX = 700


class PolicyServerClient:
    """Makes a policy for each worker: a session with the server at `url`.

    PROCTOR_POLICY_KEY of the environment is sent as bearer token. retry_timeout_s: how
    long an unreachable server is retried.
    """

    def __init__(self, url: str, *, retry_timeout_s: float = 60.0) -> None:
        self._url = url.rstrip("/")
        self._retry_timeout_s = retry_timeout_s
        self._benchmark: dict[str, Any] | None = None
        self._description: dict[str, Any] | None = None
        self._first = FirstGreeting()

    @functools.cached_property
    def _pool(self) -> urllib3.PoolManager:
        return http_connections(self._url, maxsize=64)

    def check(self, benchmark: Benchmark) -> None:
        """Set the benchmark. Raises ProctorError if the server is unreachable."""
        self._benchmark = benchmark.to_dict()
        with first_contact(self._url):
            self._description = self._describe(FIRST_CONTACT_S)  # it may have ended
        self._first = FirstGreeting()
        self._check_policy()
        reported = self._description
        session_limit = reported.get("max_sessions")
        if not isinstance(session_limit, int) or session_limit < 1:
            raise self.failed("violates the schema of describe_policy in policy.yaml")
        if (assumes := reported.get("assumes")) is not None:
            try:
                document = Assumptions.from_dict(assumes).to_dict()
            except ValueError as error:
                raise self.failed(f"assumes what no schema has: {error}") from error
            check_assumptions(document, self._benchmark)

    def check_again(self) -> None:
        """Raises ProctorError if another policy than at first answers there now."""
        self._description = self._describe(self._retry_timeout_s)
        self._check_policy()

    def _check_policy(self) -> None:
        said = self._description or {}
        members = {name: said[name] for name in _OF_POLICY if name in said}
        self._first.check(self._url, members)

    def described_name(self, retry_timeout_s: float = FIRST_CONTACT_S) -> str | None:
        """The name in describe_policy. Raises ProctorError without an answer."""
        if self._description is None:
            self._description = self._describe(retry_timeout_s)
        name = self._description.get("name")
        return name if isinstance(name, str) and name else None

    def _describe(self, retry_timeout_s: float) -> dict[str, Any]:
        description: dict[str, Any] = self.call("GET", "", None, retry_timeout_s)
        return description

    def __call__(self) -> PolicySession:
        if self._benchmark is None:
            raise self.failed("has no benchmark yet")
        return PolicySession(self, self._benchmark)

    def post(self, operation: str, body: Any) -> Any:
        """The response of an operation. Raises ProctorError `policy_failed`."""
        content = msgspec.json.encode(body)
        return self.call("POST", f"/{operation}", content, self._retry_timeout_s)

    def call(
        self, method: str, path: str, content: bytes | None, retry_timeout_s: float
    ) -> Any:
        """One request, repeated without a response and on retryable statuses."""
        answer_s = FIRST_ANSWER_S if content is None else ANSWER_S
        url = f"{self._url}/v1/policy{path}"

        def attempt() -> HttpAnswer:
            answer = request_once(
                self._pool,
                method,
                url,
                content=content,
                headers=_headers(content),
                answer_s=answer_s,
            )
            if answer.status == 200:
                return answer
            what = wrong_server(url, answer) or (
                f"answered with status {answer.status}{_detail(answer)}"
                f"{_in_its_place(url, answer)}"
            )
            # POL-006: a policy with a state failed, and is not called again.
            is_final = answer.status == 500 and content is not None
            if answer.status not in (500, *RETRY_STATUSES) or is_final:
                raise self.failed(what)
            raise Unreached(what)

        answer = repeat_until_reached(
            attempt, self._url, retry_timeout_s, is_counted_once=True
        )
        return self._read(url, answer)

    def _read(self, url: str, answer: HttpAnswer) -> Any:
        shown = beginning(answer.data, answer.media_type)
        way = f"; {shown}{_in_its_place(url, answer)}"
        try:
            value = msgspec.json.decode(answer.data)
        except (msgspec.DecodeError, UnicodeDecodeError) as error:
            raise self.failed(f"sent invalid JSON ({error}){way}") from error
        if not isinstance(value, dict):
            raise self.failed(f"sent JSON that is not an object{way}")
        return value

    def failed(self, what: str) -> ProctorError:
        return failed(self._url, what)


class PolicySession:
    """The policy of one worker; sessions have the ids of the evaluation server."""

    def __init__(self, server: PolicyServerClient, benchmark: dict[str, Any]) -> None:
        self._server = server
        self._benchmark = benchmark
        self._is_new = True

    def reset(self, instruction: str) -> None:
        self._is_new = True  # reset needs the turn, which `act` receives

    def act(self, observation: Observation) -> Chunk:
        turn = observation.turn
        assert turn is not None, "observations of a worker have a turn"
        if self._is_new:
            self._server.check_again()  # before each episode: it may be another one
            self._reset(turn)
            self._is_new = False
        answer = self._server.post("predict", turn)
        reported = (answer.get("session_id"), answer.get("seq"))
        if reported != (turn.session_id, turn.seq + 1):
            raise self._server.failed("answered with a wrong session_id or seq")
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
            raise self._server.failed("acknowledged a wrong reset")


def _headers(content: bytes | None) -> dict[str, str]:
    headers = {"Accept": "application/json"}
    if content is not None:
        headers["Content-Type"] = "application/json"
    key = key_of(KEY)
    return headers | ({"Authorization": f"Bearer {key}"} if key else {})


def _in_its_place(url: str, answer: HttpAnswer) -> str:
    return "" if is_of_proctor(answer.headers) else in_its_place(url)


def _detail(answer: HttpAnswer) -> str:
    """The detail of a problem document, for the policy's author; else the beginning."""
    try:
        problem = msgspec.json.decode(answer.data[:65536])
    except (msgspec.DecodeError, UnicodeDecodeError):
        problem = None
    detail = problem.get("detail") if isinstance(problem, dict) else None
    if not isinstance(detail, str):
        detail = beginning(answer.data, answer.media_type)
    return f" ({shortened(detail, _DETAIL_CHARS_MAX)})"
