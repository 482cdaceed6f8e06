"""A policy behind HTTP, called by a server or by this client; the kit judges it in
test_policy_kit.py.
"""

import contextlib
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, NoReturn

import httpx
import pytest

from conformance.policy import turn_builder
from reference_client import Observation, ProctorError
from reference_client.policies import policy_http_app, serve_command
from reference_client.policies.policy_http_app import PolicyApp
from tests.support.client.evaluations import play
from tests.support.client.policy_apps import (
    ACTION,
    KEY,
    CountingPolicy,
    make_app,
    run_app,
    run_proctor,
)
from tests.support.ports import free_port
from tests.support.push_runs import (
    episodes,
    push_submission,
    submit_push_run,
    wait_for_state,
)
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.usefixtures("policy_key")

BENCHMARK = turn_builder.calibration()


@contextlib.contextmanager
def call_app(app: PolicyApp) -> Iterator[httpx.Client]:
    headers = {"Authorization": f"Bearer {KEY}"}
    with (
        run_app(app.app) as url,
        httpx.Client(
            base_url=url, headers=headers, trust_env=False, timeout=TIMEOUT_S
        ) as client,
    ):
        yield client


def reset(
    client: httpx.Client, session_id: str, index: int = 0, run_id: str = "r"
) -> httpx.Response:
    body = {
        "session_id": session_id,
        "run_id": run_id,
        "benchmark": BENCHMARK,
        "episode": turn_builder.episode(BENCHMARK, index),
    }
    return client.post("/v1/policy/reset", json=body)


def predict(client: httpx.Client, session_id: str, seq: int = 0) -> httpx.Response:
    view = turn_builder.episode(BENCHMARK)
    body = turn_builder.turn(BENCHMARK, session_id, seq, view)
    return client.post("/v1/policy/predict", json=body)


def score_of(answer: httpx.Response) -> float:
    return float(answer.json()["actions"][0]["values"]["score"][0])


@pytest.mark.parametrize(
    ("idle_s", "runs", "status", "evicted"),
    [
        pytest.param(30.0, "rrr", 200, "b", id="a run has all: its longest idle"),
        pytest.param(30.0, "rrs", 503, "", id="another run has all in use"),
        pytest.param(30.0, "rst", 503, "", id="two other runs"),
        pytest.param(30.0, "rsr", 503, "", id="its own may be in use, too"),
        pytest.param(30.0, ("", "", ""), 503, "", id="callers that name no run"),
        pytest.param(0.0, "rrs", 200, "b", id="another run has left one"),
    ],
)
def test_a_session_in_use_is_never_evicted(
    monkeypatch: pytest.MonkeyPatch,
    idle_s: float,
    runs: Sequence[str],
    status: int,
    evicted: str,
) -> None:
    monkeypatch.setattr(policy_http_app, "IDLE_S", idle_s)
    with call_app(make_app(max_sessions=2)) as client:
        for number, session_id in enumerate("ab"):
            reset(client, session_id, number, run_id=runs[number])
        predict(client, "a")
        answer = reset(client, "c", 2, run_id=runs[2])
        assert answer.status_code == status
        if status == 503:
            assert answer.json()["code"] == "unavailable"
            assert "--max-sessions 2" in answer.json()["detail"]
            assert int(answer.headers["retry-after"]) > 0
        for session_id, seq in (("a", 1), ("b", 0)):
            is_known = predict(client, session_id, seq).status_code == 200
            assert is_known == (session_id != evicted)


def test_a_session_whose_call_failed_gives_way() -> None:
    def fail() -> None:
        raise ValueError

    app = PolicyApp(lambda: FailingPolicy(fail), "fails", key=KEY, max_sessions=2)
    with call_app(app) as client:
        for number, session_id in enumerate("ab"):
            reset(client, session_id, number, run_id="r")
            predict(client, session_id)
        assert predict(client, "b", 1).status_code == 500
        assert reset(client, "c", run_id="s").status_code == 200
        assert predict(client, "b", 1).json()["code"] == "session_ended"
        assert reset(client, "d", 2, run_id="s").status_code == 503


@pytest.mark.parametrize(("index", "evicted"), [(0, "a"), (1, "b"), (2, "a")])
def test_a_session_whose_episode_restarts_gives_way(index: int, evicted: str) -> None:
    """Without such a session, that of the run that was idle for longest."""
    with call_app(make_app(max_sessions=2)) as client:
        for number, session_id in enumerate("ab"):
            reset(client, session_id, number)
        assert reset(client, "c", index).status_code == 200
        codes = {name: predict(client, name).status_code for name in "ab"}
        assert codes == {"a": 200, "b": 200} | {evicted: 409}


