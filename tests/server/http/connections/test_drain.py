"""How a server ends: turns in progress are answered, nothing new begins, and when."""

from __future__ import annotations

import signal
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.processes import descendants, signal_all, wait_until_ended
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts servers")

RUN = {"benchmark_id": "calibration", "policy": {"name": "p"}}


@contextmanager
def draining_server(
    folder: Path, steps: int, **settings: str
) -> Iterator[tuple[ReferenceServer, httpx.Client, str, Future[httpx.Response]]]:
    """A server with one turn in play of so many steps of 3 s, after SIGTERM.

    The server, a client, the run and what the turn is answered with.
    """
    with (
        ReferenceServer(folder, **settings) as server,
        server.client() as client,
        server.client() as player,
        ThreadPoolExecutor(1) as pool,
    ):
        run_id = submit(client, "delay")
        turn = attach(client, run_id)
        path, body = worker_path(run_id) + "/predict", predict_body(turn)
        slow = predict_body(turn, delay_s=3)
        slow["actions"] *= steps
        playing = pool.submit(player.post, path, json=slow)
        ahead = body | {"seq": body["seq"] + 5}
        wait_until(
            lambda: client.post(path, json=ahead).json()["expected_seq"] > body["seq"],
            "the turn has begun",
        )
        server.process.send_signal(signal.SIGTERM)
        wait_until(lambda: client.get("/readyz").status_code == 503, "it drains")
        yield server, client, run_id, playing


def wait_until_over(server: ReferenceServer) -> None:
    """It ends by the first signal alone."""
    server.process.wait(TIMEOUT_S)
    assert server.end() == -signal.SIGTERM


def assert_refused(answer: httpx.Response) -> None:
    assert (answer.status_code, answer.json()["code"]) == (503, "unavailable")
    assert answer.headers["retry-after"]


def test_a_turn_in_progress_is_answered_and_nothing_new_begins(tmp_path: Path) -> None:
    """Longer than what uvicorn alone would wait for."""
    started = draining_server(tmp_path, steps=3, PROCTOR_DRAIN_S="20")
    with started as (server, client, run_id, playing):
        assert client.get("/readyz").json()["not_ready"] == ["draining"]
        assert client.get("/livez").json() == {"status": "live"}
        assert_refused(client.post("/v1/runs", json=RUN))
        other = {"attach_key": "other"}
        assert_refused(client.put(worker_path(run_id, "other"), json=other))
        assert client.get(f"/v1/runs/{run_id}").json()["state"] == "running"
        answer = playing.result(TIMEOUT_S)
        assert answer.status_code == 200, answer.text
        assert answer.json()["executed_steps"] == 3
        wait_until_over(server)
        assert server.log() == ""
        server.start()
        with server.client() as again:
            assert again.get(f"/v1/runs/{run_id}").json()["state"] == "ready"


@pytest.mark.parametrize("first", [signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1])
def test_a_session_begins_no_other_turn(tmp_path: Path, first: signal.Signals) -> None:
    """An answer of before is given again all the same, at its time. Expect that
    the repeated notice of a batch system does not end it, nor its simulators."""
    with ReferenceServer(tmp_path, PROCTOR_DRAIN_NOTICE_S="600") as server:
        with server.client() as client:
            run_id = submit(client, "count")
            turn = attach(client, run_id)
            path = worker_path(run_id)
            body = predict_body(turn)
            played = client.post(f"{path}/predict", json=body).json()
            server.process.send_signal(first)
            wait_until(lambda: client.get("/readyz").status_code == 503, "it drains")
            if first == signal.SIGUSR1:
                pid = server.process.pid
                signal_all([pid, *descendants(pid)], first)
            again = client.post(f"{path}/predict", json=body)
            assert again.status_code == 200, again.text
            assert again.json()["rewards"] == played["rewards"]
            assert_refused(client.post(f"{path}/predict", json=predict_body(played)))
            session = {"session_id": turn["session_id"]}
            alive = client.post(f"{path}/heartbeat", json=session)
            assert alive.status_code == 200, alive.text
            left = client.delete(path, params=session)
            assert left.status_code == 204
            wait_until(
                lambda: client.get("/livez").headers["date"] != left.headers["date"],
                "answers have the date of their time",
            )
        # Nothing is in progress any more when the second signal comes.
        assert server.end() == -signal.SIGTERM
        assert server.log() == ""


def test_a_turn_that_takes_too_long_is_answered_with_503(tmp_path: Path) -> None:
    with draining_server(tmp_path, steps=8, PROCTOR_DRAIN_S="8") as given:
        server, _, _, playing = given
        began_at = time.monotonic()
        assert_refused(playing.result(TIMEOUT_S))
        wait_until_over(server)
        assert time.monotonic() - began_at < 20  # the turn takes 24 s


@pytest.mark.parametrize("second", [signal.SIGTERM, signal.SIGINT])
def test_a_second_signal_ends_at_once(tmp_path: Path, second: signal.Signals) -> None:
    with draining_server(tmp_path, steps=8, PROCTOR_DRAIN_S="25") as given:
        server, _, _, playing = given
        children = descendants(server.process.pid)
        began_at = time.monotonic()
        server.end(second)
        wait_until_ended(children)
        assert time.monotonic() - began_at < 20
        answer: Any = playing.exception(TIMEOUT_S) or playing.result()
        assert isinstance(answer, httpx.TransportError) or answer.status_code == 503
