"""Progress of `proctor run` where stderr is no terminal."""

import time

import pytest

from reference_client.command.output.printer import REPEATED_S, Printer, ProgressDisplay
from reference_client.evaluation.status_board import Progress


def test_a_wait_that_comes_again_and_again_is_not_said_each_time(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As on a network that cuts every connection. Another wait is said at once."""
    now = 5.0  # a machine that was just started
    monkeypatch.setattr(time, "monotonic", lambda: now)
    display = ProgressDisplay(Printer(as_json=False))

    def report(*waits: str | None) -> list[str]:
        for waiting in waits:
            display(Progress("run_1", 9, 0, None, waiting))
        lines = capsys.readouterr().err.splitlines()
        return [line for line in lines if line.startswith("it")]

    assert report("it is cut", None, "it is cut", None) == ["it is cut"]
    assert report("it is full", "it is cut", None) == ["it is full"]
    now += REPEATED_S
    assert report("it is cut", "it is cut") == ["it is cut"]
    until = [f"it is busy. Until {hour} h." for hour in range(3)]
    assert report(*until) == until[:1]


def test_a_server_that_is_away_is_said_once_for_all_workers_and_when_it_is_back(
    capsys: pytest.CaptureFixture[str],
) -> None:
    display = ProgressDisplay(Printer(as_json=False))
    away = "It is unreachable (refused). This program repeats the request for 9 s."
    for waiting in (f"worker-1: {away}", f"worker-0: {away}", None, "it is full", None):
        display(Progress("run_1", 9, 0, None, waiting))
    said = [f"worker-1: {away}", "The server answers again.", "it is full"]
    lines = capsys.readouterr().err.splitlines()
    assert [line for line in lines if "episodes" not in line] == said
