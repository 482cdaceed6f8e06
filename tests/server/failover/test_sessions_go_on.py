"""A session goes on in another process at the turn at which its own one ended.

A kill is a copy of what is on disk at one moment, and a server that opens the copy.
"""

from __future__ import annotations

import shutil
from collections.abc import AsyncIterator, Awaitable, Callable, Sequence
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from zlib import crc32

import msgspec
import pytest
from mcap.reader import make_reader

from reference_record.recordings.recording import WHOLE_HEAD, Turn
from reference_server.failover.kept_sessions import KeptSession, KeptSessions
from reference_server.failover.session_recovery import can_go_on
from reference_server.records.recordings import Recordings
from reference_server.rules.runs.lifecycle import Attach, Detach, Heartbeat, Predict
from reference_server.rules.runs.run import Result, Run
from reference_server.storage.runs.run_store import Store
from reference_sim.process.pool import SimulatorHandle
from tests.support.server.databases import UsedDatabase
from tests.support.server.server_parts import (
    BlockedCall,
    ServerParts,
    calibration_run,
    expect_refusal,
    open_server_parts,
    start_task,
)
from tests.support.sim.calibration_action import calibration_action

RUN = "run_1"
TASKS = ("score", "fault", "score")


@asynccontextmanager
async def server(
    path: Path, *, keeps: bool = True
) -> AsyncIterator[tuple[ServerParts, Recordings]]:
    recordings = Recordings(path / "records", keeps_sessions=keeps)
    async with open_server_parts(
        path / "proctor.sqlite", recordings=recordings
    ) as parts:
        recordings.open()
        yield parts, recordings


def copy_disk(source: Path, target: Path) -> None:
    """Copy all that a kill at this moment leaves; what is just removed may be gone."""
    with suppress(shutil.Error):
        shutil.copytree(source, target)


@dataclass(frozen=True)
class Step:
    """A request of a worker. actions: their values; None for an attach."""

    actions: Sequence[dict[str, Any]] | None = None
    observe: str = "last"
    key: str = "key"
    takeover: bool = False
    worker: str = "w"

    async def send(
        self, parts: ServerParts, before: dict[str, Any] | None
    ) -> dict[str, Any]:
        run = await parts.registry.get(RUN)
        if self.actions is None:
            command = Attach(self.worker, self.key, takeover=self.takeover)
            return dict(await parts.executor.attach(run, command))
        assert before is not None
        return dict(await parts.executor.predict(run, self.command(before)))

    def command(self, before: dict[str, Any]) -> Predict:
        actions = [calibration_action(**values) for values in self.actions or ()]
        seq = before["seq"] + 1
        session_id = before["session_id"]
        return Predict(self.worker, session_id, seq, actions, self.observe)  # type: ignore[arg-type]


def turn(*actions: dict[str, Any], observe: str = "last") -> Step:
    return Step(actions, observe)


# Every way in which a turn is answered, over three episodes.
STORY = (
    Step(),
    turn({"score": 0.25}),
    turn({"score": 0.5, "clipped": 9.0}),  # is clipped
    turn({"score": 0.5}, {"score": 0.75}, observe="all"),
    Step(key="second", takeover=True),
    turn({"score": 0.5}),
    turn({"score": 0.5, "end": 1}, {"score": 1}, observe="all"),  # stopped early
    turn({"vector": [0.1] * 8}),
    turn({"fault": 1}),
    turn({"vector": [0.2] * 8}, {"clipped": -9.0}),
    turn({"score": 0.5, "end": 1}),
    turn({"score": 1, "end": 1}),  # done
)


def shown(answer: dict[str, Any]) -> dict[str, Any]:
    """The values that a repeat has to show though another process sends it."""
    kept = {k: v for k, v in answer.items() if k not in ("timing", "lease")}
    if result := kept.get("episode_result"):  # not stored before the kill: decided anew
        kept["episode_result"] = result | {"finished_at": "", "think_s": 0.0}
    return kept


def results(run: Run) -> list[Result | None]:
    return [
        e.result and replace(e.result, think_s=0.0, finished_at_wall=0.0)
        for e in run.episodes
    ]


