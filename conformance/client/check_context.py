"""What a check gets: one server, the accounts it was given, and verbs to tell a story.

    @requirement("ATT-003")
    def test_att_003_cannot_attach_with_another_key_on_a_live_worker(story):
        \"\"\"Another key on a live worker. Expect worker_busy.\"\"\"
        worker = story.submit("count").worker()
        worker.attach()
        expect.refused(worker.try_attach(), "worker_busy")
        expect.ok(worker.try_predict(story.action()))

A story is cheap, belongs to one check, and may be used from several threads.
"""

import contextlib
import random
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any
from urllib.parse import quote

import msgspec

from conformance.cli.settings import Settings
from conformance.client.exchange_log import Journal
from conformance.client.http_client import Answer, ClientPool, NoAnswer, Wire
from conformance.client.run_client import Patience, Run, Worker
from conformance.specification.document import (
    MSGPACK,
    Spec,
    load_policy_spec,
    load_spec,
)
from conformance.specification.ledger import NEVER_ANNOUNCED, POLICY
from conformance.verdicts.expect import KitError, SetUpFailed, given, told
from conformance.verdicts.universal_rules import Tally

if TYPE_CHECKING:
    from conformance.runner.private_server import PrivateServer

__all__ = ["Context", "Run", "Story", "Worker"]

_NO_ROOM = "no_capacity"
_COME_BACK = (_NO_ROOM, "unavailable")
_ROOM_S = 5.0
_ROOM_POLL_S = 0.1
# Capacity may have to be made first: a simulator started, a robot freed.
_READY_S = 30.0
# Name → size, from calibration.md.
ACTION_SIZES = {
    "score": 1,
    "success": 1,
    "end": 1,
    "delay_s": 1,
    "fault": 1,
    "vector": 8,
    "clipped": 2,
}


@dataclass(frozen=True)
class Context:
    """What all stories of one process share."""

    settings: Settings
    clients: ClientPool
    spec: Spec
    patience: Patience = field(default_factory=Patience)

    @classmethod
    def of(cls, settings: Settings) -> "Context":
        """Open the connections for one run of the kit."""
        is_policy = settings.profiles == [POLICY]
        spec = load_policy_spec() if is_policy else load_spec()
        return cls(settings, ClientPool(settings.url), spec)

    def close(self) -> None:
        """Close the connections."""
        self.clients.close()


