"""Clients of another account, who play runs and time every request meanwhile.

`ServiceWatcher` asks for the service, on a kept and on a new connection in turn.
`Player` plays one run after another, in a long or in a short form, and writes down what
the server acknowledged. An operation is timed until it succeeds: a refusal as
`unavailable`, `no_capacity` or by a limit is repeated, and its time counts.
"""

from __future__ import annotations

import itertools
import random
import threading
import time
from abc import abstractmethod
from typing import Any

from tests.campaigns.campaign_server import WATCHER, WATCHER_ADDRESS
from tests.campaigns.players.raw_client import Answer, NoAnswer, RawClient
from tests.campaigns.players.run_history import History, Report, Sample
from tests.support.server.http_runs import predict_body

PAUSE_S = 0.005
RETRY_S = 0.02
RETRIED = (429, 503)


class Ended(Exception):
    """The watcher was ended while it waited for something."""


class Watcher:
    """A thread that samples until `end`; `violations` are what must never be."""

    def __init__(self, url: str, seed: int, name: str) -> None:
        self.samples: list[Sample] = []
        self.report = Report()
        self.name = name
        self._random = random.Random(f"{seed} {name}")
        self._client = RawClient(url, WATCHER, timeout_s=60, source=WATCHER_ADDRESS)
        self._unfinished: Sample | None = None
        self._is_ending = threading.Event()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def start(self) -> None:
        self._thread.start()

    def end(self) -> None:
        self._is_ending.set()
        self._thread.join(70)
        self._client.close()

    @property
    def is_alive(self) -> bool:
        return self._thread.is_alive()

    def _run(self) -> None:
        try:
            while not self._is_ending.is_set():
                self.step()
        except Ended:
            return
        except Exception as error:  # noqa: BLE001 - a finding, and the thread ends
            self._unfinished = None  # else it would seem to wait until all is over
            self.report.violations.append(f"{self.name}: {error!r}")

    @abstractmethod
    def step(self) -> None:
        """Do one thing."""

    def _timed(self, kind: str, *request: Any) -> Answer:
        self._begin(kind)
        answer = self._until_answered(*request)
        self._finish()
        return answer

    def _begin(self, kind: str) -> None:
        self._unfinished = Sample(kind, time.monotonic(), 0.0)

    def _finish(self) -> None:
        begun, self._unfinished = self._unfinished, None
        assert begun is not None
        took_s = time.monotonic() - begun.began_at
        self.samples.append(Sample(begun.kind, begun.began_at, took_s))

    def waiting(self) -> list[Sample]:
        """The operation that has not succeeded yet, with its time so far."""
        begun = self._unfinished
        if begun is None:
            return []
        return [Sample(begun.kind, begun.began_at, time.monotonic() - begun.began_at)]

    def _until_answered(self, *request: Any, **headers: Any) -> Answer:
        while not self._is_ending.is_set():
            try:
                answer = self._client.request(*request, **headers)
            except NoAnswer:
                self.report.hangs += 1
            except OSError:
                pass  # closed, or not listening while it starts again
            else:
                self.report.add_answer(answer)
                if answer.status < 500 and answer.status not in RETRIED:
                    return answer
            self._is_ending.wait(RETRY_S)
        raise Ended


class ServiceWatcher(Watcher):
    """Times `GET /v1`."""

    def step(self) -> None:
        if self._random.random() < 0.5:
            self._client.close()
        answer = self._timed("service", "GET", "/v1")
        if answer.status != 200:
            self.report.violations.append(f"GET /v1 was answered {answer.status}")
        self._is_ending.wait(PAUSE_S)


