"""How sandboxes begin and end: the socket, the limits of time, kills, hosts that lack
what is needed.
"""

from __future__ import annotations

import asyncio
import os
import shutil
import socket
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from reference_platform.sandbox import bubblewrap, control_groups
from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.control_groups import ControlGroups
from reference_platform.sandbox.sandbox_interface import (
    CODE_PATH,
    NotListening,
    Sandbox,
    SandboxEnd,
    SandboxSpec,
    SandboxUnavailable,
)
from tests.support.paths import ROOT
from tests.support.platform.sandboxes import (
    ECHO,
    SMALL,
    WrittenLog,
    open_folder,
    python_command,
    system_binds,
)
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

IGNORE_SIGNALS = """
import os, signal, time
for number in range(1, 65):
    try:
        signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError):
        pass
print("started", flush=True)
if os.fork() == 0:
    os.setsid()
while True:
    time.sleep(1)
"""


def spec_of(code: str, wall_clock_s: float = 60.0) -> SandboxSpec:
    command = [python_command(), "-c", code]
    return SandboxSpec(
        command, binds=system_binds(), limits=replace(SMALL, wall_clock_s=wall_clock_s)
    )


async def connect(sandbox: Sandbox) -> socket.socket:
    """As soon as the policy listens."""
    while True:
        try:
            return sandbox.connect()
        except NotListening:
            assert sandbox.end is None
            await asyncio.sleep(0.01)


async def run_to_end(spec: SandboxSpec, log: WrittenLog) -> SandboxEnd:
    sandbox = await BubblewrapMaker().start(spec, log)
    return await sandbox.wait()


async def test_the_socket_is_the_way_in() -> None:
    log = WrittenLog()
    sandbox = await BubblewrapMaker().start(spec_of(ECHO), log)
    with await connect(sandbox) as connection:
        connection.sendall(b"hello")
        assert connection.recv(100) == b"hello"
    end = await sandbox.close("The test is over.")
    assert end == SandboxEnd("The test is over.", True, cpu_s=end.cpu_s)
    assert log.lines == [
        ("policy", "listening"),
        ("platform", "The sandbox has ended. The test is over."),
    ]
    with pytest.raises(NotListening):
        sandbox.connect()


async def test_a_sandbox_that_is_ended_at_once_leaves_nothing() -> None:
    for _ in range(20):
        sandbox = await BubblewrapMaker().start(spec_of(ECHO), WrittenLog())
        async with asyncio.timeout(TIMEOUT_S):
            await sandbox.close("The test is over.")


@pytest.mark.parametrize("is_seen", [True, False])
@pytest.mark.parametrize(
    ("command", "text", "code"),
    [
        (["/not/there"], "bwrap: execvp /not/there: No such file or directory", 1),
        ([python_command(), "-c", "print('done')"], "done", 0),
    ],
    ids=["no program", "short program"],
)
async def test_a_program_that_ends_at_once_is_no_fault_of_the_host(
    monkeypatch: pytest.MonkeyPatch,
    is_seen: bool,
    command: list[str],
    text: str,
    code: int,
) -> None:
    """Also when it has ended before the host looks for its process."""
    if not is_seen:
        wait = subprocess.Popen.wait

        def end_first(process: subprocess.Popen[bytes], info_fd: int) -> object:
            wait(process, 10)
            return open_child(process, info_fd)

        open_child = bubblewrap._open_child
        monkeypatch.setattr(bubblewrap, "_open_child", end_first)
    log = WrittenLog()
    end = await run_to_end(replace(spec_of("pass"), command=command), log)
    assert end.reason == f"The policy ended by itself, with exit code {code}."
    assert log.of("policy") == [text]


@pytest.mark.parametrize("kind", ["link", "folder of links", "file", "nothing"])
async def test_no_link_leads_to_a_socket_of_the_host(kind: str) -> None:
    """A policy that names a socket of the host gets the platform to no connection."""
    with open_folder() as folder, socket.socket(socket.AF_UNIX) as listener:
        place = folder / "policy.sock"
        listener.bind(str(place))
        listener.listen()
        code = {
            "link": f"os.symlink({str(place)!r}, path)",
            "folder of links": (
                f"os.symlink('/proc/1/root{place}', path);"
                f"os.symlink({str(folder)!r}, '/run/other')"
            ),
            "file": "open(path, 'w').close()",
            "nothing": "pass",
        }[kind]
        code = f"import os, time; path = os.environ['PROCTOR_POLICY_SOCKET']; {code}"
        code += "; print('ready', flush=True); time.sleep(60)"
        log = WrittenLog()
        sandbox = await BubblewrapMaker().start(spec_of(code), log)
        await log.first.wait()
        with pytest.raises(NotListening):
            sandbox.connect()
        await sandbox.close("The test is over.")


@pytest.mark.parametrize(
    ("code", "reason"),
    [
        ("raise SystemExit(3)", "The policy ended by itself, with exit code 3."),
        (
            "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)",
            "The policy was ended by SIGSEGV.",
        ),
        (
            "import ctypes; ctypes.CDLL(None).ptrace(0, 0, 0, 0)",
            "The policy was killed: it made a system call that is not allowed.",
        ),
        (IGNORE_SIGNALS, "It ran for 0.5 s, the longest time that it may."),
    ],
    ids=["exit", "signal", "system call", "time"],
)
async def test_an_end_has_its_reason(code: str, reason: str) -> None:
    log = WrittenLog()
    limit_s = 0.5 if code == IGNORE_SIGNALS else 60.0
    end = await run_to_end(spec_of(code, limit_s), log)
    assert end.reason == reason
    assert log.of("platform") == [f"The sandbox has ended. {reason}"]


