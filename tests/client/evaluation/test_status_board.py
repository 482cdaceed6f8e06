"""The reports of an evaluation while it runs."""

from __future__ import annotations

import io

import pytest

from reference_client.evaluation.status_board import Progress, ProgressLine, StatusBoard


def test_progress_is_one_line_that_fits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    stream = io.StringIO()
    line = ProgressLine(stream)
    line(Progress("run_1", 20, 0, None, None))
    line(Progress("run_1", 20, 7, 0.5, "worker-0: no answer " * 9))
    line.end()
    first, second = stream.getvalue().split("\r\x1b[2K")[1:]
    assert first.startswith("run_1  0/20 episodes  mean –  0:0")
    assert second.startswith("run_1  7/20 episodes  mean 0.500  0:0")
    assert "worker-0: no" in second
    assert len(second) == 60  # 59 and the line's end


def test_the_status_board_shows_one_waiting_worker() -> None:
    board = StatusBoard()
    first, second = (
        board.waiting_reporter("worker-0"),
        board.waiting_reporter("worker-1"),
    )
    first("a")
    second("b")
    assert board.wait(0.0)
    assert board.waiting() == "worker-0: a"
    first(None)
    assert board.waiting() == "worker-1: b"
    second(None)
    assert board.waiting() is None
    assert not board.pop_scored()
    board.on_scored()
    assert board.pop_scored()
    assert not board.pop_scored()
