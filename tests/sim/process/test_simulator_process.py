"""Frames of a simulator process, however the socket cuts or joins them; its log."""

import asyncio
import os
import socket
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from reference_sim.interface import ChangedSource, TaskUnplayable
from reference_sim.message_frames import LENGTH, frame
from reference_sim.process import simulator_main
from reference_sim.process.simulator_process import LocalProcess

SMALL = simulator_main.FailureReply("x", unplayable=True)
LARGE = simulator_main.FailureReply("y" * 200_000, unplayable=True)


class TestProcessStarter:
    """`ProcessStarter` of a process that this test plays."""

    def start(self, child_end: socket.socket) -> None:
        self.end = socket.socket(fileno=os.dup(child_end.fileno()))
        self.end.setblocking(False)

    def kill(self, pid: int) -> None:
        self.end.close()

    async def close(self) -> None:
        self.end.close()


@pytest.fixture
def process_starter() -> Iterator[TestProcessStarter]:
    starter = TestProcessStarter()
    yield starter
    starter.end.close()


def cut(stream: bytes, size: int) -> list[bytes]:
    return [stream[at : at + size] for at in range(0, len(stream), size)]


@pytest.mark.parametrize(
    ("replies", "size"),
    [
        ([SMALL], 1),
        ([simulator_main.Busy(), simulator_main.Busy(), SMALL], 10**9),
        ([simulator_main.Busy(), SMALL], 3),
        ([LARGE], 10**9),
        ([simulator_main.Busy(), LARGE], 4099),
        ([simulator_main.Busy(), LARGE], 2**15),
    ],
)
async def test_frames_come_in_any_pieces(
    process_starter: TestProcessStarter,
    replies: Sequence[simulator_main.SimulatorReply],
    size: int,
) -> None:
    loop = asyncio.get_running_loop()
    process = LocalProcess(process_starter, 20.0, lambda _: None)
    starting = asyncio.create_task(process.start())
    await asyncio.sleep(0)
    hello = frame(simulator_main.Hello(1))
    await loop.sock_sendall(process_starter.end, hello)
    await starting
    for _ in range(3):  # nothing of one answer is left to the next
        asking = asyncio.create_task(
            process.request(simulator_main.Observe(), simulator_main.FailureReply)
        )
        await loop.sock_recv(process_starter.end, 4096)
        stream = b"".join(map(bytes, map(frame, replies)))
        for piece in cut(stream, size):
            await loop.sock_sendall(process_starter.end, piece)
            await asyncio.sleep(0)
        assert await asking == replies[-1]
    process.end("is not needed")


def test_a_process_whose_parent_has_ended_is_no_failure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def end(code: int) -> None:
        raise SystemExit(code)

    monkeypatch.setattr(os, "_exit", end)
    ours, theirs = socket.socketpair()
    ours.close()
    with theirs, pytest.raises(SystemExit) as ended:
        simulator_main._send(theirs, simulator_main.Hello(1))
    assert ended.value.code == 0


@pytest.mark.parametrize(
    ("error", "reply", "has_traceback"),
    [
        (ChangedSource.of(["lab.py"]), "ChangedSource: lab.py has changed", False),
        (TaskUnplayable("no asset"), "no asset", False),
        (ValueError("a bad number"), "ValueError: a bad number", True),
    ],
)
def test_what_the_reply_explains_has_no_traceback_in_the_log(
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    error: Exception,
    reply: str,
    has_traceback: bool,
) -> None:
    """Every process meets an edited file, and the server logs its name once."""

    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr(simulator_main._EpisodeHost, "_execute", fail)
    ours, theirs = socket.socketpair()
    with ours, theirs:
        host = simulator_main._EpisodeHost(ours)
        command = frame(simulator_main.Observe())
        failed = host.answer(bytes(command[LENGTH.size :]))
    assert isinstance(failed, simulator_main.FailureReply)
    assert failed.error.startswith(reply)
    assert ("Traceback" in caplog.text) == has_traceback


@pytest.mark.parametrize(
    "kind", ["RuntimeError", "SystemExit", "KeyboardInterrupt", "GeneratorExit"]
)
def test_a_fault_in_a_sealed_split_names_its_lines_alone(
    kind: str,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    tmp_path: Path,
) -> None:
    """The author finds the place in the reply and in the log, and no value in it."""
    file = tmp_path / "lab.py"
    file.write_text(f"def step(seed):\n    raise {kind}(f'seed {{seed}}')\n")
    values: dict[str, Any] = {}
    exec(compile(file.read_text(), str(file), "exec"), values)  # noqa: S102
    monkeypatch.setattr(
        simulator_main._EpisodeHost, "_execute", lambda *_: values["step"](4711)
    )
    ours, theirs = socket.socketpair()
    with ours, theirs:
        host = simulator_main._EpisodeHost(ours)
        host._is_sealed = True
        command = frame(simulator_main.Observe())
        failed = host.answer(bytes(command[LENGTH.size :]))
    assert isinstance(failed, simulator_main.FailureReply)
    assert failed.error == f"{kind}: seed 4711 (lab.py:2)"
    assert f'File "{file}", line 2, in step' in caplog.text
    assert f"simulator failed in a sealed split: {kind}" in caplog.text
    assert "4711" not in caplog.text
