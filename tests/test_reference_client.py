"""The reference client against the reference server, over a wire that loses answers.

What ran twice shows in the state `count` of the benchmark calibration, what was lost in
the attempts of the episodes.
"""

from __future__ import annotations

import signal
import threading
import time
from collections import deque
from collections.abc import Iterator
from pathlib import Path

import pytest
from proctor_client import Action, Predict

from reference_client import Observation, ProctorError, evaluate
from tests.test_reference_client_scenes import (
    ANY_ANSWER,
    DEADLINE_S,
    TOKEN,
    Actions,
    Counting,
    Graded,
    Held,
    House,
    Listener,
    Relay,
    ServerProcess,
    action,
    aside,
    calibration,
    quiet,
    serving,
)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ServerProcess]:
    with ServerProcess(tmp_path_factory.mktemp("server")) as process:
        yield process


@pytest.fixture
def relay(server: ServerProcess) -> Iterator[Relay]:
    with serving(Relay(server.url)) as relay:
        yield relay


@pytest.fixture
def house(server: ServerProcess) -> Iterator[House]:
    with House(server.url) as house:
        yield house


# An undisturbed evaluation


def test_several_workers_play_every_episode_once(
    server: ServerProcess, house: House
) -> None:
    """Each has its own policy, which is reset for each episode it plays."""
    policies: list[Graded] = []

    def make() -> Graded:
        policies.append(Graded())
        return policies[-1]

    listener = Listener()
    score = evaluate(
        make,
        url=server.url,
        workers=3,
        **calibration(*["score"] * 12) | {"progress": listener},
    )
    assert score.score == pytest.approx(sum(i % 5 / 4 for i in range(12)) / 12)
    assert len(policies) == 3
    assert sum(policy.resets for policy in policies) == 12
    assert house.attempts(score.run_id) == [1] * 12
    scored = [progress.episodes_scored for progress in listener.heard]
    assert scored == sorted(scored)
    assert (scored[0], scored[-1]) == (0, 12)
    assert listener.heard[0].mean is None
    assert listener.heard[-1].mean == score.mean


def test_the_readme_policy_solves_every_task(server: ServerProcess) -> None:
    from reference_sim.benchmarks.tabletop.experts import TabletopExpert

    class Expert:
        def __init__(self) -> None:
            self._expert = TabletopExpert()

        def reset(self, instruction: str) -> None:
            assert instruction.endswith(".")
            self._expert.reset(instruction)

        def act(self, observation: Observation) -> Actions:
            return [self._expert.act(observation.state)]

    score = evaluate(
        Expert,
        url=server.url,
        token=TOKEN,
        benchmark="tabletop_state",
        workers=2,
        progress=quiet,
    )
    assert score.score == 1.0


@pytest.mark.parametrize("codec", ["raw", "png", "jpeg"])
def test_images_and_tensors_arrive_as_the_benchmark_says(
    server: ServerProcess, codec: str
) -> None:
    seen: list[Observation] = []

    class Looking(Graded):
        def act(self, observation: Observation) -> Actions:
            seen.append(observation)
            return super().act(observation)

    images = {"codec": codec, "width": 64, "height": 48}
    evaluate(Looking, url=server.url, images=images, **calibration("echo"))
    for count, observation in enumerate(seen):
        pattern = observation.images["pattern"]
        assert pattern.shape == (48, 64, 3)
        if codec != "jpeg":
            assert pattern[5, 7, 2] == (7 * 7 + 13 * 5 + 29 * 2 + count) % 256
        tensors = observation.tensors
        assert tensors["int16"].tolist() == [[-2, -1, 0], [1, -(2**15), 2**15 - 1]]
        assert tensors["bool"].tolist() == [[False, True, False], [True, False, True]]
        assert tensors["uint64"][1, 2] == 2**64 - 1
        assert tensors["empty"].shape == (0, 3)
    assert len(seen) == 2


# A wire that loses answers


def test_lost_answers_to_predict_execute_nothing_twice(
    relay: Relay, house: House
) -> None:
    relay.fates["predict"] = deque(
        ["lose_answer", "pass", "lose_request", "cut_answer", "gateway"]
        + ["lose_answer"] * 3
    )
    score = evaluate(Counting, url=relay.url, **calibration("count", "count"))
    assert score.score == 1.0
    assert not relay.fates["predict"]
    for episode in house.episodes(score.run_id):
        assert episode.result is not None
        assert (episode.result.attempt, episode.result.steps) == (1, 10)
    # 10 turns of 2 steps, and 7 that were asked for again.
    assert len(relay.bodies("predict")) == 17


def test_a_lost_answer_to_attach_is_asked_for_again(relay: Relay, house: House) -> None:
    relay.fates["attach_worker"] = deque(["lose_answer", "cut_answer"])
    # With a short lease, so that a session that nobody knows of would not hold us up.
    score = evaluate(Counting, url=relay.url, idle_timeout_s=1, **calibration("count"))
    attachments = relay.bodies("attach_worker")
    assert len({body["attach_key"] for body in attachments}) == 1
    assert len(attachments) == 3
    assert house.attempts(score.run_id) == [1]


