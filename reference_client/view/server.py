"""Serves the live view, on this machine only.

Nothing is computed for it until somebody looks: workers leave a reference to their
latest turn, and pictures are made when the page asks. A page of another site cannot ask
(the Host header is checked, for a name may lead here), and the page loads nothing from
anywhere.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from importlib.resources import files
from typing import Any, Self

from reference_client.evaluation.status_board import Progress, StatusBoard, TurnSnapshot
from reference_client.evaluation.turn_report import describe_turn

LOOPBACK = "127.0.0.1"
CONTENT_SECURITY_POLICY = (
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'"
)


class SnapshotBoard(StatusBoard):
    """A board that keeps each worker's latest turn: an assignment, no more."""

    def __init__(self) -> None:
        super().__init__()
        self.latest: dict[str, TurnSnapshot] = {}

    def on_turn(self, snapshot: TurnSnapshot) -> None:
        self.latest[snapshot.worker_id] = snapshot


class View:
    """The page at `url`, while the context lasts.

    port: 0 takes a free one. Raises OSError if it cannot be had.
    """

    def __init__(self, port: int) -> None:
        self.board = SnapshotBoard()
        self.title = ""
        self.progress: Progress | None = None
        # For workers in processes of their own: has them send what they see.
        self.request_frames: Callable[[], object] | None = None
        self._reports: dict[str, Any] = {}
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

    def store_report(self, worker_id: str, report: dict[str, Any]) -> None:
        """What a worker's process shows of itself."""
        self._reports[worker_id] = report

    def state(self) -> dict[str, Any]:
        """What the page shows, JSON-able."""
        if self.request_frames is not None:
            self.request_frames()  # for the next time
        snapshots = dict(self.board.latest)
        progress = self.progress
        return {
            "title": self.title,
            "run_id": progress.run_id if progress else "",
            "scored": progress.episodes_scored if progress else 0,
            "total": progress.episodes_total if progress else 0,
            "mean": progress.mean if progress else None,
            "waiting": progress.waiting if progress else None,
            "workers": {
                name: describe_turn(snapshot) for name, snapshot in snapshots.items()
            }
            | self._reports,
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
            self._answer(403, "text/plain", b"this page is for this machine alone")
        elif self.path == "/":
            page = files("reference_client.view").joinpath("page.html").read_bytes()
            self._answer(200, "text/html; charset=utf-8", page)
        elif self.path == "/state.json":
            state = json.dumps(self.server.view.state()).encode()
            self._answer(200, "application/json", state)
        else:
            self._answer(404, "text/plain", b"nothing here")

    def log_message(self, *_: object) -> None:
        """The terminal is the command's."""

    def _answer(self, status: int, kind: str, body: bytes) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.send_header("Content-Security-Policy", CONTENT_SECURITY_POLICY)
        self.send_header("Cache-Control", "no-store")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.end_headers()
        self.wfile.write(body)
