"""Whatever an unknown caller sends is parsed with work that is linear in its length.

Each place of a request is filled with texts that make a careless parser go back and
begin again, up to the size at which the server refuses it. Uploads of records and
answers of policy servers are given to the functions that read them.
"""

from __future__ import annotations

import contextlib
import io
import re
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import msgspec
import pytest

from reference_record.broken import BrokenRecord
from reference_record.contents.statement import read_lines
from reference_record.formats.archive import Content, read_entries, stream_archive
from reference_record.formats.envelope import PAYLOAD_TYPE, read_envelope
from reference_record.formats.names import recording_name
from reference_record.formats.strict_json import read_json
from reference_record.history.checkpoint import InvalidCheckpoint
from reference_record.history.checkpoint import read as read_checkpoint
from reference_record.pages.spreadsheet_cells import as_cell
from reference_record.recordings.mcap_reader import MAGIC, McapReader
from reference_server.generated import models
from reference_server.http.bodies.bounded_parsing import read_structure
from reference_server.http.bodies.malformed_bodies import explain
from reference_server.http.codec import JSON, has_unusual_integers
from reference_server.http.connections.connection_limits import (
    HEADER_BYTES,
    ConnectionLimits,
)
from reference_server.http.pages.page_routes import FORM, FORM_BYTES_MAX
from reference_server.profiles.ebench import pickle_reader
from reference_server.push.calls_with_retries import ANSWER_BYTES_MAX
from reference_server.push.chat_calls import read_answer
from reference_server.rules.refusal import Refused
from tests.support.parsing.asgi_server import TOKEN, AsgiServer, asgi_server
from tests.support.parsing.parsing_work import (
    FREE_S,
    SIZE_FACTOR,
    NotLinear,
    assert_linear,
    work_of,
)

pytestmark = pytest.mark.slow("sends ten thousand requests, and large bodies")

URL_BYTES = ConnectionLimits().request_line_bytes
AUTHORIZED = ("authorization", f"Bearer {TOKEN}".encode())
HOST = ("host", b"127.0.0.1")
# Repeated, these fill a text. A number has as many digits as a double may have.
UNITS: tuple[str, ...] = (
    *(
        "\\\\",
        "\\",
        '"',
        '\\"',
        '"\\',
        "'",
        " ",
        "\t",
        ",",
        ", ",
        ";",
        "; ",
        "=",
        "a",
        "0",
    ),
    *("9" * 308 + ",", "-0.", ":", "1:", "/", ".", "-", "%", "%41", "+", "&", "&a="),
    *("a=", "a=b; ", 'a="\\', "a,", "a;q=", "q=1,", '"a",', 'W/"a",', "*/*,", "for=a,"),
    *("(", "[", "{", "[[", '{"a":', '"a":0,', "0,", "\\u0041", "\\ud800", "\xe9"),
    *("\u2028", "<answer>", "</answer>", "</think>", "answer:", "answer is ", "####"),
    *("\\boxed{", "1 ", "(A) ", " - at `$"),
)
# Those that stand in a header, a path or a query; none of them ends one.
HEADER_UNITS = [unit for unit in UNITS if ord(max(unit)) < 256]

