"""How an evaluation by the reference client ends, other than with a score.

What it says, what it leaves behind, and how it goes on.
"""

from __future__ import annotations

import signal
import subprocess
import sys
from collections import deque
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from proctor_client import StopRun

from reference_client import (
    Observation,
    ProctorError,
    RunFailed,
    RunStopped,
    evaluate,
)
from tests.test_reference_client_scenes import (
    DEADLINE_S,
    ROOT,
    TOKEN,
    Actions,
    Counting,
    Graded,
    Held,
    House,
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


# Runs that end, and go on


def test_a_failed_run_says_why_and_goes_on(server: ServerProcess) -> None:
    class Fatal(Graded):
        fault = 1.0

        def act(self, observation: Observation) -> Actions:
            return [action(fault=self.fault, success=1.0, end=1.0)]

    with pytest.raises(RunFailed, match=r"faulted 2 times.*run_id=") as caught:
        evaluate(Fatal, url=server.url, **calibration("count", "fault", max_faults=2))
    assert caught.value.retryable
    run_id = caught.value.run.run_id
    Fatal.fault = 0.0
    score = evaluate(Fatal, url=server.url, token=TOKEN, run_id=run_id, progress=quiet)
    assert score.score == 1.0


def test_a_run_that_cannot_go_on_says_so(server: ServerProcess) -> None:
    class Unplayable(Graded):
        def act(self, observation: Observation) -> Actions:
            return [action(fault=2.0)]

    with pytest.raises(RunFailed, match="It cannot be resumed") as caught:
        evaluate(Unplayable, url=server.url, **calibration("fault"))
    run_id = caught.value.run.run_id
    with pytest.raises(RunFailed, match="It cannot be resumed"):
        evaluate(Graded, url=server.url, token=TOKEN, run_id=run_id, progress=quiet)


@pytest.mark.parametrize("mode", ["abort", "drain"])
def test_a_stopped_run_is_reported_and_goes_on(
    server: ServerProcess, house: House, mode: str
) -> None:
    policy = Held()
    evaluation = aside(
        evaluate, lambda: policy, url=server.url, **calibration("count", "count")
    )
    assert policy.is_acting.wait(DEADLINE_S)
    run_id = house.latest().run_id
    house.control.stop_run(run_id, StopRun.from_dict({"mode": mode}) or StopRun())
    policy.may_go.set()
    with pytest.raises(RunStopped, match=f'run_id="{run_id}"'):
        evaluation.result(DEADLINE_S)
    score = evaluate(
        Counting,
        url=server.url,
        token=TOKEN,
        benchmark="calibration",
        run_id=run_id,
        progress=quiet,
    )
    assert score.score == 1.0


def test_a_completed_run_has_its_score_at_once(server: ServerProcess) -> None:
    first = evaluate(Graded, url=server.url, **calibration("score", "score"))
    again = evaluate(
        Graded, url=server.url, token=TOKEN, run_id=first.run_id, progress=quiet
    )
    assert again == first


def test_a_policy_that_raises_leaves_no_session(
    server: ServerProcess, house: House
) -> None:
    class Broken(Graded):
        def act(self, observation: Observation) -> Actions:
            raise ZeroDivisionError("mine")

    with pytest.raises(ZeroDivisionError, match="mine") as caught:
        evaluate(Broken, url=server.url, workers=2, **calibration("score", "score"))
    run = house.latest()
    assert run.live_workers == 0
    assert f'run_id="{run.run_id}"' in "\n".join(caught.value.__notes__)


def test_a_policy_that_raises_ends_the_other_workers_too(
    server: ServerProcess, house: House
) -> None:
    class Broken(Graded):
        def act(self, observation: Observation) -> Actions:
            raise ZeroDivisionError("mine")

    made: list[Graded] = []

    def make() -> Graded:
        made.append(Graded() if made else Broken())
        return made[-1]

    episodes = ["score"] * 300
    with pytest.raises(ZeroDivisionError):
        evaluate(make, url=server.url, workers=2, **calibration(*episodes))
    run = house.latest()
    assert run.live_workers == 0
    assert run.progress.episodes_pending > 0


INTERRUPTED = """
import sys, threading
from reference_client import evaluate, evaluation

evaluation.FAREWELL_S = 0.2

class Stuck:
    def reset(self, instruction): ...
    def act(self, observation):
        print("acting", flush=True)
        threading.Event().wait()

evaluate(Stuck, url=sys.argv[1], token=sys.argv[2], benchmark="calibration")
"""


def test_ctrl_c_detaches_and_says_how_to_go_on(
    server: ServerProcess, house: House
) -> None:
    """Even while the policy is lost in thought."""
    with subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, server.url, TOKEN],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == "acting\n"
        run_id = house.latest().run_id
        program.send_signal(signal.SIGINT)
        _, told = program.communicate(timeout=DEADLINE_S)
    assert f'evaluate(..., run_id="{run_id}") goes on with it' in told
    run = house.control.get_run(run_id)
    assert (run.state.value, run.live_workers) == ("ready", 0)
    assert evaluate(
        Graded, url=server.url, token=TOKEN, run_id=run_id, progress=quiet
    ).complete


