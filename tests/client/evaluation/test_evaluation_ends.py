"""How an evaluation by the reference client ends, other than with a score.

What it says, what it leaves behind, and how it goes on.
"""

import io
import os
import queue
import re
import signal
import subprocess
import sys
import threading
import time
from collections import deque
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar, cast

import pytest
from proctor_client import StopRun

from reference_client import Observation, ProctorError, RunFailed, RunStopped, evaluate
from reference_client.errors import WORKER_DIED, PolicyFailed
from reference_client.evaluation import evaluate as evaluate_module
from reference_client.evaluation import wait_reminder
from reference_client.evaluation.status_board import ProgressLine, StatusBoard
from reference_client.evaluation.uncaught_errors import _print_text
from reference_client.policies.servers.server_transport import reporting_wait
from tests.support.client.direct_client import DirectClient
from tests.support.client.evaluations import play, play_on, run_in_thread
from tests.support.client.policies import (
    Actions,
    BlockingPolicy,
    ExactlyOncePolicy,
    GradedPolicy,
)
from tests.support.network.lossy_proxy import Proxy
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer
from tests.support.sim.calibration_action import calibration_action as action

# Runs that end, and go on


def test_a_failed_run_states_its_reason_and_resumes(server: ReferenceServer) -> None:
    class FaultingPolicy(GradedPolicy):
        fault = 1.0

        def act(self, observation: Observation) -> Actions:
            return [action(fault=self.fault, success=1.0, end=1.0)]

    options = {"tasks": ["count", "fault"], "max_faults": 2}
    with pytest.raises(RunFailed, match=r"faulted 2 times.*run_id=") as caught:
        play(server, FaultingPolicy, options=options)
    assert caught.value.retryable
    run_id = caught.value.run.run_id
    FaultingPolicy.fault = 0.0
    score = play_on(server, FaultingPolicy, run_id)
    assert score.score == 1.0


def test_a_run_that_cannot_resume_is_reported(server: ReferenceServer) -> None:
    class UnplayablePolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            return [action(fault=2.0)]

    with pytest.raises(RunFailed, match="It cannot be resumed") as caught:
        play(server, UnplayablePolicy, "fault")
    run_id = caught.value.run.run_id
    with pytest.raises(RunFailed, match="It cannot be resumed"):
        play_on(server, GradedPolicy, run_id)


@pytest.mark.parametrize("mode", ["abort", "drain"])
def test_a_stopped_run_is_reported_and_resumes(
    server: ReferenceServer, direct: DirectClient, mode: str
) -> None:
    policy = BlockingPolicy()
    tasks = "count", "count"
    evaluation = run_in_thread(play, server, lambda: policy, *tasks, name="counter")
    assert policy.is_acting.wait(TIMEOUT_S)
    run_id = direct.latest().run_id
    direct.control.stop_run(run_id, StopRun.from_dict({"mode": mode}))
    policy.may_continue.set()
    with pytest.raises(RunStopped, match=f'run_id="{run_id}"'):
        evaluation.result(TIMEOUT_S)
    named = {"benchmark": "calibration", "name": "counter"}
    score = play_on(server, ExactlyOncePolicy, run_id, **named)
    assert score.score == 1.0


def test_a_completed_run_has_its_score_at_once(server: ReferenceServer) -> None:
    first = play(server, GradedPolicy, "score", "score")
    again = play_on(server, GradedPolicy, first.run_id)
    assert again == first


