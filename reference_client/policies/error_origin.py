"""Describes an exception of a policy in one line, with the place in the user's code."""

from __future__ import annotations

import traceback
from pathlib import Path

from reference_client.errors import PolicyFailed

_CLIENT_ROOT = Path(__file__).resolve().parent.parent


def describe_policy_error(error: BaseException) -> str:
    """The error, its notes, and the innermost line of the policy's own code."""
    frames = traceback.extract_tb(error.__traceback__)
    policy_frames = [
        frame
        for frame in frames
        if _CLIENT_ROOT not in Path(frame.filename).parents
        and "site-packages" not in frame.filename
        and not frame.filename.startswith("<")
        and Path(traceback.__file__).parent not in Path(frame.filename).parents
    ]
    what = " ".join(f"{type(error).__name__}: {error}".split())
    notes = " ".join(["", *getattr(error, "__notes__", ())])
    if not policy_frames:
        return f"The policy raised {what}{notes}"
    at = f"{Path(policy_frames[-1].filename).name}:{policy_frames[-1].lineno}"
    return f"The policy raised {what} ({at}){'.' if notes else ''}{notes}"


def policy_failure(error: BaseException) -> PolicyFailed:
    """The failure to report for an error of the policy's own code."""
    whole = "".join(traceback.format_exception(error))
    return PolicyFailed(describe_policy_error(error), whole)
