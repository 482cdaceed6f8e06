"""`proctor serve-policy`: serves a policy over HTTP, for runs in push mode.

Accepts the policies of `proctor run --policy`; docs/evaluate/policies/push.md has an
example.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
import sys
from collections.abc import Iterator, Sequence
from types import FrameType
from typing import NoReturn

import uvicorn
from proctor_client import Assumptions
from proctor_client.transport.copied_text import token_of

from reference_client.errors import ProctorError
from reference_client.evaluation.parameters import parse_strictly
from reference_client.policies import load, read_mapping
from reference_client.policies.error_origin import errors_of_policy
from reference_client.policies.policy_http_app import PolicyApp
from reference_client.policies.policy_loader import name_of_reference
from reference_record.command_line.click_commands import (
    Command,
    WrongUsage,
    option,
    parse_options,
)
from reference_record.command_line.closed_output import (
    ended_by,
    ending_signals_taken,
    run_program,
)
from reference_record.command_line.listening import CannotListen, bind, listen
from reference_record.texts.counted_text import counted

PORT = 8470
END_WAIT_S = 1  # for calls in execution, after a signal


def build_command() -> Command:
    """The command line of the program."""
    options = [
        option("--policy", "see proctor run --help", required=True),
        option(
            "--mapping", "TOML file that maps observation and action names",
            metavar="FILE",
        ),
        option("--name", "name of the policy (default: that of its class or function)"),
        option("--host", "address to listen on", default="127.0.0.1"),
        option("--port", f"port ({PORT})", type=int, default=PORT),
        option(
            "--socket",
            "Unix socket to listen on, instead of a port [PROCTOR_POLICY_SOCKET]",
            envvar="PROCTOR_POLICY_SOCKET", metavar="PATH",
        ),
        option(
            "--max-sessions",
            "maximum simultaneous sessions, each with its own policy instance (16); "
            "another one waits",
            type=int, default=16, metavar="N",
        ),
    ]  # fmt: skip
    return Command(
        "proctor serve-policy",
        "",
        options,
        help_text="Serve a policy over HTTP, for runs in push mode. If "
        "PROCTOR_POLICY_KEY is set, requests MUST carry it as bearer token.",
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Returns the exit code."""
    try:
        args = parse_options(build_command(), arguments)
        mapping = read_mapping(args.policy, args.mapping)
        with errors_of_policy():
            make = load(args.policy, mapping)
        given = None if mapping is None else mapping.assumes
        assumes = parse_strictly(Assumptions, "[assumes]", given)
        # A policy that fails to load is reported here, not to a client.
        with errors_of_policy():
            first = [make()]
        key = token_of("PROCTOR_POLICY_KEY")
    except (ProctorError, WrongUsage, ValueError) as error:
        sys.stderr.write(f"proctor: {error}\n")
        return 2
    served = PolicyApp(
        lambda: first.pop() if first else make(),
        args.name or name_of_reference(args.policy),
        max_sessions=args.max_sessions,
        key=key,
        assumes=None if assumes is None else assumes.to_dict(),
    )
    try:
        listeners = [] if args.socket else [bind(args.host, args.port)]
        for listener in listeners:
            listen(listener)
    except CannotListen as error:
        sys.stderr.write(f"proctor: {error}\n")
        return 2
    place = args.socket or f"http://{args.host}:{args.port}"
    config = uvicorn.Config(
        served.app,
        host=args.host,
        port=args.port,
        uds=args.socket,
        log_level="warning",
        timeout_keep_alive=75,
    )
    return _PolicyServer(config, served, place).serve_until_ended(listeners or None)


class _PolicyServer(uvicorn.Server):
    """Ends END_WAIT_S after a signal, also while a policy does not return."""

    def __init__(self, config: uvicorn.Config, served: PolicyApp, place: str) -> None:
        super().__init__(config)
        self._served, self._place = served, place
        self._signal = 0

    def serve_until_ended(self, listeners: list[socket.socket] | None) -> int:
        """Returns the exit code."""
        with contextlib.suppress(KeyboardInterrupt):
            self.run(listeners)
        return 0 if self.started else 3  # uvicorn has said why, and has this code

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        if self.started:
            sys.stderr.write(f"Serving policy at {self._place}\n")

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        try:
            async with asyncio.timeout(END_WAIT_S):
                await super().shutdown(sockets)
        except TimeoutError:
            _end_at_once(128 + self._signal)

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Also those of a terminal that is closed and of a batch system."""
        with super().capture_signals(), ending_signals_taken(self.handle_exit):
            yield

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        if self.should_exit:
            _end_at_once(128 + sig)
        self._signal = sig
        if in_execution := self._served.seconds_in_execution():
            sys.stderr.write(
                f"proctor: ends in {END_WAIT_S} s; it waits for "
                f"{counted(len(in_execution), 'call')} that the policy has not "
                f"answered, for {in_execution[-1]:.0f} s so far. Another signal ends "
                "it at once.\n"
            )
        super().handle_exit(ended_by(sig), frame)


def _end_at_once(code: int) -> NoReturn:
    with contextlib.suppress(OSError, ValueError):
        sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    sys.exit(run_program(main))
