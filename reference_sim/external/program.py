"""A program that speaks the simulator protocol, and the exchange of frames with it.

The program is a child of `supervisor.py`, which ends it when this process ends, or it
was started elsewhere and listens at a socket. Pixels are received into the memory that
is shared with the server, so that they are copied no more often than those of a
simulator in this process.
"""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Sequence
from itertools import chain, repeat
from pathlib import Path
from typing import Any, Never

import msgspec

from reference_record.this_machine import temporary_folder
from reference_sim.external import socket_address
from reference_sim.external.simulator_messages import (
    PROTOCOL,
    REPLY_BYTES_MAX,
    CloseCall,
    Closed,
    DescribeCall,
    Described,
    Reply,
    ReplyT,
    ReportedFault,
    Request,
    Signal,
    WrongNumber,
    read_reply,
)
from reference_sim.interface import ProgramFault, SimulatorAway, TaskUnplayable
from reference_sim.message_frames import LENGTH, frame
from reference_sim.shared_frame_buffer import FRAME_BUFFER

START_TIMEOUT_S = 120.0
CALL_TIMEOUT_S = 60.0
CLOSE_TIMEOUT_S = 5.0
AWAY_TIMEOUT_S = 10.0
# Between tries to reach a program that does not listen; the last one from then on.
AWAY_PAUSES_S = (0.1, 0.2, 0.4, 0.8, 1.0)
_ALLOWS_MORE = "`start_timeout_s` in its benchmark file allows more"
_WAIT_INTERVAL_S = 1.0
_PIPE_BYTES = 1 << 20
_INBOX_BYTES = 1 << 16
_SUPERVISOR = str(Path(__file__).with_name("supervisor.py"))


def program_name(command: Sequence[str], folder: str) -> str:
    """The name of the program's file; for `python my_world.py` it is the second one."""
    name = Path(command[0]).name
    files = [word for word in command[1:] if is_file(Path(folder, word))]
    return Path(files[0]).name if name.startswith("python") and files else name


def is_file(path: Path) -> bool:
    """Whether a word of a command is the path of a file; a word may be anything."""
    try:
        return path.is_file()
    except OSError:  # it is too long for a path
        return False


class NoReply(ProgramFault):
    """The program ended, ended its connection, or did not reply in time."""


