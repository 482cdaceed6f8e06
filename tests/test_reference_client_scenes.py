"""What the tests of the reference client play with.

A reference server that may die, a wire that loses answers, a house that knows what is
true, and policies that notice what a client does wrong.
"""

from __future__ import annotations

import contextlib
import http.client
import os
import re
import signal
import subprocess
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Future
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any, Self, TypeVar
from urllib.parse import urlsplit

import msgspec
import pytest
from proctor_client import (
    ApiClient,
    AttachWorker,
    CalibrationOptions,
    Configuration,
    ControlApi,
    DataApi,
    Episode,
    PolicyInfo,
    Run,
    SubmitRun,
    Turn,
)

from reference_client import Observation, Progress

ROOT = Path(__file__).parent.parent
TOKEN = "t1"
DEADLINE_S = 10.0
ACCEPT_ANY = {"Accept": "*/*"}
AnswerT = TypeVar("AnswerT")
ServerT = TypeVar("ServerT", bound=ThreadingHTTPServer)
Actions = list[dict[str, list[float]]]


# The server and the wire


class RestartableServer:
    """A reference server with a database of its own; may die and come back.

    A context that starts it, and ends whatever it is then.
    """

    def __init__(self, directory: Path) -> None:
        self._directory = directory
        self._port = 0
        self._process: subprocess.Popen[str] | None = None
        self.url = ""

    def start(self) -> Self:
        clean = {k: v for k, v in os.environ.items() if not k.startswith("PROCTOR_")}
        self._process = subprocess.Popen(
            [sys.executable, "-m", "reference_server"],
            cwd=ROOT,
            env=clean
            | {
                "PROCTOR_PORT": str(self._port),
                "PROCTOR_TOKENS": f"alice:read+run:{TOKEN},bob:read:t2",
                "PROCTOR_DATABASE": str(self._directory / "proctor.sqlite"),
            },
            stdout=subprocess.PIPE,
            text=True,
        )
        assert self._process.stdout is not None
        startup_line = self._process.stdout.readline()
        self.url = startup_line.rpartition(" ")[2].strip()
        self._port = int(self.url.rpartition(":")[2])
        return self

    def __enter__(self) -> Self:
        return self.start()

    def __exit__(self, *_: object) -> None:
        self.end()

    def end(self, number: signal.Signals = signal.SIGTERM) -> None:
        assert self._process is not None
        self._process.send_signal(number)
        self._process.wait(DEADLINE_S)
        assert self._process.stdout is not None
        self._process.stdout.close()


class FaultyProxy(ThreadingHTTPServer):
    """Passes requests on to a server, and does with their answers what `fates` says.

    fates: operation → what happens to its next requests, in order; what is not said
    passes. seen: (operation, body) of every request that arrived here.
    """

    daemon_threads = True

    def __init__(self, upstream_url: str) -> None:
        super().__init__(("127.0.0.1", 0), _FaultyProxyHandler)
        self.upstream = urlsplit(upstream_url).netloc
        self.url = f"http://127.0.0.1:{self.server_address[1]}"
        self.faults: dict[str, deque[str]] = {}
        self.received_requests: list[tuple[str, dict[str, Any]]] = []

    def bodies(self, operation: str) -> list[dict[str, Any]]:
        return [body for name, body in self.received_requests if name == operation]