HEADERS: tuple[tuple[str, str], ...] = (
    *(("cookie", f'{name}={quote}') for name in ("proctor_session", "proctor_login")
      for quote in ('"', "")),
    ("cookie", ""),
    *(("authorization", before) for before in ("", "Bearer ", "Basic ", 'Digest a="')),
    *(("accept", before) for before in ("", 'text/html;a="')),
    *(("content-type", before) for before in ("", f'{FORM}; a="', 'a/b; boundary="')),
    *(("prefer", before) for before in ("", "wait=")),
    *(("if-none-match", before) for before in ("", '"')),
    *(("range", before) for before in ("", "bytes=")),
    *((name, "") for name in (
        *("accept-encoding", "accept-language", "content-encoding", "content-length"),
        *("date", "expect", "forwarded", "host", "idempotency-key", "if-match"),
        *("if-modified-since", "if-range", "last-event-id", "origin", "priority"),
        *("proctor-version", "referer", "run_id", "sec-fetch-site", "te"),
        *("traceparent", "tracestate", "upgrade", "user-agent", "via"),
        *("x-forwarded-for", "x-forwarded-host", "x-forwarded-proto", "x-real-ip"),
        *("x-request-id",),
    )),
)  # fmt: skip
REQUESTS: tuple[tuple[str, str], ...] = (
    *(("GET", path) for path in ("/", "/pages/runs", "/pages/login", "/livez")),
    ("POST", "/pages/login"),
    *(("GET", f"/v1/runs/run_absent{end}") for end in ("", "/events", "/record")),
    ("POST", "/v1/runs"),
    ("POST", "/v1/records"),
    ("GET", "/eval-server/run_absent/api/predict/calibration/status"),
    ("GET", "/evaluation_progress"),
)


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[AsgiServer]:
    folder: Path = tmp_path_factory.mktemp("server")
    with asgi_server(folder, profiles="ebench,flageval") as server:
        server.answer("GET", "/pages/login", [HOST])  # its template is compiled now
        yield server