class Program:
    """One running program. Every method raises ProgramFault and TaskUnplayable.

    latest: the last reply of each kind without pictures, as it came.
    on_wait: called about every second while the program starts.
    call_timeout_s: time for each request; None if another process watches the time.
    away_timeout_s: how long a program is tried again that does not listen at its
        socket; then SimulatorAway is raised.
    """

    def __init__(
        self,
        command: Sequence[str],
        folder: str,
        *,
        start_timeout_s: float = START_TIMEOUT_S,
        call_timeout_s: float | None = CALL_TIMEOUT_S,
        away_timeout_s: float = AWAY_TIMEOUT_S,
        on_wait: Callable[[], None] = lambda: None,
    ) -> None:
        self.name = program_name(command, folder)
        self._call_timeout_s, self._start_timeout_s = call_timeout_s, start_timeout_s
        self._inbox, self._moment = bytearray(_INBOX_BYTES), ""
        self.latest: dict[type[Reply], bytes] = {}
        self._sending = threading.Lock()
        self._supervisor: subprocess.Popen[bytes] | None = None
        if socket_address.is_socket(command):
            self._reach(command, away_timeout_s, on_wait)
        else:
            self._start(command, folder)
            self._describe(on_wait)

    def _describe(self, on_wait: Callable[[], None]) -> None:
        """The first exchange; the program is ended if it fails."""
        self._number = 0
        self._poll = select.poll()
        self._poll.register(self._replies, select.POLLIN)
        try:
            self.description = self.request(
                DescribeCall(),
                Described,
                timeout_s=self._start_timeout_s,
                on_wait=on_wait,
            )
            if self.description.protocol != PROTOCOL:  # SIM-007
                protocol = self.description.protocol
                self._raise(f"speaks protocol {protocol}, and {PROTOCOL} was offered")
        except BaseException:
            self.end()
            raise

    def _reach(
        self, command: Sequence[str], timeout_s: float, on_wait: Callable[[], None]
    ) -> None:
        """Connect; a program that has one world listens when its connection has ended.

        Raises SimulatorAway.
        """
        until = time.monotonic() + timeout_s
        for pause_s in chain(AWAY_PAUSES_S, repeat(AWAY_PAUSES_S[-1])):
            try:
                self._requests = socket_address.connect(command).detach()
                self._replies = os.dup(self._requests)
                return self._describe(on_wait)
            except PermissionError as error:
                raise ProgramFault(f"{command[0]}: {error.strerror}") from error
            except (OSError, NoReply) as error:
                if time.monotonic() + pause_s > until:
                    why = getattr(error, "strerror", None) or error
                    raise SimulatorAway(
                        f"the simulator {self.name} is away ({why}); it was tried for "
                        f"{timeout_s:g} s"
                    ) from error
            time.sleep(pause_s)
            on_wait()
        raise AssertionError("pauses do not end")

    def _start(self, command: Sequence[str], folder: str) -> None:
        try:
            temporary = temporary_folder()
        except OSError as error:
            raise self._not_started(error.strerror or str(error)) from error
        their_input, self._requests = os.pipe()
        self._replies, their_output = os.pipe()
        if hasattr(fcntl, "F_SETPIPE_SZ"):
            with contextlib.suppress(OSError):  # a user's pipes have a limit together
                fcntl.fcntl(self._replies, fcntl.F_SETPIPE_SZ, _PIPE_BYTES)
        plan = {
            "command": list(command),
            "folder": folder,
            "name": self.name,
            "descriptors": [their_input, their_output],
            "temporary": temporary,
        }
        try:
            self._supervisor = subprocess.Popen(
                [sys.executable, "-I", "-S", _SUPERVISOR, json.dumps(plan)],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                pass_fds=(their_input, their_output),
                start_new_session=True,  # a Ctrl-C is the server's to handle
            )
        except OSError as error:
            os.close(self._requests)
            os.close(self._replies)
            raise self._not_started(error.strerror or str(error)) from error
        finally:
            os.close(their_input)
            os.close(their_output)

    def request(
        self,
        request: Request,
        wanted: type[ReplyT],
        moment: str = "",
        *,
        reply_bytes_max: int = REPLY_BYTES_MAX,
        timeout_s: float | None = None,
        on_wait: Callable[[], None] = lambda: None,
    ) -> ReplyT:
        """Send a request and wait for its reply.

        moment: when, in an episode, for the texts of faults until the next request.
        """
        self._moment = moment
        limit_s = timeout_s or self._call_timeout_s or float("inf")
        self._deadline, self._on_wait = time.monotonic() + limit_s, on_wait
        call = type(request).__name__.removesuffix("Call").lower()
        self._limit_text = f"{call} within {limit_s:g} s; {_ALLOWS_MORE}"
        self._number = request.number = self._number + 1
        self._send(frame(request))
        body = self._receive(reply_bytes_max)
        if isinstance(body, bytes):  # pictures are in memory that is used again
            self.latest[wanted] = body
        try:
            return read_reply(body, wanted, self._number)
        except WrongNumber as error:
            self._raise(
                f"sent a reply with number {error}: each request has one reply, with "
                "its number"
            )
        except msgspec.DecodeError as error:
            self._raise(f"sent a reply to {call} that is not valid: {error}")
        except ReportedFault as fault:
            if fault.is_unplayable:
                raise TaskUnplayable(str(fault)) from None
            self._raise(f"reports a fault: {fault}")

    def signal(self, signal: Signal) -> None:
        """Send what is not answered, beside a request that may wait for its reply.

        Any thread may call it. A program that has ended needs no signal.
        """
        with contextlib.suppress(OSError):
            self._write(frame(signal))

    def _send(self, message: bytearray) -> None:
        try:
            self._write(message)
        except OSError:
            self._raise_ended()

    def _write(self, message: bytearray) -> None:
        unsent = memoryview(message)
        with self._sending:
            while unsent:
                unsent = unsent[os.write(self._requests, unsent) :]

    def _receive(self, limit: int) -> bytes | memoryview:
        inbox, filled = self._inbox, 0
        while filled < LENGTH.size:
            filled += self._read_into(memoryview(inbox)[filled:])
        (length,) = LENGTH.unpack_from(inbox)
        if length > limit:
            what = f"announced a reply of {length} bytes, and {limit} is the most here"
            if self._supervisor is not None:
                what += "; a program that prints on its standard output breaks its "
                what += "frames, too"
            self._raise(what)
        end = LENGTH.size + length
        if filled > end:
            self._raise("sent more than one reply to a request")
        if end <= len(inbox):
            while filled < end:
                filled += self._read_into(memoryview(inbox)[filled:end])
            return bytes(inbox[LENGTH.size : end])
        # Pictures: the reply is received where the server reads their pixels.
        large = FRAME_BUFFER.allocate(1, length, 1).reshape(-1).data
        filled -= LENGTH.size
        large[:filled] = inbox[LENGTH.size : LENGTH.size + filled]
        while filled < length:
            filled += self._read_into(large[filled:])
        return large

    def _read_into(self, place: memoryview) -> int:
        while not self._poll.poll(_WAIT_INTERVAL_S * 1000):
            self._on_wait()
            if time.monotonic() > self._deadline:
                self._raise(f"did not reply to {self._limit_text}", NoReply)
        try:
            received = os.readv(self._replies, [place])
        except ConnectionError:  # of a socket
            received = 0
        if received == 0:
            self._raise_ended()
        return received

    def fault(self, what: str, kind: type[ProgramFault] = ProgramFault) -> ProgramFault:
        """The fault of the program in its last request: where, and what."""
        return kind(f"{self.name}{self._moment and f', in {self._moment},'} {what}")

    def _raise(self, what: str, kind: type[ProgramFault] = ProgramFault) -> Never:
        raise self.fault(what, kind)

    def _not_started(self, reason: str) -> SimulatorAway:
        """Nothing of the program has run: this machine is the cause."""
        return SimulatorAway(
            f"this machine could not start the simulator {self.name} ({reason}), which "
            "is not the cause"
        )

    def _raise_ended(self) -> Never:
        """Raise what the supervisor reports about the end of the program."""
        if self._supervisor is None:
            self._raise("ended its connection", NoReply)
        report: dict[str, Any] = {}
        assert self._supervisor.stdout is not None
        if select.select([self._supervisor.stdout], [], [], CLOSE_TIMEOUT_S)[0]:
            with contextlib.suppress(ValueError):
                report = json.loads(self._supervisor.stdout.readline())
        if reason := report.get("could_not_start"):
            if report["of_machine"]:
                raise self._not_started(reason)
            self._raise(f"cannot be started: {reason}")
        status = report.get("status")
        if status is None:
            self._raise("closed its standard input or output", NoReply)
        how = f"with exit code {status}"
        if status < 0:
            how = f"by {signal.Signals(-status).name}"
        last = report.get("last_line")
        last_line = f"; its last line: {last}" if last else ""
        self._raise(f"ended {how}{last_line}", NoReply)

    def close(self) -> None:
        """Ask the program to end, then end it."""
        with contextlib.suppress(ProgramFault, TaskUnplayable):
            self.request(CloseCall(), Closed, timeout_s=CLOSE_TIMEOUT_S)
        self.end()

    def end(self) -> None:
        """End the program and everything that it started, or the connection."""
        with contextlib.suppress(OSError):
            os.close(self._requests)
            os.close(self._replies)
        if self._supervisor is not None:
            with self._supervisor:  # closes its input, and waits until nothing is left
                pass
