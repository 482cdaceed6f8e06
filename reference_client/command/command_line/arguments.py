"""The command line of `proctor`: its commands, and the server that the options name.

Flags take precedence over environment variables. Why click: it comes with uvicorn, has
completion for shells, starts in 20 ms, and leaves help and errors to us; typer and
cyclopts take twice as long and bring four packages.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Sequence

import click

from reference_client.command.command_line.chosen_server import resolve_server
from reference_client.command.command_line.command_options import (
    headings_of_commands,
)
from reference_record.command_line.click_commands import (
    Command,
    Group,
    Options,
    flag,
    parse_options,
)
from reference_record.generated.protocol_version import PROTOCOL_VERSION

EXIT_CODES_HELP = (
    "exit codes: 0 success; 1 the run failed, is incomplete, or fails the release "
    "check; 2 usage error, or the server is unreachable or refuses; 130 interrupted"
)
# Command → what it does; the last five are programs of their own.
COMMANDS = {
    "login": "sign in at a server where people have accounts, and keep the key",
    "submit": "submit a new run, or resume an existing one",
    "run": "evaluate a policy: submit, play, score",
    "status": "show the state of a run; without RUN, list the latest runs",
    "stop": "stop a run; scored episodes are kept",
    "resume": "resume a stopped or failed run",
    "delete": "delete runs that were never played, for good",
    "open": "open the page of a run in a browser; without RUN, the first page",
    "results": "show the score of a run, by task and split",
    "compare": "compare runs with a baseline, with the release decision",
    "export": "save the signed record of a completed run in a file, or convert it",
    "verify": "check a record: signature, every episode, the score (no server needed)",
    "upload": "hand a record in at a server, which verifies it and replays it",
    "report": "write pages about runs, as files that any browser opens",
    "board": "show the leaderboard of a benchmark; `verify` checks its history",
    "publish": "publish a completed run on the leaderboard, or change its entry",
    "withdraw": "take the entry of a run off the leaderboard, for good",
    "video": "draw episodes of a record again from their recorded actions",
    "benchmarks": "list benchmarks; with NAME, show its action and observation spaces",
    "completion": "print what makes a shell complete words of this command",
    "serve": "start the reference server (own flags)",
    "admin": "manage a server, or a challenge, of this machine (own flags)",
    "serve-policy": "serve a policy over HTTP, for push mode (own flags)",
    "replay": "simulate the actions of a record again, sign what came out (own flags)",
    "conformance": "run the conformance kit against a server (own flags)",
}


def build_command() -> Group:
    """The command `proctor` with all its commands."""
    version = flag(
        "--version",
        "show the versions of this program and of the protocol",
        is_eager=True,
        expose_value=False,
        callback=_print_version,
    )
    headings = headings_of_commands()
    commands = [
        Command(
            name,
            text,
            headings.get(name, {}),  # none of programs of their own
            epilog=EXIT_CODES_HELP,
            command=name,
        )
        for name, text in COMMANDS.items()
    ]
    return Group(
        "proctor",
        "evaluate robot policies on any Proctor server",
        commands,
        params=[version],
        epilog=EXIT_CODES_HELP,
    )


def parse(arguments: Sequence[str]) -> Options:
    """The command and its options, with `url` and `token`. Raises WrongUsage."""
    args = parse_options(build_command(), arguments)
    resolve_server(args)
    return args


def _print_version(context: click.Context, _: click.Parameter, is_given: bool) -> None:
    if is_given and not context.resilient_parsing:
        click.echo(_version())
        context.exit()


def _version() -> str:
    try:
        installed = importlib.metadata.version("proctor-eval")
    except importlib.metadata.PackageNotFoundError:
        installed = "not installed"
    return f"proctor {installed}, protocol version {PROTOCOL_VERSION}"
