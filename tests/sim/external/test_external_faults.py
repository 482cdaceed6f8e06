"""Programs that misbehave: their episode has a fault, and nothing is left of them."""

import asyncio
import contextlib
import errno
import os
import re
import signal
import subprocess
import sys
import tempfile
import uuid
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.external import LIBRARIES, program
from reference_sim.gymnasium import registration
from reference_sim.gymnasium.own_sources import sha256_of
from reference_sim.interface import ProgramFault, SimulatorAway
from reference_sim.process.pool import (
    Begin,
    NoCapacity,
    SimulatorFault,
    SimulatorHandle,
    SimulatorPool,
)
from tests.support.paths import ROOT
from tests.support.processes import descendants
from tests.support.sim import breakable_simulator
from tests.support.sim.shared_processes import opened_pool, shared_pool
from tests.support.waiting import wait_in_loop, wait_until

pytestmark = [
    pytest.mark.skipif(sys.platform != "linux", reason="needs /proc"),
    pytest.mark.slow("starts programs that are ended by force"),
]
ACTION = {"add": [0.05]}
SOURCES = {
    path.relative_to(ROOT).as_posix(): sha256_of(path)
    for path in (Path(breakable_simulator.__file__), LIBRARIES / "proctor_simulator.py")
}
ONE_WORLD = """
import sys
from breakable_simulator import WORLD, proctor_simulator
proctor_simulator.serve(WORLD, *sys.argv[1:])
"""
FOLDERS = f"{LIBRARIES}:{Path(breakable_simulator.__file__).parent}"


@dataclass(frozen=True)
class Mark:
    """Marks a program and all that it starts by a variable of its environment."""

    value: str

    def command(self, *arguments: str) -> list[str]:
        program = [sys.executable, "-S", breakable_simulator.__file__, *arguments]
        return ["env", f"SIMULATOR_TEST={self.value}", *program]

    def config(self, *arguments: str) -> SimulatorConfig:
        return self.config_of(self.command(*arguments))

    def config_of(
        self, command: list[str], away_timeout_s: float = 10.0
    ) -> SimulatorConfig:
        plan: dict[str, Any] = {"command": command, "folder": str(Path.cwd())}
        plan |= {"sources": {}, "announced": SOURCES, "start_timeout_s": 60.0}
        plan |= {"away_timeout_s": away_timeout_s}
        plan |= {"benchmark": breakable_simulator.WORLD.benchmark}
        settings: dict[str, Any] = {"codec": "raw", "width": 8, "height": 6}
        settings |= {"adapter": "external", "plan": plan, "success_scored_tasks": []}
        return SimulatorConfig("breakable", settings)

    def processes(self) -> set[int]:
        found = set()
        for path in Path("/proc").glob("[0-9]*/environ"):
            with contextlib.suppress(OSError):
                if f"SIMULATOR_TEST={self.value}".encode() in path.read_bytes():
                    found.add(int(path.parent.name))
        return found

    @contextmanager
    def listening(self, folder: Path, fault: str = "") -> Iterator[list[str]]:
        """A program that the server did not start; gives its address. fault: of its
        second connection."""
        path = folder / "sim.sock"
        started = subprocess.Popen(
            self.command(fault, f"unix:{path}", "2"), stderr=subprocess.DEVNULL
        )
        try:
            wait_until(path.exists, "it listens")
            yield [f"unix:{path}"]
        finally:
            started.kill()
            for pid in self.processes():  # the server does not end it
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
            started.wait()


@asynccontextmanager
async def lent(
    fault: str, turn_timeout_s: float = 60.0, *, has_own_log: bool = False
) -> AsyncIterator[tuple[SimulatorHandle, Mark, SimulatorPool]]:
    """A simulator; expects that nothing of its program is left. has_own_log: its
    processes are not those that tests share, whose log goes elsewhere."""
    mark = Mark(str(uuid.uuid4()))
    kind = SimulatorPool if has_own_log else shared_pool
    pool = kind(spares=0, turn_timeout_s=turn_timeout_s)
    await pool.start()
    try:
        handle = await pool.acquire(mark.config(fault))
        supervisors = descendants(handle.pid or 0)
        assert mark.processes()
        yield handle, mark, pool
    finally:
        await pool.close()
    await wait_in_loop(lambda: not mark.processes(), 20.0)
    await wait_in_loop(lambda: not directories_of(supervisors), 20.0)