def test_a_session_whose_policy_is_thinking_is_not_evicted() -> None:
    """The new session of the same run is refused, too, until the policy returns."""
    began, may_continue = threading.Event(), threading.Event()

    class SlowPolicy(CountingPolicy):
        def act(self, observation: Observation) -> list[dict[str, Any]]:
            began.set()
            may_continue.wait(TIMEOUT_S)
            return super().act(observation)

    app = PolicyApp(SlowPolicy, "slow", key=KEY, max_sessions=1)
    with call_app(app) as client, ThreadPoolExecutor(1) as threads:
        reset(client, "a")
        first = threads.submit(predict, client, "a")
        assert began.wait(TIMEOUT_S)
        assert reset(client, "b").json()["code"] == "unavailable"
        may_continue.set()
        assert first.result().status_code == 200
        assert reset(client, "b").status_code == 200
        assert score_of(predict(client, "b")) == 0.1


@pytest.mark.parametrize(
    ("reference", "name"),
    [
        ("hold.py:hold", "hold"),
        ("my.module:Policy", "Policy"),
        ("openpi:ws://127.0.0.1:8000", "openpi"),
        ("ws://127.0.0.1:8000", "ws"),
        ("lerobot:models/act", "act"),
    ],
)
def test_a_served_policy_has_the_name_that_it_has_in_a_pull_run(
    monkeypatch: pytest.MonkeyPatch, reference: str, name: str
) -> None:
    served: list[str] = []

    def make(_make: object, given: str, **_: object) -> NoReturn:
        served.append(given)
        raise StopIteration

    monkeypatch.setattr(serve_command, "load", lambda *_: CountingPolicy)
    monkeypatch.setattr(serve_command, "PolicyApp", make)
    for arguments in ([], ["--name", "given"]):
        with pytest.raises(StopIteration):
            serve_command.main(["--policy", reference, *arguments])
    assert served == [name, "given"]


class FailingPolicy(CountingPolicy):
    """Its second call does what `fail` does; `calls` counts all of them."""

    def __init__(self, fail: Callable[[], Any]) -> None:
        super().__init__()
        self.fail = fail
        self.calls = 0

    def act(self, observation: Observation) -> list[dict[str, Any]]:
        self.calls += 1
        if self.calls != 2:
            return super().act(observation)
        failed: list[dict[str, Any]] = self.fail()
        return failed


def raises(error: BaseException) -> Callable[[], Any]:
    def fail() -> Any:
        raise error

    return fail


class Wordless(Exception):
    def __str__(self) -> str:
        raise ValueError


FAILURES: dict[str, tuple[Callable[[], Any], str]] = {
    "raises": (raises(ValueError("no joint")), "ValueError: no joint (test_serving.py"),
    "stops": (lambda: next(iter([])), "The policy raised StopIteration"),
    "exits": (raises(SystemExit("bye")), "The policy raised SystemExit: bye"),
    "writes_controls": (raises(ValueError("\x1b[2J")), "The policy raised ValueError"),
    "has_no_text": (raises(Wordless()), "raised Wordless: <its str() failed with Val"),
    "is_long": (raises(OSError("x " * 9999)), "(test_serving.py:"),
    "nan": (lambda: [{"score": [float("nan")]}], "/actions/0/values/score/0: is nan"),
    "names": (lambda: [{"grip": [1.0]}], "has grip, which is no name"),
    "sizes": (
        lambda: [ACTION | {"vector": [0.0] * 7}],
        "/actions/0/values/vector: has 7 numbers; vector has 8",
    ),
    "none": (lambda: None, "/actions: is a NoneType"),
}


@pytest.mark.parametrize("name", FAILURES)
def test_a_call_that_failed_is_not_executed_again(
    name: str, caplog: pytest.LogCaptureFixture
) -> None:
    """A third call would succeed: a repeat gets the first outcome, said once."""
    fail, said = FAILURES[name]
    policy = FailingPolicy(fail)
    with call_app(PolicyApp(lambda: policy, "wrong", key=KEY)) as client:
        reset(client, "s")
        assert predict(client, "s").status_code == 200
        failed, repeated = predict(client, "s", 1), predict(client, "s", 1)
        assert failed.content == repeated.content
        assert (failed.status_code, policy.calls) == (500, 2)
        problem = failed.json()
        assert (problem["code"], problem["retryable"]) == ("policy_failed", False)
        assert said in problem["detail"]
        assert len(failed.content) < 4096  # servers read no problem that is long
        assert [said in line for line in caplog.messages] == [True]
        assert "\x1b" not in caplog.text
        assert reset(client, "s").status_code == 200
        assert predict(client, "s", 1).status_code == 200


