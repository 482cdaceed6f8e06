"""A session ends while its turn is carried out: by a stop, a detach, the end."""

import asyncio
from pathlib import Path
from typing import Any

import pytest

from reference_server.rules import effects
from reference_server.rules.lifecycle import Attach, Detach
from reference_server.storage.store import Store
from reference_sim.process.pool import SimulatorHandle, SimulatorPool
from tests.parts import (
    Gate,
    Parts,
    begun,
    calibration,
    no_defect,
    nothing_is_held,
    predict,
    refusal,
    stop,
    tell,
)

# --- a run meets another server ---


@pytest.mark.parametrize(
    ("what", "change"),
    [
        ("is not offered", {"submission": {"benchmark_id": "gone"}}),
        ("has changed", {"manifest_sha256": "0" * 64}),
    ],
)
def test_a_run_is_not_played_on_another_benchmark(
    tmp_path: Path, what: str, change: dict[str, Any]
) -> None:
    """A score is of one manifest. Nothing is counted, and the run stays as it is."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count", **change), None, "")
        with refusal("benchmark_unavailable") as refused:
            await parts.executor.attach(run, Attach("w", "key"))
        assert what in refused.value.detail
        await nothing_is_held(parts)
        assert (run.state, run.episodes[0].attempt) == ("ready", 1)

    tell(tmp_path, story)


# --- a stop meets a turn ---


@pytest.mark.parametrize("who", ["a new session", "a successor", "a turn"])
def test_a_stop_before_the_work_begins(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, who: str
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        if who == "a new session":
            work = parts.executor.attach(run, Attach("w", "key"))
        else:
            turn = await parts.executor.attach(run, Attach("w", "key"))
            work = parts.executor.predict(run, predict(turn))
        if who == "a successor":
            work.close()
            work = parts.executor.attach(run, Attach("w", "another", takeover=True))
        task = begun(work)
        await asyncio.sleep(0)  # the session is open; its work waits for its turn
        stop(parts, run)
        with refusal("session_ended", ended_by="run_stopped"):
            await task
        await nothing_is_held(parts)
        assert run.state == "stopped"

    tell(tmp_path, story)
    no_defect(caplog)


@pytest.mark.parametrize(
    ("owner", "method"),
    [(SimulatorPool, "acquire"), (SimulatorHandle, "begin")],
    ids=["while it waits for a simulator", "while the simulator begins"],
)
def test_a_stop_while_a_session_opens(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    owner: type,
    method: str,
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        gate = Gate(monkeypatch, owner, method)
        opening = begun(parts.executor.attach(run, Attach("w", "key")))
        await gate.reached()
        stop(parts, run)
        gate.open()
        with refusal("session_ended", ended_by="run_stopped"):
            await opening
        await nothing_is_held(parts)
        assert (run.episodes[0].attempt, run.episodes[0].faults) == (1, 0)
        effects.resume(run, 0.0)
        effects.apply_event(run, "capacity")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        assert turn["episode"]["attempt"] == 1

    tell(tmp_path, story)
    no_defect(caplog)


@pytest.mark.parametrize(
    ("method", "attempt"), [("begin", 1), ("play", 2), ("observe", 2)]
)
def test_a_stop_when_the_simulator_has_just_answered(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    method: str,
    attempt: int,
) -> None:
    """The answer comes too late: it is not told, and what it says is not scored."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        if method != "begin":
            turn = await parts.executor.attach(run, Attach("w", "key"))
        if method == "observe":
            await parts.executor.predict(run, predict(turn))
        gate = Gate(monkeypatch, SimulatorHandle, method, after=True)
        work = (
            parts.executor.predict(run, predict(turn, end=1))
            if method == "play"
            else parts.executor.attach(run, Attach("w", "another", takeover=True))
        )
        task = begun(work)
        await gate.reached()
        stop(parts, run)
        gate.open()
        with refusal("session_ended", ended_by="run_stopped"):
            await task
        await nothing_is_held(parts)
        assert (run.state, run.scored) == ("stopped", 0)
        assert run.episodes[0].attempt == attempt

    tell(tmp_path, story)
    no_defect(caplog)


def test_a_stop_after_the_last_action_and_before_the_result_is_stored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The result stands, although the turn that brought it is not answered."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("score", "score"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        gate = Gate(monkeypatch, parts.store, "save")
        last = begun(parts.executor.predict(run, predict(turn, score=1, end=1)))
        await gate.reached()
        stop(parts, run)
        gate.open()
        with refusal("session_ended", ended_by="run_stopped"):
            await last
        await parts.registry.commit(run)
        stored = await parts.store.load(run.run_id)
        assert stored is not None
        assert (stored.state, stored.scored) == ("stopped", 1)
        await nothing_is_held(parts)

    tell(tmp_path, story)


# --- a detach, a loss or the end of the server meets a turn ---


def test_a_detach_ends_a_turn_in_the_middle(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        gate = Gate(monkeypatch, SimulatorHandle, "play")
        playing = begun(parts.executor.predict(run, predict(turn)))
        await gate.reached()
        await parts.executor.detach(run, Detach("w", turn["session_id"]))
        gate.open()
        with refusal("session_ended", ended_by="detached"):
            await playing
        await nothing_is_held(parts)
        assert run.episodes[0].attempt == 2

    tell(tmp_path, story)
    no_defect(caplog)


@pytest.mark.parametrize(
    ("owner", "method"),
    [
        (SimulatorHandle, "play"),
        (SimulatorHandle, "begin"),
        (SimulatorPool, "acquire"),
        (Store, "save"),
    ],
)
def test_the_end_of_the_server_is_no_defect(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    owner: type,
    method: str,
) -> None:
    """Sessions end uncounted, whatever is executed for them; then nothing is left."""
    work: list[asyncio.Task[Any]] = []

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("score", "score"), None, "")
        if method in ("acquire", "begin"):
            gate = Gate(monkeypatch, owner, method)
            work.append(begun(parts.executor.attach(run, Attach("w", "key"))))
        else:
            turn = await parts.executor.attach(run, Attach("w", "key"))
            gate = Gate(monkeypatch, owner, method)
            command = predict(turn, score=1, end=1)
            work.append(begun(parts.executor.predict(run, command)))
        await gate.reached()
        await parts.executor.close()
        gate.open()
        with refusal("session_ended", ended_by="unknown"):
            await work[0]
        await nothing_is_held(parts)

    async def after(parts: Parts) -> None:
        run = await parts.registry.get("run_1")
        assert (run.state, [e.attempt for e in run.episodes]) == ("ready", [1, 1])
        assert run.scored == (method == "save")

    tell(tmp_path, story, after)
    no_defect(caplog)
