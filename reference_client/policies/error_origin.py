"""Describes an exception in one line: that of a policy with its place in its code.

An error that the connection to the server raises is not the policy's.
"""

from __future__ import annotations

import contextlib
import errno
import traceback
from collections.abc import Iterator
from pathlib import Path

import proctor_client

from reference_client.errors import (
    CLIENT_FAILED,
    BadPolicy,
    PolicyFailed,
    ProctorError,
    as_sentence,
    class_and_text,
)
from reference_client.policies.mapping import BadMapping

OUT_OF_THREADS = (
    "This program can start no more threads or processes: the limit of this user "
    "(`ulimit -u`), of the container or of the job is reached. The policy is not the "
    "cause. Raise the limit, or take fewer --workers"
)

_CLIENT_ROOT = Path(__file__).resolve().parent.parent
_CONNECTION = {_CLIENT_ROOT / "protocol", Path(proctor_client.__file__).parent}


def describe_policy_error(error: BaseException) -> str:
    """The error, its notes, and the innermost line of the policy's own code.

    Actions that do not fit raise nothing in the policy: what is wrong with them is said
    first, then what fits.
    """
    if isinstance(error, ProctorError):
        wrong = "; ".join(f"{at}: {text}" for at, text in error.errors)
        return f"{wrong}. {error.detail}" if wrong else error.detail
    if isinstance(error, BadMapping):
        return " ".join([as_sentence(str(error)), *getattr(error, "__notes__", ())])
    what = class_and_text(error)
    if frames := _frames_of_policy(error):
        what += f" ({Path(frames[-1].filename).name}:{frames[-1].lineno})"
    if notes := getattr(error, "__notes__", ()):
        what = " ".join([as_sentence(what), *notes])
    return f"The policy raised {what}"


def _frames_of_policy(error: BaseException) -> list[traceback.FrameSummary]:
    return [
        frame
        for frame in traceback.extract_tb(error.__traceback__)
        if _CLIENT_ROOT not in Path(frame.filename).parents
        and "site-packages" not in frame.filename
        and not frame.filename.startswith("<")
        and Path(traceback.__file__).parent not in Path(frame.filename).parents
    ]


def policy_failure(error: BaseException) -> ProctorError:
    """The failure to report for an error that nothing expects: the policy's, mostly."""
    if is_out_of_threads(error) and not _frames_of_policy(error):
        return ProctorError(CLIENT_FAILED, OUT_OF_THREADS, retryable=True)
    if _is_of_connection(error):
        what = class_and_text(error)
        return ProctorError(
            CLIENT_FAILED,
            f"This client failed in its connection to the server: {what}. The policy "
            "is not the cause; PROCTOR_DEBUG=1 or --debug shows where.",
        )
    whole = "".join(traceback.format_exception(error))
    return PolicyFailed(describe_policy_error(error), whole)


@contextlib.contextmanager
def errors_of_policy() -> Iterator[None]:
    """Raise every error of this block, also a ValueError, as a failure of the policy.

    An error that this client raises about the policy or its mapping stays as it is.
    """
    try:
        yield
    except (BadPolicy, BadMapping, ProctorError):
        raise
    except (Exception, SystemExit) as error:
        raise policy_failure(error) from error


def is_out_of_threads(error: BaseException) -> bool:
    """Whether the system refused another thread or process."""
    if isinstance(error, OSError):
        return error.errno == errno.EAGAIN
    return isinstance(error, RuntimeError) and "start new thread" in str(error)


def _is_of_connection(error: BaseException) -> bool:
    """Whether the client called its connection, and not the policy, when it failed."""
    for frame in traceback.extract_tb(error.__traceback__):
        folders = Path(frame.filename).parents
        if not _CONNECTION.isdisjoint(folders):
            return True
        if _CLIENT_ROOT not in folders:
            return False
    return False