async def test_memory_ends_a_policy_with_that_reason() -> None:
    code = "a = []\nwhile True: a.append(bytearray(b'x' * 2**24))"
    end = await run_to_end(spec_of(code), WrittenLog())
    assert "memory limit" in end.reason or "exit code 1" in end.reason


async def test_long_and_broken_output_is_written_in_parts() -> None:
    code = "import os\nos.write(1, b'x' * 20_000)\nos.write(1, b'\\xff\\nend')"
    log = WrittenLog()
    await run_to_end(spec_of(code), log)
    written = log.of("policy")
    assert "".join(written) == "x" * 20_000 + "\N{REPLACEMENT CHARACTER}end"
    assert max(map(len, written)) <= 8192


PLATFORM = """
import asyncio, sys
from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from tests.platform.sandbox import test_sandbox_ends as ends
async def main():
    spec = ends.spec_of(ends.IGNORE_SIGNALS + "# " + sys.argv[1])
    write = lambda *line: print(*line, flush=True)
    sandbox = await BubblewrapMaker().start(spec, write)
    await sandbox.wait()
asyncio.run(main())
"""


def test_a_killed_platform_leaves_no_process() -> None:
    mark = f"mark-{os.getpid()}"
    with subprocess.Popen(
        [sys.executable, "-c", PLATFORM, mark],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
    ) as platform:
        assert platform.stdout is not None
        assert platform.stdout.readline() == "policy started\n"
        platform.kill()
    wait_until(lambda: not _processes_with(mark), f"no process has {mark}")
    BubblewrapMaker()  # the next platform removes the groups
    groups = Path("/sys/fs/cgroup").glob(f"**/proctor-sandbox-{platform.pid}-*")
    assert not list(groups)


def _processes_with(mark: str) -> list[str]:
    commands = []
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            commands.append(path.read_text())
        except (FileNotFoundError, ProcessLookupError):
            continue
    return [command for command in commands if mark in command]


def test_a_host_without_bubblewrap_gets_the_name_of_the_package(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    which = shutil.which
    monkeypatch.setattr(
        shutil, "which", lambda name: None if name == "bwrap" else which(name)
    )
    with pytest.raises(SandboxUnavailable, match="apt-get install bubblewrap"):
        BubblewrapMaker()


def test_a_host_without_user_namespaces_gets_the_way_to_allow_them() -> None:
    code = """
import asyncio
from tests.platform.sandbox import test_sandbox_ends as ends
try:
    asyncio.run(ends.run_to_end(ends.spec_of("pass"), ends.WrittenLog()))
except ends.SandboxUnavailable as error:
    print(error)
"""
    script = 'echo 0 > /proc/sys/user/max_user_namespaces && exec "$@"'
    command = ["unshare", "--user", "--map-root-user", "sh", "-c", script, "sh"]
    answer = subprocess.run(
        [*command, sys.executable, "-c", code],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    assert "The sandbox cannot be started" in answer.stdout, answer
    assert "user.max_user_namespaces above 0" in answer.stdout


async def test_a_root_that_sandboxes_cannot_enter_is_refused(tmp_path: Path) -> None:
    if os.getuid() != 0:  # then sandboxes have this user's rights
        return
    closed = tmp_path / "closed"
    (closed / "root").mkdir(parents=True)
    closed.chmod(0o700)
    spec = replace(spec_of("pass"), binds={CODE_PATH: closed / "root"})
    with pytest.raises(SandboxUnavailable, match="chmod o\\+x"):
        await BubblewrapMaker().start(spec, WrittenLog())


def test_version_2_of_control_groups(tmp_path: Path) -> None:
    """On a folder that looks like one: the machine of the tests may have version 1."""
    unit = tmp_path / "system.slice" / "proctor.service"
    unit.mkdir(parents=True)
    for folder in (tmp_path, unit):
        (folder / "cgroup.controllers").write_text("cpu memory pids")
        (folder / "cgroup.subtree_control").write_text("")
        (folder / "cgroup.procs").write_text("")
    groups = ControlGroups(tmp_path, "0::/system.slice/proctor.service\n")
    assert groups.problem is None
    assert (unit / "cgroup.subtree_control").read_text() == "+cpu +memory +pids"
    group = groups.make(SMALL)
    assert group is not None
    (folder,) = unit.glob("proctor-sandbox-*")
    assert {file.name: file.read_text() for file in folder.iterdir()} == {
        "cpu.max": "200000 100000",
        "memory.max": str(SMALL.memory_bytes),
        "memory.swap.max": "0",
        "pids.max": str(SMALL.processes),
    }
    assert group.entrances == (folder / "cgroup.procs",)
    (folder / "memory.events").write_text("low 0\noom_kill 2\n")
    (folder / "pids.events").write_text("max 7\n")
    assert group.refusals() == [
        "The memory limit was reached; processes killed: 2.",
        "The process limit was reached; refused: 7.",
    ]
    assert control_groups._own_folders(tmp_path, "4:memory:/\n")[1] is False

    (unit / "cgroup.subtree_control").write_text("cpu memory pids\n")
    (unit / "proctor-platform").mkdir()
    ControlGroups(tmp_path, "0::/system.slice/proctor.service/proctor-platform\n").make(
        SMALL
    )
    assert len(list(unit.glob("proctor-sandbox-*"))) == 2
