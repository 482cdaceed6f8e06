"""The retry policy: the only place that decides whether a request is repeated.

All requests to a Proctor server, of both planes, go through RetryPolicy.call; urllib3's
retries are off. Every request may be repeated, because operations that must not be
executed twice carry a seq, an attach_key or an Idempotency-Key. So the response alone
decides. Requests to policy servers are not of this protocol: their clients repeat at a
fixed interval until a deadline (policies/servers/server_transport.py).
"""

from __future__ import annotations

import contextlib
import math
import random
import re
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import TypeVar

import msgspec
from proctor_client import ApiException

from reference_client.errors import (
    NO_ANSWER_ERRORS,
    UNREACHABLE,
    ProctorError,
    first_sentence,
    from_failure,
    is_passing_page,
)
from reference_record.this_machine import start_if_possible

Answer = TypeVar("Answer")

FIRST_PAUSE_S = 0.1
LONGEST_PAUSE_S = 5.0
RETRY_TIMEOUT_S = 300.0  # of a server that has answered, where a user gives none
FIRST_CONTACT_S = 3.0  # short for a mistyped URL, long enough for a starting server
# For a first answer on a connection that was made: a server can be busy.
FIRST_ANSWER_S = 15.0
_SILENT_S = 3.0

# Refusals, missing responses, responses that violate the schema.
FAILURES = (ApiException, *NO_ANSWER_ERRORS, msgspec.MsgspecError, ValueError)

# Refusals of a healthy server at its capacity: retried without a limit of time.
_FULL = frozenset({"worker_limit", "no_capacity"})
_DEFECT_S = 10.0  # a defect of the server seldom disappears by itself
# For a page in the place of a server that has answered, such as a network's sign-in.
PAGE_S = 60.0
_UPLOADS_TO_PAGES = 2  # a body that may be large is sent no more often

# The advice of the protocol to programs that repeat a request, as this one does by
# itself: on every limit, which names members of a response, and on waits.
ON_LIMITS = re.compile(r" Repeat after Retry-After, .*?, or ask the operator\.")
ON_WAITS = re.compile(
    r"Wait for Retry-After(,? (or detach a worker|and repeat)|"
    r"; repeat with the same seq, attach_key or Idempotency-Key)\."
)
# The advice on a URL, which is right where a server has answered.
_ON_URL = re.compile(r" (Check|If that lasts, check) the URL.*", re.DOTALL)
REPEATS = "This program repeats the request"
_WAITS_ITSELF = "This program waits by itself."

_NO_LIMITS: Mapping[str, float] = {}


def text_of_wait(detail: str) -> str:
    """A refusal that is waited for, without the advice to repeat the request."""
    advice = f" {_WAITS_ITSELF}"
    return ON_LIMITS.sub(advice, ON_WAITS.sub(_WAITS_ITSELF, detail))


def _unchanged(error: ProctorError) -> ProctorError:
    return error


class Interrupted(Exception):
    """The evaluation is ending; raised by every wait."""


@dataclass(slots=True)
class Contact:
    """Knows of a server whether it has ever answered as one of Proctor does.

    answer_s: how long its first answer may take, on a connection that was made.
    """

    has_answered: bool = False
    answer_s: float = FIRST_ANSWER_S
    _is_reported: bool = False

    @contextlib.contextmanager
    def reporting_silence(
        self, url: str, report_waiting: Callable[[str | None], None]
    ) -> Iterator[None]:
        """Report that a first answer is waited for, when that takes seconds."""
        text = f"{url} has not answered yet. Waiting for up to {self.answer_s:g} s …"
        timer = threading.Timer(_SILENT_S, report_waiting, [text])
        timer.daemon = True
        if self._is_reported or not start_if_possible(timer):
            yield
            return
        try:
            yield
        finally:
            self._is_reported = not timer.is_alive()
            timer.cancel()
            if self._is_reported:
                report_waiting(None)


@dataclass(frozen=True, slots=True)
class _Failure:
    """is_page: it comes from what may soon be gone from the place of the server.

    has_body: its request was not one that only reads.
    """

    error: ProctorError
    is_page: bool
    has_body: bool

    @property
    def is_retryable(self) -> bool:
        return self.error.retryable or self.is_page

    @property
    def is_of_body(self) -> bool:
        """Whether a page has answered a request that has a body."""
        return self.is_page and self.has_body

    @property
    def kind(self) -> tuple[str, bool]:
        """Failures of one kind share their limit of time."""
        return self.error.code, self.is_page


