"""What can go wrong, as exceptions whose message says what happened and what to do.

A server's refusal and a mistake noticed here are told alike: one class, with the
members of the spec's schema Problem. This file knows no socket and sends nothing.
"""

from __future__ import annotations

from collections.abc import Sequence

import urllib3.exceptions
from proctor_client import ApiException, Problem, Run

# Nothing answered, or what answered does not speak the protocol: two codes of this
# client beside those of x-problems.
UNREACHABLE = "unreachable"
BAD_ANSWER = "bad_answer"
# What ends in a process of its own: the process, or the policy in it.
WORKER_DIED = "worker_died"
POLICY_FAILED = "policy_failed"

# What the generated client and the data plane raise when no answer comes.
NO_ANSWER_ERRORS = (urllib3.exceptions.HTTPError, OSError)

_CLIENT_HINTS = {
    "unauthenticated": "Here that is the argument `token`, or PROCTOR_TOKEN.",
    "worker_busy": "Here that is `takeover=True`.",
    "session_superseded": "Here that is `takeover=True` with the run's `run_id`.",
}


class ProctorError(Exception):
    """A request was refused, could not be sent, or would be refused if it were sent.

    code: one of x-problems; or `unreachable` (no answer), `bad_answer` (an answer that
        does not follow the protocol), or what a subclass names.
    detail: what happened and what to do about it, for people.
    retryable: whether the same request can succeed later.
    side_effects: `none`, or `possible` when the request may have been carried out.
    errors: (JSON pointer into the request, text) pairs.
    problem: the whole answer, when the server gave one.
    retry_after_s: how long the server wants to be left alone, seconds.
    """

    def __init__(
        self,
        code: str,
        detail: str,
        *,
        retryable: bool = False,
        side_effects: str = "none",
        errors: Sequence[tuple[str, str]] = (),
        problem: Problem | None = None,
        retry_after_s: float | None = None,
    ) -> None:
        self.code = code
        self.detail = detail
        self.retryable = retryable
        self.side_effects = side_effects
        self.errors = tuple(errors)
        self.problem = problem
        self.retry_after_s = retry_after_s
        lines = [f"{detail} [{code}]"]
        lines += [f"  {pointer}: {text}" for pointer, text in self.errors]
        super().__init__("\n".join(lines))


class RunFailed(ProctorError):
    """The run is `failed`: `code` is `run_failed` and `run.reason` says why.

    `retryable`: whether `evaluate(run_id=...)` may resume it. Scored episodes are kept.
    """

    def __init__(self, run: Run) -> None:
        cure = (
            f"Scored episodes are kept; {how_to_resume(run.run_id)}."
            if run.retryable
            else "It cannot be resumed."
        )
        detail = f"Run {run.run_id} failed: {run.reason} {cure}"
        super().__init__("run_failed", detail, retryable=bool(run.retryable))
        self.run = run


class RunStopped(ProctorError):
    """Somebody stopped the run while it was evaluated: `code` is `run_stopped`."""

    def __init__(self, run: Run) -> None:
        detail = (
            f"Run {run.run_id} is stopped: {run.reason} "
            f"Scored episodes are kept; {how_to_resume(run.run_id)}."
        )
        super().__init__("run_stopped", detail, retryable=True)
        self.run = run


class PolicyFailed(ProctorError):
    """The policy of a worker process raised: `code` is `policy_failed`.

    detail: what and where. traceback: the whole of it, as Python prints it.
    """

    def __init__(self, detail: str, traceback: str) -> None:
        super().__init__(POLICY_FAILED, detail)
        self.traceback = traceback


def how_to_resume(run_id: str) -> str:
    return f'evaluate(..., run_id="{run_id}") goes on with it'


def from_failure(error: Exception, url: str) -> ProctorError:
    """What was raised while the server at `url` was called."""
    if isinstance(error, ApiException) and error.status:
        return _from_answer(error, url)
    if _is_no_answer(error):
        return ProctorError(
            UNREACHABLE,
            f"{url} does not answer ({_cause(error)}). "
            "Check the URL, and that the server runs.",
            retryable=True,
            side_effects="possible",
        )
    why = error.reason if isinstance(error, ApiException) else error
    return ProctorError(
        BAD_ANSWER,
        f"{url} answered what the protocol does not allow ({why}). "
        "Check that a Proctor server answers at this URL.",
        side_effects="possible",
    )


def _is_no_answer(error: Exception) -> bool:
    if isinstance(error, ApiException):  # without a status
        return str(error.reason).startswith("SSLError")
    return isinstance(error, NO_ANSWER_ERRORS)


def _from_answer(error: ApiException, url: str) -> ProctorError:
    problem, status = error.data, error.status
    wait_s = _retry_after_s(error)
    if not isinstance(problem, Problem):
        # A gateway in front of the server speaks for itself.
        return ProctorError(
            BAD_ANSWER,
            f"{url} answered {status} {error.reason} and does not explain it. "
            "Check that a Proctor server answers at this URL.",
            retryable=status == 429 or status >= 500,
            side_effects="possible",
            retry_after_s=wait_s,
        )
    here = _CLIENT_HINTS.get(problem.code)
    return ProctorError(
        problem.code,
        f"{problem.detail} {here}" if here else problem.detail,
        retryable=problem.retryable,
        side_effects=problem.side_effects.value,
        errors=[(item.pointer, item.detail) for item in problem.errors or ()],
        problem=problem,
        retry_after_s=wait_s,
    )


def _retry_after_s(error: ApiException) -> float | None:
    """Seconds, as the spec has it; a date, which others may send, is not read."""
    text = (error.headers or {}).get("Retry-After", "")
    return float(text) if text.isdecimal() else None


def _cause(error: BaseException) -> str:
    """The innermost reason, in the words of the operating system where it has any."""
    inner = error
    while (deeper := inner.__cause__ or inner.__context__) is not None:
        inner = deeper
    strerror = getattr(inner, "strerror", None)
    return strerror or str(inner) or type(inner).__name__