def recorded(path: Path, run: Run) -> list[list[tuple[int, int, str]]]:
    """Of each episode its turns in order: seq, steps, state."""
    found: list[list[tuple[int, int, str]]] = []
    for episode in run.episodes:
        assert episode.recording is not None
        files = Recordings(path / "records")
        file = files.path(RUN, episode.index, episode.recording.fence)
        with file.open("rb") as opened:
            turns = [
                msgspec.json.decode(message.data, type=Turn)
                for _, channel, message in make_reader(opened).iter_messages()
                if channel.topic == "/turn"
            ]
        found.append([(t.seq, t.steps, t.state_digest) for t in turns])
    return found


async def play(
    parts: ServerParts, steps: Sequence[Step], before: dict[str, Any] | None
) -> list[dict[str, Any]]:
    answers: list[dict[str, Any]] = []
    for step in steps:
        before = await step.send(parts, before)
        answers.append(before)
    return answers


async def submit(parts: ServerParts) -> None:
    await parts.registry.add(calibration_run(*TASKS, run_id=RUN), None, "")


@pytest.fixture(scope="module")
async def undisturbed(
    tmp_path_factory: pytest.TempPathFactory,
) -> tuple[list[Result | None], list[Any]]:
    path = tmp_path_factory.mktemp("undisturbed")
    async with server(path) as (parts, _):
        await submit(parts)
        await play(parts, STORY, None)
        run = await parts.registry.get(RUN)
        assert run.state == "completed"
        return results(run), recorded(path, run)


@pytest.mark.parametrize("count", range(1, len(STORY)))
async def test_a_session_goes_on_after_each_turn(
    tmp_path: Path, undisturbed: tuple[Any, Any], count: int
) -> None:
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    async with server(first) as (parts, _):
        await submit(parts)
        answers = await play(parts, STORY[:count], None)
        copy_disk(first, second)
    async with server(second) as (parts, recordings):
        before = answers[-2] if count > 1 else None
        repeated = await STORY[count - 1].send(parts, before)
        assert shown(repeated) == shown(answers[-1])
        await play(parts, STORY[count:], repeated)
        run = await parts.registry.get(RUN)
        assert (run.state, results(run)) == ("completed", undisturbed[0])
        assert recorded(second, run) == undisturbed[1]
        assert [e.faults for e in run.episodes] == [0, 1, 0]
        assert recordings.sessions is not None
        await recordings.sessions.settle(run)
        assert not list(second.glob("records/*/sessions/*"))


@pytest.mark.parametrize("is_shared", [False, True])
async def test_a_session_goes_on_after_a_restart_behind_every_turn(
    tmp_path: Path, undisturbed: tuple[Any, Any], *, is_shared: bool
) -> None:
    """is_shared: each process is another owner of the run, with a larger fence."""
    path, answers = tmp_path / "0", list[dict[str, Any]]()
    path.mkdir()
    for number, step in enumerate(STORY):
        async with server(path) as (parts, _):
            if not answers:
                await submit(parts)
            run = await parts.registry.get(RUN)
            assert run.fence == (number if is_shared else 0)
            if answers:
                again = await STORY[number - 1].send(
                    parts, answers[-2] if number > 1 else None
                )
                assert shown(again) == shown(answers[-1])
            answers += await play(parts, [step], answers[-1] if answers else None)
            path, before = tmp_path / str(number + 1), path
            copy_disk(before, path)
        if is_shared:
            used = UsedDatabase.of_file(path / "proctor.sqlite")
            used.execute(f"UPDATE runs SET fence = {number + 1}")  # noqa: S608
    async with server(path) as (parts, _):
        run = await parts.registry.get(RUN)
        assert (run.state, results(run)) == ("completed", undisturbed[0])
        assert recorded(path, run) == undisturbed[1]


@pytest.mark.parametrize("count", [2, 4, 6, 8])
@pytest.mark.parametrize("leaving", ["ended", "lost the run"])
async def test_a_session_goes_on_after_a_process_that_was_not_killed(
    tmp_path: Path, undisturbed: tuple[Any, Any], leaving: str, count: int
) -> None:
    """It has the time to write that the attempt is over, which it is not."""
    async with server(tmp_path) as (parts, _):
        await submit(parts)
        answers = await play(parts, STORY[:count], None)
        if leaving == "lost the run":
            run = await parts.registry.get(RUN)
            parts.registry.writer.drop_moved(run)
            assert run.lost
    async with server(tmp_path) as (parts, _):
        repeated = await STORY[count - 1].send(parts, answers[-2])
        assert shown(repeated) == shown(answers[-1])
        await play(parts, STORY[count:], repeated)
        run = await parts.registry.get(RUN)
        assert (run.state, results(run)) == ("completed", undisturbed[0])
        assert recorded(tmp_path, run) == undisturbed[1]


