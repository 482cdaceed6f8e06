"""A policy behind HTTP, called by a server or by this client; the kit judges it in
test_policy_kit.py.
"""

import contextlib
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest

from conformance.policy import turns
from reference_client import Observation
from reference_client.policies import serving
from reference_client.policies.serving import PolicyApp
from tests.conftest import PATIENCE_S, House
from tests.policy_parts import KEY, Counting, an_app, free_port, house, its_key
from tests.policy_parts import serving as served
from tests.push_parts import episodes, submission, submitted, until

__all__ = ["house", "its_key"]
BENCHMARK = turns.calibration()


@contextlib.contextmanager
def calling(app: PolicyApp) -> Iterator[httpx.Client]:
    headers = {"Authorization": f"Bearer {KEY}"}
    with (
        served(app.app) as url,
        httpx.Client(base_url=url, headers=headers, trust_env=False) as client,
    ):
        yield client


def reset(client: httpx.Client, session_id: str, index: int = 0) -> httpx.Response:
    body = {
        "session_id": session_id,
        "run_id": "r",
        "benchmark": BENCHMARK,
        "episode": turns.episode(BENCHMARK, index),
    }
    return client.post("/v1/policy/reset", json=body)


def predict(client: httpx.Client, session_id: str, seq: int = 0) -> httpx.Response:
    view = turns.episode(BENCHMARK)
    body = turns.turn(BENCHMARK, session_id, seq, view)
    return client.post("/v1/policy/predict", json=body)


def score_of(answer: httpx.Response) -> float:
    return float(answer.json()["actions"][0]["values"]["score"][0])


def test_a_repeated_turn_is_not_acted_twice() -> None:
    with calling(an_app()) as client:
        assert reset(client, "s").status_code == 200
        assert [score_of(predict(client, "s", q)) for q in (0, 0, 1, 1)] == [
            *[0.1, 0.1],
            *[0.2, 0.2],
        ]
        reset(client, "s")
        assert score_of(predict(client, "s", 1)) == 0.1


def test_the_session_idle_for_longest_makes_room() -> None:
    with calling(an_app(max_sessions=2)) as client:
        for name in ("a", "b"):
            reset(client, name)
        predict(client, "a")
        reset(client, "c")
        assert predict(client, "b").json()["code"] == "session_ended"
        assert predict(client, "a", 1).status_code == 200
        assert predict(client, "c").status_code == 200


def test_a_session_that_had_to_make_room_is_not_played_on() -> None:
    """It waits for its turn while another session takes its policy over."""
    began, going = threading.Event(), threading.Event()

    class Slow(Counting):
        def act(self, observation: Observation) -> list[dict[str, Any]]:
            began.set()
            going.wait(PATIENCE_S)
            return super().act(observation)

    app = PolicyApp(Slow, "slow", key=KEY, max_sessions=1)
    with calling(app) as client, ThreadPoolExecutor(3) as threads:
        reset(client, "a")
        first = threads.submit(predict, client, "a")
        assert began.wait(PATIENCE_S)
        second = threads.submit(predict, client, "a", 1)
        other = threads.submit(reset, client, "b")
        deadline = time.monotonic() + PATIENCE_S
        while "b" not in app._sessions:
            assert time.monotonic() < deadline
            time.sleep(0.005)
        going.set()
        assert first.result().status_code == 200
        assert second.result().json()["code"] == "session_ended"
        assert other.result().status_code == 200
        assert score_of(predict(client, "b")) == 0.1


class Failing(Counting):
    def act(self, observation: Observation) -> list[dict[str, Any]]:
        raise ValueError("no such joint")


class Nonsense(Counting):
    def act(self, observation: Observation) -> list[dict[str, Any]]:
        return [{"score": [float("nan")]}]


@pytest.mark.parametrize(
    ("policy", "said"),
    [
        (Failing, "ValueError: no such joint (test_policy_serving.py:"),
        (Nonsense, "/actions/0/values/score/0: is nan"),
    ],
)
def test_what_a_policy_does_wrong_is_told(policy: type[Counting], said: str) -> None:
    with calling(PolicyApp(policy, "wrong", key=KEY)) as client:
        reset(client, "s")
        answer = predict(client, "s")
        assert (answer.status_code, answer.json()["code"]) == (500, "internal_error")
        assert said in answer.json()["detail"]
        assert reset(client, "s").status_code == 200