@dataclass(frozen=True, slots=True)
class RetryPolicy:
    """Decides how long failing requests to `url` are repeated.

    total_s: limit for failures with the same code; a page in the place of the server
    has PAGE_S at most. first_s: that of a server that has never answered, as its URL
    may be mistyped. stop: ends every wait immediately.
    report_waiting: called with the reason of a wait, and with None when it is over.
    control_url: where `url` is the endpoint of a run, the server that named it.
    explain: adds to an error that is raised what may take a request. contact: what is
    known of the server; what has answered is not taken for another server later.
    """

    url: str
    total_s: float
    stop: threading.Event
    report_waiting: Callable[[str | None], None]
    first_s: float = math.inf
    control_url: str | None = None
    explain: Callable[[ProctorError], ProctorError] = _unchanged
    contact: Contact = field(default_factory=Contact)

    def at_endpoint(self, endpoint: str) -> RetryPolicy:
        """The same for requests to the data plane of a run."""
        control_url, url = self.control_url or self.url, endpoint.rstrip("/")
        # Another address may never have been a server of Proctor.
        contact = self.contact if url == self.url else Contact()
        return replace(
            self,
            url=url,
            control_url=control_url,
            contact=contact,
            first_s=math.inf,  # a server has named it, so it is not mistyped
        )

    def call(
        self,
        send: Callable[[], Answer],
        *,
        limits_s: Mapping[str, float] = _NO_LIMITS,
        is_upload: bool = False,
    ) -> Answer:
        """The result of `send`, which is called until it succeeds.

        limits_s: code → limit for this refusal, instead of the default. is_upload: the
        body may be large, and goes to pages in the server's place twice at most. Raises
        ProctorError for failures that are not retryable or exceed their limit, and
        Interrupted.
        """
        last: _Failure | None = None
        since, uploads = time.monotonic(), 0
        pause_s = FIRST_PAUSE_S
        while not self.stop.is_set():
            began_at, is_first = time.monotonic(), not self.contact.has_answered
            try:
                answer = self._send_first(send) if is_first else send()
            except FAILURES as raised:
                failure = self._failure_of(raised)
                if last is None or last.kind != failure.kind:
                    # The silence of who has never answered is a part of its time.
                    since = began_at if is_first else time.monotonic()
                    pause_s = FIRST_PAUSE_S
                if is_upload and failure.is_of_body:
                    uploads, pause_s = uploads + 1, LONGEST_PAUSE_S
                wait_s = _wait_s(failure.error, pause_s)
                left_s = since + self._limit_s(failure, limits_s) - time.monotonic()
                is_over = wait_s > left_s or uploads == _UPLOADS_TO_PAGES
                if is_over or not failure.is_retryable:
                    self._report_end(last)
                    # An earlier failure may explain the last one.
                    cause = raised if last is None else last.error
                    raise self.explain(failure.error) from cause
            else:
                self.contact.has_answered = True
                self._report_end(last)
                return answer
            if last is None or last.error.detail != failure.error.detail:
                self._report_wait(failure, is_last=uploads > 0)
            last, pause_s = failure, min(2 * pause_s, LONGEST_PAUSE_S)
            self.stop.wait(wait_s)
        raise Interrupted

    def _send_first(self, send: Callable[[], Answer]) -> Answer:
        with self.contact.reporting_silence(self.url, self.report_waiting):
            return send()

    def pause(self, wait_s: float) -> None:
        """Wait; raises Interrupted if the evaluation ends meanwhile."""
        if self.stop.wait(wait_s):
            raise Interrupted

    def _failure_of(self, raised: Exception) -> _Failure:
        has_answered = self.contact.has_answered
        error = from_failure(
            raised, self.url, self.control_url, has_answered=has_answered
        )
        # Status 502 of a gateway is retryable by itself, and for longer.
        is_page = has_answered and not error.retryable and is_passing_page(raised)
        return _Failure(error, is_page, getattr(raised, "method", "GET") != "GET")

    def _limit_s(self, failure: _Failure, limits_s: Mapping[str, float]) -> float:
        code = failure.error.code
        if code in limits_s:
            return limits_s[code]
        if code in _FULL:
            return math.inf
        total_s = self.total_s
        if not self.contact.has_answered:
            total_s = min(total_s, self.first_s)
        if code == "internal_error":
            return min(_DEFECT_S, total_s)
        return min(PAGE_S, total_s) if failure.is_page else total_s

    def _report_wait(self, failure: _Failure, *, is_last: bool) -> None:
        text = text_of_wait(failure.error.detail)
        if not (self.contact.has_answered or self.control_url):
            # The error that ends a first contact comes soon, and has the advice.
            text = first_sentence(text)
        is_away = self.contact.has_answered and failure.error.code == UNREACHABLE
        if is_away:
            text = _ON_URL.sub("", text)
        if failure.is_page or is_away:
            limit_s = self._limit_s(failure, _NO_LIMITS)
            often = "once more" if is_last else f"for up to {limit_s:g} s"
            text += f" {REPEATS} {often}."
        if is_away:
            text += " Episodes that are scored stay scored."
        self.report_waiting(text)

    def _report_end(self, last: _Failure | None) -> None:
        if last is not None:
            self.report_waiting(None)


def _wait_s(error: ProctorError, pause_s: float) -> float:
    """The time to wait; it is random, so that workers do not retry all at once."""
    if error.retry_after_s:
        return error.retry_after_s + random.uniform(0, FIRST_PAUSE_S)
    return pause_s * random.uniform(0.5, 1.0)
