"""The reports of an evaluation while it runs."""

import io
import os
import re
import threading
import time
from types import SimpleNamespace
from typing import Any

import pytest

from reference_client.errors import ProctorError
from reference_client.evaluation.status_board import Progress, ProgressLine, StatusBoard
from reference_client.evaluation.workers import worker_main
from reference_client.evaluation.workers.worker_loop import _why_again
from reference_client.generated.messages import Fault
from reference_client.policies.servers.server_transport import (
    Unreached,
    fault_of,
    repeat_until_reached,
    reporting_repeats,
)
from reference_client.protocol.worker_session import LeftEpisode
from tests.support.servers import TIMEOUT_S


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


@pytest.mark.parametrize(
    ("seconds", "is_shown"), [(4.9, False), (5.1, True), (700.0, True)]
)
def test_who_waits_long_says_so_with_one_clock(
    monkeypatch: pytest.MonkeyPatch, seconds: float, is_shown: bool
) -> None:
    now = 100.0
    monkeypatch.setattr(time, "monotonic", lambda: now)
    board = StatusBoard()
    board.begin("worker-0", "the policy, which computes actions")
    now += 1000.0
    board.begin("worker-0", "the answer to turn 4")
    now += seconds
    waiting = "worker-0: waits for the answer to turn 4"
    assert board.waits() == {"worker-0": "waits for the answer to turn 4"}
    what, waited_s = board.current_wait() or (None, seconds)
    assert what == board.waiting() == (waiting if is_shown else None)
    assert waited_s == pytest.approx(seconds)
    report = board.waiting_reporter("worker-1")
    report("the server is unreachable", 3.0)
    now += 4.0
    report("the server is busy")  # it is still the same wait
    assert board.current_wait() == ("worker-1: the server is busy", 7.0)
    assert board.waits()["worker-1"] == "the server is busy"
    report(None)
    board.end("worker-0")
    assert board.current_wait() is None
    board.begin("worker-1", "the first turn of an episode")
    now += 60.0
    report("a person prepares the robot")
    report(None)  # the turn has come: it waited for the person, and not for the server
    assert board.current_wait() is None


LEFT = LeftEpisode("worker-0", "e0000", 3, 1, "2026-11-30T12:00:00Z")
BUSY = (
    "Worker worker-0 already has a live session. In this client: `takeover=True`; "
    "a second program that plays the run needs another `worker_prefix`."
)


@pytest.mark.parametrize(
    ("left", "waiting", "error", "helps"),
    [
        ([], None, None, False),
        ([LEFT], None, None, True),
        ([], BUSY, None, True),
        ([], "The server is busy.", None, False),
        ([], None, ProctorError("worker_busy", BUSY), True),
        ([], None, ProctorError("unreachable", "No answer."), False),
    ],
)
def test_a_takeover_goes_on_at_once_where_a_session_is_left_or_waited_for(
    left: list[LeftEpisode], waiting: str | None, error: Exception | None, helps: bool
) -> None:
    board = StatusBoard()
    for episode in left:
        board.on_left(episode)
    board.waiting_reporter("worker-0")(waiting)
    assert board.takeover_helps(error) is helps


def test_each_text_of_a_fault_is_said_once() -> None:
    board = StatusBoard()
    died = [("e0", "Step 4 died"), ("e1", "Step 4 died"), ("e2", "Step 19 died")]
    for episode_id, text in [*died, ("e1", "No disk.")]:
        board.on_fault(episode_id, text)
    begun = "began again, at no cost to the policy:"
    said = [f"warning: e0 {begun} Step 4 died.", f"warning: e1 {begun} No disk."]
    assert board.pop_notes() == said


