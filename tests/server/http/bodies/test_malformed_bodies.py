"""Bodies that cannot be read: the refusal says what they are, and where they break."""

from __future__ import annotations

import gzip
import json
import zlib
from typing import Any

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import Request

from conformance.checks.support.bodies.msgpack_forms import WIDTHS, Twice, pack
from reference_server.generated import models
from reference_server.http.bodies.bounded_parsing import WHOLE_BYTES_MAX, read_structure
from reference_server.http.bodies.repeated_members import (
    refuse_repeated_json,
    refuse_repeated_msgpack,
)
from reference_server.http.codec import JSON, MSGPACK, decode, media_type_of
from reference_server.rules.refusal import Refused
from tests.support.profiles.ebench_client import dump_pickle

TEXT = b'{"a": 1}'


@pytest.mark.parametrize(
    ("body", "what"),
    [
        (b"", "it is empty"),
        (gzip.compress(TEXT, mtime=0), "compressed with gzip; send it uncompressed"),
        *((zlib.compress(TEXT, level), "with deflate") for level in (1, 6, 9)),
        (b"\x28\xb5\x2f\xfd" + TEXT, "compressed with zstd"),
        (b"\xef\xbb\xbf" + TEXT, "it begins with a byte order mark"),
        *((TEXT.decode().encode(code), "UTF-16") for code in ("utf-16", "utf-32")),
        *((dump_pickle({"a": 1}, protocol), "a pickle") for protocol in (2, 3, 4, 5)),
        (b"\x81\xa1a\x01", "it is MessagePack, not JSON"),
        (b"a=1&b=2", "it is a form, not JSON"),
        (b" <html>", "it is HTML or XML, not JSON"),
        (
            b'{"a": "\\ud800"}',
            r"a text has \\ud800, half of a surrogate pair, at byte 7",
        ),
        (b'{"a": "\\udc00x"}', r"has \\udc00, half of a surrogate pair"),
        (b'{"a": "\\ud83d\\ude00 \\uD800"}', r"has \\uD800, half .* at byte 20"),
        (b'{"a": "\\\\\\ud800"}', r"has \\ud800, half of a surrogate pair, at byte 9"),
        (b'{"a": "\xff"}', "not UTF-8 .*0xff"),
        (b'{"a": NaN}', r"NaN is not a number of JSON \(byte 6\)"),
        (b"[Infinity]", "Infinity is not a number of JSON"),
        (b'{"a": 1', "it ends too early"),
        (b'{"a": "[NaN", x', r"\(byte 14\)"),
        (b'{"a": "\\\\ud800', "it ends too early"),
        (b"{'a': 1}", "object keys must be strings"),
        (b'{"a": 1,}', "trailing comma in object"),
    ],
)
def test_json_that_is_something_else_is_called_that(body: bytes, what: str) -> None:
    with pytest.raises(Refused, match=f"^The body is malformed: .*{what}") as caught:
        decode(body, JSON)
    assert caught.value.code == "malformed_body"


@pytest.mark.parametrize(
    ("body", "what"),
    [
        (b"", "it is empty"),
        (TEXT, "it is JSON, not MessagePack"),
        (gzip.compress(TEXT, mtime=0), "compressed with gzip"),
        (dump_pickle({"a": 1}), "it is a pickle"),
        (b"\x81\xa1a", "it ends too early"),
        (b"\xa1\xff", "not UTF-8"),
    ],
)
def test_messagepack_that_is_something_else_is_called_that(
    body: bytes, what: str
) -> None:
    with pytest.raises(Refused, match=f"^The body is malformed: .*{what}"):
        decode(body, MSGPACK)


@pytest.mark.parametrize("coding", ["gzip", "x-gzip", "br", "deflate", "zstd", "GZIP"])
def test_a_coding_of_the_body_is_refused_by_name(coding: str) -> None:
    def request_with(coding: str) -> Request:
        headers = [(b"content-type", JSON.encode())]
        headers.append((b"content-encoding", coding.encode()))
        return Request({"type": "http", "headers": headers})

    with pytest.raises(Refused, match=f"{coding.lower()} is not supported: send the"):
        media_type_of(request_with(coding), (JSON,))
    for passed_over in ("identity", "utf-8", ""):
        assert media_type_of(request_with(passed_over), (JSON,)) == JSON


def action_with(values: dict[str, Any], **more: Any) -> dict[str, Any]:
    return {"values": values, **more}


