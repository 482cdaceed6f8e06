"""Requests of one check: accounts, operations by id, the log and the universal rules.

Knows nothing of runs and workers; these build on it (run_client.py) and are opened by
CheckContext (check_context.py).
"""

import contextlib
import dataclasses
import functools
import math
import random
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import Any
from urllib.parse import quote

import httpx
import msgspec

from conformance.client.adaptive_timeouts import AdaptiveTimeouts
from conformance.client.base_urls import BaseUrls
from conformance.client.cleanup_requests import cleanup_after
from conformance.client.connections.connection_pool import ConnectionPool
from conformance.client.exchange_log import ExchangeLog
from conformance.client.http_client import HttpClient, NoAnswer
from conformance.client.own_causes import OwnCauses
from conformance.exchanges.answer import Answer
from conformance.oracle import calibration_benchmark
from conformance.oracle.history.service_history import ServiceHistory
from conformance.run_settings import Settings
from conformance.specification.document import (
    MSGPACK,
    ZIP,
    Operation,
    Spec,
    load_policy_spec,
    load_spec,
)
from conformance.specification.ledger import POLICY
from conformance.specification.profile_fields import profile_of_task, profiles_used
from conformance.verdicts.coverage import Coverage
from conformance.verdicts.exchange_judge import (
    ExchangeJudge,
    judged_rules,
    new_history,
)
from conformance.verdicts.expect import SetUpFailed, describe_answer, require
from conformance.verdicts.universal_rules import Tally

ENDED = ("completed", "failed", "stopped")
_NO_CAPACITY = "no_capacity"
_RETRIED_CODES = (_NO_CAPACITY, "unavailable")
_CAPACITY_TIMEOUT_S = 5.0
_CAPACITY_POLL_S = 0.1
_ROUND_TRIPS = 12
_ROUND_TRIP_TIMEOUT_S = 10.0
_STALL_POLL_S = 0.1
# The tolerance of timing checks, in round trips.
TOLERANCE_ROUND_TRIPS = 20
# A request surely uses all but a tenth of a lease of so many tolerances. Checks wait
# for up to five leases, and are given up after three minutes.
_LEASE_TOLERANCES = 8
_LONGEST_LEASE_S = 30.0
LONGEST_QUEUE_S = 10  # the most that the option queue_s allows
# A run waits in the queue for the time of so many answers: a submit, a stop, a resume
# and a stop are the most that a check sends meanwhile.
_QUEUE_ANSWERS, _OF_QUEUE = 4, ("/runs", "/stop", "/resume")


@dataclass(frozen=True)
class SharedContext:
    """The parts that all checks of one process share."""

    settings: Settings
    connections: ConnectionPool
    spec: Spec
    timeouts: AdaptiveTimeouts = field(default_factory=AdaptiveTimeouts)
    # name → something that one check made for others, as a run that is long to play.
    stored: dict[str, Any] = field(default_factory=dict)
    # The last requests that a server took and did not answer.
    unanswered: deque[str] = field(default_factory=partial(deque, maxlen=3))

    @functools.cached_property
    def history(self) -> ServiceHistory:
        """The history of all exchanges with the server under test."""
        return new_history(self.spec, self.settings)

    @functools.cached_property
    def judged_rules(self) -> frozenset[str]:
        """The rules that may be violated."""
        return judged_rules(self.settings)

    @classmethod
    def of(cls, settings: Settings) -> "SharedContext":
        """Open the connections for one run of the kit."""
        is_policy = settings.profiles == [POLICY]
        spec = load_policy_spec() if is_policy else load_spec()
        return cls(settings, ConnectionPool(), spec)

    def close(self) -> None:
        """Close the connections."""
        self.connections.close()


