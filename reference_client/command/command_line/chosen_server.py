"""The server that the options of a command name, and the token for it."""

from __future__ import annotations

import os

from reference_client.commands_to_copy import command_to_copy
from reference_client.protocol.credentials import find_credential
from reference_record.command_line.click_commands import Options, WrongUsage
from reference_record.command_line.default_server import DEFAULT_URL

SERVERLESS_COMMANDS = ("verify", "completion")


def resolve_server(args: Options) -> None:
    """Set `url` and `credential`, by flags, the environment, or files of this user."""
    if args.ca:  # also for the processes of workers
        os.environ["PROCTOR_CA"] = args.ca
    if args.command in SERVERLESS_COMMANDS:
        return
    if args.host is not None or args.port is not None:
        from proctor_client.transport.server_address import url_of_host

        args.url = url_of_host(args.host, args.port)
    try:
        args.credential = find_credential(args.url, args.token)
    except ValueError as error:
        raise WrongUsage(str(error)) from None


def command_text(args: Options, *words: str) -> str:
    """A command to copy, which reaches the server of this one from the same shell."""
    flags = []
    if args.url != (os.environ.get("PROCTOR_URL") or DEFAULT_URL):
        flags += ["--url", args.url]
    if args.ca:
        flags += ["--ca", args.ca]
    return command_to_copy(*words, *flags)
