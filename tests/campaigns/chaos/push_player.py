"""A player whose runs the nodes play themselves: a dead node must not leave one."""

from __future__ import annotations

from typing import Any

from conformance.policy.scripted_policy import PolicyCall, PolicyReply, ScriptedPolicy
from tests.campaigns.chaos.cluster_player import EPISODES, ClusterPlayer
from tests.campaigns.players.run_history import History
from tests.campaigns.players.watcher import RETRY_S
from tests.support.network.links import HOST
from tests.support.push_runs import END_STATES, push_submission
from tests.support.sim.calibration_action import calibration_action

STEPS, SCORE = 4, 0.5
# Without a result for so long, a run stands still.
STILL_S = 60.0


def scripted_policy(host: str = HOST) -> ScriptedPolicy:
    """It ends each episode with the same score after as many steps."""
    policy = ScriptedPolicy(host)

    def answer(call: PolicyCall) -> PolicyReply:
        if call.body is None:  # a node was killed in the middle of its request
            return PolicyReply(status=400)
        is_last = call.body["episode"]["step"] == STEPS - 1
        values = calibration_action(score=SCORE, end=float(is_last))
        return policy.actions_reply(call, {"values": values})

    policy.on("predict", answer)
    return policy


class PushPlayer(ClusterPlayer):
    """It reads its run from any node until the run is completed.

    Held, it ends its run first: nothing else holds the nodes. What it samples is the
    start of a run and each change of its progress; that it can be read shows nothing.
    """

    turns_of_sample = STEPS

    def _submission(self) -> Any:
        whole = super()._submission()
        calls = {"call_timeout_s": 30.0, "max_retries": 3}
        return push_submission(self.policy_url, options=whole["options"], **calls)

    def step(self) -> None:
        self._begin("start")
        history = self._submit()
        self._finish()
        history.expected = dict.fromkeys(range(EPISODES), (SCORE, STEPS))
        self._watch(history)

    def _watch(self, history: History) -> None:
        progress = None
        self._begin_now("progress")
        while True:
            run = self._until_answered("GET", f"/v1/runs/{history.run_id}").json()
            if run["progress"] != progress:
                if progress is not None:
                    self._finish()
                    self._begin_now("progress")
                progress = run["progress"]
            if run["state"] in END_STATES:
                break
            [begun] = self.waiting()
            assert begun.took_s < STILL_S, f"it stands still: {run}"
            self._is_ending.wait(RETRY_S)
        assert run["state"] == "completed", run
        history.is_done = True