@pytest.mark.parametrize("is_counted_once", [False, True])
def test_a_request_to_a_policy_server_that_is_repeated_is_waited_for_by_its_fault(
    monkeypatch: pytest.MonkeyPatch, *, is_counted_once: bool
) -> None:
    """Expect the last fault, until when it is tried, and nothing after an answer."""
    board, waits = StatusBoard(), []
    faults = iter([Unreached("is busy; "), Unreached("is busy; "), Unreached("ended")])

    def attempt() -> str:
        if (fault := next(faults, None)) is not None:
            raise fault
        return "answer"

    monkeypatch.setattr(time, "sleep", lambda _: waits.append(board.waiting()))
    board.begin("worker-0", "the policy, which computes actions")
    with reporting_repeats(board.repeat_reporter("worker-0")):
        answer = repeat_until_reached(
            attempt, "ws://h", 60.0, is_counted_once=is_counted_once
        )
    assert answer == "answer"
    assert board.waiting() is None
    for wait, said in zip(waits, ("is busy", "is busy", "ended"), strict=True):
        server = f"worker-0: The policy server at ws://h {said}"
        until = r"\. Trying again until [0-2]\d:[0-5]\d:[0-5]\d UTC …"
        assert re.fullmatch(re.escape(server) + until, str(wait))
    notes = board.pop_notes()
    assert len(notes) == (0 if is_counted_once else 2)
    assert all("a policy with a memory may count it twice" in note for note in notes)


def test_a_server_that_was_not_there_counts_nothing_twice(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It refuses connections. Expect no warning, and for how long it was tried."""
    board, waits = StatusBoard(), []
    monkeypatch.setattr(time, "sleep", lambda _: waits.append(board.waiting()))

    def attempt() -> str:
        raise fault_of("http://127.0.0.1:1", ConnectionRefusedError(111, "refused"))

    refused = r"http://127\.0\.0\.1:1 is unreachable \(refused\)\."
    tried = rf"{refused} It was tried again for 0 s\."
    with (
        reporting_repeats(board.repeat_reporter("worker-0")),
        pytest.raises(ProctorError, match=tried),
    ):
        repeat_until_reached(attempt, "http://127.0.0.1:1", 0.01)
    assert re.search(rf"{refused} Trying again until ", str(waits[0]))
    assert board.waiting() is None
    assert board.pop_notes() == []


@pytest.mark.parametrize(
    ("void", "said"),
    [
        ({}, "the simulator broke: The light went out."),
        ({"is_void": False}, "the simulator broke: The light went out."),
        ({"is_void": True}, "The light went out."),
    ],
)
def test_a_void_trial_is_no_broken_simulator(void: dict[str, bool], said: str) -> None:
    fault = Fault(episode_id="e0", faults=1, detail="The light went out.", **void)
    assert _why_again(fault) == said


def test_a_worker_ends_with_a_killed_parent(monkeypatch: pytest.MonkeyPatch) -> None:
    """The report that it was asked for has no reader. Expect the end of the process."""
    ended = threading.Event()
    monkeypatch.setattr(worker_main, "STOP_TIMEOUT_S", 0.0)
    monkeypatch.setattr(os, "_exit", lambda _code: ended.set())
    reporter: Any = SimpleNamespace(latest=SimpleNamespace(describe=dict))

    def report(*_: Any) -> None:
        raise BrokenPipeError

    reporter.report = report
    receiver = worker_main.OrderReceiver(io.StringIO('{"order": "frames"}\n'), reporter)
    assert receiver.next_order() is None
    assert ended.wait(TIMEOUT_S)


def test_a_report_to_a_parent_that_has_ended_goes_to_nowhere() -> None:
    """Also each later one. Expect no error, which would be printed for nothing."""
    read_end, write_end = os.pipe()
    os.close(read_end)
    with os.fdopen(write_end, "w") as stream:
        reporter = worker_main.ReportingBoard(stream)
        for _ in range(2):
            reporter.report("ready")


def test_the_status_board_shows_one_waiting_worker() -> None:
    board = StatusBoard()
    first, second = map(board.waiting_reporter, ("worker-0", "worker-1"))
    first("a")
    second("b")
    assert board.wait(0.0)
    assert board.waiting() == "worker-0: a"
    first("c")  # the one that is shown does not change with each report
    assert board.waiting() == "worker-0: c"
    first(None)
    assert board.waiting() == "worker-1: b"
    second(None)
    assert board.waiting() is None
    assert not board.pop_scored()
    board.on_scored()
    assert board.pop_scored()
    assert not board.pop_scored()
