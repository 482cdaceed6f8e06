"""The reference client against the reference server, over a wire that loses answers.

What ran twice shows in the state `count` of the benchmark calibration, what was lost in
the attempts of the episodes.
"""

import signal
import sys
import threading
import time
from collections import deque
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from reference_client import Observation, ProctorError, evaluate
from tests.support.client.command import Proctor
from tests.support.client.direct_client import ACCEPT_ANY, DirectClient
from tests.support.client.evaluations import (
    ProgressRecorder,
    calibration_evaluation,
    play,
    play_on,
    run_in_thread,
)
from tests.support.client.policies import (
    Actions,
    BlockingPolicy,
    ExactlyOncePolicy,
    GradedPolicy,
)
from tests.support.network.lossy_proxy import Proxy
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action as action

# An undisturbed evaluation


class NoReset:
    def act(self, observation: Observation) -> Any:
        return action(success=1, end=1)


class NoAct:
    def reset(self, instruction: str) -> None:
        """Nothing is kept."""


class WithoutInstruction(NoReset):
    def reset(self) -> None:
        """Nothing is kept."""


class Loaded(GradedPolicy):
    def __init__(self, checkpoint: str, device: str = "cuda") -> None:
        super().__init__()


def make_loaded(*, checkpoint: str) -> Loaded:
    return Loaded(checkpoint)


def of_two(observation: Observation, history: Any) -> Any:
    return history(observation)


class AsyncAct(NoAct):
    async def act(self, observation: Observation) -> Any:
        return action(success=1, end=1)


class AsyncReset(NoReset):
    async def reset(self, instruction: str) -> None:
        """Nothing is kept."""


async def async_answer(observation: Observation) -> Any:
    return observation


@pytest.mark.parametrize(
    ("policy", "says"),
    [
        (GradedPolicy(), "is an object of GradedPolicy; give its class"),
        (NoReset, r"NoReset makes a policy without reset\(instruction\)"),
        (partial(NoReset), r"NoReset makes a policy without reset\(instruction\)"),
        (NoAct, r"NoAct makes a NoAct without act\(\)"),
        (WithoutInstruction, "of which reset does not take the instruction"),
        (17, "int is not callable: 17"),
        (
            Loaded,
            r"missing .*'checkpoint'; name a .*`def make\(\): return Loaded\(…\)`",
        ),
        (
            make_loaded,
            r"make_loaded\(\), and that fails: missing .* 'checkpoint'; name a",
        ),
        (
            of_two,
            r"of_two\(observation\), .*'history'; give its other arguments default",
        ),
        (AsyncAct, "act of AsyncAct is async, and is called without await: make it a"),
        (AsyncReset, "reset of AsyncReset is async"),
        (async_answer, "async_answer is async"),
    ],
    ids=[
        *("object", "no reset", "partial", "no act", "no instruction", "number"),
        *("argument", "keyword", "two", "async act", "async reset", "async function"),
    ],
)
def test_what_the_command_refuses_as_a_policy_is_refused(
    policy: Any, says: str, server: ReferenceServer
) -> None:
    with pytest.raises(ValueError, match=says):
        play(server, policy, "score")


def test_a_function_of_the_observation_is_a_policy(server: ReferenceServer) -> None:
    def succeed(observation: Observation) -> Any:
        return action(success=1, end=int(observation.step >= 0))

    assert play(server, succeed, "score").counts.success == 1


def test_a_policy_without_a_name_has_that_of_its_class(
    server: ReferenceServer, direct: DirectClient
) -> None:
    class Scaled(GradedPolicy):
        def __init__(self, factor: float) -> None:
            super().__init__()
            self.factor = factor

    play(server, lambda: Scaled(2.0), "score", workers=2)
    assert direct.latest().policy.name == "Scaled"


