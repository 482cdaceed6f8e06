"""A run and a worker of a check: one method per operation of the protocol.

The plain methods (`attach`, `predict`, `stop`) are set-up: when the server refuses one,
they raise SetUpFailed, which proves nothing against the rule under test. The `try_`
methods and `call` return the raw answer, for `expect` to judge.
"""

import contextlib
import itertools
import time
import uuid
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

from conformance.client.adaptive_timeouts import GrowingPauses
from conformance.client.http_client import AnswerStream, HttpClient, LeftUnanswered
from conformance.client.request_context import ENDED, RequestContext
from conformance.exchanges.answer import Answer
from conformance.exchanges.pages import read_pages
from conformance.specification.document import Operation
from conformance.verdicts.expect import (
    Inconclusive,
    SetUpFailed,
    SetUpList,
    Violation,
    as_set_up,
)

_CLEAN_UP_TIMEOUT_S = 5.0
_POLL_FIRST_S = 0.004
_POLL_LONGEST_S = 0.1
_VOLATILE = ("updated_at", "queue_position")
_MAX_EMPTY_PAGES = 20


class RunClient:
    """A run that a check submitted; `body` is the run as last seen."""

    def __init__(
        self, context: RequestContext, body: dict[str, Any], http_client: HttpClient
    ) -> None:
        self.context = context
        self.http_client = http_client
        self.body = as_set_up(body)
        self.id = str(self.body["run_id"])
        self._worker_numbers = itertools.count(1)
        self._sessions: dict[str, str] = {}  # of each worker, the latest
        self._results_in_turns: dict[int, dict[str, Any]] = {}  # by the index

    def call(self, operation_id: str, **how: Any) -> Answer:
        """Send an operation on this run; the answer is raw."""
        how.setdefault("http_client", self.http_client)
        how.setdefault("run_id", self.id)
        endpoint = str(self.body["endpoint"])
        answer = self.context.call(operation_id, endpoint=endpoint, **how)
        if operation_id == "attach_worker" and answer.status == 200:
            self._store_session_id(str(how.get("worker_id")), answer.json)
        if operation_id == "predict" and isinstance(answer.json, dict):
            result = answer.json.get("episode_result")
            if isinstance(result, dict) and isinstance(result.get("index"), int):
                self._results_in_turns[result["index"]] = result
        return answer

    @contextlib.contextmanager
    def stream(
        self, operation_id: str, headers: Mapping[str, str]
    ) -> Iterator[AnswerStream | Answer]:
        """Open the event stream of this run; an Answer if it is refused."""
        operation = self.context.spec.operations[operation_id]
        path = self.base_url_of(operation) + operation.path.format(run_id=self.id)
        with self.http_client.stream(operation, path, headers) as opened:
            yield opened

    def base_url_of(self, operation: Operation) -> str:
        """Where an operation on this run is served: its endpoint, or the service."""
        if operation.is_data_plane:
            return str(self.body["endpoint"]).rstrip("/")
        return self.http_client.base_url

    def _store_session_id(self, worker_id: str, turn: Any) -> None:
        session_id = turn.get("session_id") if isinstance(turn, dict) else None
        if isinstance(session_id, str):
            self._sessions[worker_id] = session_id

    def clean_up(self) -> None:
        """Stop the run, so that it holds no simulator; best effort.

        If the server cannot stop it, the sessions are detached one by one. A run that
        was shown as ended, or of which turns had all results, holds none, for good.
        """
        total = self.body.get("progress", {}).get("episodes_total")
        has_all = len(self._results_in_turns) == total
        if has_all or self.context.has_ended(self.id):
            return
        with contextlib.suppress(Violation, SetUpFailed):
            abort = {"mode": "abort"}
            stopped = self.call("stop_run", json=abort, timeout_s=_CLEAN_UP_TIMEOUT_S)
            if stopped.status == 200 or not self._sessions:
                return
            refusal = stopped.json if isinstance(stopped.json, dict) else {}
            if refusal.get("state") in ENDED:
                return
            if not self.context.offers("sessions"):
                return
            for worker_id, session_id in self._sessions.items():
                self.call(
                    "detach_worker",
                    worker_id=worker_id,
                    params={"session_id": session_id},
                    timeout_s=_CLEAN_UP_TIMEOUT_S,
                )

    def _require(self, operation_id: str, status: int = 200, **how: Any) -> Any:
        return self.context.require(
            lambda: self.call(operation_id, **how), status, operation_id
        )

    def get(self) -> dict[str, Any]:
        """Read the run."""
        self.body = self._require("get_run")
        return self.body

    def score(self) -> dict[str, Any]:
        """Read the score."""
        score: dict[str, Any] = self._require("get_score")
        return score

    def episodes(self) -> list[dict[str, Any]]:
        """Read all pages of the episodes."""
        episodes: list[dict[str, Any]] = SetUpList()
        empty = 0
        endless = SetUpFailed("`list_episodes` does not end", breaks="EPI-006")
        read = partial(self._require, "list_episodes")
        for page in read_pages(lambda p: read(params=p), endless):
            episodes += page["episodes"]
            empty += not page["episodes"]
            if empty == _MAX_EMPTY_PAGES and page["next_cursor"] is not None:
                text = f"`list_episodes` returned {empty} pages without an episode"
                raise SetUpFailed(text, breaks="EPI-006")
        return episodes

    def results(self) -> list[dict[str, Any] | None]:
        """Give the results by manifest order; None for an episode without one.

        As `list_episodes` shows them, or as turns did where it is not offered.
        """
        if self.context.offers("lists"):
            return SetUpList(episode.get("result") for episode in self.episodes())
        total = self.body["progress"]["episodes_total"]
        return SetUpList(map(self._results_in_turns.get, range(total)))

    def stop(self, mode: str = "abort", **members: Any) -> dict[str, Any]:
        """Stop the run."""
        self.body = self._require("stop_run", json={"mode": mode, **members})
        return self.body

    def resume(self, *, until_ready: bool = False) -> dict[str, Any]:
        """Resume the run."""
        self.body = self._require("resume_run")
        return self.until("ready") if until_ready else self.body

    def until(self, state: str, timeout_s: float = 5.0) -> dict[str, Any]:
        """Poll until the run is in a state."""
        timeout_s = self.context.shared.timeouts.of(state, timeout_s)
        deadline = time.monotonic() + timeout_s
        pauses = GrowingPauses(_POLL_FIRST_S, _POLL_LONGEST_S)
        while self.get()["state"] != state:
            if time.monotonic() > deadline:
                self.context.shared.timeouts.record_miss(state)
                raise SetUpFailed(
                    f"run state is `{self.body['state']}`, expected `{state}` "
                    f"within {timeout_s:g} s"
                )
            pauses.wait()
        return self.body

    def worker(self, worker_id: str | None = None) -> "WorkerClient":
        """Give a worker of this run; sends no request."""
        return WorkerClient(self, worker_id or f"worker-{next(self._worker_numbers)}")

    def _lasting_members(self) -> dict[str, Any]:
        return {k: v for k, v in self.get().items() if k not in _VOLATILE}

    def snapshot(self) -> dict[str, Any]:
        """Read everything of the run that only a command may change."""
        read: dict[str, Callable[[], Any]] = {
            "get_run": self._lasting_members,
            "list_episodes": self.episodes,
            "get_score": self.score,
        }
        return {
            name: call() for name, call in read.items() if self.context.serves(name)
        }