def test_a_reset_that_failed_begins_nothing() -> None:
    class UnwillingPolicy(CountingPolicy):
        resets = 0

        def reset(self, instruction: str) -> None:
            super().reset(instruction)
            UnwillingPolicy.resets += 1
            if UnwillingPolicy.resets == 1:
                raise KeyError("no such task")

    with call_app(PolicyApp(UnwillingPolicy, "unwilling", key=KEY)) as client:
        failed = [reset(client, "s").json() for _ in range(2)]
        assert failed[0] == failed[1]
        assert "KeyError: 'no such task' (test_serving.py:" in failed[0]["detail"]
        assert predict(client, "s").json()["code"] == "session_ended"
        assert reset(client, "s", 1).status_code == 200
        assert predict(client, "s").status_code == 200


def test_unknown_operations_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(policy_http_app, "BODY_BYTES_MAX", 1000)
    with call_app(make_app()) as client:
        assert client.get("/v1/elsewhere").json()["code"] == "not_found"
        wrong = client.get("/v1/policy/reset")
        assert wrong.json()["code"] == "method_not_allowed"
        assert wrong.headers["allow"] == "POST"
        assert reset(client, "s").json()["code"] == "body_too_large"
        huge = client.post("/v1/policy/predict", content=b"[" * 900)
        assert huge.json()["code"] in ("malformed_body", "invalid_request")


def test_a_picture_that_does_not_decode_is_refused() -> None:
    picture = {"codec": "raw", "width": 9, "height": 9, "channels": 3, "data": "AAAA"}
    with call_app(make_app()) as client:
        reset(client, "s")
        turn = turn_builder.turn(BENCHMARK, "s", 0, turn_builder.episode(BENCHMARK))
        turn["observation"]["images"] = {"front": picture}
        answer = client.post("/v1/policy/predict", json=turn)
        assert answer.json()["code"] == "invalid_request"
        assert "front" in answer.json()["detail"]


def test_assumed_conventions_are_described() -> None:
    assumes = {"control_rate_hz": 20.0}
    with call_app(make_app(assumes=assumes, max_sessions=3)) as client:
        description = client.get("/v1/policy").json()
        assert (description["assumes"], description["max_sessions"]) == (assumes, 3)


# --- end to end ---


def test_a_server_plays_a_policy_that_is_served(push_server: ReferenceServer) -> None:
    with run_app(make_app().app) as url, push_server.client() as client:
        order = {"api_key": KEY, "max_concurrent": 3}
        run_id = submit_push_run(client, url, *["echo"] * 2, *["score"] * 4, **order)
        run = wait_for_state(client, run_id)
        assert (run["state"], run["reason"]) == ("completed", None)
        results = [e["result"] for e in episodes(client, run_id)]
        assert [r["steps"] for r in results] == [3] * 6
        assert [r["score"] for r in results[2:]] == [0.3] * 4


@pytest.mark.parametrize("name", ["raises", "sizes", "none"])
def test_push_and_pull_give_one_reason_for_one_policy(
    push_server: ReferenceServer, name: str
) -> None:
    """In push mode the attempt ends where an evaluation in pull mode stops. A repeat
    would succeed. The reason stands beside what was abandoned in each output."""
    fail, said = FAILURES[name]

    class SecondFails(FailingPolicy):
        def __init__(self) -> None:
            super().__init__(fail)

        def reset(self, instruction: str) -> None:
            super().reset(instruction)
            self.calls = 0

    options = {"tasks": ["score"], "max_attempts": 1}
    with pytest.raises((ValueError, ProctorError)) as pulled:
        play(push_server, SecondFails, options=options)
    assert said.partition(": ")[2].partition(" (")[0] in str(pulled.value)
    app = PolicyApp(SecondFails, "failing", key=KEY)
    with run_app(app.app) as url, push_server.client() as client:
        order = {"options": options, "api_key": KEY, "max_retries": 3}
        run_id = submit_push_run(client, url, **order)
        assert wait_for_state(client, run_id)["state"] == "completed"
        (episode,) = episodes(client, run_id)
    result = episode["result"]
    assert result["outcome"] == "abandoned"
    assert (result["attempt"], result["steps"]) == (1, 1)
    assert said in episode["policy_fault"]
    for command in (["status"], ["results", "--episodes"]):
        printed = run_proctor(push_server, run_id, *command[1:], command=command[0])
        shown = " ".join(printed.stdout.split())
        assert f"policy fault {episode['policy_fault']} In 1 episode: e0000" in shown
        assert "played by pushed, called by the server: 1 episode" in shown
        assert "not declared" not in shown


