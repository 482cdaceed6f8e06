"""Sandboxes by bubblewrap: namespaces, a filter of system calls, limits (HST-024).

The policy sees its image as a read-only root and two small writable folders in memory.
It has namespaces of its own for users, processes, the network, mounts and names, no
environment but its own, no capability, and no way to new ones. A platform that runs as
root gives each sandbox a user of its own, which owns nothing on the host.
"""

from __future__ import annotations

import asyncio
import contextlib
import itertools
import json
import os
import resource
import secrets
import shutil
import signal
import subprocess
import threading
import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from socket import socket

from reference_platform.sandbox.control_groups import ControlGroup, ControlGroups
from reference_platform.sandbox.policy_socket import connect_to_policy
from reference_platform.sandbox.sandbox_interface import (
    MIB,
    SOCKET_PATH,
    SOCKET_VARIABLE,
    Limits,
    NotListening,
    SandboxEnd,
    SandboxSpec,
    SandboxUnavailable,
    WriteLine,
)
from reference_platform.sandbox.system_calls import compiled_filter

# Users of sandboxes, where the platform is root; nothing on the host belongs to them.
_USERS = range(1_900_000_000, 1_900_004_096)
# How long bubblewrap may take to set a sandbox up, and to be gone.
_SET_UP_S = 30.0
_CONNECT_S = 5.0
_DISK_LOOK_S = 0.5
_GONE = -1  # in place of the descriptor of a process
_NOT_REMOVED = "The platform could not remove all of the sandbox; its log says why."
_READ_BYTES = 65_536
# The longest line that is written as one.
_LINE_BYTES_MAX = 8_192
_PROGRAMS = {
    "bwrap": "bubblewrap",
    "prlimit": "util-linux",
    "setpriv": "util-linux",
    "sh": "dash",
}
# Enters the control groups named before `--`, then becomes the rest.
_ENTER_GROUPS = (
    'while [ "$1" != -- ]; do echo $$ > "$1" || exit 1; shift; done; shift; exec "$@"'
)
_NAMESPACES = [
    "--unshare-all", "--unshare-user", "--disable-userns", "--uid", "1000",
    "--gid", "1000", "--hostname", "sandbox", "--new-session", "--die-with-parent",
    "--cap-drop", "ALL", "--clearenv",
]  # fmt: skip
# The folders in which a policy can write, besides that of its socket.
_TEMPORARY, _SHARED_MEMORY = "/tmp", "/dev/shm"  # noqa: S108 - the sandbox's own


class BubblewrapMaker:
    """Starts sandboxes on this host. Raises SandboxUnavailable."""

    def __init__(self) -> None:
        missing = [name for name in _PROGRAMS if shutil.which(name) is None]
        if missing:
            packages = sorted({_PROGRAMS[name] for name in missing})
            raise SandboxUnavailable(
                f"{', '.join(missing)} is missing. Install it "
                f"(Debian: apt-get install {' '.join(packages)})."
            )
        self._groups = ControlGroups()
        self._groups.remove_left()
        users = _users_of_sandboxes()
        # From anywhere: a platform that starts again takes other users than before.
        begin = secrets.randbelow(len(users)) if users else 0
        self._users = itertools.cycle([*users[begin:], *users[:begin]])

    def enforcement(self, limits: Limits) -> str:
        """How this host enforces limits, in a few sentences for the host."""
        amounts = f"{limits.memory_bytes / MIB:g} MiB of memory, {limits.cpus:g} CPUs "
        amounts += f"and {limits.processes} processes"
        rest = (
            f"{limits.disk_bytes / MIB:g} MiB of each writable folder, by its size; "
            f"{limits.open_files} files of a process, by rlimits; time, by the platform"
        )
        if self._groups.problem is None:
            how = f"for all of a sandbox, by control groups {self._groups.version}"
            return f"{amounts}: {how}; {rest}."
        return (
            f"{amounts}: for each process alone (processes: of the user), by rlimits, "
            f"because {self._groups.problem}; {rest}. For limits of a whole sandbox "
            "run proctor-host as root, or under systemd with Delegate=yes."
        )

    async def start(self, spec: SandboxSpec, write: WriteLine) -> BubblewrapSandbox:
        """Raises SandboxUnavailable."""
        user = next(self._users, None)
        if user is not None:
            _check_reachable(spec)
        group = self._groups.make(spec.limits)
        try:
            process, child, output = _spawn(spec, group, user)
        except BaseException:
            if group is not None:
                group.remove()
            raise
        sandbox = BubblewrapSandbox(process, child, group, spec.limits, write)
        sandbox.follow(output.decode(errors="replace"))
        return sandbox


