"""Bytes to messages: what is read, what is refused and where the refusal points."""

import asyncio
import contextlib
import tracemalloc
from collections.abc import Callable, Iterable
from datetime import UTC, datetime
from functools import partial
from typing import Any

import msgspec
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
    encode_response,
    media_type_of,
    negotiate_media_type,
    pointer,
    validate,
)
from reference_server.rules.refusal import Refused

DEEP = 10**6
NOW = datetime.now(UTC)
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


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"{",
        b"{}{}",
        b"{'a': 1}",
        b'{"a": 1,}',
        b"\xef\xbb\xbf{}",
        b'"\\ud800"',
        b'{"\\udfff": 1}',
        b'"\xed\xa0\x80"',
        b'"\xff"',
        b"\x00",
        b"NaN",
        b'{"a": NaN}',
        b'{"a": [-Infinity]}',
        b"1e999",
        b"9" * 5000,
        b"01",
        b"[" * DEEP,
        b"[" * DEEP + b"]" * DEEP,
        b'{"a":' * DEEP + b"1" + b"}" * DEEP,
    ],
    ids=lambda body: repr(body[:12]),
)
def test_invalid_json_is_malformed(body: bytes) -> None:
    assert refused(lambda: decode(body, JSON), "malformed_body") == []


@pytest.mark.parametrize(
    "body",
    [
        b"",
        b"\x81",
        b"\x80\x80",
        b"\xc1",
        b"\xa3\xed\xa0\x80",
        b"\xa1\xff",
        b"\x81\x80\x01",
        b"\x81\x91\x80\x01",
        b"\xdd\xff\xff\xff\xff",
        b"\xdf\xff\xff\xff\xff",
        b"\xc6\xff\xff\xff\xff",
        b"\xd4\x05\x00",
        b"\x81\xa1a\xd4\x05\x00",
        b"\x81\xd4\x05\x00\x01",
        b"\xc7\x0c\xff" + b"\xff" * 12,
        b"\x91" * DEEP,
        b"\x81\xa1a" * DEEP,
    ],
    ids=lambda body: repr(body[:12]),
)
def test_invalid_msgpack_is_malformed(body: bytes) -> None:
    assert refused(lambda: decode(body, MSGPACK), "malformed_body") == []


@given(st.binary(max_size=64), st.sampled_from([JSON, MSGPACK]))
def test_any_bytes_are_read_or_refused(body: bytes, media_type: str) -> None:
    with contextlib.suppress(Refused):  # anything else would fail the test
        decode(body, media_type)


def test_big_integers_are_read_exactly() -> None:
    assert decode(b"9" * 40, JSON) == 10**40 - 1
    assert decode(b"-9007199254740993", JSON) == -(2**53) - 1


@pytest.mark.parametrize(
    "holder",
    [
        NOW,
        PREDICT | {"session_id": NOW},
        PREDICT | {"other": NOW},
        PREDICT | {"other": [{"deep": [NOW]}]},
        PREDICT | {"actions": [{"values": {"arm": [[NOW]]}}]},
        PREDICT | {"actions": {"a": NOW}},
        {NOW: 1},
    ],
    ids=["top", "member", "unknown", "deep", "number", "wrong type", "key"],
)
def test_a_timestamp_is_an_extension_wherever_it_stands(holder: Any) -> None:
    body = msgspec.msgpack.encode(holder)
    assert b"\xff" in body
    refused(lambda: validate(models.Predict, decode(body, MSGPACK)), "malformed_body")


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


@pytest.mark.parametrize(
    "value", [float("nan"), float("inf"), 10**400, "1", None, True, b"1", [1.0]]
)
def test_an_action_holds_numbers(value: Any) -> None:
    body = PREDICT | {"actions": [{"values": {"a/b": [0.0, value]}}]}
    faults = refused(lambda: validate(models.Predict, body), "invalid_request")
    assert faults == ["/actions/0/values/a~1b/1"]