def test_the_command_serves_an_expert_to_a_real_benchmark(
    push_server: ReferenceServer, tmp_path: Path
) -> None:
    """`proctor serve-policy`, called for a robot's benchmark. Expect a success."""
    (tmp_path / "mine.py").write_text(
        "from reference_sim.benchmarks.tabletop.experts import TabletopExpert\n"
        "class Mine:\n"
        "    def __init__(self):\n"
        "        self.expert = TabletopExpert()\n"
        "    def reset(self, instruction):\n"
        "        self.expert.reset(instruction)\n"
        "    def act(self, observation):\n"
        "        return [self.expert.act(observation.state)]\n"
    )
    port = str(free_port())
    command = ["serve-policy", "--policy", "mine.py:Mine", "--port", port]
    process = subprocess.Popen(
        [sys.executable, "-m", "reference_client.command", *command],
        cwd=tmp_path,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stderr is not None
    assert port in process.stderr.readline()
    with push_server.client() as client:
        order = {"api_key": KEY, "max_concurrent": 1, "max_retries": 5}
        body = push_submission(f"http://127.0.0.1:{port}", **order)
        body = {**body, "benchmark_id": "tabletop_state"}
        del body["options"]
        run_id = client.post("/v1/runs", json=body).json()["run_id"]

        def has_scored() -> bool:
            run = wait_for_state(client, run_id, "ready", "running")
            return bool(run["progress"]["episodes_scored"])

        wait_until(has_scored, "an episode is scored")
        client.post(f"/v1/runs/{run_id}/stop", json={})
        first = episodes(client, run_id)[0]["result"]
    assert (first["outcome"], first["score"]) == ("success", 1.0)
    process.send_signal(signal.SIGTERM)
    process.wait(TIMEOUT_S)
    process.stderr.close()


def is_listening(port: int) -> bool:
    with socket.socket() as probe:
        return probe.connect_ex(("127.0.0.1", port)) == 0


@pytest.mark.slow("starts a program for each row")
@pytest.mark.parametrize(
    ("number", "signals", "endless"),
    [
        (signal.SIGTERM, 1, "time.sleep(1e6)"),
        (signal.SIGINT, 1, "while True: pass"),
        (signal.SIGUSR1, 1, "time.sleep(1e6)"),
        (signal.SIGTERM, 2, "time.sleep(1e6)"),
    ],
)
def test_a_policy_that_never_returns_does_not_keep_its_server(
    number: signal.Signals, signals: int, endless: str, tmp_path: Path
) -> None:
    """The end says what it waits for, and a second signal waits for nothing."""
    (tmp_path / "endless.py").write_text(
        "import time\ndef act(observation):\n    print('acts', flush=True)\n"
        f"    {endless}\n"
    )
    port = free_port()
    with subprocess.Popen(
        [
            *(sys.executable, "-m", "reference_client.command", "serve-policy"),
            *("--policy", "endless.py:act", "--port", str(port)),
        ],
        cwd=tmp_path,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        assert process.stderr is not None
        address = f"http://127.0.0.1:{port}"
        headers = {"Authorization": f"Bearer {KEY}"}
        with (
            httpx.Client(base_url=address, headers=headers, trust_env=False) as client,
            ThreadPoolExecutor(1) as thread,
        ):
            wait_until(lambda: is_listening(port), "the policy server listens")
            assert reset(client, "s").status_code == 200
            call = thread.submit(predict, client, "s")
            assert process.stdout.readline() == "acts\n"
            process.send_signal(number)
            while "Another signal ends it at once." not in process.stderr.readline():
                assert process.poll() is None
            for _ in range(signals - 1):
                process.send_signal(number)
            assert process.wait(TIMEOUT_S) == 128 + number
            assert isinstance(call.exception(), httpx.TransportError)
        assert "Traceback" not in process.stderr.read()


@pytest.mark.parametrize("policy", ["nowhere.py:X", "json:nothing"])
def test_an_invalid_policy_reference_is_reported(
    policy: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    assert serve_command.main(["--policy", policy]) == 2
    assert capsys.readouterr().err.startswith("proctor: ")


@pytest.mark.parametrize("error", ["ValueError", "RuntimeError"])
def test_what_the_maker_of_a_policy_raises_is_said_to_be_its_error(
    error: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("makes.py").write_text(f"def make():\n    raise {error}('no weights')\n")
    assert serve_command.main(["--policy", "makes.py:make"]) == 2
    said = capsys.readouterr().err
    assert f"The policy raised {error}: no weights (makes.py:2)" in said
    assert "Traceback" not in said


def test_a_port_in_use_is_said_before_anything_is_served(
    policy_folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(policy_folder)
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = str(other.getsockname()[1])
        words = ["--policy", "policies:best", "--port", port]
        assert serve_command.main(words) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert line.startswith(f"proctor: cannot listen on 127.0.0.1:{port} (Address")
    assert "--port" in line