class BubblewrapSandbox:
    """A process of bubblewrap, and all that it has started."""

    def __init__(
        self,
        process: subprocess.Popen[bytes],
        process_fd: int,
        group: ControlGroup | None,
        limits: Limits,
        write: WriteLine,
    ) -> None:
        self._process = process
        self._process_fd = process_fd
        self._group = group
        self._limits = limits
        self._write = write
        self._end_reason: str | None = None
        self._ended = asyncio.Event()
        self._end: SandboxEnd | None = None
        self._loop = asyncio.get_running_loop()
        self._follower = threading.Thread(target=self._follow, daemon=True)
        self._early_output = ""
        self._is_over = threading.Event()
        self._disk_watcher = threading.Thread(target=self._watch_disk, daemon=True)

    @property
    def end(self) -> SandboxEnd | None:
        return self._end

    def connect(self) -> socket:
        """Raises NotListening."""
        if self._end is not None:
            raise NotListening(self._end.reason)
        return connect_to_policy(self._process_fd, _CONNECT_S)

    async def wait(self) -> SandboxEnd:
        await self._ended.wait()
        assert self._end is not None
        return self._end

    async def close(self, reason: str) -> SandboxEnd:
        self._kill(reason)
        return await self.wait()

    def follow(self, output: str) -> None:
        """output: that was read before."""
        self._early_output = output
        self._disk_watcher.start()  # the other thread waits for its end
        self._follower.start()

    def _kill(self, reason: str) -> None:
        """Kill the first process of the sandbox: the kernel then kills all of them.

        That process dies with its parent, but not before it has asked for it.
        """
        if self._end_reason is None and self._process.poll() is None:
            self._end_reason = reason
            with contextlib.suppress(OSError):
                signal.pidfd_send_signal(self._process_fd, signal.SIGKILL)
            self._process.kill()

    def _follow(self) -> None:
        """In a thread: write the output down, and then let go of the process.

        The output ends when no process of the sandbox is left, because each may hold
        it. Only then is the process reaped, and its end published.
        """
        limit_s = self._limits.wall_clock_s
        reason = f"It ran for {limit_s:g} s, the longest time that it may."
        timer = threading.Timer(limit_s, self._kill, [reason])
        timer.start()
        try:
            assert self._process.stdout is not None
            if self._early_output:
                self._write("policy", self._early_output)
            for line in _lines(self._process.stdout.fileno()):
                self._write("policy", line)
            self._process.wait()
        finally:
            timer.cancel()
            end = SandboxEnd(_NOT_REMOVED, is_by_platform=False, is_lost=True)
            try:
                end = self._clean_up()
            finally:
                self._loop.call_soon_threadsafe(self._publish, end)

    def _watch_disk(self) -> None:
        """In a thread: the kernel reports a full folder to the policy alone."""
        noted: set[str] = set()
        while not self._is_over.wait(_DISK_LOOK_S):
            for folder in {_TEMPORARY, _SHARED_MEMORY} - noted:
                if _is_full(self._process_fd, folder):
                    noted.add(folder)
                    text = f"The disk limit of {folder} was reached."
                    self._write("platform", text)

    def _clean_up(self) -> SandboxEnd:
        self._is_over.set()
        self._disk_watcher.join()
        refusals = [] if self._group is None else self._group.refusals()
        cpu_s = None if self._group is None else self._group.cpu_s()
        for text in refusals:
            self._write("platform", text)
        if self._group is not None:
            self._group.remove()
        _wait_until_dead(self._process_fd)
        if self._process_fd != _GONE:
            os.close(self._process_fd)
        assert self._process.stdout is not None
        self._process.stdout.close()
        if self._end_reason is not None:
            end = SandboxEnd(self._end_reason, is_by_platform=True)
        else:
            reason = self._describe_exit(refusals)
            is_killed = self._exit_signal == signal.SIGKILL and not refusals
            # No program in the sandbox sees the process of bubblewrap.
            is_lost = is_killed and self._process.returncode < 0
            end = SandboxEnd(reason, False, is_killed, is_lost)
        end = replace(end, cpu_s=cpu_s)
        self._write("platform", f"The sandbox has ended. {end.reason}")
        return end

    @property
    def _exit_signal(self) -> int:
        """Which signal ended the policy; 0 or less if none did."""
        code = self._process.returncode
        return code - 128 if code > 128 else -code  # bubblewrap adds 128 to signals

    def _describe_exit(self, refusals: Sequence[str]) -> str:
        code, number = self._process.returncode, self._exit_signal
        if number == signal.SIGSYS:
            return "The policy was killed: it made a system call that is not allowed."
        if number == signal.SIGKILL and refusals:
            return f"The policy was killed. {refusals[0]}"
        if number > 0:
            with contextlib.suppress(ValueError):
                return f"The policy was ended by {signal.Signals(number).name}."
        return f"The policy ended by itself, with exit code {code}."

    def _publish(self, end: SandboxEnd) -> None:
        self._end = end
        self._ended.set()


