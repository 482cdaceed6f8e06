"""A player of a cluster: reaches any node with any request, and repeats itself.

Beside what every player writes down, it finds two answers to one `seq`, a simulator
that made another number of steps than it was sent, and what a stop loses.
"""

from __future__ import annotations

import json
import threading
import time
from collections import deque
from typing import Any

from tests.campaigns.campaign_server import WATCHER, WATCHER_ADDRESS
from tests.campaigns.chaos.event_follower import EventFollower
from tests.campaigns.players.raw_client import Answer, RawClient
from tests.campaigns.players.run_history import History
from tests.campaigns.players.watcher import Ended, Player

EPISODES = 6
RECONNECTS, REPEATS, STOPS = 0.3, 0.2, 0.2
# How long the answer to a turn that was sent twice may take after the other one.
SECOND_S = 1.0
# Requests and answers that are shown of a player who failed.
TRAIL = 12
# What a repeat may be answered with when its session, or its node, ended meanwhile.
ENDED = ("session_ended", "session_superseded", "unavailable", "illegal_transition")


class ClusterPlayer(Player):
    """`hold` lets it pause between two operations, `release` go on.

    compared: turns that were sent twice and answered twice. policy_url: of a policy
    server, for players whose runs the nodes play.
    """

    policy_url = ""
    # Turns that a sample stands for, where it is waited until players go on.
    turns_of_sample = 1

    def __init__(self, url: str, seed: int, name: str, timeout_s: float) -> None:
        super().__init__(url, seed, name, EPISODES)
        self._url, self._timeout_s = url, timeout_s
        self.followers: dict[str, EventFollower] = {}
        self._client, self._second = (
            RawClient(url, WATCHER, timeout_s=limit_s, source=WATCHER_ADDRESS)
            for limit_s in (timeout_s, SECOND_S)
        )
        self.compared = 0
        self._changed = threading.Condition()
        self._may_play, self._is_waiting = True, False
        self._before: dict[str, Any] = {}
        self._trail: deque[str] = deque(maxlen=TRAIL)

    def hold(self) -> None:
        with self._changed:
            self._may_play = False

    def release(self) -> None:
        with self._changed:
            self._may_play = True
            self._changed.notify_all()

    @property
    def is_held(self) -> bool:
        """After `hold`: no operation is under way, and none begins."""
        with self._changed:
            return self._is_waiting and not self._may_play

    def end(self) -> None:
        self._is_ending.set()
        self.release()
        super().end()
        self._second.close()
        for follower in self.followers.values():
            follower.close()

    def _begin(self, kind: str) -> None:
        with self._changed:
            self._is_waiting = True
            self._changed.wait_for(lambda: self._may_play)
            self._is_waiting = False
        if self._is_ending.is_set():
            raise Ended
        self._begin_now(kind)

    def _begin_now(self, kind: str) -> None:
        """Though it is held."""
        super()._begin(kind)

    def _timed(self, kind: str, *request: Any) -> Answer:
        if self._random.random() < RECONNECTS:
            self._client.close()  # the balancer gives it the next node
        if kind != "turn" or self._random.random() >= REPEATS:
            return super()._timed(kind, *request)
        is_sent = self._send_second(*request)
        answer = super()._timed(kind, *request)
        if is_sent:
            self._compare_second(answer)
        return answer

    def _until_answered(self, *request: Any, **headers: Any) -> Answer:
        self._trail.append(f"{time.time():.3f} {request}")
        answer = super()._until_answered(*request, **headers)
        shown = answer.code or answer.body[:300]
        self._trail.append(f"{time.time():.3f} {answer.status} {shown!r}")
        return answer

    def _run(self) -> None:
        super()._run()
        if self.report.violations:
            self.report.violations.append("\n    ".join(self._trail))

    def _send_second(self, *request: Any) -> bool:
        """The same request at the same time, over a connection of its own."""
        self._second.close()
        try:
            self._second.connect().sendall(self._second.encode(*request))
        except OSError:
            return False
        return True

    def _compare_second(self, answer: Answer) -> None:
        try:
            second = self._second.read_answer()
        except OSError:
            return
        if 200 not in (answer.status, second.status):
            return
        self.compared += 1
        if answer.status == second.status:
            found = _turn_of(answer), _turn_of(second)
            if found[0] != found[1]:
                self.report.violations.append(f"two answers to one seq: {found}")
            return
        if (answer if second.status == 200 else second).code not in ENDED:
            what = f"of one request twice, {answer} and {second}"
            self.report.violations.append(what)
        if second.status == 200 and "episode_result" in (turn := second.json()):
            result = turn["episode_result"]
            self.histories[-1].acknowledged[result["index"]] = result

    def _submit(self) -> History:
        history = super()._submit()
        follower = EventFollower(self._url, history, self._timeout_s)
        self.followers[history.run_id] = follower
        return history

    def _attach(self, history: History) -> dict[str, Any] | None:
        turn = super()._attach(history)
        self._before = turn or {}
        return turn

    def _may_attach_again(
        self, history: History, answer: Answer, body: dict[str, Any]
    ) -> bool:
        """A request that was given up may act as late as its node is paused."""
        if answer.code == "worker_busy":  # an earlier attach
            body["takeover"] = True
            return True
        path = f"/v1/runs/{history.run_id}"
        if self._until_answered("GET", path).json()["state"] == "stopped":
            self._until_answered("POST", f"{path}/resume", {})
            return True
        return super()._may_attach_again(history, answer, body)

    def _accept(self, history: History, answer: Answer) -> dict[str, Any]:
        turn = super()._accept(history, answer)
        self._check_steps(history, turn)
        self._before = turn
        is_between = turn.get("episode_result") is not None and not turn["done"]
        if is_between and self._random.random() < STOPS:
            return self._stop_and_resume(history)
        return turn

    def _check_steps(self, history: History, turn: dict[str, Any]) -> None:
        if turn["seq"] != self._before["seq"] + 1:
            self._report(history, f"seq {self._before['seq']} is followed by {turn}")
        if turn["done"]:
            return
        step = turn["episode"]["step"]
        made = turn["observation"]["state"]["count"]
        if made != [step]:
            self._report(history, f"the simulator made {made} steps of {step}")
        if step not in (0, self._before["episode"]["step"] + 1):
            self._report(history, f"step {step} follows {self._before['episode']}")
        if step == 0 and not (turn.get("episode_result") or turn.get("fault")):
            self._report(history, f"an episode began again without a reason: {turn}")

    def _report(self, history: History, what: str) -> None:
        self.report.violations.append(f"run {history.run_id}: {what}")

    def _stop_and_resume(self, history: History) -> dict[str, Any]:
        """Between two episodes: nothing is in play that could be lost."""
        path = f"/v1/runs/{history.run_id}"
        self._until_answered("POST", f"{path}/stop", {"mode": "abort"})
        turn = self._attach(history)  # resumes it
        assert turn is not None, f"run {history.run_id} is completed without its end"
        return turn


def _turn_of(answer: Answer) -> dict[str, Any]:
    """Without what may be renewed by a repeat, or by another node."""
    turn: dict[str, Any] = json.loads(answer.body)
    turn.pop("lease", None)
    turn.pop("timing", None)
    return turn