class WorkerClient:
    """A worker with its latest session, the last seq it used, and its last turn."""

    def __init__(self, run: RunClient, worker_id: str) -> None:
        self.run = run
        self.id = worker_id
        self.attach_key = ""
        self.session_id = ""
        self.seq = 0
        self.turn: dict[str, Any] = {}

    def _call(self, operation_id: str, **how: Any) -> Answer:
        how.setdefault("worker_id", self.id)
        return self.run.call(operation_id, **how)

    def try_attach(
        self,
        takeover: bool = False,
        attach_key: str | None = None,
        assumes: Mapping[str, Any] | None = None,
        player: Mapping[str, Any] | None = None,
        first_episodes: int | None = None,
        **how: Any,
    ) -> Answer:
        """Send `attach_worker`, with a new key unless one is given."""
        body: dict[str, Any] = {"attach_key": attach_key or uuid.uuid4().hex}
        if takeover:
            body["takeover"] = True
        if assumes is not None:
            body["assumes"] = assumes
        if player is not None:
            body["player"] = player
        if first_episodes is not None:
            body["first_episodes"] = first_episodes
        return self._call("attach_worker", json=body, **how)

    def attach(
        self,
        takeover: bool = False,
        attach_key: str | None = None,
        assumes: Mapping[str, Any] | None = None,
        **how: Any,
    ) -> dict[str, Any]:
        """Open a session and give its turn 0."""
        key = attach_key or uuid.uuid4().hex
        turn: dict[str, Any] = self.run.context.require(
            lambda: self.try_attach(takeover, key, assumes, **how), 200, "attach_worker"
        )
        self.attach_key = key
        self.session_id = turn["session_id"]
        self.seq = turn["seq"]
        self.turn = turn
        return turn

    def try_predict(
        self,
        *actions: Mapping[str, Any],
        seq: int | None = None,
        session_id: str | bytes | None = None,
        observe: str | None = None,
        msgpack: bool = False,
        **how: Any,
    ) -> Answer:
        """Send a chunk; `seq` of the worker does not change."""
        body: dict[str, Any] = {
            "session_id": self.session_id if session_id is None else session_id,
            "seq": self.seq + 1 if seq is None else seq,
            "actions": list(actions),
        }
        if observe is not None:
            body["observe"] = observe
        return self._call("predict", json=body, msgpack=msgpack, **how)

    def leave_turn(
        self, *actions: Mapping[str, Any], after_s: float
    ) -> Callable[[], Answer]:
        """Send a chunk under the next seq and close the connection before its answer.

        Gives what sends it again. Raises Inconclusive if the answer came first.
        """
        again = partial(self.try_predict, *actions)
        with contextlib.suppress(LeftUnanswered):
            again(leave_after_s=after_s)
            raise Inconclusive(f"a turn was answered within {after_s:g} s")
        return again

    def try_next(self, **values: float) -> Answer:
        """Play one action under the next seq; the answer is raw."""
        answer = self.try_predict(self.run.context.action(**values))
        self.seq += answer.status == 200
        return answer

    def predict(
        self,
        *actions: Mapping[str, Any],
        observe: str | None = None,
        msgpack: bool = False,
        **how: Any,
    ) -> dict[str, Any]:
        """Play a chunk under the next seq and give the turn."""
        turn: dict[str, Any] = self.run.context.require(
            lambda: self.try_predict(*actions, observe=observe, msgpack=msgpack, **how),
            200,
            "predict",
        )
        self.seq += 1
        self.turn = turn
        return turn

    def play(
        self, score: float = 0.5, success: float = 0, steps: int = 1
    ) -> dict[str, Any]:
        """Play the current episode to its end; give the turn that ended it."""
        context = self.run.context
        actions = [
            context.action(score=score, success=success) for _ in range(steps - 1)
        ]
        actions.append(context.action(score=score, success=success, end=1))
        turn: dict[str, Any] = {}
        max_chunk = context.limits["max_chunk"]
        for first in range(0, steps, max_chunk):
            turn = self.predict(*actions[first : first + max_chunk])
        if "episode_result" not in turn:
            text = "an action with `end` 1 did not end the episode"
            raise SetUpFailed(text, breaks="CAL-005")
        return turn

    def try_heartbeat(
        self, session_id: str | None = None, reason: str | None = None, **how: Any
    ) -> Answer:
        """Send a heartbeat; the answer is raw."""
        body = {"session_id": self.session_id if session_id is None else session_id}
        if reason is not None:
            body["reason"] = reason
        return self._call("heartbeat", json=body, **how)

    def heartbeat(self) -> dict[str, Any]:
        """Extend the lease."""
        lease: dict[str, Any] = self.run.context.require(
            self.try_heartbeat, 200, "heartbeat"
        )
        return lease

    def try_detach(self, session_id: str | None = None, **how: Any) -> Answer:
        """Send `detach_worker`; the answer is raw."""
        session = self.session_id if session_id is None else session_id
        return self._call("detach_worker", params={"session_id": session}, **how)

    def detach(self) -> None:
        """Close the session."""
        self.run.context.require(self.try_detach, 204, "detach_worker")


def adopt_run(
    context: RequestContext,
    body: dict[str, Any],
    http_client: HttpClient | None = None,
) -> RunClient:
    """Handle a run that a raw request submitted; it is stopped after the check."""
    run = RunClient(context, body, http_client or context.http_client)
    context.adopted.add(run.id)
    context.clean_up_with(run.clean_up)
    return run