# What a person is told


def refused(make: Callable[[], Any] = Graded, **arguments: Any) -> ProctorError:
    with pytest.raises(ProctorError) as caught:
        evaluate(make, **arguments)
    return caught.value


def test_a_wrong_token_is_told(
    server: ServerProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    error = refused(url=server.url, token="wrong", benchmark="calibration")
    assert (error.code, error.retryable) == ("unauthenticated", False)
    assert "PROCTOR_TOKEN" in str(error)
    assert refused(url=server.url, benchmark="calibration").code == "unauthenticated"
    monkeypatch.setenv("PROCTOR_TOKEN", "t2")
    assert refused(url=server.url, benchmark="calibration").code == "forbidden"


def test_an_unreachable_server_is_told_by_its_url() -> None:
    with Relay("http://unused") as closed:
        url = closed.url
    error = refused(url=url, benchmark="calibration", patience_s=0.5)
    assert error.code == "unreachable"
    assert f"{url} does not answer (Connection refused)" in str(error)


def test_a_server_of_another_kind_is_told(relay: Relay) -> None:
    relay.fates["/v1"] = deque(["gateway"] * 10)
    error = refused(url=relay.url, benchmark="calibration", patience_s=0.3)
    assert error.code == "bad_answer"
    assert f"{relay.url} answered 502 Bad Gateway" in str(error)


def test_actions_that_do_not_fit_are_pointed_at(server: ServerProcess) -> None:
    class Misfit(Graded):
        def act(self, observation: Observation) -> Actions:
            return [action(), action(score=7.0)]

    error = refused(Misfit, url=server.url, **calibration("score"))
    assert error.code == "invalid_request"
    assert [pointer for pointer, _ in error.errors] == ["/actions/1/values/score/0"]
    assert "/actions/1/values/score/0" in str(error)


def test_conventions_that_differ_are_refused(server: ServerProcess) -> None:
    error = refused(
        url=server.url, assumes={"control_rate_hz": 30.0}, **calibration("score")
    )
    assert error.code == "convention_mismatch"
    assert [pointer for pointer, _ in error.errors] == ["/assumes/control_rate_hz"]


def test_more_workers_than_the_server_has_are_refused(server: ServerProcess) -> None:
    error = refused(url=server.url, workers=17, **calibration("score"))
    assert "17 workers" in str(error)


def test_arguments_that_cannot_be_meant_are_refused(server: ServerProcess) -> None:
    with pytest.raises(ValueError, match="http://"):
        evaluate(Graded, url="localhost:8460", benchmark="calibration")
    with pytest.raises(ValueError, match=r"benchmark=.*run_id="):
        evaluate(Graded, url=server.url)
    with pytest.raises(ValueError, match="control_rate"):
        evaluate(
            Graded, url=server.url, assumes={"control_rate": 1}, **calibration("score")
        )
    run_id = evaluate(Graded, url=server.url, **calibration("score")).run_id
    with pytest.raises(ValueError, match="'calibration', not 'tabletop'"):
        evaluate(
            Graded, url=server.url, token=TOKEN, benchmark="tabletop", run_id=run_id
        )