def directories_of(supervisors: set[int]) -> list[Path]:
    folder = Path(tempfile.gettempdir())
    patterns = [f"proctor-simulator-{pid}-*" for pid in supervisors]
    return [path for pattern in patterns for path in folder.glob(pattern)]


async def begin(handle: SimulatorHandle) -> None:
    await handle.begin(Begin("count", 1, max_steps=20, success_rule="any_step"))


async def play(handle: SimulatorHandle) -> None:
    await begin(handle)
    await handle.play([ACTION] * 5, observe_all=True)


FAULTS = pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("SIM-001", "announced a reply of 1819238756 bytes, and 16777216 is the most"),
        (
            "SIM-002",
            "`step` 3 of count, ended with exit code 7; its last line: no more",
        ),
        ("SIM-003", "made no step for 1 s and was killed, after 0 steps of count"),
        ("success_text", r"got `str` - at `\$.success`: 'no'"),
        ("terminated_text", r"got `str` - at `\$.terminated`: 'False'"),
        ("world_reports_text", r"fault: ValueError: success is 'no' \(str\), and must"),
        (
            "stages_with_the_goal",
            r"^the stages \['begun', 'goal'\] must have different",
        ),
        ("exits_by_python", "reports a fault: SystemExit: no licence"),
        ("SIM-015", "declares: sum has 2 numbers, not 1"),
        ("SIM-016", "^in `step` 1 of count, score 1.05 is outside 0"),
        ("SIM-018", "sent the tensor 'sums' as float64"),
        ("floods_forever", "made no step for 1 s and was killed"),
        ("sends_2_gb", "announced a reply of 2147483648 bytes, and 1048632 is the"),
        ("lies_about_sizes", r"as \(480, 640, 1\) in 48 bytes"),
        ("garbage", "sent a reply to step that is not valid: MessagePack data is"),
        ("replies_twice", "sent more than one reply to a request"),
        ("replies_late", r"a reply with number \d instead of \d: each request has"),
        ("has_no_numbers", "sent a reply with number None instead of 2"),
        (
            "faults_to_observe",
            "`observe` after 0 steps of count, reports a fault: the display",
        ),
        ("not_finite", "`step` 1 of count, sent a state 'sum' that is not finite"),
        ("killed", "`step` 1 of count, ended by SIGKILL"),
        ("forks", "`step` 1 of count, ended with exit code 1"),
    ],
)


@FAULTS
async def test_a_program_that_misbehaves_costs_its_episode_a_fault(
    fault: str, said: str
) -> None:
    """Another program of the pool plays on."""
    timeout_s = 1.0 if "no step" in said else 60.0
    async with lent(fault, timeout_s) as (handle, mark, pool):
        other = await pool.acquire(mark.config())
        await begin(other)
        with pytest.raises(SimulatorFault, match=said):
            await play(handle)
        played = await other.play([ACTION] * 3, observe_all=True)
        assert played.steps == 3
        assert not played.ended
        await other.release()


@FAULTS
async def test_a_program_at_a_socket_that_misbehaves_costs_its_episode_a_fault(
    fault: str, said: str, tmp_path: Path
) -> None:
    """Its other connections go on, and so does a new one."""
    mark = Mark(str(uuid.uuid4()))
    said = re.sub("ended .*", "ended its connection", said)
    turn_timeout_s = 1.0 if "no step" in said else 60.0
    async with opened_pool(turn_timeout_s=turn_timeout_s) as pool:
        with mark.listening(tmp_path, fault) as command:
            other = await pool.acquire(mark.config_of(command))
            await begin(other)
            handle = await pool.acquire(mark.config_of(command))
            with pytest.raises(SimulatorFault, match=said):
                await play(handle)
            for playing in (other, await pool.acquire(mark.config_of(command))):
                await begin(playing)


async def test_a_program_that_is_away_is_tried_again(tmp_path: Path) -> None:
    """Expect `no_capacity` when it stays away, and no fault; then it is played."""
    mark = Mark(str(uuid.uuid4()))
    address = [f"unix:{tmp_path}/sim.sock"]
    async with opened_pool() as pool:
        with pytest.raises(NoCapacity, match=r"is away \(No such file or directory\)"):
            await pool.acquire(mark.config_of(address, away_timeout_s=0.0))
        waiting = asyncio.create_task(pool.acquire(mark.config_of(address)))
        with mark.listening(tmp_path):
            await begin(await waiting)