def test_several_workers_play_every_episode_once(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """Each has its own policy, which is reset for each episode it plays."""
    policies: list[GradedPolicy] = []

    def make() -> GradedPolicy:
        policies.append(GradedPolicy())
        return policies[-1]

    recorder = ProgressRecorder()
    tasks = ["score"] * 12
    score = play(server, make, *tasks, workers=3, progress=recorder)
    assert score.score == pytest.approx(sum(i % 5 / 4 for i in range(12)) / 12)
    assert len(policies) == 3
    assert sum(policy.resets for policy in policies) == 12
    assert direct.attempts(score.run_id) == [1] * 12
    scored = [progress.episodes_scored for progress in recorder.received]
    assert scored == sorted(scored)
    assert (scored[0], scored[-1]) == (0, 12)
    assert recorder.received[0].mean is None
    assert recorder.received[-1].mean == score.mean


@pytest.mark.parametrize("shows_progress", [False, True])
def test_it_begins_with_the_run_and_its_page(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str], shows_progress: bool
) -> None:
    """Nothing where the caller shows the progress."""
    given = calibration_evaluation("score")
    if not shows_progress:
        del given["progress"]
    score = evaluate(GradedPolicy, url=server.url, **given)
    page = f"{server.url}/pages/runs/{score.run_id}"
    line = f"Run {score.run_id}: GradedPolicy on calibration; page: {page}\n"
    assert capsys.readouterr().err == ("" if shows_progress else line)


def test_it_ends_with_how_a_partial_run_goes_on(
    server: ReferenceServer, capsys: pytest.CaptureFixture[str]
) -> None:
    given = calibration_evaluation("score", "score") | {"episodes": 1}
    del given["progress"]
    score = evaluate(GradedPolicy, url=server.url, **given)
    last = capsys.readouterr().err.splitlines()[-1]
    assert last == (
        f'The score is partial; evaluate(..., run_id="{score.run_id}") continues it.'
    )


class CoreServer(ReferenceServer):
    command = (sys.executable, "-m", "tests.support.kit.server_of_profiles")


