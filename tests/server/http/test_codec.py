"""Bytes to messages: what is read, what is refused and where the refusal points."""

import asyncio
import contextlib
import tracemalloc
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import Request

from reference_server.generated import models
from reference_server.http.bodies.request_bodies import DRAIN_BYTES, read_body
from reference_server.http.codec import (
    JSON,
    MSGPACK,
    decode,
    negotiate_media_type,
    pointer,
    validate,
)
from reference_server.rules.refusal import Refused

SUBMIT: dict[str, Any] = {"benchmark_id": "calibration", "policy": {"name": "p"}}
PREDICT: dict[str, Any] = {
    "session_id": "s",
    "seq": 1,
    "actions": [{"values": {"arm": [0.5, 1]}}],
}


def refused(work: Callable[[], Any], code: str) -> list[str]:
    """The pointers of the refusal that the work ends in."""
    with pytest.raises(Refused) as caught:
        work()
    assert caught.value.code == code
    return [at for at, _ in caught.value.errors]


def request(parts: Iterable[bytes] = (), **headers: str | list[str]) -> Request:
    raw = [
        (name.replace("_", "-").encode(), value.encode())
        for name, values in headers.items()
        for value in ([values] if isinstance(values, str) else values)
    ]
    remaining = iter(parts)

    async def receive() -> dict[str, Any]:
        part = next(remaining, None)
        return {
            "type": "http.request",
            "body": part or b"",
            "more_body": part is not None,
        }

    return Request({"type": "http", "method": "POST", "headers": raw}, receive)


# --- decoding ---


@given(st.binary(max_size=64), st.sampled_from([JSON, MSGPACK]))
def test_any_bytes_are_read_or_refused(body: bytes, media_type: str) -> None:
    with contextlib.suppress(Refused):  # anything else would fail the test
        decode(body, media_type)


def test_big_integers_are_read_exactly() -> None:
    assert decode(b"9" * 40, JSON) == 10**40 - 1
    assert decode(b"-9007199254740993", JSON) == -(2**53) - 1


# --- validating ---


@pytest.mark.parametrize(
    ("model", "body", "at"),
    [
        (models.SubmitRun, SUBMIT | {"max_workers": 4.5}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"max_workers": 1e300}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"max_workers": 10**30}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"max_workers": "4"}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"max_workers": True}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"max_workers": None}, "/max_workers"),
        (models.SubmitRun, SUBMIT | {"a/b~c": 1}, "/a~1b~0c"),
        (models.SubmitRun, SUBMIT | {"": 1}, "/"),
        (models.SubmitRun, SUBMIT | {"policy": {}}, "/policy/name"),
        (models.SubmitRun, SUBMIT | {"policy": {"name": ""}}, "/policy/name"),
        (models.SubmitRun, SUBMIT | {"options": {"tasks": ["x"]}}, "/options/tasks/0"),
        (
            models.SubmitRun,
            SUBMIT | {"idle_timeout_s": float("nan")},
            "/idle_timeout_s",
        ),
        (models.SubmitRun, [], ""),
        (models.SubmitRun, None, ""),
        (models.SubmitRun, 630.0, ""),
        (models.AttachWorker, {"attach_key": "k", "takeover": 1}, "/takeover"),
        (models.AttachWorker, {"attach_key": "k", "takeover": None}, "/takeover"),
        (models.Predict, PREDICT | {"seq": 2**53}, "/seq"),
        (models.Predict, PREDICT | {"seq": 0}, "/seq"),
        (models.Predict, PREDICT | {"observe": "none"}, "/observe"),
        (models.Predict, PREDICT | {"actions": []}, "/actions"),
    ],
)
def test_a_refusal_points_at_the_fault(model: Any, body: Any, at: str) -> None:
    assert refused(lambda: validate(model, body), "invalid_request") == [at]


def test_every_fault_is_named_up_to_a_bound() -> None:
    unknown = {f"x{i:03}": i for i in range(200)}
    faults = refused(
        lambda: validate(models.SubmitRun, SUBMIT | unknown), "invalid_request"
    )
    assert faults == [f"/x{i:03}" for i in range(50)]


