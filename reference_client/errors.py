"""The exceptions of this client; every message says what happened and what to do.

A refusal of the server and an error detected by this client have the same class and the
members of the specification's schema Problem. This module sends nothing.
"""

from __future__ import annotations

import re
import ssl
from collections.abc import Sequence
from http import HTTPStatus
from typing import TypeGuard

import pydantic
import urllib3.exceptions
from proctor_client import (
    ApiException,
    BadProxy,
    Problem,
    ProblemItem,
    ProxyRoute,
    Run,
    find_route,
)
from proctor_client.transport.fault_texts import (
    NO_PASSWORD,
    WITHOUT_SERVER,
    cure_of_page,
    describe_http2,
    describe_page,
    describe_proxy_fault,
    describe_tls_fault,
    describe_unreachable_proxy,
    is_of_proctor,
    is_refusal,
    who_answered,
)
from proctor_client.transport.tls_trust import certificate_cure

from reference_client.printable_text import printable
from reference_client.protocol.connection_advice import (
    causes_of,
    fault_of_proxy,
    is_late_answer,
    is_of_first_hop,
    line_of_http2,
    out_of_files,
    scheme_hint,
    speaks_tls,
    was_cut,
    where_it_moved,
)

# Three codes of this client beside those of x-problems: no response, a response that
# violates the protocol, and a server that does not prove to be the one of the URL.
UNREACHABLE = "unreachable"
BAD_ANSWER = "bad_answer"
NOT_TRUSTED = "not_trusted"
# A wrong endpoint of a run may look like one of these.
ENDPOINT_FAULTS = (UNREACHABLE, BAD_ANSWER, NOT_TRUSTED, "not_found")
# Two more, of workers in their own processes: the process exited, or the policy raised.
WORKER_DIED = "worker_died"
POLICY_FAILED = "policy_failed"
# And one of a defect of this client, which is never said to be the policy's.
CLIENT_FAILED = "client_failed"

# Raised by the generated client and the data plane when no response arrives.
NO_ANSWER_ERRORS = (urllib3.exceptions.HTTPError, OSError)

# How a server of this project refuses a member that is not in its schema.
_UNKNOWN_MEMBER = "Extra inputs are not permitted"

_SHOWN_CHARS = 80
_FIRST_SENTENCE = re.compile(r"\A(.+?[.!?…])(?= [A-Z]).*", re.DOTALL)
# Values of `limit` in a problem: this limit opens by nothing that a wait brings.
_USED_UP = frozenset({"total", "keys", "stored_bytes", "changes"})
# Hints on a code, or on what a problem names as its `limit`.
_TAKEOVERS = {
    "worker_busy": "In this client: `takeover=True`; a second program that plays the "
    "run needs another `worker_prefix`.",
    "session_superseded": "In this client: `takeover=True` with the run's `run_id`.",
}
_CLIENT_HINTS = {
    "at_once": "`proctor status` lists runs; `proctor stop RUN` ends one of them.",
    **_TAKEOVERS,
}