def test_a_server_of_core_alone_is_enough(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It refuses every field and operation of other profiles."""
    with CoreServer(tmp_path, ONLY_PROFILES="core") as server:
        score = evaluate(
            GradedPolicy,
            url=server.url,
            token=TOKENS["alice"],
            benchmark="calibration",
            options={"tasks": ["score", "count", "score"]},
        )
        assert (score.counts.total, score.counts.unscored) == (3, 0)
        proctor = Proctor(server.url, capsys)
        assert proctor("status", score.run_id, "--token", TOKENS["alice"]) == 0
        assert "completed" in proctor.out
        assert proctor("status", "--token", TOKENS["alice"]) == 2
        assert "has no list of runs: it does not announce the profile" in proctor.err


# A wire that loses answers


@pytest.mark.slow("starts a server or a kit")
def test_lost_answers_to_predict_execute_nothing_twice(
    proxy: Proxy, direct: DirectClient
) -> None:
    proxy.faults["predict"] = deque(
        ["lose_answer", "pass", "lose_request", "cut_answer", "gateway", "page"]
        + ["lose_answer"] * 3
    )
    score = play(proxy, ExactlyOncePolicy, "count", "count")
    assert score.score == 1.0
    assert not proxy.faults["predict"]
    for episode in direct.episodes(score.run_id):
        assert episode.result is not None
        assert (episode.result.attempt, episode.result.steps) == (1, 10)
    # 10 turns of 2 steps, and 8 that were repeated.
    assert len(proxy.bodies("predict")) == 18


@pytest.mark.slow("starts a server or a kit")
def test_a_lost_attach_is_repeated(proxy: Proxy, direct: DirectClient) -> None:
    proxy.faults["attach"] = deque(["lose_answer", "cut_answer", "page"])
    # With a short lease, so that a lost session does not delay the test for long.
    score = play(proxy, ExactlyOncePolicy, "count", idle_timeout_s=10)
    attachments = proxy.bodies("attach")
    assert len({body["attach_key"] for body in attachments}) == 1
    assert len(attachments) == 4
    assert direct.attempts(score.run_id) == [1]


@pytest.mark.slow("starts a server or a kit")
def test_a_lost_answer_to_submit_makes_one_run(
    proxy: Proxy, direct: DirectClient
) -> None:
    before = {run.run_id for run in direct.control.list_runs().runs}
    proxy.faults["submit"] = deque(["lose_answer", "gateway", "page"])
    score = play(proxy, GradedPolicy, "score")
    after = {run.run_id for run in direct.control.list_runs().runs}
    assert after - before == {score.run_id}


@pytest.mark.slow("starts a server or a kit")
def test_a_server_killed_and_restarted_gives_the_same_score(tmp_path: Path) -> None:
    turns = iter(range(1000))
    restart: list[threading.Thread] = []
    recorder = ProgressRecorder()

    def restart_when_missed() -> None:
        missed.wait(TIMEOUT_S)
        killed_server.start()

    class KillingPolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            if next(turns) == 7:
                killed_server.end(signal.SIGKILL)
                restart.append(threading.Thread(target=restart_when_missed))
                restart[0].start()
            return super().act(observation)

    eight = ["score"] * 8
    with (
        ReferenceServer(tmp_path) as killed_server,
        DirectClient(killed_server.url) as direct,
    ):
        missed = recorder.waiting_event(f"{killed_server.url} is unreachable")
        undisturbed = play(killed_server, GradedPolicy, *eight)
        try:
            seen = {"workers": 2, "progress": recorder}
            score = play(killed_server, KillingPolicy, *eight, **seen)
        finally:
            restart[0].join()
        attempts = direct.attempts(score.run_id)
    assert score.score == undisturbed.score
    assert attempts == [1] * 8
    assert missed.is_set()


# Other sessions


def test_a_worker_that_is_taken_over_stops(
    server: ReferenceServer, direct: DirectClient
) -> None:
    policy = BlockingPolicy()
    evaluation = run_in_thread(play, server, lambda: policy, "count")
    assert policy.is_acting.wait(TIMEOUT_S)
    run_id = direct.latest().run_id
    direct.attach(run_id, "worker-0", takeover=True)
    policy.may_continue.set()
    with pytest.raises(ProctorError, match="takeover=True") as caught:
        evaluation.result(TIMEOUT_S)
    assert caught.value.code == "session_superseded"
    assert direct.control.get_run(run_id).live_workers == 1


def test_a_busy_worker_is_waited_for_until_its_lease_ends(
    server: ReferenceServer, direct: DirectClient
) -> None:
    for lease_s in (1, 4, 16):  # on a busy machine a short one is over too soon
        run = direct.submit("score", "score", idle_timeout_s=lease_s)
        direct.attach(run.run_id, "worker-0")
        recorder = ProgressRecorder()
        busy = recorder.waiting_event("takeover=True")
        score = play_on(server, GradedPolicy, run.run_id, progress=recorder)
        assert score.complete
        if busy.is_set():
            break
    assert busy.is_set()


def test_a_full_run_is_awaited(server: ReferenceServer, direct: DirectClient) -> None:
    run = direct.submit("score", "score", max_workers=1)
    occupant = direct.attach(run.run_id, "occupant")
    recorder = ProgressRecorder()
    full = recorder.waiting_event("live workers")
    call = GradedPolicy, run.run_id
    evaluation = run_in_thread(play_on, server, *call, progress=recorder)
    assert full.wait(TIMEOUT_S)
    leaving = (run.run_id, "occupant", occupant.session_id)
    direct.data.detach_worker(*leaving, _headers=ACCEPT_ANY)
    assert evaluation.result(TIMEOUT_S).complete
    assert recorder.received[-1].waiting is None


def test_episodes_of_a_dead_session_are_played(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """Its episode is pending again only after our workers found nothing more."""
    run = direct.submit("score", "score", "score", idle_timeout_s=1)
    direct.attach(run.run_id, "dead")
    score = play_on(server, GradedPolicy, run.run_id, workers=2)
    assert score.counts.success == 3


@pytest.mark.slow("starts a server or a kit")
def test_heartbeats_keep_the_lease_while_the_policy_thinks(
    proxy: Proxy, direct: DirectClient
) -> None:
    class SlowPolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            time.sleep(1.7 * lease_s)
            return [action(score=1.0, end=1.0)]

    for lease_s in (1, 4, 16):  # a machine that stands still costs a lease
        proxy.recorded.clear()
        proxy.faults["heartbeat"] = deque(["pass", "lose_answer"])
        score = play(proxy, SlowPolicy, "score", idle_timeout_s=lease_s)
        if len(proxy.bodies("attach")) == 1:
            break
    assert len(proxy.bodies("heartbeat")) >= 3
    assert len(proxy.bodies("attach")) == 1
    assert direct.attempts(score.run_id) == [1]
