"""A reader of the events of one run, who reconnects to any node until the run ends."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterator
from typing import Any

import httpx

from conformance.client.event_reader import EventParser
from tests.campaigns.campaign_server import WATCHER
from tests.campaigns.players.run_history import History
from tests.campaigns.players.watcher import RETRY_S


class EventFollower:
    """It follows once constructed. episodes: as they were received."""

    def __init__(self, url: str, history: History, timeout_s: float) -> None:
        self.episodes: list[dict[str, Any]] = []
        self._url, self._timeout_s = url, timeout_s
        self._history = history
        self._path = f"/v1/runs/{history.run_id}/events"
        self._last_id = ""
        self._refused: list[str] = []
        self._is_closed = threading.Event()
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def close(self) -> None:
        self._is_closed.set()
        self._thread.join(2 * self._timeout_s)

    def judge(self, wait_s: float) -> Iterator[str]:
        """EVT-002, EVT-005, EVT-006: each result once; of a run that is done, all.

        wait_s: how long the end of a run that is done may take to come.
        """
        if self._history.is_done:
            self._thread.join(wait_s)
            if self._thread.is_alive():
                yield f"the events of {self._path} do not end"
        yield from self._refused
        indices = [one["index"] for one in list(self.episodes)]
        if len(set(indices)) < len(indices):
            yield f"{self._path} sent episodes twice: {indices}"
        if self._history.is_done and len(indices) < self._history.episodes:
            yield f"{self._path} sent only {indices}"
        for episode in list(self.episodes):
            acknowledged = self._history.acknowledged.get(episode["index"])
            if acknowledged is not None and acknowledged != episode["result"]:
                yield f"{self._path} sent {episode}, {acknowledged} was acknowledged"

    def _run(self) -> None:
        with httpx.Client(
            base_url=self._url, timeout=self._timeout_s, trust_env=False
        ) as client:
            while not self._is_closed.is_set():
                # After a fault it continues behind the last id.
                with contextlib.suppress(httpx.HTTPError):
                    if self._follow(client):
                        return
                self._is_closed.wait(RETRY_S)

    def _follow(self, client: httpx.Client) -> bool:
        """One stream of events; whether nothing will follow."""
        headers = {"Authorization": f"Bearer {WATCHER}"}
        if self._last_id:
            headers["Last-Event-ID"] = self._last_id
        with client.stream("GET", self._path, headers=headers) as answer:
            status = answer.status_code
            if status not in (200, 503):
                if status != 204:
                    body = answer.read()
                    self._refused.append(f"{self._path}: {status} {body!r}")
                return True
            parser = EventParser()
            for part in answer.iter_raw() if status == 200 else ():
                for event in parser.feed(part):
                    self._last_id = event.id or self._last_id
                    if event.kind == "episode":
                        self.episodes.append(event.body)
                if self._is_closed.is_set():
                    break
        return False
