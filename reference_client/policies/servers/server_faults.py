"""Describes the faults of a policy server: its error text, or another protocol.

Policy servers report errors in many places; the text is shown whatever its place.
"""

from __future__ import annotations

import contextlib
import re
import socket
from collections.abc import Iterable, Iterator, Mapping
from email.message import Message
from typing import Any
from urllib.parse import urljoin, urlsplit

import numpy as np
from proctor_client import find_route
from proctor_client.transport.copied_text import BadToken, token_of
from proctor_client.transport.server_address import without_user

from reference_client.errors import (
    POLICY_FAILED,
    BadPolicy,
    PolicyFailed,
    ProctorError,
)
from reference_client.policies.servers.wire_formats import kind_of
from reference_record.texts.shortened_text import shortened

UNASKED = "sent a message for which there was no request"
ONE_ANSWER = (
    "Answers have no number, so each later one would be taken for that of another "
    "request; let the server send one message for each request"
)
_TEXT_MAX = 500
_BEGINNING_MAX, _BYTES_MAX = 80, 40
_OUTLINE_MAX, _LISTED_MAX = 200, 3
_PROBE_S = 1.0
_TEXT_KEYS = (
    *("error", "exception", "detail", "message", "msg", "reason", "err_msg"),
    "traceback",
)
_FAILURES = ("error", "failed", "failure")
_OTHER_SCHEMES = {"http": "https", "https": "http", "ws": "wss", "wss": "ws"}
_REFUSED_KEY = re.compile(
    r"(?i)unauthori[sz]ed|not authenticated|unauthenticated|authentication|"
    r"\b(api|access|auth|bearer|invalid|missing|wrong)[ _-]?(key|token)\b"
)
# The last line of a traceback that is not indented names the exception.
_EXCEPTION = re.compile(r"^[A-Za-z_][\w.]*(: |$)")


def failed(place: str, what: str, whole: str | None = None) -> ProctorError:
    """The failure of the policy server at `place`; whole: its text, for --debug."""
    detail = f"The policy server at {without_user(place)} {what.rstrip('.')}."
    if whole is None:
        return ProctorError(POLICY_FAILED, detail)
    return PolicyFailed(detail, whole)


def text_of(data: bytes, media_type: str | None) -> str:
    """The text of a body in the charset that its media type declares, or in UTF-8."""
    declared = Message()
    declared["Content-Type"] = media_type or ""
    text = ""
    with contextlib.suppress(LookupError, ValueError):  # no charset; it raises for any
        text = data.decode(declared.get_content_charset("utf-8"), errors="replace")
    # From Python 3.14 on, `punycode` makes nothing of most bodies.
    return (text or data.decode(errors="replace")).removeprefix("\ufeff")


def beginning(data: str | bytes, media_type: str | None = None) -> str:
    """How a message begins that cannot be read, and its media type."""
    kind = f" ({media_type})" if media_type else ""
    if not data:
        return f"it is empty{kind}"
    shown: str | bytes = data[:_BEGINNING_MAX]
    if isinstance(data, bytes):
        text = text_of(data[: 4 * _BEGINNING_MAX], media_type)[:_BEGINNING_MAX]
        is_text = all(one.isprintable() or one.isspace() for one in text)
        shown = text if is_text and "\ufffd" not in text else data[:_BYTES_MAX]
    return f"it begins with {shown!r}{kind}"


def moved(url: str, status: int, location: str | None) -> str:
    """Where an answer sends the client, which does not go: it may be another policy."""
    if not location:
        return f"answered {status} and names no other place"
    return f"answered {status}: it is at {without_user(urljoin(url, location))}"


def describe_format(url: str, data: str | bytes, wire_format: str) -> str | None:
    """The option for an answer that is right in another format; None for others."""
    kind = kind_of(data)
    if kind is None or wire_format.startswith(kind):
        return None
    scheme = urlsplit(url).scheme
    sent, read = ("JSON", "MessagePack") if kind == "json" else ("MessagePack", "JSON")
    return (
        f"answers {sent}, and {read} is read: take --policy {scheme}://…, with "
        f'`format = "{kind}"` in [server] of the mapping file'
    )


def check_answer(place: str, answer: Any, key: str = "") -> None:
    """Raises ProctorError if a decoded answer reports an error.

    key: the variable of the environment that has the key of this wire, if it has one.
    """
    if _is_error(answer):
        raise failed(place, f"failed: {with_key(error_text(answer), key)}")


def without_numbers(place: str, answer: Any, why: str, key: str) -> ProctorError:
    """The failure for an answer that has no numbers where the mapping expects them.

    Its own text comes first: the server may have failed, whatever the mapping. why: the
    sentence of the mapping. key: as of `check_answer`.
    """
    texts = map(_text_in, _tables_in([answer]))
    if text := last_exception(next(filter(None, texts), "")):
        return failed(place, f"says: {with_key(text, key).rstrip('.')}. {why}")
    return ProctorError(POLICY_FAILED, why)


def outline(message: Any) -> str:
    """The names in a message, and the shapes of its arrays."""
    return shortened(_outlined(message), _OUTLINE_MAX)