def filled(unit: str, size: int) -> str:
    """Whole units: half of a pair of backslashes would take away the quote behind."""
    return unit * (size // len(unit))


def test_a_quadratic_parser_is_found() -> None:
    """The control. From each letter on, the expression reads all that follow."""
    search = re.compile("a*b").search
    with pytest.raises(NotLinear, match="letters: "):
        assert_linear(lambda size: search("a" * size), 2**14, "letters")


@pytest.mark.parametrize(("name", "before"), HEADERS)
def test_headers(server: AsgiServer, name: str, before: str) -> None:
    others = [one for one in (HOST, AUTHORIZED) if one[0] != name]
    after = '"' if before.endswith('"') else ""
    most = HEADER_BYTES - len(before) - 200
    for unit in HEADER_UNITS:
        for method, path in REQUESTS:

            def send(
                size: int, unit: str = unit, method: str = method, path: str = path
            ) -> None:
                value = (before + filled(unit, size) + after).encode("latin-1")
                server.answer(method, path, [*others, (name, value)])

            assert_linear(send, most, f"{method} {path} with {name}: {before}{unit!r}")


@pytest.mark.parametrize(
    "before",
    ["", "a=", "next=", "cursor=", "v=", "page=", "limit=", "runs=", "request_ids="],
)
def test_queries(server: AsgiServer, before: str) -> None:
    for unit in HEADER_UNITS:
        for method, path in REQUESTS:

            def send(
                size: int, unit: str = unit, method: str = method, path: str = path
            ) -> None:
                query = (before + filled(unit, size)).encode("latin-1")
                server.answer(method, path, [HOST, AUTHORIZED], query=query)

            assert_linear(send, URL_BYTES, f"{method} {path}?{before}{unit!r}")


@pytest.mark.parametrize(
    "before", ["/", "/v1/", "/v1/runs/", "/pages/", "/pages/runs/a/", "/eval-server/"]
)
def test_paths(server: AsgiServer, before: str) -> None:
    for unit in HEADER_UNITS:

        def send(size: int, unit: str = unit) -> None:
            server.answer("GET", before + filled(unit, size), [HOST, AUTHORIZED])

        assert_linear(send, URL_BYTES, f"{before}{unit!r}")


@pytest.mark.parametrize("before", ["", "csrf=", "next=/pages", "token="])
@pytest.mark.parametrize("path", ["/pages/login", "/pages/logout"])
def test_forms(server: AsgiServer, path: str, before: str) -> None:
    for unit in UNITS:

        def send(size: int, unit: str = unit) -> None:
            body = (before + filled(unit, size)).encode()[:FORM_BYTES_MAX]
            headers = [HOST, ("content-type", FORM.encode())]
            server.answer("POST", path, headers, body=body)

        assert_linear(send, FORM_BYTES_MAX, f"{path}: {before}{unit!r}")


def test_digits_cost_no_more_than_letters() -> None:
    """Numbers that are almost too long are looked at once, as anything else."""
    size = 2**22
    letters = b"a" * size
    for digits in (1, 154, 308):
        numbers = (b"9" * digits + b",") * (size // (digits + 1))
        for _ in range(5):
            letters_s = work_of(partial(has_unusual_integers, letters))
            numbers_s = work_of(partial(has_unusual_integers, numbers))
            if numbers_s <= 8 * letters_s + FREE_S:
                break
        else:
            pytest.fail(f"{digits} digits: {numbers_s} s, letters: {letters_s} s")


TRUNCATED = msgspec.DecodeError("Input data was truncated")


def _refused(read: Callable[..., object], model: object, data: bytes) -> None:
    with contextlib.suppress(Refused):
        read(model, data, JSON, closed=False)


# Name → what parses bytes, what stands before and after, and the most that is read.
PARSERS: dict[str, tuple[Callable[[bytes], object], str, str, int]] = {
    "text of a chat model": (
        *(lambda data: read_answer(data.decode(errors="replace")), "", ""),
        ANSWER_BYTES_MAX,
    ),
    "marked text of a chat model": (
        *(lambda data: read_answer(data.decode(errors="replace")), "<answer>", ""),
        ANSWER_BYTES_MAX,
    ),
    "answer of a policy server": (
        *(lambda data: _refused(read_structure, models.Predict, data), "", ""),
        ANSWER_BYTES_MAX,
    ),
    "text that is explained": (
        *(lambda data: explain(data, TRUNCATED, is_json=True), '{"a":"', '"', 2**22),
    ),
    "cell of a spreadsheet": (
        *(lambda data: as_cell(data.decode("latin-1")), "", "", 2**20),
    ),
    **{
        f"pickle {code}": (pickle_reader.read, code, "\n.", 2**20)
        for code in ("", "V", "I", "L", "F", "c", "(", "}")
    },
    "archive": (lambda data: read_entries(io.BytesIO(data), len(data)), "", "", 2**22),
    "local header of an archive": (
        *(lambda data: read_entries(io.BytesIO(data), len(data)), "PK\x03\x04", ""),
        2**22,
    ),
    "recording": (
        lambda data: list(McapReader("a", io.BytesIO(data), len(data)).messages()),
        *(MAGIC.decode("latin-1"), "", 2**22),
    ),
    "manifest": (lambda data: read_json("a", data, dict), '{"a":"', '"}', 2**22),
    "manifest of objects": (lambda data: read_json("a", data, dict), "{", "}", 2**22),
    "episodes": (lambda data: list(read_lines([data])), "", "\n", 2**22),
    "episodes in small blocks": (
        lambda data: list(
            read_lines(data[at : at + 512] for at in range(0, len(data), 512))
        ),
        *("", "\n", 2**22),
    ),
    "envelope": (
        lambda data: read_envelope("a", data),
        *('{"payload":"', f'","payloadType":"{PAYLOAD_TYPE}"', 2**22),
    ),
    "checkpoint": (
        lambda data: read_checkpoint(data.decode(errors="replace"), bytes(32)),
        *(f"a\n1\n{'A' * 43}=\n\n— a ", "\n", 2**20),
    ),
}


@pytest.mark.parametrize("name", PARSERS)
def test_parsers(name: str) -> None:
    parse, before, after, most = PARSERS[name]
    for unit in (*UNITS, "\n", "\r", "\x00", "(", "0", "K\x01"):

        def parse_size(size: int, unit: str = unit) -> None:
            text = before + filled(unit, size) + after
            with contextlib.suppress(
                BrokenRecord, pickle_reader.BadPickle, InvalidCheckpoint
            ):
                parse(text.encode("latin-1", errors="replace"))

        assert_linear(parse_size, most, f"{name}: {before}{unit!r}")


def test_directories_of_archives() -> None:
    """Archives of many empty files; the size is their number."""
    archives: dict[int, bytes] = {}

    def read(size: int) -> None:
        if size not in archives:
            contents = [
                (recording_name(index), Content(0, 0, list)) for index in range(size)
            ]
            archives[size] = b"".join(stream_archive(contents))
        data = archives[size]
        assert len(read_entries(io.BytesIO(data), len(data))) == size

    most = 16_000
    for size in (most // SIZE_FACTOR, most):
        read(size)
    assert_linear(read, most, "files")