def test_a_worker_that_ends_alone_gives_its_episode_back(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """One of two workers ends in the middle of an episode, and the other plays on.
    Expect it to play that episode, too, long before the lease is over."""
    is_in_the_middle, may_end = threading.Event(), threading.Event()
    made: list[GradedPolicy] = []

    class EndingPolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            if made[0] is self and observation.step == 1:
                is_in_the_middle.set()
                may_end.wait(TIMEOUT_S)
                raise ProctorError(WORKER_DIED, "the device was lost")
            if made[0] is not self:
                is_in_the_middle.wait(TIMEOUT_S)
                may_end.set()
            return super().act(observation)

    def make() -> GradedPolicy:
        made.append(EndingPolicy())
        return made[-1]

    playing = run_in_thread(play, server, make, *["score"] * 4, workers=2)
    score = playing.result(TIMEOUT_S)
    assert score.complete
    assert sum(direct.attempts(score.run_id)) == 5


class RaisingPolicy(GradedPolicy):
    def act(self, observation: Observation) -> Actions:
        raise ZeroDivisionError("mine")


def test_a_policy_that_raises_leaves_no_session(
    server: ReferenceServer, direct: DirectClient
) -> None:
    with pytest.raises(ZeroDivisionError, match="mine") as caught:
        play(server, RaisingPolicy, "score", "score", workers=2)
    run = direct.latest()
    assert run.live_workers == 0
    assert f'run_id="{run.run_id}"' in "\n".join(caught.value.__notes__)
    reasons = direct.reasons(run.run_id)
    said = r"The policy raised ZeroDivisionError: mine \(test_\w+\.py:\d+\)"
    assert any(re.fullmatch(said, reason or "") for reason in reasons), reasons


def test_a_policy_that_exits_the_program_is_reported(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """Expect an error with the run in it, not the end of the program."""

    class ExitingPolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            raise SystemExit(0)

    with pytest.raises(PolicyFailed, match=r"raised SystemExit: 0 \(test_") as caught:
        play(server, ExitingPolicy, "score")
    run = direct.latest()
    assert f'run_id="{run.run_id}"' in "\n".join(caught.value.__notes__)


def test_a_policy_that_raises_ends_the_other_workers_too(
    server: ReferenceServer, direct: DirectClient
) -> None:
    made: list[GradedPolicy] = []

    def make() -> GradedPolicy:
        made.append(GradedPolicy() if made else RaisingPolicy())
        return made[-1]

    with pytest.raises(ZeroDivisionError):
        play(server, make, *["score"] * 300, workers=2)
    run = direct.latest()
    # The other one may be in the middle of an episode; that one waits.
    assert run.live_workers <= 1
    assert set(direct.attempts(run.run_id)) == {1}
    assert run.progress.episodes_pending > 0


def test_an_interrupted_episode_is_continued_at_its_step(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """The policy raises at step 2. Expect a note that says what waits, and no attempt
    lost when `takeover` continues it."""

    class RaisingPolicy(GradedPolicy):
        may_pass = False
        steps: ClassVar[list[int]] = []

        def act(self, observation: Observation) -> Actions:
            self.steps.append(observation.step)
            if observation.step == 2 and not self.may_pass:
                raise ZeroDivisionError("mine")
            return [action(success=1.0, end=float(observation.step == 3))]

    with pytest.raises(ZeroDivisionError) as caught:
        play(server, RaisingPolicy, "count")
    note = "\n".join(caught.value.__notes__)
    run_id = direct.latest().run_id
    [reason] = direct.reasons(run_id)
    assert (reason or "").startswith("The policy raised ZeroDivisionError: mine (test_")
    assert re.search(r"e0000 waits at step 2 until \d\d:\d\d:\d\d UTC; attempt 1", note)
    assert f'run_id="{run_id}", takeover=True) continues it' in note
    RaisingPolicy.may_pass = True
    score = play_on(server, RaisingPolicy, run_id, takeover=True)
    assert (score.score, direct.attempts(run_id)) == (1.0, [1])
    assert RaisingPolicy.steps == [0, 1, 2, 2, 3]


INTERRUPTED = """
import sys, threading
from reference_client import evaluate
from reference_client.evaluation import rounds

rounds.STOP_TIMEOUT_S = 0.2

class Stuck:
    def reset(self, instruction): ...
    def act(self, observation):
        print("acting", flush=True)
        threading.Event().wait()

evaluate(Stuck, url=sys.argv[1], token=sys.argv[2], benchmark="calibration",
         dry_turn=False)
"""


def test_ctrl_c_detaches_and_prints_how_to_resume(
    server: ReferenceServer, direct: DirectClient
) -> None:
    """Even while the policy is lost in thought."""
    with subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, server.url, TOKENS["alice"]],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == "acting\n"
        run_id = direct.latest().run_id
        program.send_signal(signal.SIGINT)
        _, stderr_text = program.communicate(timeout=TIMEOUT_S)
    assert program.returncode == -signal.SIGINT
    report = stderr_text[stderr_text.index("Traceback (most recent") :].splitlines()
    assert f'evaluate(..., run_id="{run_id}") continues it' in report[-1]
    where = [line for line in report if line.startswith("  File")]
    assert ", line 14, in <module>" in where[0]
    assert len(where) <= 3, stderr_text
    run = direct.control.get_run(run_id)
    assert (run.state.value, run.live_workers) == ("ready", 0)
    by_user = "Its evaluation was interrupted by its user."
    assert direct.reasons(run_id)[0] == by_user
    assert play_on(server, GradedPolicy, run_id).complete


# Error texts


def error_of(server: Any, make: Any = GradedPolicy, **arguments: Any) -> ProctorError:
    with pytest.raises(ProctorError) as caught:
        play(server, make, "score", **arguments)
    return caught.value


def test_a_wrong_token_is_reported(
    server: ReferenceServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    error = error_of(server, token="wrong")
    assert (error.code, error.retryable) == ("unauthenticated", False)
    assert "sent the value of the argument `token`" in str(error)
    assert error_of(server, token=None).code == "unauthenticated"
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["reader"])
    assert error_of(server, token=None).code == "forbidden"


@pytest.mark.slow("starts a program")
@pytest.mark.parametrize("debug", [False, True])
def test_a_wrong_token_ends_a_program_with_one_line(
    server: ReferenceServer, tmp_path: Path, debug: bool
) -> None:
    file = tmp_path / "program.py"
    file.write_text(
        "from reference_client import evaluate\n"
        f"evaluate(object, url='{server.url}', token='x', benchmark='calibration')\n"
    )
    ended = run_program(
        [sys.executable, file],
        cwd=ROOT,
        env=os.environ | {"PROCTOR_DEBUG": "1" if debug else ""},
        timeout=TIMEOUT_S,
    )
    assert (ended.returncode, ended.stdout) == (1, "")
    assert "give the argument `token`. [unauthenticated]\n" in ended.stderr
    assert ("Traceback" in ended.stderr) == debug
    assert debug or ended.stderr.count("\n") == 1, ended.stderr


def test_other_errors_keep_their_traceback(capsys: pytest.CaptureFixture[str]) -> None:
    """Of the program, and of a policy, which is the program's, too."""
    for error in (KeyError("x"), PolicyFailed("it raised", "")):
        _print_text(type(error), error, None)
        assert type(error).__name__ in capsys.readouterr().err


def test_an_unreachable_server_is_reported_with_its_url() -> None:
    with Proxy("http://unused") as closed:
        pass
    error = error_of(closed, retry_timeout_s=0.5)
    assert error.code == "unreachable"
    assert f"{closed.url} is unreachable (Connection refused)" in str(error)


@pytest.mark.slow("starts a server or a kit")
def test_a_server_that_is_not_proctor_is_reported(proxy: Proxy) -> None:
    proxy.faults["describe"] = deque(["gateway"] * 10)
    error = error_of(proxy, retry_timeout_s=0.3)
    assert error.code == "bad_answer"
    assert f"{proxy.url} answered 502 Bad Gateway" in str(error)
    assert "A proxy before a server answers so while it reaches none." in str(error)


def test_actions_that_do_not_fit_are_pointed_at(server: ReferenceServer) -> None:
    class OutOfRangePolicy(GradedPolicy):
        def act(self, observation: Observation) -> Actions:
            return [action(), action(score=7.0)]

    error = error_of(server, OutOfRangePolicy)
    assert error.code == "invalid_request"
    assert [pointer for pointer, _ in error.errors] == ["/actions/1/values/score/0"]
    assert "/actions/1/values/score/0" in str(error)


def test_more_workers_than_the_server_has_are_refused(server: ReferenceServer) -> None:
    assert "17 workers" in str(error_of(server, workers=17))


def test_invalid_arguments_are_refused(server: ReferenceServer) -> None:
    with pytest.raises(ValueError, match="http://"):
        evaluate(GradedPolicy, url="localhost:8460", benchmark="calibration")
    with pytest.raises(ValueError, match=r"benchmark=.*run_id="):
        evaluate(GradedPolicy, url=server.url)
    with pytest.raises(ValueError, match="control_rate"):
        play(server, GradedPolicy, "score", assumes={"control_rate": 1})
    run_id = play(server, GradedPolicy, "score").run_id
    with pytest.raises(ValueError, match="'calibration', not 'tabletop'"):
        play_on(server, GradedPolicy, run_id, benchmark="tabletop")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"workers": "2"}, "workers must be a whole number, not '2'"),
        ({"workers": 2.0}, "workers must be a whole number, not 2.0"),
        ({"episodes": True}, "episodes must be a whole number, not True"),
        ({"name": 5}, "name must be a text, not 5"),
        ({"tasks": "reach"}, "tasks must be a list of names, not 'reach'"),
        ({"splits": "test"}, "splits must be a list of names, not 'test'"),
    ],
)
def test_an_argument_of_a_wrong_type_is_named(
    arguments: dict[str, Any], says: str
) -> None:
    with pytest.raises(ValueError, match=f"^{says}$"):
        evaluate(GradedPolicy, url="http://h:1", benchmark="calibration", **arguments)