def _outlined(value: Any) -> str:
    match value:
        case np.ndarray():
            return f"{value.dtype} {value.shape}"
        case Mapping():
            parts = (f"{name!r}: {_outlined(part)}" for name, part in value.items())
            return f"{{{', '.join(parts)}}}"
        case list() if len(value) <= _LISTED_MAX:
            return f"[{', '.join(map(_outlined, value))}]"
        case list():
            return f"a list of {len(value)}"
    return f"{value!r:.40}"


def key_of(variable: str) -> str | None:
    """The key in a variable of the environment.

    Raises BadPolicy for one that cannot be a token.
    """
    try:
        return token_of(variable) if variable else None
    except BadToken as error:
        raise BadPolicy(f"{error}") from error


def describe_key(variable: str) -> str:
    """Where the key of a server is taken from; variable: empty if none is ever sent."""
    if not variable:
        return "this source of policies sends no key"
    if key_of(variable):
        return f"its key is taken from {variable}, which is set"
    return f"its key is taken from {variable}, which is not set, so no key was sent"


def with_key(text: str, variable: str) -> str:
    """The text, with where the key is taken from if it is a refusal of a key."""
    is_refusal = _REFUSED_KEY.search(text) is not None
    return f"{text.rstrip('.')}; {describe_key(variable)}" if is_refusal else text


def _is_error(answer: Any) -> bool:
    if not isinstance(answer, Mapping):
        return False
    errors = (answer.get("error"), answer.get("exception"))
    if any(error and isinstance(error, str | Mapping | list) for error in errors):
        return True
    if any(answer.get(flag) is False for flag in ("ok", "success")):
        return True
    words = (answer.get("status"), answer.get("type"))
    return any(isinstance(word, str) and word.lower() in _FAILURES for word in words)


def error_text(value: Any) -> str:
    """The text of an error, however deep in the answer; whole if it has no place."""
    return last_exception(_text_in(value) or f"{value!r}")


def status_text(report: Any) -> str:
    """The words of a server that is not ready yet, about itself."""
    status = report.get("status") if isinstance(report, Mapping) else None
    said = [status, _text_in(report)]
    words = [word for word in said if isinstance(word, str) and word]
    return last_exception(", ".join(words) or outline(report)).rstrip(".")


def _text_in(value: Any) -> str:
    match value:
        case str():
            return value
        case Mapping():
            place = value.get("loc")
            named = [value[key] for key in _TEXT_KEYS if key in value]
            texts = map(_text_in, [*named, *_tables_in(value.values())])
            text = next(filter(None, texts), "")
            if isinstance(place, list | tuple):  # as FastAPI reports invalid requests
                return f"{'.'.join(map(str, place))}: {text}"
            return text
        case list():
            return "; ".join(filter(None, map(_text_in, value)))
    return ""


def _tables_in(values: Iterable[Any]) -> Iterator[Mapping[Any, Any]]:
    """The tables among the values, also those in lists."""
    for value in values:
        for part in value if isinstance(value, list) else [value]:
            if isinstance(part, Mapping):
                yield part


def last_exception(text: str) -> str:
    """The exception that a traceback ends with; other text as it is, in one line."""
    lines = text.strip().splitlines()
    if any(line.startswith("Traceback (most recent call last)") for line in lines):
        frames = [i for i, line in enumerate(lines) if line.startswith("  ")]
        tail = lines[frames[-1] + 1 :] if frames else lines
        named = [i for i, line in enumerate(lines) if _EXCEPTION.match(line)]
        lines = tail or lines[named[-1] :] if named else tail or lines[-1:]
    return shortened(" ".join(" ".join(lines).split()), _TEXT_MAX)


def scheme_hint(url: str) -> str:
    """Advice on a server that hangs up, as one does whose scheme is mixed up."""
    other = _OTHER_SCHEMES.get(scheme := urlsplit(url).scheme)
    if other is None:
        return ""
    has_tls = "does not speak TLS" if scheme in ("https", "wss") else "speaks TLS"
    return f"; if it {has_tls}, the URL begins with {other}://"


def who_speaks_at(url: str) -> str:
    """Names the protocol of a server by the bytes that it sends before a request."""
    parts = urlsplit(url)
    with contextlib.suppress(ValueError):
        scheme = parts.scheme.replace("ws", "http")
        if (route := find_route(parts._replace(scheme=scheme).geturl())).url:
            return f"it was to be reached {route.how}; {route.advice}"
    port = parts.port or (443 if parts.scheme in ("wss", "https") else 80)
    try:
        with socket.create_connection((parts.hostname or "", port), _PROBE_S) as peer:
            peer.settimeout(_PROBE_S)
            first = peer.recv(64)
    except OSError:
        first = b""
    if first.startswith(b"\xff\x00\x00"):
        return "it speaks ZeroMQ, as GR00T's policy servers do (gr00t:HOST:PORT)"
    if first.startswith(b"SSH-"):
        return "it speaks SSH"
    if first[3:5] == b"\x04\x00":
        return "it speaks HTTP/2, as gRPC does, which no source of policies speaks"
    if first:
        return f"it sends {first[:32]!r} first"
    return (
        "it accepts connections and says nothing; it is busy with another client, or "
        f"the port is that of another program{scheme_hint(url)}"
    )