async def test_a_turn_writes_nothing_for_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A session is kept when it gets an episode, and when that has ended."""
    kept: list[KeptSession] = []
    keep = KeptSessions.keep

    async def keep_and_note(self: KeptSessions, run: Run, one: KeptSession) -> None:
        kept.append(one)
        await keep(self, run, one)

    monkeypatch.setattr(KeptSessions, "keep", keep_and_note)
    async with server(tmp_path) as (parts, _):
        await submit(parts)
        answers = await play(parts, STORY[:4], None)
        assert len(kept) == 1
        await play(parts, [turn({"end": 1})], answers[-1])
        assert [one.index for one in kept] == [0, 0, 1]


# What a server was about when it was killed: a call that is held up, before its work or
# after it.
MOMENTS = {
    "the turn was recorded": (SimulatorHandle, "play", True),
    "the recording was complete": (Recordings, "finish", True),
    "the result was about to be stored": (Store, "save", False),
    "the result was stored": (Store, "save", True),
    "the next episode was about to begin": (SimulatorHandle, "begin", False),
    "the next episode had begun": (SimulatorHandle, "begin", True),
}


@pytest.mark.parametrize("moment", MOMENTS)
async def test_a_turn_that_was_cut_off_is_executed_once(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    undisturbed: tuple[Any, Any],
    moment: str,
) -> None:
    """The request is repeated at the other process, as clients do it."""
    owner, name, after = MOMENTS[moment]
    count = 6  # the turn that ends the first episode
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    async with server(first) as (parts, _):
        await submit(parts)
        answers = await play(parts, STORY[:count], None)
        with monkeypatch.context() as patch:
            blocked = BlockedCall(patch, owner, name, after=after)
            cut = start_task(STORY[count].send(parts, answers[-1]))
            await blocked.wait_until_reached()
            copy_disk(first, second)
            blocked.open()
        expected = await cut
    async with server(second) as (parts, _):
        repeated = await STORY[count].send(parts, answers[-1])
        assert shown(repeated) == shown(expected)
        await play(parts, STORY[count + 1 :], repeated)
        run = await parts.registry.get(RUN)
        assert (run.state, results(run)) == ("completed", undisturbed[0])
        assert recorded(second, run) == undisturbed[1]


@pytest.mark.parametrize("waiting", ["a", "b"])
async def test_who_gets_the_next_episode_takes_none_that_is_in_play(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, waiting: str
) -> None:
    """One worker is in an episode, the other one between two, when both are cut off."""
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    playing = "b" if waiting == "a" else "a"
    begin, go_on = Step(worker=playing), Step([{"score": 0.5}], worker=playing)
    end = Step([{"score": 1, "end": 1}], worker=waiting)
    async with server(first) as (parts, _):
        await submit(parts)
        (inside,) = (await play(parts, [begin, go_on], None))[-1:]
        before = await Step(worker=waiting).send(parts, None)
        with monkeypatch.context() as patch:
            blocked = BlockedCall(patch, SimulatorHandle, "begin")
            cut = start_task(end.send(parts, before))
            await blocked.wait_until_reached()
            next((first / "records" / RUN / "sessions").iterdir())
            copy_disk(first, second)
            blocked.open()
        expected = await cut
    async with server(second) as (parts, _):
        assert shown(await end.send(parts, before)) == shown(expected)
        assert (await go_on.send(parts, inside))["episode"]["index"] == 0


End = Callable[[ServerParts, dict[str, Any]], Awaitable[object]]


async def _detach(parts: ServerParts, answer: dict[str, Any]) -> None:
    run = await parts.registry.get(RUN)
    await parts.executor.detach(run, Detach("w", answer["session_id"]))


async def _stop(parts: ServerParts, _answer: dict[str, Any]) -> None:
    await parts.service.stop_run("alice", RUN)


async def _drain(parts: ServerParts, _answer: dict[str, Any]) -> None:
    await parts.service.stop_run("alice", RUN, "drain")


def _make_other(path: Path) -> None:
    """The recording says that the state was another one."""
    (part,) = path.glob("records/*/*.parts/*.part")
    data = part.read_bytes()
    run = data.find(b'"state_digest":"') + len(b'"state_digest":"')
    changed = data[:run] + b"0" * 32 + data[run + 32 :]
    part.write_bytes(_with_checksums(changed))


def _with_checksums(part: bytes) -> bytes:
    fixed, at = b"", 0
    while at < len(part):
        kind, length, channel, _, at_ns, published = WHOLE_HEAD.unpack_from(part, at)
        start = at + WHOLE_HEAD.size
        at += 9 + length
        data = part[start:at]
        fixed += WHOLE_HEAD.pack(kind, length, channel, crc32(data), at_ns, published)
        fixed += data
    return fixed


def _nothing(_path: Path) -> None:
    pass


def _cut_session(path: Path) -> None:
    next(path.glob("records/*/sessions/*")).write_bytes(b"\x85")


async def _no_end(_parts: ServerParts, _answer: dict[str, Any]) -> None:
    pass


# How a session ended before the kill, or what became of its files; and the attempt that
# its episode then has.
ENDS: dict[str, tuple[End, Callable[[Path], None], bool, int]] = {
    "detached": (_detach, _nothing, True, 2),
    "stopped": (_stop, _nothing, True, 2),
    "draining": (_drain, _nothing, True, 1),
    "not kept": (_no_end, _nothing, False, 1),
    "another state": (_no_end, _make_other, True, 1),
    "file cut": (_no_end, _cut_session, True, 1),
}


@pytest.mark.parametrize("how", ENDS)
async def test_a_session_that_cannot_go_on_has_ended(tmp_path: Path, how: str) -> None:
    """As without fail-over: no attempt is counted by the kill, and no fault."""
    end, change, keeps, attempt = ENDS[how]
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    async with server(first, keeps=keeps) as (parts, _):
        await submit(parts)
        answer = (await play(parts, STORY[:3], None))[-1]
        await end(parts, answer)
        copy_disk(first, second)
    change(second)
    async with server(second) as (parts, _):
        run = await parts.registry.get(RUN)
        if run.state == "stopped":
            await parts.service.resume_run("alice", RUN)
        with expect_refusal("session_ended", ended_by="unknown"):
            await STORY[3].send(parts, answer)
        assert (run.episodes[0].attempt, run.episodes[0].faults) == (attempt, 0)
        assert not run.live_sessions
        turns = await play(parts, [Step(key="new")], None)
        assert turns[0]["episode"]["step"] == 0


async def test_a_request_waits_while_a_session_is_restored(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its lease stands still meanwhile (LEASE-005), and another body is refused."""
    first, second = tmp_path / "first", tmp_path / "second"
    first.mkdir()
    async with server(first) as (parts, _):
        await submit(parts)
        answers = await play(parts, STORY[:3], None)
        copy_disk(first, second)
    async with server(second) as (parts, _):
        blocked = BlockedCall(monkeypatch, SimulatorHandle, "resume_turn")
        run = await parts.registry.get(RUN)
        assert run.state == "running"
        await blocked.wait_until_reached()
        lease = parts.executor.heartbeat(run, Heartbeat("w", answers[2]["session_id"]))
        assert lease.busy
        again = start_task(STORY[2].send(parts, answers[1]))
        following = start_task(STORY[3].send(parts, answers[2]))
        with expect_refusal("seq_conflict"):
            await STORY[1].send(parts, answers[1])
        blocked.open()
        assert shown(await again) == shown(answers[2])
        assert (await following)["seq"] == 3


def test_only_what_can_be_played_again_goes_on() -> None:
    run = calibration_run(*TASKS)
    assert can_go_on(run)
    changed: Any = {**run.manifest, "simulator": {"deterministic": False}}
    run.manifest = changed
    assert not can_go_on(run)
    pushed = calibration_run(*TASKS, submission={"mode": "push"})
    assert not can_go_on(pushed)
