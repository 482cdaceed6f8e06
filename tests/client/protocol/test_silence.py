"""A worker that loses its session by its own silence says so, with cause and cure."""

from types import SimpleNamespace
from typing import Any

import pytest

from reference_client import ProctorError
from reference_client.evaluation.status_board import StatusBoard
from reference_client.protocol import silence
from reference_client.protocol.silence import LostSession, SilenceMeter, summary
from reference_client.protocol.worker_session import Session

LEASE_S = 3.0


class Clocks:
    """Two clocks that stand still until a test moves them."""

    def __init__(self) -> None:
        self.now = self.awake = 100.0

    def pass_time(self, awake_s: float, suspended_s: float = 0.0) -> None:
        self.now += awake_s + suspended_s
        self.awake += awake_s


@pytest.fixture
def clocks(monkeypatch: pytest.MonkeyPatch) -> Clocks:
    made = Clocks()
    monkeypatch.setattr(silence, "_clocks", lambda: (made.now, made.awake))
    return made


@pytest.mark.parametrize(
    ("steps", "expected"),
    [
        ([5.0], (5.0, "standstill")),
        ([1.0, "answered", 4.0], (4.0, "standstill")),
        ([1.0, "failed", 4.0], (5.0, "unreached")),
        ([1.0, "failed", "answered", 4.0], (4.0, "standstill")),
        ([0.5, "sent", 4.0], (4.5, "request")),
        ([4.0, "sent", 0.1], (4.1, "standstill")),
        ([(0.5, 60.0), "sent", 0.1], (60.6, "suspended")),
        ([0.5, "failed", (0.1, 60.0)], (60.6, "suspended")),
    ],
)
def test_the_cause_of_a_silence_is_measured(
    clocks: Clocks, steps: list[Any], expected: tuple[float, str]
) -> None:
    meter = SilenceMeter()
    for step in steps:
        if isinstance(step, str):
            getattr(meter, step)()
        else:
            clocks.pass_time(*(step if isinstance(step, tuple) else (step,)))
    silent_s, cause = meter.silence(LEASE_S)
    assert (round(silent_s, 6), cause) == expected


@pytest.mark.parametrize(
    ("ended_by", "silent_s", "is_lost"),
    [
        ("lease_ended", 5.0, True),
        ("lease_ended", 2.9, True),  # its clock is the one that counts
        ("unknown", 5.0, True),
        ("unknown", 1.0, False),
        (None, 5.0, True),
        ("detached", 5.0, False),
        ("run_stopped", 5.0, False),
        ("run_failed", 5.0, False),
    ],
)
def test_a_session_that_ended_for_another_reason_is_not_lost(
    clocks: Clocks, ended_by: str | None, silent_s: float, is_lost: bool
) -> None:
    turn = SimpleNamespace(
        lease=SimpleNamespace(expires_at="", idle_timeout_s=LEASE_S),
        episode=SimpleNamespace(episode_id="e0003", step=50, attempt=2),
    )
    slot = SimpleNamespace(worker_id="worker-0")
    session = Session(slot, None, turn)  # type: ignore[arg-type]
    clocks.pass_time(silent_s)
    problem: Any = SimpleNamespace(ended_by=ended_by)
    lost = session.lost(ProctorError("session_ended", "…", problem=problem))
    assert (lost is not None) == is_lost
    if lost is not None:
        assert lost.describe() == (
            "worker-0 lost attempt 2 of e0003 at step 50: this program stood still for "
            f"{silent_s:.1f} s, and the lease is 3 s"
        )


def lost_session(
    cause: silence.Cause, worker: int = 0, *, step: int = 50, silent_s: float = 5.0
) -> LostSession:
    return LostSession(f"worker-{worker}", "e0", step, 1, LEASE_S, silent_s, cause)


def test_a_loss_is_said_at_once_and_kept_for_the_end() -> None:
    board = StatusBoard()
    board.on_lost(lost_session("standstill"))
    (note,) = board.pop_notes()
    assert note.startswith("warning: worker-0 lost attempt 1 of e0 at step 50")
    assert board.lost == [lost_session("standstill")]


@pytest.mark.parametrize(
    ("lost", "abandoned", "texts"),
    [
        (
            [lost_session("standstill")],
            1,
            ["1 session of 1 worker, and with them 1 attempt. 1 episode has"],
        ),
        (
            [lost_session("standstill"), lost_session("standstill", 1, step=0)],
            0,
            ["2 sessions of 2 workers, and with them 1 attempt. Code that"],
        ),
        (
            [lost_session("standstill", silent_s=21)],
            0,
            ["--idle-timeout-s 50", "serve-"],
        ),
        ([lost_session("suspended")], 0, ["systemd-inhibit", "--idle-timeout-s 10"]),
        (
            [lost_session("unreached"), lost_session("request")],
            0,
            ["outlives such a cut", "held it back"],
        ),
    ],
)
def test_the_end_names_each_cure_once(
    lost: list[LostSession], abandoned: int, texts: list[str]
) -> None:
    said = summary(lost, abandoned)
    assert all(text in said for text in texts), said
    assert said.count("--idle-timeout-s") == len({session.cause for session in lost})