def test_what_is_no_operation_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "BODY_BYTES_MAX", 1000)
    with calling(an_app()) as client:
        assert client.get("/v1/elsewhere").json()["code"] == "not_found"
        wrong = client.get("/v1/policy/reset")
        assert wrong.json()["code"] == "method_not_allowed"
        assert wrong.headers["allow"] == "POST"
        assert reset(client, "s").json()["code"] == "body_too_large"
        huge = client.post("/v1/policy/predict", content=b"[" * 900)
        assert huge.json()["code"] in ("malformed_body", "invalid_request")


def test_a_picture_that_does_not_decode_is_refused() -> None:
    picture = {"codec": "raw", "width": 9, "height": 9, "channels": 3, "data": "AAAA"}
    with calling(an_app()) as client:
        reset(client, "s")
        turn = turns.turn(BENCHMARK, "s", 0, turns.episode(BENCHMARK))
        turn["observation"]["images"] = {"front": picture}
        answer = client.post("/v1/policy/predict", json=turn)
        assert answer.json()["code"] == "invalid_request"
        assert "front" in answer.json()["detail"]


def test_what_it_takes_for_granted_is_told() -> None:
    assumes = {"control_rate_hz": 20.0}
    with calling(an_app(assumes=assumes, max_sessions=3)) as client:
        told = client.get("/v1/policy").json()
        assert (told["assumes"], told["max_sessions"]) == (assumes, 3)


# --- end to end ---


def test_a_server_plays_a_policy_that_is_served(house: House) -> None:
    with served(an_app().app) as url, house.client() as client:
        order = {"api_key": KEY, "max_concurrent": 3}
        run_id = submitted(client, url, *["echo"] * 2, *["score"] * 4, **order)
        run = until(client, run_id)
        assert (run["state"], run["reason"]) == ("completed", None)
        results = [e["result"] for e in episodes(client, run_id)]
        assert [r["steps"] for r in results] == [3] * 6
        assert [r["score"] for r in results[2:]] == [0.3] * 4


def test_the_reason_names_the_policys_own_line(house: House) -> None:
    app = PolicyApp(Failing, "failing", key=KEY)
    with served(app.app) as url, house.client() as client:
        run = until(client, submitted(client, url, api_key=KEY))
        assert "ValueError: no such joint (test_policy_serving.py:" in run["reason"]


@pytest.mark.parametrize("wrong", [{}, {"api_key": "wrong"}])
def test_a_wrong_key_is_told(house: House, wrong: dict[str, str]) -> None:
    with served(an_app().app) as url, house.client() as client:
        run = until(client, submitted(client, url, **wrong))
        assert run["state"] == "failed"
        assert "unauthenticated: This policy server wants its key" in run["reason"]


def test_the_command_serves_an_expert_to_a_real_benchmark(
    house: House, tmp_path: Path
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
    with house.client() as client:
        order = {"api_key": KEY, "max_concurrent": 1, "max_retries": 5}
        body = submission(f"http://127.0.0.1:{port}", **order)
        body = {**body, "benchmark_id": "tabletop_state"}
        del body["options"]
        run_id = client.post("/v1/runs", json=body).json()["run_id"]
        deadline = time.monotonic() + 2 * PATIENCE_S
        while not (run := until(client, run_id, "ready", "running"))["progress"][
            "episodes_scored"
        ]:
            assert time.monotonic() < deadline, run
            time.sleep(0.05)
        client.post(f"/v1/runs/{run_id}/stop", json={})
        first = episodes(client, run_id)[0]["result"]
    assert (first["outcome"], first["score"]) == ("success", 1.0)
    process.send_signal(signal.SIGTERM)
    process.wait(PATIENCE_S)
    process.stderr.close()


@pytest.mark.parametrize("policy", ["nowhere.py:X", "json:nothing"])
def test_the_command_tells_what_is_no_policy(policy: str, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "reference_client.policies.serve", "--policy", policy],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr.startswith("proctor: ")