def test_whole_numbers_excuse_no_other_fault() -> None:
    body = SUBMIT | {"max_workers": 4.0, "other": 5.0}
    assert refused(lambda: validate(models.SubmitRun, body), "invalid_request") == [
        "/other"
    ]


@given(st.lists(st.text() | st.integers(0, 99), max_size=4))
def test_a_pointer_leads_back_to_its_parts(parts: list[str | int]) -> None:
    pieces = pointer(parts).split("/")[1:]
    back = [piece.replace("~1", "/").replace("~0", "~") for piece in pieces]
    assert back == [str(part) for part in parts]


# --- media types ---


@pytest.mark.parametrize(
    ("accept", "answer"),
    [
        ("*/*", JSON),
        ("application/*", JSON),
        (f"{MSGPACK}, {JSON}", JSON),  # ENC-001
        (f"{JSON};q=0.5, {MSGPACK};q=0.5", JSON),
        (f"{MSGPACK}, {JSON};q=1.0", JSON),
        (MSGPACK, MSGPACK),
        ("Application/MsgPack", MSGPACK),
        (f"{JSON};q=0.4, {MSGPACK}; q=0.9", MSGPACK),
        (f"{JSON};q=0.4, */*", MSGPACK),  # the most specific range counts
        (f"{JSON};q=0, */*", MSGPACK),
        (f"*/*;q=0.1, {MSGPACK}", MSGPACK),
        (f"text/html, {MSGPACK};q=0.001", MSGPACK),
        (f"{JSON};charset=utf-8", JSON),
        ([MSGPACK, JSON], JSON),  # two lines are one list
        (["text/html", MSGPACK], MSGPACK),
        ("text/html", None),
        (f"{JSON};q=0", None),
        (f"{JSON};q=0, {MSGPACK};q=0, */*", None),
        ("application/*;q=0, */*;q=1", None),
        (f"{JSON};q=much", None),
        (f"{JSON};q=nan", None),
        (",", None),
        (f"{JSON}," * 5000, None),  # longer than is read
    ],
)
def test_the_preferred_media_type_is_chosen(
    accept: str | list[str], answer: str | None
) -> None:
    incoming_request = request(accept=accept)
    if answer is None:
        refused(
            lambda: negotiate_media_type(incoming_request, [JSON, MSGPACK]),
            "not_acceptable",
        )
    else:
        assert negotiate_media_type(incoming_request, [JSON, MSGPACK]) == answer


# --- bodies ---


def read(parts: Iterable[bytes], limit_bytes: int) -> bytes:
    return asyncio.run(read_body(request(parts), limit_bytes))


def test_an_oversized_body_is_drained_and_not_kept() -> None:
    part, limit_bytes = b"x" * 2**16, 2**18
    taken = 0

    def parts() -> Iterable[bytes]:
        nonlocal taken
        for _ in range(2 * DRAIN_BYTES // len(part)):
            taken += len(part)
            yield bytes(part)

    tracemalloc.start()
    refused(lambda: read(parts(), limit_bytes), "body_too_large")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # Read to the last bound that still reaches a client who is sending, and no further.
    assert 0 < taken - limit_bytes - DRAIN_BYTES <= len(part)
    assert peak < 4 * limit_bytes


def test_a_body_a_bit_too_large_is_read_to_its_end() -> None:
    rest = iter([b"x" * 10] * 3)
    refused(lambda: read(rest, 10), "body_too_large")
    assert list(rest) == []


def test_a_body_that_breaks_off_is_malformed() -> None:
    async def receive() -> dict[str, Any]:
        return {"type": "http.disconnect"}

    broken = Request({"type": "http", "method": "POST", "headers": []}, receive)
    refused(lambda: asyncio.run(read_body(broken, 10)), "malformed_body")


def test_an_integer_beyond_the_doubles_is_malformed() -> None:
    """As 1e999 is (ERR-002); the largest double and long texts of digits are read."""
    for digits in (b"1" + b"0" * 309, b"-1" + b"0" * 309, b"9" * 5000):
        refused(partial(decode, b"[%b]" % digits, JSON), "malformed_body")
    largest = int(float(2**1023) * (2 - 2**-52))
    assert decode(b"[%d]" % largest, JSON) == [largest]
    assert decode(b'["%b"]' % (b"0" * 400), JSON) == ["0" * 400]