class _FaultyProxyHandler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server: FaultyProxy

    def _forward_with_fault(self) -> None:
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        operation = operation_of(self.command, self.path)
        packed = self.headers.get("Content-Type") == "application/msgpack"
        decode = msgspec.msgpack.decode if packed else msgspec.json.decode
        self.server.received_requests.append((operation, decode(body) if body else {}))
        faults = self.server.faults.get(operation)
        fault = faults.popleft() if faults else "pass"
        if fault == "lose_request":
            self.close_connection = True
        elif fault == "gateway":
            html = {"Content-Type": "text/html", "Content-Length": "20"}
            self._answer(502, html, b"<h1>Bad Gateway</h1>")
        else:
            self._forward(body, fault)

    def _forward(self, body: bytes, fault: str) -> None:
        upstream = http.client.HTTPConnection(self.server.upstream, timeout=DEADLINE_S)
        with contextlib.closing(upstream):
            upstream.request(self.command, self.path, body, dict(self.headers.items()))
            answer = upstream.getresponse()
            content = answer.read()
        if fault == "lose_answer":
            self.close_connection = True
            return
        headers = dict(answer.getheaders())
        if fault == "cut_answer":
            self.close_connection = True
            content = content[: len(content) // 2]
        self._answer(answer.status, headers, content)

    def _answer(self, status: int, headers: Mapping[str, str], content: bytes) -> None:
        self.send_response_only(status)
        lengths = {"Content-Length": str(len(content))} if status != 304 else {}
        for name, value in (
            lengths | {k.title(): v for k, v in headers.items()}
        ).items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(content)

    do_GET = do_PUT = do_POST = do_DELETE = _forward_with_fault  # noqa: N815 - http.server's names


@contextlib.contextmanager
def serve_in_thread(listener: ServerT) -> Iterator[ServerT]:
    """Serves in a thread, until the context ends."""
    with listener:
        threading.Thread(
            target=listener.serve_forever, args=[0.01], daemon=True
        ).start()
        yield listener
        listener.shutdown()


def operation_of(method: str, path: str) -> str:
    path = urlsplit(path).path
    for suffix in ("predict", "heartbeat"):
        if path.endswith(f"/{suffix}"):
            return suffix
    if re.search(r"/workers/[^/]+$", path):
        return {"PUT": "attach_worker", "DELETE": "detach_worker"}[method]
    return {"/v1/runs": "submit_run"}.get(path, path) if method == "POST" else path


class DirectClient:
    """The server without the reference client: what others do, and what is true."""

    def __init__(self, url: str) -> None:
        configuration = Configuration(host=url, access_token=TOKEN, retries=False)
        self._client = ApiClient(configuration)
        self.control = ControlApi(self._client)
        self.data = DataApi(self._client)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._client.rest_client.pool_manager.clear()

    def submit(self, *tasks: str, **members: Any) -> Run:
        options = CalibrationOptions.from_dict({"tasks": tasks or ["count"]})
        return self.control.submit_run(
            SubmitRun(
                benchmark_id="calibration",
                policy=PolicyInfo(name="other"),
                options=options,
                **members,
            )
        )

    def attach(self, run_id: str, worker_id: str, *, takeover: bool = False) -> Turn:
        request = AttachWorker(attach_key=os.urandom(8).hex(), takeover=takeover)
        return self.data.attach_worker(run_id, worker_id, request)

    def latest(self) -> Run:
        return self.control.list_runs(limit=1).runs[0]

    def episodes(self, run_id: str) -> list[Episode]:
        return self.control.list_episodes(run_id).episodes

    def attempts(self, run_id: str) -> list[int]:
        return [episode.attempt for episode in self.episodes(run_id)]


# Policies


def action(**values: float) -> dict[str, list[float]]:
    sizes = {"vector": 8, "clipped": 2}
    names = ("score", "success", "end", "delay_s", "fault", "vector", "clipped")
    return {name: [values.get(name, 0.0)] * sizes.get(name, 1) for name in names}


class GradedPolicy:
    """Ends every episode after two turns with a score that depends on the episode."""

    def __init__(self) -> None:
        self.resets = 0

    def reset(self, instruction: str) -> None:
        self.resets += 1

    def act(self, observation: Observation) -> Actions:
        score = episode_score(observation.episode_id)
        return [action(score=score, success=1.0, end=float(observation.step > 0))]


def episode_score(episode_id: str) -> float:
    return int(episode_id[1:]) % 5 / 4


class ExactlyOncePolicy:
    """Expects after each turn that what it has sent was executed exactly once."""

    def reset(self, instruction: str) -> None:
        self.sent = 0

    def act(self, observation: Observation) -> Actions:
        assert observation.state["count"][0] == self.sent
        assert observation.step == self.sent
        self.sent += 2
        return [action(), action(success=1.0)]


class BlockingPolicy:
    """Waits in `act` until it is let go; says that it is there."""

    def __init__(self) -> None:
        self.is_acting = threading.Event()
        self.may_continue = threading.Event()
        self.first: Observation | None = None
        self.instructions: list[str] = []

    def reset(self, instruction: str) -> None:
        self.instructions.append(instruction)

    def act(self, observation: Observation) -> Actions:
        self.first = self.first or observation
        self.is_acting.set()
        assert self.may_continue.wait(DEADLINE_S)
        return [action(success=1.0, end=1.0)]


def calibration_evaluation(*tasks: str, **options: Any) -> dict[str, Any]:
    return {
        "benchmark": "calibration",
        "token": TOKEN,
        "options": {"tasks": list(tasks), **options},
        "progress": ignore_progress,
    }


def ignore_progress(_progress: Progress) -> None:
    """For evaluations whose progress nobody reads."""


def run_in_thread(
    call: Callable[..., AnswerT], *args: Any, **kwargs: Any
) -> Future[AnswerT]:
    """Calls in a thread of its own, which does not keep a failed test from ending."""
    future: Future[AnswerT] = Future()

    def run() -> None:
        try:
            future.set_result(call(*args, **kwargs))
        except BaseException as error:  # noqa: BLE001 - raised by the future
            future.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return future


class ProgressRecorder:
    """A progress callback that remembers."""

    def __init__(self) -> None:
        self.received: list[Progress] = []
        self._waits: dict[str, threading.Event] = {}

    def __call__(self, progress: Progress) -> None:
        self.received.append(progress)
        for text, event in list(self._waits.items()):
            if text in (progress.waiting or ""):
                event.set()

    def waiting_event(self, text: str) -> threading.Event:
        """Is set when the evaluation says that it waits for this."""
        return self._waits.setdefault(text, threading.Event())


# Whether the wire does what it is told


@pytest.mark.parametrize(
    ("fault", "arrives", "error"),
    [
        ("lose_request", 0, http.client.RemoteDisconnected),
        ("lose_answer", 1, http.client.RemoteDisconnected),
        ("cut_answer", 1, http.client.IncompleteRead),
    ],
)
def test_the_proxy_applies_its_faults(
    fault: str, arrives: int, error: type[Exception]
) -> None:
    arrived: list[str] = []

    class Upstream(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            arrived.append(self.path)
            self.send_response(200)
            self.send_header("Content-Length", "4")
            self.end_headers()
            self.wfile.write(b"true")

        def log_message(self, *_: object) -> None:
            pass

    with serve_in_thread(ThreadingHTTPServer(("127.0.0.1", 0), Upstream)) as upstream:
        upstream_url = f"http://127.0.0.1:{upstream.server_address[1]}"
        with serve_in_thread(FaultyProxy(upstream_url)) as proxy:
            proxy.faults["/x"] = deque([fault])
            with pytest.raises(error):
                get_x(proxy)
            assert len(arrived) == arrives
            assert get_x(proxy) == b"true"


def get_x(proxy: FaultyProxy) -> bytes:
    connection = http.client.HTTPConnection(urlsplit(proxy.url).netloc)
    try:
        connection.request("GET", "/x")
        return connection.getresponse().read()
    finally:
        connection.close()
