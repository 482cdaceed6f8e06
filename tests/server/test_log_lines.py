"""What a server logs of a run, and that a line stays a line."""

from __future__ import annotations

import json
import logging
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from reference_server.telemetry.log_output import (
    REQUEST_ID,
    JsonFormatter,
    TextFormatter,
    log_event,
    request_id_of,
)
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.waiting import wait_until

ACTION = {
    "score": [1], "success": [1], "end": [1], "delay_s": [0], "fault": [0],
    "vector": [0] * 8, "clipped": [0, 0],
}  # fmt: skip


def play(server: ReferenceServer) -> str:
    """Submit a run, play its episode, and stop nothing; returns its id."""
    with server.client() as client:
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        submitted = client.post(
            "/v1/runs", json=body, headers={"X-Request-Id": "from-the-client.1"}
        )
        assert submitted.headers["X-Request-Id"] == "from-the-client.1"
        run_id: str = submitted.json()["run_id"]
        worker = f"/v1/runs/{run_id}/workers/w"
        turn = client.put(worker, json={"attach_key": "k" * 16}).json()
        played = client.post(
            f"{worker}/predict",
            json={
                "session_id": turn["session_id"],
                "seq": 1,
                "actions": [{"values": ACTION}],
            },
        )
        assert played.json()["done"], played.text
        assert len(played.headers["X-Request-Id"]) == 16
    return run_id


def lines(folder: Path) -> list[dict[str, Any]]:
    """The lines of the log that are JSON, which all of the server's are."""
    return [json.loads(line) for line in (folder / "log").read_text().splitlines()]


def requests_in(found: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """The lines of the access log."""
    return [one for one in found if one["logger"] == "proctor.access"]


@pytest.mark.slow("starts a server")
def test_the_life_of_a_run_is_logged_with_its_ids(tmp_path: Path) -> None:
    with ReferenceServer(
        tmp_path,
        PROCTOR_LOG_LEVEL="info",
        PROCTOR_LOG_FORMAT="json",
        PROCTOR_ACCESS_LOG="on",
    ) as server:
        run_id = play(server)
        # An answer is sent before its line is written.
        wait_until(lambda: len(requests_in(lines(tmp_path))) == 3, "all are logged")
        found = lines(tmp_path)
    life = [one for one in found if one["logger"] == "proctor.runs"]
    assert sorted(one["message"] for one in life) == [
        *("episode scored", "run completed", "run ready", "run running"),
        *("run submitted", "worker attached"),
    ]
    assert {one["run_id"] for one in life} == {run_id}
    by_message = {one["message"]: one for one in life}
    assert by_message["run submitted"]["request_id"] == "from-the-client.1"
    assert by_message["run submitted"]["account"] == "alice"
    scored = by_message["episode scored"]
    assert (scored["episode_id"], scored["score"], scored["outcome"]) == (
        *("e0000", 1.0, "success"),
    )
    requests = requests_in(found)
    assert [(one["method"], one["status"]) for one in requests] == [
        *(("POST", 201), ("PUT", 200), ("POST", 200))
    ]
    assert requests[-1]["request_id"] == scored["request_id"]
    assert {one["account"] for one in requests} == {"alice"}
    everything = json.dumps(found)
    assert not any(token in everything for token in TOKENS.values())


@pytest.mark.slow("starts a server")
def test_by_default_nothing_is_logged_of_a_run(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path) as server:
        play(server)
        assert not (tmp_path / "log").read_text()


@pytest.mark.parametrize(
    ("header", "kept"),
    [
        (b"a-Z.0_9", True),
        (b"x" * 64, True),
        (b"x" * 65, False),
        (b"", False),
        (b"a b", False),
        (b"a\x1b[31m", False),
        (None, False),
    ],
)
def test_an_id_that_is_not_fit_for_a_line_is_replaced(
    header: bytes | None, kept: bool
) -> None:
    found = request_id_of(header)
    assert (header is not None and found == header.decode()) == kept
    assert kept or len(found) == 16


class Records(logging.Handler):
    """Keeps the records."""

    def __init__(self) -> None:
        super().__init__()
        self.records: list[logging.LogRecord] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.records.append(record)


def record_of(text: str, **members: Any) -> logging.LogRecord:
    log = logging.getLogger("proctor.test_log_lines")
    log.setLevel(logging.INFO)
    handler = Records()
    log.addHandler(handler)
    log_event(log, text, **members)
    log.removeHandler(handler)
    return handler.records[0]


def test_no_value_breaks_a_line() -> None:
    record = record_of("a\nb", policy='x\n"=\u202e y', reason=None, steps=3)
    text = TextFormatter().format(record)
    assert text.count("\n") == 0
    assert text.isprintable()
    assert text.endswith("steps=3")
    assert "reason" not in text
    line = json.loads(JsonFormatter().format(record))
    assert line["policy"] == 'x\n"=\u202e y'
    assert "\n" not in JsonFormatter().format(record)


def test_a_line_names_its_request_and_keeps_its_traceback() -> None:
    record = record_of("failed")
    error = ValueError("odd")
    record.exc_info = (ValueError, error, None)
    token = REQUEST_ID.set("r1")
    try:
        text = TextFormatter().format(record)
        line = json.loads(JsonFormatter().format(record))
    finally:
        REQUEST_ID.reset(token)
    assert "request_id=r1" in text
    assert line["request_id"] == "r1"
    assert "ValueError: odd" in text
    assert "ValueError: odd" in line["traceback"]


def test_lines_of_other_loggers_are_objects_too() -> None:
    program = (
        "import logging, logging.config\n"
        "from reference_server.telemetry.log_output import log_config\n"
        "logging.config.dictConfig(log_config('info', 'json', access=False))\n"
        "for name in ('asyncio', 'reference_sim.process.pool', 'proctor.runs'):\n"
        "    logging.getLogger(name).error('broken')\n"
        "    logging.getLogger(name).debug('unseen')\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    lines = [json.loads(line) for line in done.stderr.splitlines()]
    names = ["asyncio", "reference_sim.process.pool", "proctor.runs"]
    assert [line["logger"] for line in lines] == names
