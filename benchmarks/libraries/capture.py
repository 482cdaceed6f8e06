"""Captures the samples from a running reference server: see samples.py.

The reference client's last request is recorded and sent again over a plain socket: the
server repeats the same turn, and its bytes are stored. Needs the server's
dependencies.
"""

from __future__ import annotations

import contextlib
import os
import socket
import subprocess
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

from proctor_client import AttachWorker

from benchmarks.libraries.samples import CAMERAS, STATE, Sample
from benchmarks.round_trips import contender_registry, interleaved_rounds, observations
from benchmarks.round_trips.contenders import ours_client
from reference_client.protocol.connection import Connection
from reference_client.protocol.http_connection import (
    Answer,
    HttpConnection,
    _ResponseParser,
)


class RecordingConnection(HttpConnection):
    """A connection that records its last request."""

    last = b""

    def send_request(self, request: bytes) -> Answer:
        self.last = request
        return super().send_request(request)


def write(folder: Path) -> None:
    """Write both samples, from a server that is started for it."""
    with _server(folder) as url:
        for scenario in (STATE, CAMERAS):
            _sample(url, scenario).write(folder, scenario)


@contextlib.contextmanager
def _server(scratch: Path) -> Iterator[str]:
    ours = contender_registry.contender("ours msgpack", STATE, scratch)
    with subprocess.Popen(
        list(ours.server),
        cwd=interleaved_rounds.ROOT,
        env={**os.environ, **ours.environment},
        stdout=subprocess.PIPE,
        text=True,
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.terminate()


def _sample(url: str, scenario: str) -> Sample:
    shown = observations.SCENARIOS[scenario]
    submission: dict[str, Any] = {"benchmark_id": f"still_life_{scenario}"}
    if shown.cameras:
        size = {"width": shown.width, "height": shown.height}
        submission["images"] = {"codec": "raw", **size}
    with (
        contextlib.closing(ours_client.Connection(url, "json")) as control_connection,
        Connection(url, ours_client.TOKEN, requests=1) as connection,
    ):
        run_id = control_connection.submit(**submission)
        plane = connection.data(url)
        recorder = plane.http_connection = RecordingConnection(
            url, (10.0, 10.0), _make_buffer
        )
        attach = AttachWorker(attach_key=uuid.uuid4().hex)
        session_id = plane.attach_worker(run_id, "w", attach).session_id
        values = observations.by_name(observations.action(1))
        plane.predict(run_id, "w", session_id, 1, [{"values": values}])
        sample = Sample(recorder.last, _raw_answer(url, recorder.last))
        plane.close()
        control_connection.stop(run_id)
    return sample


def _make_buffer(size: int) -> memoryview:
    return memoryview(bytearray(size))


def _raw_answer(url: str, request: bytes) -> bytes:
    """The response as bytes on the wire."""
    place, parser, read = urlsplit(url), _ResponseParser(), bytearray()
    with socket.create_connection(
        (place.hostname or "", place.port or 80)
    ) as connection:
        connection.sendall(request)
        while not parser.is_complete:
            piece = connection.recv(2**20)
            if not piece:
                raise interleaved_rounds.ContenderFailed(
                    f"the server broke off after {bytes(read[:500])!r}"
                )
            parser.feed(memoryview(piece))
            read += piece
    return bytes(read)