def _users_of_sandboxes() -> range:
    """Users that this process can give to sandboxes; none if it is not root.

    In a container, root may know fewer users than a machine has: then some of the last.
    """
    if os.getuid() != 0:
        return range(0)
    users = range(0)
    for line in Path("/proc/self/uid_map").read_text().splitlines():
        first, _, count = map(int, line.split())
        if first <= _USERS[0] and _USERS[-1] < first + count:
            return _USERS
        if count >= 4096:
            users = range(first + count - 2048, first + count - 1024)
    return users


def _spawn(
    spec: SandboxSpec, group: ControlGroup | None, user: int | None
) -> tuple[subprocess.Popen[bytes], int, bytes]:
    """Start bubblewrap; its process, and what `_open_child` returns."""
    read_fd, write_fd = os.pipe()
    with (
        os.fdopen(read_fd, "rb", buffering=0) as info,
        os.fdopen(write_fd, "wb", buffering=0) as written_info,
        compiled_filter() as filter_fd,
    ):
        command = [
            "sh", "-c", _ENTER_GROUPS, "sh",
            *(() if group is None else map(str, group.entrances)), "--",
            *_process_limits(spec.limits, user, has_group=group is not None),
            *_privileges(user),
            *_bubblewrap(spec, filter_fd, write_fd),
        ]  # fmt: skip
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            env={"PATH": os.environ.get("PATH", os.defpath)},
            cwd="/",
            pass_fds=(filter_fd, write_fd),
        )
        written_info.close()
        try:
            return process, *_open_child(process, info.fileno())
        except BaseException:
            process.kill()
            process.wait()
            assert process.stdout is not None
            process.stdout.close()
            raise


def _bubblewrap(spec: SandboxSpec, filter_fd: int, info_fd: int) -> list[str]:
    """The command that gives the policy namespaces of its own (HST-024)."""
    size = str(spec.limits.disk_bytes)
    environment = {
        "PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
        "HOME": _TEMPORARY,
        "LANG": "C.UTF-8",
        **spec.environment,
        SOCKET_VARIABLE: SOCKET_PATH,
    }
    command = ["bwrap", *_NAMESPACES]
    if spec.root is not None:
        command += ["--ro-bind", str(spec.root), "/"]
    for place, path in spec.binds.items():
        command += ["--ro-bind", str(path), place]
    command += [
        "--proc", "/proc",
        "--dev", "/dev",
        "--size", size, "--tmpfs", _SHARED_MEMORY, "--remount-ro", "/dev",
        "--size", size, "--tmpfs", _TEMPORARY,
        "--size", "65536", "--tmpfs", "/run",
        "--remount-ro", "/",
        "--chdir", spec.directory,
        "--seccomp", str(filter_fd), "--info-fd", str(info_fd),
    ]  # fmt: skip
    for name, value in environment.items():
        command += ["--setenv", name, value]
    return [*command, "--", *spec.command]


def _process_limits(limits: Limits, user: int | None, *, has_group: bool) -> list[str]:
    """Limits of each process; some stand in for those of a control group."""
    values = {
        "core": 0,
        "memlock": 64 * 2**20,
        "msgqueue": 0,
        "nofile": limits.open_files,
        "nproc": _most_processes(limits, user, has_group=has_group),
        "rtprio": 0,
        "sigpending": 4096,
    }
    if not has_group:
        values["as"] = limits.memory_bytes
        values["cpu"] = max(1, int(limits.wall_clock_s * limits.cpus))
    command = ["prlimit"]
    for name, value in values.items():
        # The platform may itself have less, which cannot be raised.
        most = resource.getrlimit(getattr(resource, f"RLIMIT_{name.upper()}"))[1]
        least = value if most == resource.RLIM_INFINITY else min(value, most)
        command.append(f"--{name}={least}:{least}")
    return [*command, "--"]


def _privileges(user: int | None) -> list[str]:
    command = ["setpriv", "--no-new-privs"]
    if user is not None:
        command += [f"--reuid={user}", f"--regid={user}", "--clear-groups"]
    return [*command, "--"]


