"""A client of GR00T's policy server, for policies given as `gr00t:HOST:PORT`.

As in gr00t 1.6 and 1.7: a request names an endpoint, `get_modality_config`, `reset` or
`get_action`. An observation has the groups video, state and language; each array has a
batch and a time of 1 in front. The answer is a pair: the actions by name, (batch, time,
numbers), and information.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np

from reference_client.errors import BadPolicy, ProctorError, innermost_reason
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.gr00t.npy_messages import (
    BadNpyMessage,
    pack,
    unpack,
)
from reference_client.policies.servers.gr00t.zmq_requester import (
    NotZeroMq,
    ZmqAnswerTimeout,
    ZmqRequester,
)
from reference_client.policies.servers.server_faults import (
    beginning,
    check_answer,
    failed,
    key_of,
    outline,
    without_numbers,
)
from reference_client.policies.servers.server_transport import (
    Silent,
    Unreached,
    first_contact,
    may_have_been_sent,
    past_proxies,
    repeat_until_reached,
    report_answer_read,
    report_request_sent,
)
from reference_client.policies.servers.wire_settings import (
    ANSWER_S,
    FIRST_CONTACT_S,
    LIMIT_OF_ANSWERS,
)
from reference_client.protocol.connection_advice import out_of_files

Answer = TypeVar("Answer")
KEY = "GR00T_API_TOKEN"
GROUPS = ("video", "state", "language")


class Gr00tClient:
    """The server at host:port; connects at the first request.

    GR00T_API_TOKEN of the environment is sent as its API token. answer_s: the limit for
    one answer. first: what the server reads, at the first contact of the run.
    retry_timeout_s: how long an unreachable server is retried.
    """

    def __init__(
        self,
        host: str,
        port: int,
        *,
        answer_s: float = ANSWER_S,
        first: FirstGreeting | None = None,
        retry_timeout_s: float = 60.0,
    ) -> None:
        self._address = (host, port)
        self._place = f"[{host}]:{port}" if ":" in host else f"{host}:{port}"
        self._answer_s = answer_s
        self._retry_timeout_s = retry_timeout_s
        self._first = first or FirstGreeting()
        self._config: Any = None
        self._requester: ZmqRequester | None = None
        self._is_closed = False

    @classmethod
    def connect_to(
        cls,
        address: str,
        keys: Sequence[str],
        *,
        answer_s: float = ANSWER_S,
        first: FirstGreeting | None = None,
    ) -> Gr00tClient:
        """Connected. keys: of the requests that will be sent, such as video.front.

        Raises BadPolicy if the server's policy reads others, ProctorError
        `policy_failed` if no server is there.
        """
        host, port = split_address(address)
        client = cls(host, port, answer_s=answer_s, first=first)
        client._check_keys(keys)
        return client

    def infer(self, request: Mapping[str, Any]) -> dict[str, Any]:
        """The actions by name, (time, numbers).

        request: keys are GROUP.NAME; pictures (height, width, 3), vectors, texts.
        """
        observation: dict[str, dict[str, Any]] = {group: {} for group in GROUPS}
        for key, value in request.items():
            group, _, name = key.partition(".")
            observation[group][name] = _batched(value)
        answer = self._call("get_action", {"observation": observation, "options": None})
        match answer:
            case [dict() as actions, dict()]:
                return {name: _unbatched(array) for name, array in actions.items()}
        refusal = self._failed(
            f"answered get_action without a pair of maps, but with {outline(answer)}"
        )
        raise self.without_numbers(answer, refusal.detail)

    def begin_episode(self, message: Mapping[str, Any] | None) -> None:
        """Its `reset` has no message."""
        assert message is None
        self._call("reset", {"options": None})

    def without_numbers(self, answer: Any, why: str) -> ProctorError:
        return without_numbers(self._place, answer, why, KEY)

    def close(self) -> None:
        """Close the connection; a request in progress fails."""
        self._is_closed = True
        self._drop()

    def _check_keys(self, keys: Sequence[str]) -> None:
        """Every group's names, of one time step each."""
        with first_contact(self._place):
            self._retry(self._ensure_connected, FIRST_CONTACT_S)
        read: set[str] = set()
        try:
            for group in GROUPS:
                modality = self._config[group]
                read |= {f"{group}.{name}" for name in modality["modality_keys"]}
                if len(modality["delta_indices"]) != 1:
                    raise BadPolicy(
                        f"gr00t: the policy reads {len(modality['delta_indices'])} "
                        f"time steps of {group}; a mapping gives one"
                    )
        except (KeyError, TypeError) as error:
            raise self._failed("described no video, state and language") from error
        if read != set(keys):
            raise BadPolicy(
                f"gr00t: the policy reads {', '.join(sorted(read))}; the mapping has "
                f"{', '.join(sorted(keys))}"
            )

    def _call(self, endpoint: str, data: Any) -> Any:
        message = _request(endpoint, data)

        def exchange() -> Any:
            requester = self._ensure_connected()
            report_request_sent(self._place, len(message))
            answer = requester.request(message)
            report_answer_read(self._place, len(answer))
            return self._read(answer)

        return self._retry(exchange, self._retry_timeout_s)

    def _ensure_connected(self) -> ZmqRequester:
        """Asks on every connection for the names that the policy reads: they stay."""
        if self._requester is None:
            question = _request("get_modality_config", None)
            self._requester = ZmqRequester(*self._address, answer_s=self._answer_s)
            self._config = self._read(self._requester.request(question))
            self._first.check(self._place, self._config)
        return self._requester

    def _retry(self, attempt: Callable[[], Answer], retry_timeout_s: float) -> Answer:
        def try_once() -> Answer:
            try:
                return attempt()
            except ProctorError:
                self._drop()
                raise
            except NotZeroMq as error:
                self._drop()
                raise self._failed(str(error)) from error
            except (ZmqAnswerTimeout, OSError) as error:
                self._drop()
                if self._is_closed:
                    raise self._failed("was left") from error
                raise self._fault_of(error) from error

        return repeat_until_reached(try_once, self._place, retry_timeout_s)

    def _fault_of(self, error: ZmqAnswerTimeout | OSError) -> Exception:
        if isinstance(error, ZmqAnswerTimeout):
            return Silent(
                f"did not answer within {self._answer_s:g} s; {LIMIT_OF_ANSWERS}"
            )
        if (text := out_of_files(error)) is not None:
            return Unreached(f"was not reached: {text}", was_sent=False)
        way = past_proxies(self._place)
        return Unreached(
            f"is unreachable ({innermost_reason(error)}{way})",
            was_sent=may_have_been_sent(error),
        )

    def _read(self, message: bytes) -> Any:
        if message == b"ERROR":
            raise self._failed("failed; its own log has the reason")
        try:
            answer = unpack(message)
        except BadNpyMessage as error:
            what = f"sent a message that {error}; {beginning(message)}"
            raise self._failed(what) from error
        check_answer(self._place, answer, KEY)
        return answer

    def _drop(self) -> None:
        if self._requester is not None:
            self._requester.close()
            self._requester = None

    def _failed(self, what: str) -> ProctorError:
        return failed(self._place, what)


