"""The exit codes of `proctor`, and the text of an error in one line.

0: success. 1: the run failed, was stopped, is incomplete, or fails the release check.
2: usage error, or the server is unreachable or refuses the request. 128 + n: ended by
signal n, as in shells; 141, whose output is read no more, is that of SIGPIPE.
"""

from __future__ import annotations

import re

from reference_client.errors import (
    BAD_ANSWER,
    NOT_TRUSTED,
    UNREACHABLE,
    ProctorError,
)
from reference_client.protocol.retry_policy import ON_LIMITS, ON_WAITS

DONE, NOT_COMPLETE, WRONG_USAGE_OR_NO_SERVER = 0, 1, 2
NOT_RELEASED = 1

# Errors that imply nothing about the state of the run.
_CANNOT = frozenset(
    {
        UNREACHABLE,
        BAD_ANSWER,
        NOT_TRUSTED,
        "benchmark_unavailable",
        "convention_mismatch",
        "forbidden",
        "idempotency_conflict",
        "illegal_transition",
        "not_found",
        "policy_mismatch",
        "unauthenticated",
        "unsupported_version",
    }
)
_ARGUMENTS = {
    "authority: PROCTOR_CA,": "authority: --ca, PROCTOR_CA,",
    "the argument `token`": "--token",
    "`takeover=True` with the run's `run_id`": "--takeover with --run-id",
    "`takeover=True`": "--takeover",
    "`takeover`": "--takeover",
    "takeover=True": "--takeover",
    "`worker_prefix`": "--worker-prefix",
    "dry_turn=False": "--no-dry-turn",
    "`retry_timeout_s`": "`--retry-timeout-s`",
    "`any_policy=True`": "--any-policy",
    "`any_policy`": "--any-policy",
    "any_policy: ": "--any-policy: ",
    "tasks, splits: ": "--tasks, --split: ",
    "episodes=N ": "--episodes N ",
    "`name=": "`--name ",
    "`version=": "`--policy-version ",
    # These parts of the protocol's texts point at a document that a user does not see.
    " Correct what `errors` points at.": "",
    " Send `Authorization: Bearer <token>` with a token of this server.": "",
    " Ask the operator to do what detail says.": "",
    " Read `state`; the lifecycle table says what it allows.": "",
    " Send `expected_seq`.": "",
    "; `requirement` is the rule of record.md that it breaks, and `errors` has the "
    "file.": ".",
    "Convert as `errors` says": "Convert the values",
    "of `entry_id` again to change its description; a run of another policy names that "
    "in `policy`.": "of that entry again to change its description.",
    "Retry with the same seq, attach_key or Idempotency-Key; report it": "If it lasts, "
    "report it",
}
# The advice on limits is left out where Retry-After is long: then the refusal says when
# there is room again.
_SOON_S = 5.0
_NO_WAIT = (
    " Waiting does not help: where open or stored runs are counted, end or delete "
    "some; else ask the host."
)
# A command waits by itself (`text_of_wait`); one that has ended may be given again.
_LATER = "Give the command again later."
# A terminal shows the detail: the advice behind these words is a sentence of its own.
_READ_DETAIL = re.compile("Read `detail`: (?P<first>.)")
_HOW_TO_RESUME = re.compile(
    r'; (when that is mended, )?evaluate\(\.\.\., run_id="[^"]*"\) continues it'
)
# Pointer into a refused request → the flag that sets the value there.
_POINTERS = {
    "/select/tasks": "--tasks",
    "/select/splits": "--split",
    "/select": "--tasks, --split",
    "/any_policy": "--any-policy",
    "/takeover": "--takeover",
    "/max_workers": "--max-workers",
    "/idle_timeout_s": "--idle-timeout-s",
    "/images": "--images",
    "/options": "--options",
    "/policy_server/url": "--push",
    "/policy_server/model": "--model",
    "query:runs": "",  # the text names them
}


def exit_code_of(error: ProctorError, *, has_run: bool) -> int:
    """The exit code for an error.

    has_run: whether a run exists that the error leaves incomplete.
    """
    if error.code in _CANNOT or not has_run:
        return WRONG_USAGE_OR_NO_SERVER
    return NOT_COMPLETE


def message_of(error: ProctorError) -> str:
    """The error and its remedy, with flags in place of Python arguments."""
    advice = "" if (error.retry_after_s or 0) > _SOON_S else _NO_WAIT
    parts = [with_flag_names(ON_LIMITS.sub(advice, error.detail))]
    pairs = [(_with_flag(pointer), text) for pointer, text in error.errors]
    parts += [" ".join(filter(None, pair)) for pair in pairs]
    return f"{' – '.join(parts)} [{error.code}]"


def _with_flag(pointer: str) -> str:
    """The flag in place of the beginning of a pointer into a request."""
    for member, flag in _POINTERS.items():
        if pointer == member or pointer.startswith(f"{member}/"):
            return " ".join(filter(None, (flag, pointer.removeprefix(member))))
    return pointer


def with_flag_names(text: str) -> str:
    """Replaces the library's argument names by the command's flags."""
    text = _HOW_TO_RESUME.sub("", text)
    text = ON_WAITS.sub(_LATER, text)
    text = _READ_DETAIL.sub(lambda match: match["first"].upper(), text)
    for argument, flag in _ARGUMENTS.items():
        text = text.replace(argument, flag)
    return " ".join(text.split())
