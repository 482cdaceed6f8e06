"""Serves the live view, on localhost only.

Nothing is computed until the page requests it: workers store a reference to their
latest turn, and images are encoded on request. Pages of other sites cannot read it (the
Host header is checked, against DNS rebinding), and the page loads no external
resources.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from typing import Any, Self

from reference_client.evaluation.status_board import Progress, StatusBoard, TurnSnapshot
from reference_client.evaluation.turn_report import (
    RESULTS_MAX,
    EpisodeOutcome,
    LatestTurn,
    TurnReport,
)
from reference_record.pages.page_templates import read_asset
from reference_record.texts.figures import figure

LOOPBACK = "127.0.0.1"
CONTENT_SECURITY_POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'"
)


class SnapshotBoard(StatusBoard):
    """Stores each worker's latest turn and its last results."""

    def __init__(self) -> None:
        super().__init__()
        self.latest: dict[str, LatestTurn] = {}

    def on_turn(self, snapshot: TurnSnapshot) -> None:
        self.latest.setdefault(snapshot.worker_id, LatestTurn()).keep(snapshot)


class View:
    """The page at `url`; a context manager that serves it.

    port: 0 for a free one. Raises OSError if it cannot be bound.
    """

    def __init__(self, port: int) -> None:
        self.board = SnapshotBoard()
        self.title = ""
        self.progress: Progress | None = None
        # For workers in their own processes: requests their latest turns.
        self.request_frames: Callable[[], object] | None = None
        self._reports: dict[str, TurnReport] = {}
        self._results: dict[
            str, EpisodeOutcome
        ] = {}  # by id, in the order of their ends
        self._server = _Server((LOOPBACK, port), _PageHandler)
        self._server.view = self
        self.url = f"http://{LOOPBACK}:{self._server.server_address[1]}/"

    def __enter__(self) -> Self:
        threading.Thread(
            target=self._server.serve_forever, args=[0.1], daemon=True
        ).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._server.shutdown()
        self._server.server_close()

    def store_report(self, worker_id: str, report: TurnReport) -> None:
        """Store the latest turn of a worker process."""
        self._reports[worker_id] = report

    def state(self) -> dict[str, Any]:
        """The content of the page, as JSON-able values."""
        if self.request_frames is not None:
            self.request_frames()  # for the next call
        reports = dict(self._reports)
        for name, latest in dict(self.board.latest).items():
            if (report := latest.describe()) is not None:
                reports[name] = report
        for report in reports.values():
            self._results |= {
                result["episode_id"]: result for result in report["results"]
            }
        progress, ended = self.progress, list(self._results.values())
        mean = progress.mean if progress else None
        failures = [result for result in ended if result["outcome"] != "success"]
        return {
            "title": self.title,
            "run_id": progress.run_id if progress else "",
            "scored": progress.episodes_scored if progress else 0,
            "total": progress.episodes_total if progress else 0,
            "mean": None if mean is None else figure(mean, 3),
            "waiting": progress.waiting if progress else None,
            "workers": reports,
            "waits": self.board.waits(),
            "max_steps": self.board.max_steps,
            "results": ended[-RESULTS_MAX:],
            "failures": failures[-RESULTS_MAX:],
        }


class _Server(ThreadingHTTPServer):
    daemon_threads = True
    view: View


class _PageHandler(BaseHTTPRequestHandler):
    server: _Server
    protocol_version = "HTTP/1.1"

    def do_GET(self) -> None:
        port = self.server.server_address[1]
        if self.headers.get("Host") not in (f"{LOOPBACK}:{port}", f"localhost:{port}"):
            self._answer(403, "text/plain", b"only localhost is allowed")
        elif self.path == "/":
            page = files("reference_client.view").joinpath("page.html").read_bytes()
            self._answer(200, "text/html; charset=utf-8", page)
        elif self.path == "/favicon.ico":  # each browser asks for it
            self._answer(200, "image/svg+xml", read_asset("icon.svg"))
        elif self.path == "/state.json":
            state = json.dumps(self.server.view.state()).encode()
            self._answer(200, "application/json", state)
        else:
            self._answer(404, "text/plain", b"not found")

    def log_message(self, *_: object) -> None:
        """No log: it would disturb the progress bar."""

    def _answer(self, status: int, kind: str, body: bytes) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Content-Security-Policy", CONTENT_SECURITY_POLICY)
        self.send_header("Cache-Control", "no-store")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        self.wfile.write(body)