class RequestContext:
    """Sends any operation with any account, for one check."""

    def __init__(
        self,
        shared: SharedContext,
        name: str,
        base_url: str | None = None,
        parent: "RequestContext | None" = None,
        round_number: int = 0,
    ) -> None:
        """Open it; round_number: of a check that is played again, with others."""
        self.shared = shared
        self.name = name
        self.spec = shared.spec
        self.service: dict[str, Any] = shared.settings.service
        self.limits: dict[str, Any] = self.service.get("limits", {})
        self.benchmark: dict[str, Any] = shared.settings.benchmark
        self.tolerance_s = shared.settings.tolerance_s
        self.exchange_log: ExchangeLog = (
            parent.exchange_log if parent else ExchangeLog(name, round_number)
        )
        self.round_number: int = parent.round_number if parent else round_number
        self.tally: Tally = parent.tally if parent else Tally(shared.spec)
        self.coverage: Coverage = parent.coverage if parent else Coverage()
        history = new_history(shared.spec, shared.settings) if base_url else None
        self.judge = ExchangeJudge(
            self.tally,
            history or shared.history,
            shared.judged_rules,
            self.exchange_log,
        )
        longest_s = self.limits.get("heartbeat_s_max", math.inf)
        own_causes = parent.own_causes if parent else OwnCauses(longest_s)
        self.own_causes: OwnCauses = own_causes
        self.random = random.Random()
        self.exchange_log.way_faults.has_way = shared.settings.start_cmd is None
        self._seed()
        # Another server than the one that is judged is reached at this URL alone.
        urls = (base_url,) if base_url else shared.settings.urls
        self._base_urls = BaseUrls(tuple(urls), seed=shared.settings.seed)
        self._clean_ups: list[Callable[[], object]] = []
        self.adopted: set[str] = set()  # runs that their clients stop
        self._ended: set[str | None] = set()  # runs that were shown so, and the deleted
        self._resumed: set[str | None] = set()
        # Token and id of each run on the server under test.
        self.submitted: list[tuple[str | None, str]] = []
        # Kind and name of what else a check leaves at a service.
        self.left: list[tuple[str, str]] = []
        self._is_under_test = base_url is None
        self.http_client = self._open_client(shared.settings.token, "TOKEN")

    def begin_try(self) -> None:
        """Begin the check, or begin it again: the same seed gives the same requests."""
        self._seed()
        self.exchange_log.way_faults.begin_try()

    def _seed(self) -> None:
        again = f"/{self.round_number}" if self.round_number else ""
        self.random.seed(f"{self.shared.settings.seed}/{self.name}{again}")

    def _open_client(
        self,
        token: str | None,
        name: str,
        connections: ConnectionPool | None = None,
        pinned: int | None = None,
    ) -> HttpClient:
        return HttpClient(
            connections=connections or self.shared.connections,
            spec=self.spec,
            base_urls=dataclasses.replace(self._base_urls, pinned=pinned),
            token=token,
            token_name=name,
            exchange_log=self.exchange_log,
            judge=self.judge,
        )

    @contextlib.contextmanager
    def own_connection(self) -> Iterator[HttpClient]:
        """Give a client that sends its requests one by one over one connection."""
        token = self.shared.settings.token
        with contextlib.closing(ConnectionPool()) as connections:
            yield self._open_client(token, "TOKEN", connections, pinned=0)

    @property
    def clients_by_url(self) -> list[HttpClient]:
        """A client for each base URL of the service, which sends all requests to it."""
        token, places = self.shared.settings.token, range(len(self._base_urls.urls))
        return [self._open_client(token, "TOKEN", pinned=place) for place in places]

    @property
    def speaks_msgpack(self) -> bool:
        """Whether the server announces the profile msgpack."""
        return self.offers("msgpack")

    def offers(self, profile: str) -> bool:
        """Whether the server offers a profile."""
        return self.shared.settings.is_offered(profile)

    def serves(self, operation_id: str) -> bool:
        """Whether the server has an operation at its stage, by what it announces."""
        profile = self.spec.operations[operation_id].profile
        return self.offers(profile) and self.shared.settings.is_served(operation_id)

    def tasks(self, *wanted: str) -> list[str]:
        """Those of these tasks of calibration that the server offers."""
        return [task for task in wanted if self.offers(profile_of_task(task))]

    def worker_count(self, most: int) -> int:
        """How many workers may play a run at a time, at most `most`."""
        return min(most, self.limits["max_workers"]) if self.offers("sessions") else 1

    def client_with_token(self, token: str | None) -> HttpClient:
        """Give a client with any token, or without one."""
        return self._open_client(token, "WRONG_TOKEN")

    @property
    def second_account(self) -> HttpClient:
        """A client with the token of another account."""
        token = self.shared.settings.token_2
        if token is None:
            raise SetUpFailed(
                "no token of a second account (PROCTOR_TOKEN_2)", allowed=True
            )
        return self._open_client(token, "TOKEN_2")

    @property
    def read_only_account(self) -> HttpClient:
        """A client with the read-only token of the first account."""
        token = self.shared.settings.token_read
        if token is None:
            raise SetUpFailed(
                "no token with the scope read only (PROCTOR_TOKEN_READ)", allowed=True
            )
        return self._open_client(token, "TOKEN_READ")

    def call(
        self,
        operation_id: str,
        *,
        json: Any = None,
        content: Any = None,
        http_client: HttpClient | None = None,
        headers: Mapping[str, str] | None = None,
        params: Mapping[str, Any] | None = None,
        msgpack: bool = False,
        timeout_s: float = 30.0,
        leave_after_s: float | None = None,
        endpoint: str | None = None,
        **path_params: str,
    ) -> Answer:
        """Send an operation by its id; the answer is raw.

        leave_after_s: as of `HttpClient.request`. Further keywords fill the path.
        `msgpack` sends `json` as MessagePack and accepts nothing else. An entry or an
        import that is made is taken back after the check.
        """
        operation = self.spec.operations[operation_id]
        self._require_offered(operation, json)
        sent, run_id = json, path_params.get("run_id")
        http_client = http_client or self.http_client
        path = operation.path.format(
            **{name: quote(value, safe="") for name, value in path_params.items()}
        )
        base_url = http_client.base_url
        if operation.is_data_plane and endpoint is not None:
            base_url = endpoint.rstrip("/")
        if msgpack:
            content, json = msgspec.msgpack.encode(json), None
            headers = {"Content-Type": MSGPACK, "Accept": MSGPACK, **(headers or {})}
        if content is not None and operation.request_media_types() == [ZIP]:
            headers = {"Content-Type": ZIP, **(headers or {})}
        send = partial(
            http_client.request,
            operation.method,
            base_url + path,
            json=json,
            content=content,
            headers=headers,
            params=params,
            operation=operation,
        )
        if leave_after_s is None:
            send = partial(self._send_with_limit, operation_id, send, timeout_s)
        else:
            send = partial(send, leave_after_s=leave_after_s)
        try:
            answer = self._retry_while_no_capacity(send)
        except KeyboardInterrupt:  # it may have reached the server
            if operation_id == "publish_entry":
                withdraw = partial(self.call, "withdraw_entry", http_client=http_client)
                self.clean_up_with(partial(withdraw, **path_params))
            raise
        self.coverage.note(operation_id, run_id)
        self.own_causes.note(operation_id, sent, run_id, answer)
        self._note_end(operation_id, run_id, answer)
        if cleanup := cleanup_after(operation_id, answer, path_params):
            name, where = cleanup
            if operation_id == "submit_run" and self._is_under_test:
                self.submitted.append((http_client.token, where["run_id"]))
            if operation_id == "publish_entry":
                self.left.append(("entry", where["run_id"]))
            step = partial(self.call, name, http_client=http_client, **where)
            self.clean_up_with(partial(self._take_back, name, where, step))
        return answer

    def _note_end(self, operation_id: str, run_id: str | None, answer: Answer) -> None:
        shown = answer.json if isinstance(answer.json, dict) else {}
        if operation_id == "resume_run":
            self._resumed.add(run_id)
        is_deleted = operation_id == "delete_run" and answer.status == 204
        if is_deleted or (answer.status < 300 and shown.get("state") in ENDED):
            self._ended.add(run_id or str(shown.get("run_id")))

    def has_ended(self, run_id: str) -> bool:
        """Whether a run holds no simulator for good: it has ended, and stays so."""
        return run_id in self._ended and run_id not in self._resumed

    def _require_offered(self, operation: Operation, body: Any) -> None:
        """Send nothing of a profile that the server does not announce.

        A check that needs it leaves its rule not verified.
        """
        used = [(operation.operation_id, operation.profile)]
        if isinstance(body, dict):
            used += profiles_used(operation.operation_id, body)
        for what, profile in used:
            if not self.offers(profile):
                text = f"the check uses `{what}`, of the profile {profile}, "
                raise SetUpFailed(f"{text}which is not announced", allowed=True)

    def _send_with_limit(
        self, operation_id: str, send: Callable[..., Answer], timeout_s: float
    ) -> Answer:
        """Send once; wait less after an operation has twice in a row not answered."""
        timeouts = self.shared.timeouts
        waited_s = timeouts.of_answer(operation_id, timeout_s)
        try:
            answer = send(timeout_s=waited_s)
        except NoAnswer as error:
            if not isinstance(error.__cause__, httpx.ConnectError):
                sent = (
                    f"`{operation_id}` (X-Correlation-Id {self.name}/{error.exchange})"
                )
                self.shared.unanswered.append(sent)
            if isinstance(error.__cause__, httpx.TimeoutException):
                timeouts.record_miss(operation_id)
                if waited_s < timeout_s:
                    text = f"`{operation_id}` has not answered in time more than once"
                    raise SetUpFailed(
                        f"{text}: {error.observed}", exchange=error.exchange
                    ) from error
            raise
        timeouts.record_answer(operation_id)
        return answer

    def _retry_while_no_capacity(self, send: Callable[[], Answer]) -> Answer:
        """Repeat while the server has no capacity, as every client must; then give up.

        A server without capacity neither violates a rule nor shows that it obeys one.
        """
        timeouts = self.shared.timeouts
        until = time.monotonic() + timeouts.of("capacity", _CAPACITY_TIMEOUT_S)
        while (answer := send()).code in _RETRIED_CODES:
            if time.monotonic() > until:
                timeouts.record_miss("capacity")
                if answer.code == _NO_CAPACITY:
                    raise SetUpFailed(
                        f"server has no capacity: {describe_answer(answer)}"
                    )
                return answer
            time.sleep(_CAPACITY_POLL_S)
        return answer

    def require(self, step: Callable[[], Answer], status: int, name: str) -> Any:
        """Take a set-up step and give its body; its failure is a SetUpFailed."""
        try:
            return require(step(), status, f"`{name}`")
        except NoAnswer as error:
            text = f"`{name}`: no response: {error.observed}"
            raise SetUpFailed(text, exchange=error.exchange) from error

    @staticmethod
    def submit_body(**members: Any) -> dict[str, Any]:
        """Give a body for submit_run; members that are None are left out."""
        body = {"benchmark_id": "calibration", "policy": {"name": "conformance kit"}}
        return body | {k: v for k, v in members.items() if v is not None}

    @staticmethod
    def action(**values: Any) -> dict[str, Any]:
        """Give an action of calibration; omitted names are zero."""
        return calibration_benchmark.action(**values)

    @staticmethod
    def call_concurrently(*thunks: Callable[[], Any]) -> list[Any]:
        """Call all at the same time, each in its thread; results in their order."""
        barrier = threading.Barrier(len(thunks))
        results: list[Any] = [None] * len(thunks)
        errors: list[BaseException] = []

        def call(index: int, thunk: Callable[[], Any]) -> None:
            barrier.wait()
            try:
                results[index] = thunk()
            except BaseException as error:  # noqa: BLE001 - handed to the caller
                errors.append(error)

        threads = [
            threading.Thread(target=call, args=pair, daemon=True)
            for pair in enumerate(thunks)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if errors:
            raise errors[0]
        return results

    def begin_restart(self) -> float:
        """Note that the kit kills the server from now on; gives the time."""
        self.exchange_log.way_faults.is_restarting = True
        return self.judge.history.begin_restart()

    def end_restart(self, began_at: float) -> None:
        """Note that it serves again."""
        self.judge.history.end_restart(began_at)
        self.exchange_log.way_faults.is_restarting = False

    @property
    def least_lease_s(self) -> float:
        """The shortest lease that suits the times to answer, in seconds."""
        return min(_LEASE_TOLERANCES * self.tolerance_s, _LONGEST_LEASE_S)

    def choose_queue_s(self, least_s: float) -> float:
        """Give how long a run shall wait in the queue for the check to see it there.

        Longer where this check, in an earlier try, was answered late.
        """
        took_s = [
            exchange.elapsed_s
            for exchange in self.exchange_log.exchanges
            if exchange.method == "POST" and exchange.url.endswith(_OF_QUEUE)
        ]
        late_s = _QUEUE_ANSWERS * max(took_s, default=0.0)
        return min(LONGEST_QUEUE_S, max(least_s, late_s))

    def measure_noise(self) -> float:
        """Measure the round trip again, and derive the tolerance from it.

        Gives by how much it varies, in seconds: much on a machine that is busy.
        """
        round_trips = sorted(self._measure_round_trip() for _ in range(_ROUND_TRIPS))
        longest_s = round_trips[-1]
        self.tolerance_s = max(self.tolerance_s, TOLERANCE_ROUND_TRIPS * longest_s)
        return longest_s - round_trips[_ROUND_TRIPS // 2]

    @contextlib.contextmanager
    def watch_for_stalls(self) -> Iterator[list[float]]:
        """Ask for something cheap again and again, in a thread, until the block ends.

        Gives a list, which holds then how long each answer took, in seconds: for how
        long the server, this machine or the kit did nothing at all.
        """
        took_s: list[float] = []
        is_over = threading.Event()

        def measure() -> None:
            while not is_over.is_set():
                began_at = time.monotonic()
                self._measure_round_trip()
                is_over.wait(_STALL_POLL_S)
                took_s.append(time.monotonic() - began_at - _STALL_POLL_S)

        thread = threading.Thread(target=measure, daemon=True)
        thread.start()
        try:
            yield took_s
        finally:
            is_over.set()
            thread.join()

    def _measure_round_trip(self) -> float:
        began_at = time.monotonic()
        with (
            contextlib.suppress(httpx.RequestError),
            self.shared.connections.borrow() as connections,
        ):
            connections.get(f"{self._base_urls.first}/v1", _ROUND_TRIP_TIMEOUT_S)
        return time.monotonic() - began_at

    def _take_back(
        self, operation_id: str, where: Mapping[str, Any], step: Callable[[], object]
    ) -> None:
        """Take the step, unless the client of an adopted run takes it (clean_up)."""
        run_id = where.get("run_id", "")
        is_needless = run_id in self.adopted or self.has_ended(run_id)
        if not (operation_id == "stop_run" and is_needless):
            step()

    def clean_up_with(self, step: Callable[[], object]) -> None:
        """Take a step when the check has ended."""
        self._clean_ups.append(step)

    def tidy_up(self) -> None:
        """Stop the runs of this check, so that they hold no simulator; best effort.

        A wrong answer may break a step here; the check itself has judged it before.
        """
        while self._clean_ups:
            step = self._clean_ups.pop()
            try:
                with contextlib.suppress(Exception):
                    step()
            except KeyboardInterrupt:
                self._clean_ups.append(step)  # it may not have reached the server
                raise