class Story:
    """One check's view of the server."""

    def __init__(
        self,
        context: Context,
        name: str,
        base_url: str | None = None,
        teller: "Story | None" = None,
    ) -> None:
        self.context = context
        self.name = name
        self.spec = context.spec
        self.service: dict[str, Any] = context.settings.service
        self.limits: dict[str, Any] = self.service.get("limits", {})
        self.benchmark: dict[str, Any] = context.settings.benchmark
        self.tolerance_s = context.settings.tolerance_s
        self.journal: Journal = teller.journal if teller else Journal(name)
        self.tally: Tally = teller.tally if teller else Tally(context.spec)
        # The same seed gives the same requests.
        self.random = random.Random(f"{context.settings.seed}/{name}")
        self._base_url = base_url or context.settings.url
        self._runs: list[Run] = []
        self.wire = self._open_wire(context.settings.token, "TOKEN")

    def _open_wire(self, token: str | None, name: str) -> Wire:
        return Wire(
            clients=self.context.clients,
            spec=self.spec,
            base_url=self._base_url,
            token=token,
            token_name=name,
            journal=self.journal,
            tally=self.tally,
        )

    @property
    def speaks_msgpack(self) -> bool:
        """Whether the server announces the profile msgpack."""
        return self.offers("msgpack")

    def offers(self, profile: str) -> bool:
        """Whether the server has a part of the protocol."""
        return profile in NEVER_ANNOUNCED or profile in self.service["profiles"]

    def wire_of(self, token: str | None) -> Wire:
        """A caller with any token, or without one."""
        return self._open_wire(token, "WRONG_TOKEN")

    @property
    def wire_2(self) -> Wire:
        """Another account."""
        token = self.context.settings.token_2
        if token is None:
            raise SetUpFailed("no second token given", allowed=True)
        return self._open_wire(token, "TOKEN_2")

    @property
    def wire_read(self) -> Wire:
        """The first account with a token that may only read."""
        token = self.context.settings.token_read
        if token is None:
            raise SetUpFailed("no read token given", allowed=True)
        return self._open_wire(token, "TOKEN_READ")

    def call(
        self,
        operation_id: str,
        *,
        json: Any = None,
        content: Any = None,
        wire: Wire | None = None,
        headers: Mapping[str, str] | None = None,
        params: Mapping[str, Any] | None = None,
        msgpack: bool = False,
        timeout_s: float = 30.0,
        endpoint: str | None = None,
        **path_params: str,
    ) -> Answer:
        """Send an operation by its id; the answer is raw.

        Keywords that are left over fill the path. `msgpack` sends `json` as
        MessagePack and accepts nothing else.
        """
        operation = self.spec.operations[operation_id]
        wire = wire or self.wire
        path = operation.path.format(
            **{name: quote(value, safe="") for name, value in path_params.items()}
        )
        base_url = wire.base_url
        if operation.is_data_plane and endpoint is not None:
            base_url = endpoint.rstrip("/")
        if msgpack:
            content, json = msgspec.msgpack.encode(json), None
            headers = {"Content-Type": MSGPACK, "Accept": MSGPACK, **(headers or {})}
        send = partial(
            wire.request,
            operation.method,
            base_url + path,
            json=json,
            content=content,
            headers=headers,
            params=params,
            timeout_s=timeout_s,
            operation=operation,
        )
        return self._in_time(send)

    def _in_time(self, send: Callable[[], Answer]) -> Answer:
        """Repeat while the server has no room, as every client must; then give up.

        To have no room is no violation of any rule, and no proof that one is kept.
        """
        patience = self.context.patience
        until = time.monotonic() + patience.of("room", _ROOM_S)
        while (answer := send()).code in _COME_BACK:
            if time.monotonic() > until:
                patience.lose("room")
                if answer.code == _NO_ROOM:
                    raise SetUpFailed(f"the server has no room: {told(answer)}")
                return answer
            time.sleep(_ROOM_POLL_S)
        return answer

    def given(self, step: Callable[[], Answer], status: int, name: str) -> Any:
        """Take a set-up step and give its body; whatever goes wrong is no violation."""
        try:
            return given(step(), status, f"`{name}`")
        except NoAnswer as error:
            raise SetUpFailed(f"`{name}` got no answer: {error.observed}") from error

    def submit(
        self,
        *tasks: str,
        wait_ready: bool = True,
        wire: Wire | None = None,
        max_workers: int | None = None,
        idle_timeout_s: float | None = None,
        images: Mapping[str, Any] | None = None,
        headers: Mapping[str, str] | None = None,
        **options: Any,
    ) -> Run:
        """Submit a calibration run, one episode per task; wait until it is ready."""
        if tasks:
            options["tasks"] = list(tasks)
        asked: dict[str, Any] = {
            "max_workers": max_workers,
            "idle_timeout_s": idle_timeout_s,
            "images": images,
            "options": options or None,
        }
        body = self.submit_body(**asked)
        faults = self.spec.request_faults(self.spec.operations["submit_run"], body)
        if faults:
            raise KitError(f"the kit's own submit_run is invalid: {faults}")
        accepted = self.given(
            lambda: self.call("submit_run", json=body, wire=wire, headers=headers),
            201,
            "submit_run",
        )
        run = self.adopt(accepted, wire)
        if wait_ready and run.body["state"] != "ready":
            run.until("ready", _READY_S)
        return run

    @staticmethod
    def submit_body(**members: Any) -> dict[str, Any]:
        """Give a body for submit_run; members that are None are left out."""
        body = {"benchmark_id": "calibration", "policy": {"name": "conformance kit"}}
        return body | {k: v for k, v in members.items() if v is not None}

    def adopt(self, body: dict[str, Any], wire: Wire | None = None) -> Run:
        """Handle a run that a raw request made; it is stopped after the check."""
        run = Run(self, body, wire or self.wire)
        self._runs.append(run)
        return run

    @staticmethod
    def action(**values: Any) -> dict[str, Any]:
        """Give an action; names that are left out are zero, numbers become vectors."""
        vectors: dict[str, Any] = {n: [0.0] * size for n, size in ACTION_SIZES.items()}
        for name, value in values.items():
            vectors[name] = value if isinstance(value, list) else [value]
        return {"values": vectors}

    @staticmethod
    def together(*thunks: Callable[[], Any]) -> list[Any]:
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

    def at(self, base_url: str) -> "Story":
        """Tell the same story to another server, in the same journal."""
        return Story(self.context, self.name, base_url, self)

    @contextlib.contextmanager
    def private_server(self) -> Iterator["PrivateServer"]:
        """Start a server of its own that may be killed; see private.py."""
        from conformance.runner.private_server import open_private_server

        with open_private_server(self) as server:
            yield server

    def tidy_up(self) -> None:
        """End the runs of this story, so that they hold no simulator; best effort."""
        while self._runs:
            self._runs.pop().abandon()