def test_a_lost_answer_to_submit_makes_one_run(relay: Relay, house: House) -> None:
    before = {run.run_id for run in house.control.list_runs().runs}
    relay.fates["submit_run"] = deque(["lose_answer", "gateway"])
    score = evaluate(Graded, url=relay.url, **calibration("score"))
    after = {run.run_id for run in house.control.list_runs().runs}
    assert after - before == {score.run_id}


def test_a_server_killed_and_restarted_gives_the_same_score(tmp_path: Path) -> None:
    turns = iter(range(1000))
    restart: list[threading.Thread] = []

    class Killing(Graded):
        def act(self, observation: Observation) -> Actions:
            if next(turns) == 7:
                mortal.end(signal.SIGKILL)
                restart.append(threading.Thread(target=mortal.start))
                restart[0].start()
            return super().act(observation)

    eight = calibration(*["score"] * 8)
    listener = Listener()
    with ServerProcess(tmp_path) as mortal, House(mortal.url) as house:
        undisturbed = evaluate(Graded, url=mortal.url, **eight)
        try:
            score = evaluate(
                Killing, url=mortal.url, workers=2, **eight | {"progress": listener}
            )
        finally:
            restart[0].join()
        attempts = house.attempts(score.run_id)
    assert score.score == undisturbed.score
    assert attempts == [1] * 8
    waited_for = [progress.waiting or "" for progress in listener.heard]
    assert any(f"{mortal.url} does not answer" in text for text in waited_for)


# Other sessions


def test_a_worker_that_is_taken_over_stops(server: ServerProcess, house: House) -> None:
    policy = Held()
    evaluation = aside(evaluate, lambda: policy, url=server.url, **calibration("count"))
    assert policy.is_acting.wait(DEADLINE_S)
    run_id = house.latest().run_id
    house.attach(run_id, "worker-0", takeover=True)
    policy.may_go.set()
    with pytest.raises(ProctorError, match="takeover=True") as caught:
        evaluation.result(DEADLINE_S)
    assert caught.value.code == "session_superseded"
    assert house.control.get_run(run_id).live_workers == 1


def test_takeover_goes_on_where_a_crashed_program_stood(
    server: ServerProcess, house: House
) -> None:
    run = house.submit("count", idle_timeout_s=5)
    turn = house.attach(run.run_id, "worker-0")
    chunk = [Action(values=action())] * 3
    house.data.predict(
        run.run_id,
        "worker-0",
        Predict(session_id=turn.session_id, seq=1, actions=chunk),
    )
    policy = Held()
    policy.may_go.set()
    score = evaluate(
        lambda: policy,
        url=server.url,
        token=TOKEN,
        run_id=run.run_id,
        takeover=True,
        progress=quiet,
    )
    assert policy.first is not None
    assert policy.first.step == 3
    assert policy.instructions == ["Calibration task count."]
    assert score.score == 1.0
    assert house.attempts(run.run_id) == [1]


def test_a_busy_worker_is_waited_for_until_its_lease_ends(
    server: ServerProcess, house: House
) -> None:
    run = house.submit("score", "score", idle_timeout_s=1)
    house.attach(run.run_id, "worker-0")
    listener = Listener()
    busy = listener.waits_for("takeover=True")
    score = evaluate(
        Graded, url=server.url, token=TOKEN, run_id=run.run_id, progress=listener
    )
    assert score.complete
    assert busy.is_set()


def test_a_full_run_is_waited_for(server: ServerProcess, house: House) -> None:
    run = house.submit("score", "score", max_workers=1)
    occupant = house.attach(run.run_id, "occupant")
    listener = Listener()
    full = listener.waits_for("live workers")
    evaluation = aside(
        evaluate,
        Graded,
        url=server.url,
        token=TOKEN,
        run_id=run.run_id,
        progress=listener,
    )
    assert full.wait(DEADLINE_S)
    house.data.detach_worker(
        run.run_id, "occupant", occupant.session_id, _headers=ANY_ANSWER
    )
    assert evaluation.result(DEADLINE_S).complete
    assert listener.heard[-1].waiting is None


def test_what_a_dead_session_leaves_is_played(
    server: ServerProcess, house: House
) -> None:
    """Its episode is pending again only after our workers found nothing more."""
    run = house.submit("score", "score", "score", idle_timeout_s=1)
    house.attach(run.run_id, "dead")
    score = evaluate(
        Graded,
        url=server.url,
        token=TOKEN,
        run_id=run.run_id,
        workers=2,
        progress=quiet,
    )
    assert score.counts.success == 3


def test_heartbeats_keep_the_lease_while_the_policy_thinks(
    relay: Relay, house: House
) -> None:
    class Slow(Graded):
        def act(self, observation: Observation) -> Actions:
            time.sleep(1.7)  # the lease is 1 s
            return [action(score=1.0, end=1.0)]

    relay.fates["heartbeat"] = deque(["pass", "lose_answer"])
    score = evaluate(Slow, url=relay.url, idle_timeout_s=1, **calibration("score"))
    assert len(relay.bodies("heartbeat")) >= 3
    assert len(relay.bodies("attach_worker")) == 1
    assert house.attempts(score.run_id) == [1]