@pytest.mark.parametrize("key", [1, None, b"x", (), 1.5, True])
def test_a_key_that_is_no_text_is_refused(key: Any) -> None:
    read = decode(msgspec.msgpack.encode(SUBMIT | {key: 1}), MSGPACK)
    refused(lambda: validate(models.SubmitRun, read), "invalid_request")
    values = PREDICT | {"actions": [{"values": {key: [1.0]}}]}
    read = decode(msgspec.msgpack.encode(values), MSGPACK)
    faults = refused(lambda: validate(models.Predict, read), "invalid_request")
    assert faults[0].startswith("/actions/0/values/")


def test_every_fault_is_named_up_to_a_bound() -> None:
    unknown = {f"x{i:03}": i for i in range(200)}
    faults = refused(
        lambda: validate(models.SubmitRun, SUBMIT | unknown), "invalid_request"
    )
    assert faults == [f"/x{i:03}" for i in range(50)]


def test_a_whole_number_is_an_integer() -> None:
    choice = {"codec": "raw", "width": 630.0, "height": 12}
    body = SUBMIT | {"max_workers": 4.0, "images": choice}
    read = validate(models.SubmitRun, body).model_dump()
    assert (read["max_workers"], read["images"]["width"]) == (4, 630)
    assert isinstance(read["images"]["width"], int)
    assert validate(models.Predict, PREDICT | {"seq": 2.0}).seq == 2


def test_whole_numbers_excuse_no_other_fault() -> None:
    body = SUBMIT | {"max_workers": 4.0, "other": 5.0}
    assert refused(lambda: validate(models.SubmitRun, body), "invalid_request") == [
        "/other"
    ]


def test_absent_members_stay_absent() -> None:
    assert validate(models.SubmitRun, dict(SUBMIT)).model_dump() == SUBMIT


@given(st.lists(st.text() | st.integers(0, 99), max_size=4))
def test_a_pointer_leads_back_to_its_parts(parts: list[str | int]) -> None:
    pieces = pointer(parts).split("/")[1:]
    back = [piece.replace("~1", "/").replace("~0", "~") for piece in pieces]
    assert back == [str(part) for part in parts]


# --- media types ---


@pytest.mark.parametrize(
    "declared",
    [JSON, "Application/JSON", "application/json; charset=utf-8", " application/json "],
)
def test_a_media_type_may_have_parameters(declared: str) -> None:
    assert media_type_of(request(content_type=declared), [JSON, MSGPACK]) == JSON


@pytest.mark.parametrize(
    "declared", ["", "text/json", "application/jsonx", MSGPACK, "*/*", "json"]
)
def test_other_media_types_are_not_read(declared: str) -> None:
    incoming_request = request(content_type=declared)
    refused(lambda: media_type_of(incoming_request, [JSON]), "unsupported_media_type")
    refused(lambda: media_type_of(request(), [JSON]), "unsupported_media_type")


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


def test_the_default_media_type_is_json() -> None:
    assert negotiate_media_type(request(), [JSON, MSGPACK]) == JSON


def test_blobs_are_base64_in_json_and_bytes_in_msgpack() -> None:
    turn = {"data": b"\x00\xff"}
    plain = encode_response(turn)
    assert (plain.body, plain.status_code) == (b'{"data":"AP8="}', 200)
    packed = encode_response(turn, MSGPACK, 201)
    assert msgspec.msgpack.decode(bytes(packed.body)) == turn
    assert (packed.media_type, packed.status_code) == (MSGPACK, 201)


# --- bodies ---


def read(parts: Iterable[bytes], limit_bytes: int) -> bytes:
    return asyncio.run(read_body(request(parts), limit_bytes))


def test_a_body_is_read_in_parts_up_to_the_limit() -> None:
    assert read([b"ab", b"", b"cd"], 4) == b"abcd"
    assert read([], 4) == b""
    refused(lambda: read([b"ab", b"cde"], 4), "body_too_large")


def test_a_refused_body_names_the_limit_that_bound_it() -> None:
    for is_control, rule in ((False, "ERR-005"), (True, "LIM-008")):
        with pytest.raises(Refused) as caught:
            asyncio.run(read_body(request([b"abc"]), 2, is_control=is_control))
        assert caught.value.requirement == rule
        assert ("limits.max_control_body_bytes" in caught.value.detail) == is_control


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
