"""`/livez` and `/readyz`: what they answer to every caller, and what that costs."""

from __future__ import annotations

import asyncio
import contextlib
import sqlite3
from pathlib import Path

import httpx
import pytest

from reference_server.monitoring import readiness
from reference_server.monitoring.readiness import Readiness
from reference_server.storage.runs.run_store import StoreFailed
from reference_sim.process.pool import SimulatorFault, SimulatorPool
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until


class Part:
    """A part with a check that fails for a reason, or waits."""

    def __init__(self, why: str = "", wait: asyncio.Event | None = None) -> None:
        self.why, self.wait, self.checks = why, wait, 0

    async def check(self) -> None:
        self.checks += 1
        if self.wait is not None:
            await self.wait.wait()
        if self.why:
            raise StoreFailed(self.why)


def test_what_cannot_work_is_named_and_why_is_logged(
    caplog: pytest.LogCaptureFixture,
) -> None:
    fit, broken = Part(), Part("disk /secret/path is gone")
    asked = Readiness({"fit": fit.check, "broken": broken.check}, lambda: False)
    assert asyncio.run(asked.missing()) == ("broken",)
    assert "not ready: broken: disk /secret/path is gone" in caplog.text


def test_many_questions_are_one_check(monkeypatch: pytest.MonkeyPatch) -> None:
    async def ask() -> list[tuple[str, ...]]:
        answers = await asyncio.gather(*(asked.missing() for _ in range(100)))
        answers += [await asked.missing() for _ in range(100)]
        monkeypatch.setattr(readiness, "FRESH_S", -1.0)
        return [*answers, await asked.missing()]

    part = Part()
    asked = Readiness({"part": part.check}, lambda: False)
    assert set(asyncio.run(ask())) == {()}
    assert part.checks == 2


def test_a_part_that_does_not_answer_is_not_ready(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def ask() -> tuple[str, ...]:
        asked = Readiness({"part": Part(wait=asyncio.Event()).check}, lambda: False)
        return await asked.missing()

    monkeypatch.setattr(readiness, "CHECK_TIMEOUT_S", 0.01)
    assert asyncio.run(ask()) == ("part",)


@pytest.mark.parametrize(("late", "now"), [("", "gone"), ("gone", "")])
def test_what_came_too_late_answers_no_later_question(
    monkeypatch: pytest.MonkeyPatch, late: str, now: str
) -> None:
    async def ask() -> tuple[str, ...]:
        assert await asked.missing() == ("part",)
        part.why = late
        answers.set()
        await asyncio.wait(asyncio.all_tasks() - {asyncio.current_task()})
        part.why = now
        return await asked.missing()

    monkeypatch.setattr(readiness, "CHECK_TIMEOUT_S", 0.01)
    monkeypatch.setattr(readiness, "FRESH_S", -1.0)
    answers = asyncio.Event()
    part = Part(wait=answers)
    asked = Readiness({"part": part.check}, lambda: False)
    assert asyncio.run(ask()) == (("part",) if now else ())
    assert part.checks == 2


def test_a_server_that_ends_checks_nothing() -> None:
    part = Part()
    asked = Readiness({"part": part.check}, lambda: True)
    assert asyncio.run(asked.missing()) == ("draining",)
    assert part.checks == 0


async def test_simulators_are_started_again_by_the_check(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """No run is played on a server that is not ready: it has to find out itself."""

    def fail(*_: object) -> None:
        raise OSError("no processes are left")

    pool = SimulatorPool(4, 0)
    try:
        await pool.check_start()
        assert pool.idle == 0, "one is started only after a failure"
        with monkeypatch.context() as patch:
            patch.setattr(type(pool._starter), "start", fail)
            with pytest.raises(SimulatorFault):
                await pool._start_process(pool._new_process())
            with pytest.raises(SimulatorFault):
                await pool.check_start()
        await pool.check_start()
        await pool.check_start()
        assert pool.idle == 1
    finally:
        await pool.close()
    with pytest.raises(SimulatorFault):
        await pool.check_start()


@pytest.mark.slow("starts a server")
def test_a_server_that_cannot_store_is_not_ready(tmp_path: Path) -> None:
    """Its database is locked, or its recordings are gone. It lives, and is ready again
    when they are."""
    with (
        ReferenceServer(tmp_path, PROCTOR_ALLOWED_HOSTS="eval.example.org") as server,
        httpx.Client(base_url=server.url, trust_env=False, timeout=TIMEOUT_S) as caller,
    ):
        ready = caller.get("/readyz")
        assert (ready.status_code, ready.json()) == (200, {"status": "ready"})
        assert caller.head("/livez").status_code == 200
        refused = caller.post("/livez")
        assert refused.status_code == 405
        with contextlib.closing(
            sqlite3.connect(server.database_file, isolation_level=None)
        ) as other:
            other.execute("BEGIN IMMEDIATE")
            wait_until(
                lambda: caller.get("/readyz").status_code == 503, "it is not ready"
            )
            problem = caller.get("/readyz")
            assert problem.headers["content-type"] == "application/problem+json"
            assert problem.headers["cache-control"] == "no-store"
            assert problem.json()["not_ready"] == ["database"]
            assert str(tmp_path) not in problem.text
            assert caller.get("/livez").json() == {"status": "live"}
            other.execute("ROLLBACK")
        other.close()
        wait_until(lambda: caller.get("/readyz").status_code == 200, "it is ready")
        records, moved = tmp_path / "proctor.sqlite.records", tmp_path / "moved"
        records.rename(moved)
        wait_until(lambda: caller.get("/readyz").status_code == 503, "it is not ready")
        assert caller.get("/readyz").json()["not_ready"] == ["recordings"]
        moved.rename(records)
        wait_until(lambda: caller.get("/readyz").status_code == 200, "it is ready")