class ProctorError(Exception):
    """A request was refused, could not be sent, or would be refused if it were sent.

    code: one of x-problems; or `unreachable` (no response), `bad_answer` (a response
        that violates the protocol), `not_trusted` (its certificate is not accepted, or
        it has none), or the code of a subclass.
    detail: what happened and what to do about it; without control characters.
    retryable: whether the same request can succeed later.
    side_effects: `none`, or `possible` when the request may have been carried out.
    errors: (JSON pointer into the request, text) pairs.
    problem: the problem document, when the server sent one.
    retry_after_s: the server's Retry-After, seconds.
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
        self.code = printable(code)
        self.detail = printable(detail)
        self.retryable = retryable
        self.side_effects = side_effects
        self.errors = tuple((printable(at), printable(text)) for at, text in errors)
        self.problem = problem
        self.retry_after_s = retry_after_s
        lines = [f"{self.detail} [{self.code}]"]
        lines += [f"  {pointer}: {text}" for pointer, text in self.errors]
        super().__init__("\n".join(lines))

    def __reduce__(self) -> tuple[object, ...]:
        """A copy has the members; `__init__` cannot make it of the text alone."""
        return type(self).__new__, (type(self), *self.args), self.__dict__

    @property
    def ends_run(self) -> bool:
        """Whether the run of the evaluation cannot be continued after this error."""
        return self.code == "not_found"  # it was deleted

    def explained(self, more: str) -> ProctorError:
        """The same error with one more sentence."""
        return ProctorError(
            self.code,
            f"{as_sentence(self.detail)} {more}",
            retryable=self.retryable,
            side_effects=self.side_effects,
            errors=self.errors,
            problem=self.problem,
            retry_after_s=self.retry_after_s,
        )


class RunFailed(ProctorError):
    """The run is `failed`: `code` is `run_failed` and `run.reason` says why.

    `retryable`: whether `evaluate(run_id=...)` may resume it. Scored episodes are kept.
    """

    def __init__(self, run: Run) -> None:
        cure = (
            "Scored episodes are kept; when that is mended, "
            f"{how_to_resume(run.run_id)}."
            if run.retryable
            else "It cannot be resumed."
        )
        detail = f"Run {run.run_id} failed: {as_sentence(run.reason)} {cure}"
        super().__init__("run_failed", detail, retryable=bool(run.retryable))
        self.run = run

    @property
    def ends_run(self) -> bool:
        return not self.retryable


class RunStopped(ProctorError):
    """The run was stopped during the evaluation: `code` is `run_stopped`."""

    def __init__(self, run: Run) -> None:
        detail = (
            f"Run {run.run_id} is stopped: {as_sentence(run.reason)} "
            f"Scored episodes are kept; {how_to_resume(run.run_id)}."
        )
        super().__init__("run_stopped", detail, retryable=True)
        self.run = run


class PolicyFailed(ProctorError):
    """The policy of a worker process raised: `code` is `policy_failed`.

    detail: the error and where it was raised. traceback: as Python prints it.
    """

    def __init__(self, detail: str, traceback: str) -> None:
        super().__init__(POLICY_FAILED, detail)
        self.traceback = traceback


def advises_takeover(text: str) -> bool:
    """Whether the text says that a takeover goes on at once."""
    return any(hint in text for hint in _TAKEOVERS.values())


def first_sentence(text: str) -> str:
    """The subject of a text: further sentences may change while that lasts."""
    return _FIRST_SENTENCE.sub(r"\1", text)


def text_of(error: BaseException) -> str:
    """The text of an exception, which may be of a class that fails to make one."""
    try:
        return str(error)
    except Exception as failure:  # noqa: BLE001 - of any class
        return f"<its str() failed with {type(failure).__name__}>"


def class_and_text(error: BaseException) -> str:
    """The exception in one line, without its place."""
    return " ".join(f"{type(error).__name__}: {text_of(error)}".split())


def as_sentence(text: str | None) -> str:
    """The text with a full stop, unless it ends in a mark of its own."""
    text = (text or "").rstrip()
    return f"{text}." if text and text[-1] not in ".!?…" else text


def how_to_resume(run_id: str, *, takeover: bool = False) -> str:
    more = ", takeover=True" if takeover else ""
    return f'evaluate(..., run_id="{run_id}"{more}) continues it'


def is_from_elsewhere(error: Exception) -> bool:
    """Whether something in the place of a server has answered, with no sign of Proctor.

    It is a page of the network or of a gateway; or a certificate that is not accepted.
    """
    if isinstance(error, ApiException):
        return error.data is None and not is_of_proctor(error.headers)
    tls = _tls_error(error)
    return tls is not None and _is_final(tls)


def is_passing_page(error: Exception) -> bool:
    """Whether what is in the place of a server may soon be gone, as a sign-in page."""
    if not isinstance(error, ApiException):
        return is_from_elsewhere(error)
    return error.data is None and error.may_repeat(has_answered=True)


def from_failure(
    error: Exception,
    url: str,
    control_url: str | None = None,
    *,
    has_answered: bool = True,
) -> ProctorError:
    """The ProctorError for the error of a request to the server at `url`.

    control_url: that of the server that named `url` as the endpoint of a run.
    has_answered: whether a server of Proctor has ever answered there.
    """
    failure = _from_failure(error, url, has_answered=has_answered)
    if failure.code in ENDPOINT_FAULTS and control_url not in (None, url):
        return failure.explained(
            f"{url} is the endpoint of the run, which {control_url} has named. If "
            "clients reach the server elsewhere, its operator sets --public-url."
        )
    return failure


def _from_failure(error: Exception, url: str, *, has_answered: bool) -> ProctorError:
    route = _route_to(url)
    if _is_of_arguments(error):
        return _wrong_argument(error)
    if isinstance(error, ApiException) and error.status:
        return _from_answer(error, url, route)
    if (tls := _tls_error(error)) is not None and _is_final(tls):
        who = url
        if fault_of_proxy(error) is not None:
            who = f"The proxy {route.url} of {route.variable}"
        elif route.url:
            who = f"{url} ({route.how})"
        return _not_trusted(tls, who)
    if isinstance(error, NO_ANSWER_ERRORS):
        return _no_answer(error, url, route, has_answered=has_answered)
    return _invalid_answer(error, url, route)


def _invalid_answer(error: Exception, url: str, route: ProxyRoute) -> ProctorError:
    """A success whose body is not the message: of the server, or of something else."""
    headers = error.headers if isinstance(error, ApiException) else {}
    is_elsewhere = isinstance(error, ApiException) and is_from_elsewhere(error)
    what, who, cure = _what_is_wrong(error), url, ""
    if is_elsewhere:
        who = who_answered(url, route)
        what = describe_page(headers) or what
        cure = cure_of_page(route)
    else:
        what += f"; {route.how}" if route.url else ""
        cure = "Check that the URL is that of a Proctor server; if it is, report this "
        cure += "to its operator."
    text = f"{who} sent an invalid response ({what}). {cure}"
    is_read = getattr(error, "method", "") == "GET"
    if not is_read:
        text += " The request may have been carried out; to repeat it as it was is"
        text += " safe."
    effects = "none" if is_read else "possible"
    return ProctorError(BAD_ANSWER, text, side_effects=effects)


def _route_to(url: str) -> ProxyRoute:
    try:
        return find_route(url)
    except BadProxy:  # was reported before anything was sent
        return ProxyRoute()


def _no_answer(
    error: Exception, url: str, route: ProxyRoute, *, has_answered: bool
) -> ProctorError:
    """The server, or the proxy on the way to it, did not answer."""
    reason, advice = innermost_reason(error), route.advice
    if (fault := fault_of_proxy(error)) is not None:
        text = describe_proxy_fault(
            url, route, fault.phrase, fault.status, fault.challenges
        )
        retryable = not is_refusal(fault.status)
        return ProctorError(UNREACHABLE, text, retryable=retryable)
    if (files := out_of_files(error)) is not None:
        text = f"{url} was not reached: {files}."
        return ProctorError(UNREACHABLE, text, retryable=True)
    if (http2 := describe_http2(url, line_of_http2(error))) is not None:
        return ProctorError(BAD_ANSWER, http2)
    if route.url and is_of_first_hop(error):
        text = describe_unreachable_proxy(url, route, reason)
    elif is_late_answer(error):
        text = _late_answer(url, route, has_answered=has_answered)
    elif was_cut(error):
        way = f"; {route.how}" if route.url else ""
        text = f"The connection to {url} was cut ({reason}{way}). If that lasts, check"
        text += f" the URL{scheme_hint(error, url)}, and that the server runs"
        text += f"; {advice}." if route.url else "."
    else:
        way = f"; {route.how}" if route.how else ""
        text = f"{url} is unreachable ({reason}{way}). Check the URL"
        text += f"{scheme_hint(error, url)}, and that the server runs"
        text += f"; {advice}." if advice else "."
    return ProctorError(UNREACHABLE, text, retryable=True, side_effects="possible")


def _late_answer(url: str, route: ProxyRoute, *, has_answered: bool) -> str:
    """A connection that is silent: who is known by what it has said before."""
    way = f" ({route.how})" if route.how and not route.url else ""
    who = f"{who_answered(url, route)}{way} did not answer in time."
    if has_answered:
        return (
            f"{who} The server may be busy, or wait for a simulator: its log and the "
            "page of the run say more."
        )
    advice = f"; {route.advice}" if route.url else ""
    return (
        f"{who} It takes connections and has not said a word. Check that the URL is "
        f"that of a Proctor server{advice}. If it is busy, `retry_timeout_s` is how "
        "long it is waited for."
    )


def _is_of_arguments(error: Exception) -> TypeGuard[pydantic.ValidationError]:
    """Whether the client refused the arguments of an operation, and sent nothing.

    The title of such an error is the method; that of a response is a message.
    """
    return isinstance(error, pydantic.ValidationError) and "Api." in error.title


def _wrong_argument(error: pydantic.ValidationError) -> ProctorError:
    first = error.errors(include_url=False)[0]
    operation = error.title.rpartition(".")[2]
    given = repr(first["input"])[:_SHOWN_CHARS]
    text = f"{operation} does not take the argument {given}: {first['msg']}. "
    return ProctorError("invalid_request", f"{text}Nothing was sent; correct it.")


def _what_is_wrong(error: Exception) -> str:
    """The fault of a response that violates the protocol, in one line."""
    cause = error.__cause__ if isinstance(error, ApiException) else error
    if not isinstance(cause, pydantic.ValidationError):
        return str(error.reason if isinstance(error, ApiException) else error)
    first = cause.errors(include_url=False, include_input=False)[0]
    place = "".join(f"/{part}" for part in first["loc"])
    return f"{cause.title}{place}: {first['msg']}"


def _tls_error(error: BaseException) -> ssl.SSLError | None:
    """The error of TLS, however deep the libraries have wrapped it; else None."""
    tls = (cause for cause in causes_of(error) if isinstance(cause, ssl.SSLError))
    return next(tls, None)


def _is_final(error: ssl.SSLError) -> bool:
    """Whether the same happens again: a connection may also be lost in a handshake."""
    lost = (ssl.SSLEOFError, ssl.SSLZeroReturnError, ssl.SSLSyscallError)
    return not isinstance(error, lost)


def _not_trusted(error: ssl.SSLError, who: str) -> ProctorError:
    """A server, or the proxy on the way, that does not prove who it is."""
    if not isinstance(error, ssl.SSLCertVerificationError):
        return ProctorError(NOT_TRUSTED, describe_tls_fault(error, who))
    reason = error.verify_message.rstrip(".")
    who = f"{who[:1].lower()}{who[1:]}"
    return ProctorError(
        NOT_TRUSTED,
        f"The certificate of {who} is not accepted: {reason}. "
        f"{certificate_cure(error)}.",
    )


def _from_answer(error: ApiException, url: str, route: ProxyRoute) -> ProctorError:
    problem, status = error.data, error.status
    if not isinstance(problem, Problem):
        return _from_gateway(error, url, route)
    here = _CLIENT_HINTS.get(problem.limit or problem.code, "")
    if "/v1" not in problem.detail:  # else the server has said it
        here = here or _base_hint(status, url).strip()
    return ProctorError(
        problem.code,
        f"{problem.detail} {here}" if here else problem.detail,
        retryable=problem.retryable and not _is_used_up(problem),
        side_effects=problem.side_effects.value,
        errors=[(e.pointer, _text_of_fault(e)) for e in problem.errors or ()],
        problem=problem,
        retry_after_s=error.retry_after_s,
    )


def _text_of_fault(fault: ProblemItem) -> str:
    """A member that only a newer server knows: this client sends no others."""
    is_of_user = fault.pointer.startswith("/options/")
    if is_of_user or not fault.detail.startswith(_UNKNOWN_MEMBER):
        return fault.detail
    return (
        "this server does not know it, and so is older than this client: leave it out, "
        "or use a client of the server's version"
    )


def _is_used_up(problem: Problem) -> bool:
    """Whether a limit is refused for good, although its code is retryable."""
    return problem.limit in _USED_UP


def _from_gateway(error: ApiException, url: str, route: ProxyRoute) -> ProctorError:
    """The answer was sent by something in front of the server, or by another server."""
    status, phrase = error.status, f"{error.status} {error.reason or ''}".strip()
    if route.url and status == NO_PASSWORD:
        wanted = getattr(error.headers, "getlist", error.headers.get)
        challenges = wanted("Proxy-Authenticate") or []
        text = describe_proxy_fault(url, route, phrase, status, challenges)
        return ProctorError(UNREACHABLE, text)
    who = who_answered(url, route)
    moved = where_it_moved(error, url)
    if moved is not None:
        advice = f"; {route.advice}" if who != url else ""
        return ProctorError(BAD_ANSWER, f"{who} answered {phrase}. {moved}{advice}.")
    if speaks_tls(error, url):
        text = f"{url} answered {phrase}: it speaks TLS. Begin the URL with https://."
        return ProctorError(BAD_ANSWER, text)
    advice = f"; {route.advice}" if who != url else ""
    cure = f"Check that the URL is that of a Proctor server{advice}."
    if status == HTTPStatus.NETWORK_AUTHENTICATION_REQUIRED:
        cure = cure_of_page(route)
    elif status in WITHOUT_SERVER:
        cure = (
            "A proxy before a server answers so while it reaches none. If this lasts, "
            f"check the URL, and ask its operator{advice}."
        )
    return ProctorError(
        BAD_ANSWER,
        f"{who} answered {phrase} without a problem document. {cure}"
        f"{_base_hint(status, url)}",
        retryable=error.may_repeat(has_answered=False),
        side_effects="possible",
        retry_after_s=error.retry_after_s,
    )


def _base_hint(status: int, url: str) -> str:
    """The hint for who gives the address of the interface in place of the server's."""
    last = url.rstrip("/").rpartition("/")[2]
    if status != 404 or last not in ("v1", "hosting", "pages"):
        return ""
    why = "which is added to it" if last == "v1" else "where its pages are"
    return f" Try the URL without /{last}, {why}."


def innermost_reason(error: BaseException) -> str:
    """The innermost reason; the operating system's text if there is one."""
    *_, inner = causes_of(error)
    strerror = getattr(inner, "strerror", None)
    return strerror or str(inner) or type(inner).__name__


class BadPolicy(ValueError):
    """The reference does not name a policy; the message says why."""
