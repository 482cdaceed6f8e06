"""A full disk, a torn log, a clock that jumps, while runs are played."""

from __future__ import annotations

import signal
import time
from pathlib import Path

from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attacks.process_kills import server_of, wait_for_samples
from tests.campaigns.players.run_history import Report

FULL_AT = 4096
DAY_S = 86_400.0


def fill_disk(target: Target) -> Report:
    """Let all writes of the server fail for a while, again and again."""
    report, server = Report(), server_of(target)
    lines = server.log().count("\n")
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    for _ in range(target.count(2)):
        server.limit_file_size(FULL_AT)
        deadline = target.deadline()
        with target.client() as client:
            while time.monotonic() < deadline:
                answer = client.request("POST", "/v1/runs", body)
                report.add_answer(answer)
                time.sleep(0.02)
        server.limit_file_size(None)
        if not wait_for_samples(target, 40):
            report.violations.append("it does not serve when there is room again")
    report.figures["log_lines"] = server.log().count("\n") - lines
    return report


def tear_log(target: Target) -> Report:
    """Kill the server and leave a torn page, or others' bytes, behind its log."""
    report, server, random = Report(), server_of(target), target.random("log")
    for number in range(target.count(3)):
        wait_for_samples(target, 60)
        server.end(signal.SIGKILL)
        log = server.database.with_name(server.database.name + "-wal")
        _damage_end(log, number, random.randbytes(9000))
        server.start()
        report.sent += 1
        if not wait_for_samples(target, 20):
            report.violations.append("it does not serve after a torn log")
    return report


def _damage_end(log: Path, way: int, noise: bytes) -> None:
    """What a loss of power may leave behind the last whole frame."""
    data = log.read_bytes() if log.exists() else b""
    frame = data[-4120:]
    more = (noise, frame[:2000] + noise[:1000], frame[:24] + noise[:4096])[way % 3]
    with log.open("ab") as file:
        file.write(more)


def shift_clock(target: Target) -> Report:
    """Let the wall clock jump by days, forth and back; runs must go on."""
    report, server, random = Report(), server_of(target), target.random("clock")
    for _ in range(target.count(6)):
        shift = random.choice((-1, 1)) * random.choice(
            (1.0, 3600.0, DAY_S, 400 * DAY_S)
        )
        (server.directory / "clock").write_text(str(shift))
        report.sent += 1
        if not wait_for_samples(target, 60):
            report.violations.append(f"it does not serve after {shift:.0f} s")
    (server.directory / "clock").unlink()
    return report


ATTACKS = (
    Attack(
        "full disk",
        "submissions while every write fails",
        "2 times 2 s",
        fill_disk,
        is_beside=True,
        is_timed=False,
    ),
    Attack(
        "torn log",
        "SIGKILL, then a damaged end of the database's log",
        "3 times",
        tear_log,
        is_beside=True,
        is_timed=False,
        watchers=4,
    ),
    Attack(
        "clock jumps",
        "jumps of the wall clock by 1 s to 400 days",
        "6 jumps",
        shift_clock,
        is_beside=True,
        is_timed=False,
        watchers=2,
    ),
)
