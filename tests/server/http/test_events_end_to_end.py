"""Events of a server as people run it: read, killed, started again, ended."""

from __future__ import annotations

import json
import os
import re
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from unittest.mock import ANY

import httpx
import pytest

from conformance.client.event_reader import Event, EventParser
from tests.support.paths import ROOT
from tests.support.server.event_lists import kinds
from tests.support.server.http_runs import predict_body, submit
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer


@contextmanager
def following(
    client: httpx.Client, run_id: str, last_id: str | None = None
) -> Iterator[Iterator[Event]]:
    headers = {"Last-Event-ID": last_id} if last_id else {}
    path, parser = f"/v1/runs/{run_id}/events", EventParser()
    with client.stream("GET", path, headers=headers) as answer:
        assert answer.status_code == 200
        assert answer.headers["content-type"].startswith("text/event-stream")
        yield (event for part in answer.iter_bytes() for event in parser.feed(part))


class ScoringWorker:
    """A worker of a run that scores what it is given."""

    def __init__(self, client: httpx.Client, run_id: str, worker_id: str) -> None:
        self._client = client
        self._path = f"/v1/runs/{run_id}/workers/{worker_id}"
        self._turn = client.put(self._path, json={"attach_key": worker_id}).json()

    def leave(self) -> None:
        query = {"session_id": self._turn["session_id"]}
        assert self._client.delete(self._path, params=query).status_code == 204

    def play(self) -> None:
        body = predict_body(self._turn, end=1)
        self._turn = self._client.post(f"{self._path}/predict", json=body).json()
        assert "episode_result" in self._turn


def test_a_detach_after_completion_sends_no_event(server: ReferenceServer) -> None:
    """Most workers detach after the last event was sent to the run's followers."""
    with server.client() as client:
        run_id = submit(client, "score")
        player = ScoringWorker(client, run_id, "w")
        player.play()
        before = client.get(f"/v1/runs/{run_id}")
        with following(client, run_id) as events:
            last = list(events)[-1]
        player.leave()
        again = {"Last-Event-ID": str(last.id)}
        path = f"/v1/runs/{run_id}/events"
        assert client.get(path, headers=again).status_code == 204
        assert (
            client.get(f"/v1/runs/{run_id}").headers["etag"] == before.headers["etag"]
        )


def test_the_commands_of_the_events_page_work(server: ReferenceServer) -> None:
    """Its commands, pasted: the whole of a finished run, and a part of it."""
    page = (ROOT / "docs" / "evaluate" / "events.md").read_text()
    whole, rest = re.findall(r"^ +(curl .*)$", page, re.MULTILINE)
    with server.client() as client:
        run_id = submit(client, "score", "score")
        player = ScoringWorker(client, run_id, "w")
        player.play()
        player.play()
    variables = {"URL": server.url, "TOKEN": TOKENS["alice"], "RUN": run_id}

    def paste(command: str) -> list[Event]:
        environment = {"PATH": os.environ["PATH"], **variables}
        pasted = ["sh", "-c", command]
        done = subprocess.run(pasted, env=environment, capture_output=True, check=True)
        return EventParser().feed(done.stdout)

    events = paste(whole)
    assert kinds(events) == ["episode", "episode", "run"]
    variables["LAST"] = str(events[0].id)
    assert paste(rest) == [replace(e, at=ANY) for e in events[1:]]
    variables["LAST"] = str(events[-1].id)
    assert paste(rest) == []


@pytest.mark.slow("starts a server")
def test_streams_end_with_the_server(tmp_path: Path) -> None:
    with (
        ReferenceServer(tmp_path, PROCTOR_DRAIN_S=str(2 * TIMEOUT_S)) as server,
        server.client() as client,
    ):
        waiting, played = submit(client, "count"), submit(client, "score")
        with following(client, waiting) as one, following(client, played) as other:
            assert [next(one).kind, next(other).kind] == ["run", "run"]
            began = time.monotonic()
            server.end()
            assert time.monotonic() - began < TIMEOUT_S  # it may drain for longer
            assert [kinds(list(one)), kinds(list(other))] == [[], []]
    assert server.log() == ""


def test_disconnected_streams_do_not_delay_the_shutdown(
    server: ReferenceServer,
) -> None:
    """The server would wait at its end for streams that a client reads."""
    with server.client() as client:
        run_id = submit(client, "score")
        for _ in range(20):
            with following(client, run_id) as events:
                assert next(events).kind == "run"
        ScoringWorker(client, run_id, "w").play()
        with following(client, run_id) as events:
            assert json.loads(list(events)[-1].data[0])["state"] == "completed"
    server.end()
    assert server.log() == ""