async def test_one_world_is_played_by_one_session_at_a_time(tmp_path: Path) -> None:
    """A world of the library, in two sizes of pictures: the second has to wait."""
    (tmp_path / "one_world.py").write_text(ONE_WORLD)
    entry = tmp_path / "one.toml"
    entry.write_text('simulator = ["unix:sim.sock"]\naway_timeout_s = 0.3\n')
    program = [sys.executable, "-S", "one_world.py", "unix:sim.sock"]
    environment = os.environ | {"PYTHONPATH": FOLDERS}
    pool = shared_pool(spares=0)
    await pool.start()
    started = subprocess.Popen(program, cwd=tmp_path, env=environment)  # noqa: ASYNC220
    try:
        ((_, definition),) = await asyncio.to_thread(
            lambda: list(registration.benchmarks(str(entry), print))
        )
        manifest = definition.describe({}, 1)
        assert "one_world.py" in manifest["simulator"]["sources"]
        assert "command" not in manifest["simulator"]
        configs = [
            SimulatorConfig("one", definition.settings({"codec": "raw", **size}))
            for size in manifest["image_sizes"]
        ]
        for config, busy in (configs, configs[::-1]):
            handle = await pool.acquire(config)
            await begin(handle)
            with pytest.raises(NoCapacity, match="is away"):
                await pool.acquire(busy)
            assert (await handle.play([ACTION], observe_all=False)).steps == 1
            await handle.release()
    finally:
        started.kill()
        started.wait()
        await pool.close()


async def test_a_flood_of_errors_costs_time(capfd: pytest.CaptureFixture[str]) -> None:
    """2 MB of lines at each step: the log has some of them, and says how many not."""
    async with lent("floods", has_own_log=True) as (handle, _, _):
        await begin(handle)
        assert (await handle.play([ACTION], observe_all=False)).steps == 1
    log = capfd.readouterr().err
    assert len(log) < 100_000
    assert "simulator env: EEEE" in log
    assert "more lines are left out)" in log


async def test_a_program_has_a_directory_of_its_own_and_no_secrets(
    capfd: pytest.CaptureFixture[str],
) -> None:
    async with lent("writes_files", has_own_log=True) as (handle, _, _):
        await begin(handle)
        await handle.play([ACTION], observe_all=False)
    log = capfd.readouterr().err
    assert "SECRETS=[]" in log
    assert str(ROOT) not in log.partition("PYTHONPATH=")[2].partition("\n")[0]
    directory = Path(log.partition("TMPDIR=")[2].partition("\n")[0])
    assert directory.name.startswith("proctor-simulator-")
    await wait_in_loop(lambda: not directory.exists(), 20.0)


@pytest.mark.parametrize("error", [errno.ENOSPC, errno.EACCES, errno.ENOENT])
def test_what_keeps_this_machine_from_a_start_is_no_fault_of_the_program(
    error: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The directory of the program cannot be made, wherever its supervisor tries it."""
    place = {errno.ENOENT: tmp_path / "gone", errno.EACCES: Path("/proc")}
    if error == errno.ENOSPC:
        monkeypatch.setattr(program, "temporary_folder", _refuse_a_full_disk)
    else:
        monkeypatch.setattr(program, "temporary_folder", lambda: str(place[error]))
    with pytest.raises(SimulatorAway, match="could not start the simulator") as raised:
        program.Program([sys.executable, "-c", "print()"], str(tmp_path))
    assert "which is not the cause" in str(raised.value)


def _refuse_a_full_disk() -> str:
    raise FileNotFoundError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_a_program_that_is_not_there_is_its_own_fault(tmp_path: Path) -> None:
    with pytest.raises(ProgramFault, match="cannot be started: No such file"):
        program.Program(["./no-such-program"], str(tmp_path))


async def test_a_program_that_describes_another_benchmark_is_not_played() -> None:
    async with opened_pool() as pool:
        with pytest.raises(SimulatorFault, match="describes another benchmark than"):
            await pool.acquire(Mark("another").config("SIM-009"))
    await wait_in_loop(lambda: not Mark("another").processes(), 20.0)


async def test_the_end_of_a_simulator_process_ends_its_program() -> None:
    """The process is killed while its program hangs."""
    async with lent("SIM-003") as (handle, mark, _):
        await begin(handle)
        handle.discard()
        await wait_in_loop(lambda: not mark.processes(), 20.0)