def _request(endpoint: str, data: Any) -> bytes:
    """data: None for an endpoint without any."""
    request = {"endpoint": endpoint} | ({} if data is None else {"data": data})
    token = key_of(KEY)
    return pack(request | ({"api_token": token} if token else {}))


def split_address(address: str) -> tuple[str, int]:
    """HOST:PORT, or [IPv6]:PORT. Raises BadPolicy."""
    host, _, port = address.rpartition(":")
    if host and port.isascii() and port.isdigit() and int(port) < 65536:
        return host.removeprefix("[").removesuffix("]"), int(port)
    raise BadPolicy(
        f"gr00t: takes an address like gr00t:127.0.0.1:5555, not {address!r}"
    )


def check_keys(keys: Sequence[str]) -> None:
    """Raises BadPolicy unless each is GROUP.NAME."""
    for key in keys:
        group, _, name = key.partition(".")
        if group not in GROUPS or not name:
            raise BadPolicy(
                "gr00t: keys of [observation] are video.NAME, state.NAME, "
                f"language.NAME; not {key!r}"
            )


def _batched(value: Any) -> Any:
    """A batch of one, of one time step."""
    return [[value]] if isinstance(value, str) else np.asarray(value)[None, None]


def _unbatched(value: Any) -> Any:
    """Without a batch of one; the mapping refuses one of several."""
    is_batch = isinstance(value, np.ndarray) and value.ndim == 3 and len(value) == 1
    return value[0] if is_batch else value
