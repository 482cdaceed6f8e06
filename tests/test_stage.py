"""Sessions and their simulators: what may happen while a turn is carried out."""

import asyncio
import time
import types
from pathlib import Path

import pytest

from reference_server.http.problems import Refused
from reference_server.rules.lifecycle import Attach, Heartbeat
from reference_server.rules.run import Run
from reference_server.runs import session_executor as stage_module
from reference_sim.process.pool import SimulatorHandle
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

# --- a successor meets a turn ---


def test_a_successor_goes_on_where_the_turn_ends(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        before = parts.executor._resources.find(run.workers["w"])
        gate = Gate(monkeypatch, SimulatorHandle, "play")
        played = begun(parts.executor.predict(run, predict(turn)))
        await gate.reached()
        taking = begun(
            parts.executor.attach(run, Attach("w", "another", takeover=True))
        )
        await asyncio.sleep(0)
        gate.open()
        assert (await played)["executed_steps"] == 1
        successor = await taking
        assert successor["episode"]["step"] == 1
        assert successor["observation"]["state"]["count"] == [1.0]
        with refusal("session_superseded"):
            await parts.executor.predict(run, predict(await played))
        assert before is not None
        assert before.timer is not None
        assert before.timer.cancelled()
        assert parts.pool.busy == len(parts.executor._resources) == 1

    tell(tmp_path, story)


def test_successors_come_one_after_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        gate = Gate(monkeypatch, SimulatorHandle, "begin")
        attachments = [
            begun(parts.executor.attach(run, Attach("w", key, takeover=True)))
            for key in ("first", "second", "third")
        ]
        await gate.reached()
        gate.open()
        *before, last = [await task for task in attachments]
        for turn in before:
            with refusal("session_superseded"):
                parts.executor.heartbeat(run, Heartbeat("w", turn["session_id"]))
        parts.executor.heartbeat(run, Heartbeat("w", last["session_id"]))
        assert run.episodes[0].attempt == 1
        assert parts.pool.busy == len(parts.executor._resources) == 1

    tell(tmp_path, story)


def test_a_successor_finds_that_the_run_has_failed_meanwhile(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("fault", "count"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        other = await parts.executor.attach(run, Attach("other", "key"))
        # What the other one's simulator answers is held up until all is over.
        gate = Gate(monkeypatch, SimulatorHandle, "play", after=True)
        dying = begun(parts.executor.predict(run, predict(turn, fault=2)))
        beside = begun(parts.executor.predict(run, predict(other, "other")))
        taking = begun(
            parts.executor.attach(run, Attach("w", "another", takeover=True))
        )
        await asyncio.wait([taking])
        gate.open()
        for task in (dying, beside):
            with refusal("session_ended", ended_by="run_failed"):
                await task
        with refusal("illegal_transition", state="failed"):
            await taking
        await nothing_is_held(parts)
        assert [e.attempt for e in run.episodes] == [1, 1]

    tell(tmp_path, story)
    no_defect(caplog)


@pytest.mark.parametrize("then", ["goes on", "is stopped", "fails"])
def test_a_successor_finds_a_dead_simulator(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    then: str,
) -> None:
    """The fault is recorded; while it is stored anything may happen to the run."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count"), None, "")
        if then == "fails":
            run.manifest = {**run.manifest, "max_faults": 1}
        turn = await parts.executor.attach(run, Attach("w", "key"))
        await parts.executor.predict(run, predict(turn))
        for process in list(parts.pool._processes):
            process.end("was killed by the test")
        gate = Gate(monkeypatch, parts.store, "save")
        taking = begun(
            parts.executor.attach(run, Attach("w", "another", takeover=True))
        )
        await gate.reached()
        if then == "is stopped":
            stop(parts, run)
        gate.open()
        if then == "goes on":
            successor = await taking
            assert successor["fault"]["faults"] == 1
            assert successor["episode"]["step"] == 0
            assert successor["episode"]["attempt"] == 1
            assert successor["observation"]["state"]["count"] == [0.0]
            return
        ended_by = {"is stopped": "run_stopped", "fails": "run_failed"}[then]
        with refusal("session_ended", ended_by=ended_by):
            await taking
        await nothing_is_held(parts)
        assert (run.episodes[0].attempt, run.episodes[0].faults) == (1, 1)

    tell(tmp_path, story)
    no_defect(caplog)


def test_who_waits_for_a_turn_that_is_lost_is_told(tmp_path: Path) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("delay"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        command = predict(turn, delay_s=0.2, end=1)
        with parts.unwritable():
            work = [
                parts.executor.predict(run, command),
                parts.executor.predict(run, command),
                parts.executor.attach(run, Attach("w", "another", takeover=True)),
            ]
            tasks = [asyncio.create_task(one) for one in work]
            await asyncio.wait(tasks)
        with refusal("unavailable"):
            await tasks[0]
        with pytest.raises(Refused, match=r"has ended|newer session"):
            await tasks[1]
        # The successor plays the run as it is stored, not the one that was lost.
        successor = await tasks[2]
        found = await parts.registry.get(run.run_id)
        assert found is not run
        assert list(found.workers) == ["w"]
        assert successor["episode"]["step"] == 0

    tell(tmp_path, story)


def test_who_comes_with_a_run_that_was_lost_is_told(tmp_path: Path) -> None:
    """Its caller found the run, awaited something else, and another's write failed."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count", "count"), None, "")
        one = await parts.executor.attach(run, Attach("one", "key"))
        other = await parts.executor.attach(run, Attach("other", "key"))
        with parts.unwritable(), refusal("unavailable"):
            await parts.executor.predict(run, predict(one, "one", end=1))
        with refusal("session_ended", ended_by="unknown"):
            await parts.executor.predict(run, predict(other, "other"))
        assert await parts.registry.get(run.run_id) is not run

    tell(tmp_path, story)


def test_the_last_turn_is_answered_although_a_successor_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("score", "score"), None, "")
        await parts.executor.attach(run, Attach("other", "key"))
        turn = await parts.executor.attach(run, Attach("w", "key"))
        saving, release, save = asyncio.Event(), asyncio.Event(), parts.store.save

        async def slow_save(run: Run) -> None:
            saving.set()
            await release.wait()
            await save(run)

        monkeypatch.setattr(parts.store, "save", slow_save)
        last = asyncio.create_task(
            parts.executor.predict(run, predict(turn, score=1, end=1))
        )
        await saving.wait()
        successor = asyncio.create_task(
            parts.executor.attach(run, Attach("w", "another"))
        )
        await asyncio.sleep(0)
        release.set()
        assert (await last)["done"]
        assert (await successor)["done"]

    tell(tmp_path, story)


def test_a_lease_ends_at_one_moment_for_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between two looks at the clock a lease ended: then it ended for both or none."""

    async def story(parts: Parts) -> None:
        run = await parts.registry.add(calibration("count", "count"), None, "")
        turn = await parts.executor.attach(run, Attach("w", "key"))
        await parts.executor.predict(run, predict(turn))
        expires_at = run.workers["w"].expires_at
        moments = iter([expires_at])  # the first look; all others are too late

        def monotonic() -> float:
            return next(moments, expires_at + 0.001)

        clock = types.SimpleNamespace(**vars(time))
        clock.monotonic = monotonic
        monkeypatch.setattr(stage_module, "time", clock)
        with refusal("worker_busy"):
            await parts.executor.attach(run, Attach("w", "another"))
        turn = await parts.executor.attach(run, Attach("w", "another"))
        assert turn["episode"]["attempt"] == 2
        assert parts.pool.busy == 1
        monkeypatch.undo()
        parts.executor.heartbeat(run, Heartbeat("w", turn["session_id"]))

    tell(tmp_path, story)