class Player(Watcher):
    """Plays runs of `episodes` episodes, one action in a turn.

    With one short episode it is the start of runs that is timed, not the turns.
    """

    worker = "w"

    def __init__(self, url: str, seed: int, name: str, episodes: int = 50) -> None:
        super().__init__(url, seed, name)
        self.histories: list[History] = []
        self._episodes = episodes
        self._is_short = episodes == 1
        self._keys = (f"{name}-{number}" for number in itertools.count())
        # A later player of the same name may play on the same server.
        self._run_keys = f"{name}-{time.monotonic_ns()}"

    def step(self) -> None:
        self._begin("start")
        history = self._submit()
        turn = self._attach(history)
        self._finish()
        self._play(history, turn)

    def _submission(self) -> dict[str, Any]:
        tasks = ["score"] * self._episodes
        return {
            "benchmark_id": "calibration",
            "policy": {"name": self.name},
            "options": {"tasks": tasks, "max_steps": 100, "max_faults": 10},
        }

    def _submit(self) -> History:
        body = self._submission()
        key = f"{self._run_keys}-{len(self.histories)}"
        answer = self._until_answered("POST", "/v1/runs", body, Idempotency_Key=key)
        assert answer.status == 201, answer
        history = History(answer.json()["run_id"], self._episodes)
        self.histories.append(history)
        return history

    def _attach(self, history: History) -> dict[str, Any] | None:
        """Turn 0 of a new session as soon as the run is ready; None: the run ended."""
        path = f"/v1/runs/{history.run_id}/workers/{self.worker}"
        body: dict[str, Any] = {"attach_key": next(self._keys)}
        while True:
            answer = self._until_answered("PUT", path, body)
            if answer.status == 200:
                turn: dict[str, Any] = answer.json()
                return turn
            if not self._may_attach_again(history, answer, body):
                return None

    def _may_attach_again(
        self, history: History, answer: Answer, _body: dict[str, Any]
    ) -> bool:
        """After a refusal; False: the run is completed. The body may be changed."""
        if answer.code != "illegal_transition":
            raise AssertionError(f"attach was answered {answer}")
        run = self._until_answered("GET", f"/v1/runs/{history.run_id}").json()
        if run["state"] not in ("queued", "ready", "running"):
            assert run["state"] == "completed", run
            return False
        self._is_ending.wait(RETRY_S)
        return True

    def _play(self, history: History, turn: dict[str, Any] | None) -> None:
        path = f"/v1/runs/{history.run_id}/workers/{self.worker}/predict"
        playing, steps, length = "", 0, 0
        while turn is not None and not turn["done"]:
            episode = turn["episode"]
            if episode["step"] == 0 or episode["episode_id"] != playing:
                playing, steps = episode["episode_id"], episode["step"]
                most = 3 if self._is_short else 40
                length = steps + self._random.randint(2, most)
            steps += 1
            score = self._random.random()
            is_last = steps == length
            if is_last:
                history.expected[episode["index"]] = (score, steps)
            body = self._predict_body(turn, score=score, end=float(is_last))
            answer = self._timed("turn", "POST", path, body)
            if answer.status != 200:
                # Killed and started again: the session is gone, the run is not.
                if answer.code not in ("session_ended", "session_superseded"):
                    raise AssertionError(f"a turn was answered {answer}")
                turn = self._attach(history)
                steps = 0 if turn is None or turn["done"] else turn["episode"]["step"]
                continue
            turn = self._accept(history, answer)
            fault = turn.get("fault") or {"episode_id": None}
            if fault["episode_id"] == episode["episode_id"]:
                history.expected.pop(episode["index"], None)
            self._is_ending.wait(PAUSE_S)
        history.is_done = True

    def _predict_body(self, turn: dict[str, Any], **values: float) -> dict[str, Any]:
        return predict_body(turn, **values)

    def _accept(self, history: History, answer: Answer) -> dict[str, Any]:
        turn: dict[str, Any] = answer.json()
        result = turn.get("episode_result")
        if result is not None:
            if result["index"] in history.acknowledged:
                self.report.violations.append(f"acknowledged twice: {result}")
            history.acknowledged[result["index"]] = result
        return turn
