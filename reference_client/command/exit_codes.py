"""How the command ends: its exit codes, and every error as one line.

0 it is done; 1 the run failed, was stopped, is not complete, or is not to be released;
2 it was asked for what cannot be, or the server cannot be reached; 128 + n signal n, as
shells have it.
"""

from __future__ import annotations

import re

from reference_client.errors import BAD_ANSWER, UNREACHABLE, ProctorError

DONE, NOT_COMPLETE, WRONG_USAGE_OR_NO_SERVER, INTERRUPTED = 0, 1, 2, 130
NOT_RELEASED = 1

# What says nothing about the run: neither that it failed nor that it did not.
_CANNOT = frozenset(
    {
        UNREACHABLE,
        BAD_ANSWER,
        "benchmark_unavailable",
        "convention_mismatch",
        "forbidden",
        "idempotency_conflict",
        "illegal_transition",
        "not_found",
        "unauthenticated",
        "unsupported_version",
    }
)
_ARGUMENTS = {
    "the argument `token`, or PROCTOR_TOKEN": "--token, or PROCTOR_TOKEN",
    "`takeover=True` with the run's `run_id`": "--takeover with --run-id",
    "`takeover=True`": "--takeover",
    "takeover=True": "--takeover",
}


class UsageError(Exception):
    """The command line makes no sense; the message says why and what would."""


def exit_code_of(error: ProctorError, *, has_run: bool) -> int:
    """has_run: whether there is a run that the error leaves incomplete."""
    if error.code in _CANNOT or not has_run:
        return WRONG_USAGE_OR_NO_SERVER
    return NOT_COMPLETE


def message_of(error: ProctorError) -> str:
    """What happened and what to do, with flags in the place of arguments."""
    parts = [with_flag_names(error.detail)]
    parts += [f"{pointer} {text}" for pointer, text in error.errors]
    return f"{' – '.join(parts)} [{error.code}]"


def with_flag_names(text: str) -> str:
    """What the library says of its arguments, said of the command's flags."""
    text = re.sub(r'; evaluate\(\.\.\., run_id="[^"]*"\) goes on with it', "", text)
    for argument, flag in _ARGUMENTS.items():
        text = text.replace(argument, flag)
    return " ".join(text.split())