class PassingTime:
    """An event that is set after `ends_s`; each wait for it takes a second at once."""

    def __init__(self, ends_s: float) -> None:
        self.now_s, self._ends_s = 0.0, ends_s

    def wait(self, _timeout_s: float) -> bool:
        self.now_s += 1.0
        return self.now_s > self._ends_s


@pytest.mark.parametrize(
    ("texts", "said"),
    [
        (["prepares"], [11, 21, 41, 81, 161]),
        (["prepares", "judges"], [11, 21, 41, 81, 110, 120, 140, 180]),
        (["Busy. Until 1 h.", "Busy. Until 2 h.", "Busy."], [11, 21, 41, 81, 161]),
    ],
)
def test_a_long_wait_is_said_ever_more_rarely(
    monkeypatch: pytest.MonkeyPatch, texts: list[str], said: list[int]
) -> None:
    """Each text from the beginning. Expect no log that a person fills by a break."""
    clock, lines = PassingTime(200.0), list[str]()
    monkeypatch.setattr(time, "monotonic", lambda: clock.now_s)
    board, half_s = SimpleNamespace(), 200.0 / len(texts)
    board.current_wait = lambda: (
        texts[min(int(clock.now_s // half_s), len(texts) - 1)],
        clock.now_s,
    )
    wait_reminder._remind(
        cast("StatusBoard", board),
        lines.append,
        lambda: 10.0,
        cast("threading.Event", clock),
    )
    assert [int(line.split()[2]) for line in lines] == said


def test_a_wait_is_said_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(wait_reminder, "_LOOK_S", 0.001)
    monkeypatch.setattr(wait_reminder, "EVERY_S", 0.01)
    board, said = StatusBoard(), queue.Queue[str]()
    with wait_reminder.remind_of_waits(board, said.put, lambda: 0.005):
        board.waiting_reporter("worker-0")("the server is restarting")
        for _ in range(3):
            line = said.get(timeout=TIMEOUT_S)
            assert line.endswith("s: worker-0: the server is restarting")


@pytest.mark.parametrize("is_terminal", [True, False])
def test_a_policy_server_that_loads_is_said_before_there_is_a_run(
    server: ReferenceServer,
    monkeypatch: pytest.MonkeyPatch,
    is_terminal: bool,
) -> None:
    """Also where a progress line follows. It is ready as soon as that is said."""
    line = ProgressLine(io.StringIO()) if is_terminal else None
    monkeypatch.setattr(evaluate_module, "terminal_progress_line", lambda: line)
    monkeypatch.setattr(evaluate_module, "FIRST_S", 0.0)
    is_said, lines = threading.Event(), list[str]()

    def warn(line: str) -> None:
        lines.append(line)
        is_said.set()

    monkeypatch.setattr(evaluate_module._LOG, "warning", warn)

    def make() -> GradedPolicy:
        with reporting_wait("http://policy") as say:
            say("is not ready. It says: loading")
            assert is_said.wait(TIMEOUT_S)
        return GradedPolicy()

    play(server, make, "score", progress=None)
    said = "The policy server at http://policy is not ready. It says: loading."
    assert lines[0].endswith(said)