def _most_processes(limits: Limits, user: int | None, *, has_group: bool) -> int:
    """The limit of processes of the sandbox's user.

    Above that of the control group, which counts what it refuses. Where sandboxes have
    the platform's user, all threads of that user count.
    """
    count = limits.processes + (16 if has_group else 0)
    if user is not None:
        return count
    own = os.getuid()
    for folder in Path("/proc").iterdir():
        if folder.name.isdecimal():
            with contextlib.suppress(OSError):
                if folder.stat().st_uid == own:
                    count += len(list((folder / "task").iterdir()))
    return count


def _open_child(process: subprocess.Popen[bytes], info_fd: int) -> tuple[int, bytes]:
    """Wait until the sandbox is being set up; its first process, and early output.

    `_GONE` if it has ended by then. Raises SandboxUnavailable.
    """
    text = b""
    while part := os.read(info_fd, 4096):
        text += part
        if b"}" in text:
            child = json.loads(text)["child-pid"]
            with contextlib.suppress(OSError):
                process_fd = os.open(f"/proc/{child}", os.O_DIRECTORY | os.O_CLOEXEC)
                if _read_status(process_fd)[1] == process.pid:
                    return process_fd, b""
                os.close(process_fd)
    process.wait(_SET_UP_S)
    assert process.stdout is not None
    output = process.stdout.read()
    is_set_up = b"}" in text and not output.startswith(b"bwrap: ")
    if is_set_up or output.startswith(b"bwrap: execvp "):
        return _GONE, output  # the program has ended already, or is not there
    raise SandboxUnavailable(_explain(output.decode(errors="replace")))


def _explain(output: str) -> str:
    text = f"The sandbox cannot be started: {' '.join(output.split())[:500]}"
    if "namespace" in output or "uid map" in output:
        text += (
            ". This host lets no unprivileged user make a namespace. Allow it: sysctl "
            "kernel.unprivileged_userns_clone=1 on Debian, "
            "kernel.apparmor_restrict_unprivileged_userns=0 on Ubuntu, "
            "user.max_user_namespaces above 0 anywhere; a container needs them from "
            "its host"
        )
    return text


def _read_status(process_fd: int) -> tuple[str, int]:
    """State and parent of a process. Raises OSError when it has been reaped."""
    file_fd = os.open("stat", os.O_RDONLY | os.O_CLOEXEC, dir_fd=process_fd)
    try:
        state, parent = os.read(file_fd, 4096).rpartition(b")")[2].split()[:2]
        return state.decode(), int(parent)
    finally:
        os.close(file_fd)


def _is_full(process_fd: int, folder: str) -> bool:
    """Whether no byte is free in a folder of the sandbox."""
    try:
        root_fd = os.open("root", os.O_PATH | os.O_DIRECTORY, dir_fd=process_fd)
        try:
            if os.path.samestat(os.fstat(root_fd), Path("/").stat()):
                return False  # bubblewrap has not yet left the root of the host
            flags = os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW
            folder_fd = os.open(folder.lstrip("/"), flags, dir_fd=root_fd)
        finally:
            os.close(root_fd)
        try:
            return os.fstatvfs(folder_fd).f_bfree == 0
        finally:
            os.close(folder_fd)
    except OSError:  # it is ending
        return False


def _wait_until_dead(process_fd: int) -> None:
    """Until the sandbox's first process is dead; the kernel ends it after all others.

    Its number stays until a process of the host takes note of its end.
    """
    deadline = time.monotonic() + _SET_UP_S
    with contextlib.suppress(OSError):
        while _read_status(process_fd)[0] not in "ZX" and time.monotonic() < deadline:
            time.sleep(0.002)


def _check_reachable(spec: SandboxSpec) -> None:
    """The sandbox's user must reach its files. Raises SandboxUnavailable."""
    for path in [*([] if spec.root is None else [spec.root]), *spec.binds.values()]:
        for folder in path.resolve().parents:
            if not folder.stat().st_mode & 0o001:
                raise SandboxUnavailable(
                    f"Users of sandboxes cannot enter {folder}. Allow it with chmod "
                    f"o+x {folder}, or have the platform's files elsewhere."
                )


def _lines(output_fd: int) -> Iterator[str]:
    """The lines of the output as they come, some at a time; very long ones in parts."""
    kept = b""
    while part := os.read(output_fd, _READ_BYTES):
        *complete, kept = (kept + part).split(b"\n")
        if len(kept) >= _LINE_BYTES_MAX:
            complete, kept = [*complete, kept], b""
        if complete:
            yield "\n".join(text for line in complete for text in _parts(line))
    if kept:
        yield "\n".join(_parts(kept))


def _parts(line: bytes) -> list[str]:
    starts = range(0, max(1, len(line)), _LINE_BYTES_MAX)
    return [line[i : i + _LINE_BYTES_MAX].decode(errors="replace") for i in starts]