SESSION = {"session_id": "a:b", "seq": 1}
# Where a name stands twice, and a body in which it does.
REPEATED: dict[str, Any] = {
    "at the top": {**SESSION, "actions": [action_with({})], Twice("seq"): 1},
    "a list": {Twice("actions"): [], **SESSION, "actions": [action_with({})]},
    "in an action": {
        **SESSION,
        "actions": [action_with({}), {Twice("values"): {}, **action_with({})}],
    },
    "in a map": {**SESSION, "actions": [action_with({"a": [0.5], Twice("a"): [0.5]})]},
}


@pytest.mark.parametrize("size", [1, WHOLE_BYTES_MAX])
@pytest.mark.parametrize("where", REPEATED)
def test_a_member_that_stands_twice_is_refused(where: str, size: int) -> None:
    """ENC-013, ENC-014: in a small body, and in a large one, which is read by parts.

    The control is the same body with another name in the place of one.
    """
    wrong = dict(REPEATED[where])
    large = action_with({"large": [0.5] * min(size, 4000), "b": [0.5] * (size % 4000)})
    wrong["actions"] = [*wrong["actions"], large]
    right = {name: value for name, value in wrong.items() if type(name) is str}
    right["actions"] = [action_with({"a": [0.5]}), large]
    bodies = [(JSON, json.dumps(wrong).encode(), json.dumps(right).encode())]
    for width in WIDTHS:
        packed = [pack(body, width, is_signed=False) for body in (wrong, right)]
        bodies.append((MSGPACK, packed[0], packed[1]))
    for media_type, body, control in bodies:
        assert (len(control) > WHOLE_BYTES_MAX) is (size > 1)
        assert read_structure(models.Predict, control, media_type) == right
        with pytest.raises(Refused, match="stands twice") as caught:
            read_structure(models.Predict, body, media_type)
        assert caught.value.code == "malformed_body"


class Pairs:
    """An object whose names may be equal."""

    def __init__(self, pairs: list[tuple[str, Any]]) -> None:
        self.pairs = pairs


NAMES = st.sampled_from(["a", "b:", "é", 'q"', "\\", "\u2028"])
TREES = st.recursive(
    st.sampled_from([1, 0.5, -0.0, 2**63, None, True, "", "a:b", 'x"', "é\n", "\\:"]),
    lambda inner: (
        st.lists(st.tuples(NAMES, inner), max_size=4).map(Pairs)
        | st.lists(st.lists(st.tuples(NAMES, inner), max_size=3).map(Pairs), max_size=3)
    ),
    max_leaves=12,
)


@given(tree=TREES, style=st.sampled_from([(", ", ": "), (",", ":"), (" , ", " :\t")]))
def test_a_member_that_stands_twice_is_found_wherever_it_is(
    tree: Any, style: tuple[str, str]
) -> None:
    """In any spelling. Expect a refusal for these bodies, and for no other one."""
    for is_ascii in (True, False):
        body = written(tree, style, is_ascii).encode()
        assert is_refused(refuse_repeated_json, body, msgspec.json) is repeats(tree)
    if not repeats(tree):
        packed = msgspec.msgpack.encode(tree, enc_hook=lambda one: dict(one.pairs))
        assert not is_refused(refuse_repeated_msgpack, packed, msgspec.msgpack)


def is_refused(refuse: Any, body: bytes, library: Any) -> bool:
    try:
        refuse(body, library.decode(body))
    except ValueError:
        return True
    return False


def repeats(tree: Any) -> bool:
    if isinstance(tree, Pairs):
        names = [name for name, _ in tree.pairs]
        return len(set(names)) < len(names) or any(repeats(v) for _, v in tree.pairs)
    return isinstance(tree, list) and any(map(repeats, tree))


def written(tree: Any, style: tuple[str, str], is_ascii: bool) -> str:
    comma, colon = style
    if isinstance(tree, Pairs):
        members = (
            json.dumps(name, ensure_ascii=is_ascii)
            + colon
            + written(value, style, is_ascii)
            for name, value in tree.pairs
        )
        return "{" + comma.join(members) + "}"
    if isinstance(tree, list):
        return "[" + comma.join(written(v, style, is_ascii) for v in tree) + "]"
    return json.dumps(tree, ensure_ascii=is_ascii)


def test_a_short_json_body_names_the_member() -> None:
    for body in (
        b'{"seq": 1, "\\u0073eq": 1}',
        b'{"a:": "::", "b": [{"seq":1,"seq":2}]}',
    ):
        with pytest.raises(Refused, match="the member 'seq' stands twice in an object"):
            read_structure(models.Predict, body, JSON)
