"""Texts of policy servers in every charset, and greetings in every spelling.

And the errors that they report, on every wire.
"""

import encodings
import pkgutil
import threading
from math import nan
from typing import Any

import numpy as np
import pytest
from websockets.sync.server import ServerConnection

from reference_client.errors import ProctorError
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.server_faults import outline, text_of
from reference_client.policies.servers.server_transport import (
    reporting_repeats,
    route_to,
)
from tests.support.client.policy_wires import (
    READY,
    WIRES,
    answering,
    connected,
    encode,
    observation,
    start_websocket,
    start_wire,
)
from tests.support.servers import TIMEOUT_S

CHARSETS = sorted(module.name for module in pkgutil.iter_modules(encodings.__path__))
BODIES = [b"", b"no model caf\xc3\xa9", b"\xff\xfe\x00", b"xn--a.b..c"]


@pytest.mark.parametrize(
    ("charset", "text"),
    [
        ("utf-8", "läuft"),
        ("latin-1", "lÃ¤uft"),
        *((charset, "läuft") for charset in ("no-such", "rot13", "base64", "a\0b")),
        *((charset, "läuft") for charset in ("idna", "punycode", "undefined", "")),
    ],
)
def test_a_text_is_shown_in_its_charset_or_in_utf_8(charset: str, text: str) -> None:
    assert text_of("läuft".encode(), f"text/plain; charset={charset}") == text


def test_no_charset_of_python_raises() -> None:
    assert {"idna", "undefined", "utf_7"} < set(CHARSETS)
    for charset in CHARSETS:
        for body in BODIES:
            shown = text_of(body, f"text/plain; charset={charset}")
            assert shown or not body.strip(b"\xff\xfe\0"), charset


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ({"p": 1, "q": 2}, {"q": 2, "p": 1}),
        ([{"p": 1, "q": [2, {}]}], [{"q": [2, {}], "p": 1}]),
        ([1, -0.0, 2**53], [1.0, 0, 2.0**53]),
        ([nan, {"low": nan}], [nan, {"low": float("nan")}]),
        ([{"low": np.zeros(2)}], [{"low": (0, 0)}]),
        (np.float32(0.5), 0.5),
    ],
)
def test_a_greeting_in_another_spelling_is_the_first_one_again(
    before: Any, now: Any
) -> None:
    first = FirstGreeting()
    first.check("ws://h", {"assumes": before})
    first.check("ws://h", {"assumes": now})


@pytest.mark.parametrize(
    ("before", "now"),
    [
        ([{"p": 1}], [{"p": 2}]),
        ([{"p": 1}], [{"p": 1, "q": 1}]),
        ([{"p": None}], [{"q": None}]),
        ([1, 2], [2, 1]),
        ([1, 2], [1, 2, 3]),
        (1, True),
        ([False], [0.0]),
        (1, "1"),
        (nan, None),
        ([], [None]),
        (2**53, 2**53 + 1),
        ([{"low": np.zeros(2)}], [{"low": np.ones(2)}]),
    ],
)
def test_a_greeting_with_another_value_is_not(before: Any, now: Any) -> None:
    for one, other in ((before, now), (now, before)):
        first = FirstGreeting()
        first.check("ws://h", {"assumes": one})
        with pytest.raises(ProctorError, match=r"assumes = .* no score is made of two"):
            first.check("ws://h", {"assumes": other})


OUT = "CUDA out of memory"
WITHOUT = "the policy's answer has no "


@pytest.mark.parametrize("name", ["droid", "starvla", "vla_eval", "positronic", "xvla"])
@pytest.mark.parametrize(
    ("answer", "said"),
    [
        ({"error": OUT}, f"failed: {OUT}."),
        ({"exception": OUT}, f"failed: {OUT}."),
        ({"ok": False, "data": {"why": {"message": OUT}}}, f"failed: {OUT}."),
        ({"data": {"error": {"message": OUT}}}, f"says: {OUT}. mapping: {WITHOUT}"),
        ({"code": 500, "msg": OUT}, f"says: {OUT}. mapping: {WITHOUT}"),
        ({"outputs": [{"error": OUT}]}, f"says: {OUT}. mapping: {WITHOUT}"),
        ({"error": ""}, 'but error = ""'),
        ({"code": 7, "out": [1]}, "but code = 7, out"),
        ({}, "but is an empty object"),
    ],
)
def test_each_wire_shows_an_error_wherever_it_stands(
    name: str, answer: Any, said: str
) -> None:
    with (
        answering(name, answer) as reference,
        connected(reference, READY[name]) as policy,
        pytest.raises(ProctorError) as caught,
    ):
        policy.act(observation())
    assert said in caught.value.detail
    assert caught.value.code == "policy_failed"


@pytest.mark.parametrize(
    ("message", "said"),
    [
        ({"a": np.zeros((2, 3), "<f4"), "b": {}}, "{'a': float32 (2, 3), 'b': {}}"),
        ([1, {"n": "x"}], "[1, {'n': 'x'}]"),
        ([0.0] * 80, "a list of 80"),
        ({"data": "x" * 900}, "{'data': 'xxxx"),
    ],
)
def test_a_message_is_described_by_its_names_and_shapes(
    message: Any, said: str
) -> None:
    assert outline(message).startswith(said)
    assert len(outline({f"{i}": message for i in range(99)})) <= 200


class Reporter:
    """Notes the reported waits."""

    def __init__(self) -> None:
        self.waits: list[str | None] = []
        self.is_noted = threading.Event()

    def __call__(self, waiting: str | None, warning: str = "") -> None:
        assert not warning
        self.waits.append(waiting)
        if "is not ready" in str(waiting):
            self.is_noted.set()


@pytest.mark.parametrize("name", sorted(WIRES))
def test_the_first_contact_is_reported_until_it_is_over(name: str) -> None:
    reporter = Reporter()
    with (
        start_wire(name) as (reference, _),
        reporting_repeats(reporter),
        connected(reference, READY[name]),
    ):
        assert "has not answered yet." in str(reporter.waits[0])
        assert reporter.waits[-1] is None


@pytest.mark.parametrize(
    ("report", "said"),
    [
        ({"status": "loading"}, "loading"),
        ({"status": "loading", "progress": 0.5}, "loading"),
        ({"status": "loading", "message": "Checkpoint 7."}, "loading, Checkpoint 7"),
        ({"progress": 0.5}, "{'progress': 0.5}"),
        ("wait", "wait"),
    ],
)
def test_what_a_server_says_that_is_not_ready_is_reported(
    report: Any, said: str
) -> None:
    """It is ready when the report was read."""
    reporter = Reporter()

    def talk(socket: ServerConnection, _log: list[Any]) -> None:
        socket.send(encode(report))
        assert reporter.is_noted.wait(TIMEOUT_S)
        socket.send(encode({"status": "ready", "meta": {"action_fps": 20.0}}))
        socket.recv()

    with start_websocket(talk) as (address, _), reporting_repeats(reporter):
        reference = f"ws://{address}/api/v1/session"
        with connected(reference, READY["positronic"]):
            assert f" is not ready. It says: {said}. It is waited" in str(
                reporter.waits[1]
            )
            assert reporter.waits[-1] is None


@pytest.mark.parametrize("scheme", ["ws", "wss", "http", "https"])
@pytest.mark.parametrize("port", ["99999", "-1", "port"])
def test_a_mistyped_port_is_a_fault_of_the_address(scheme: str, port: str) -> None:
    with pytest.raises(ProctorError, match="has an invalid port: it is a number"):
        route_to(f"{scheme}://host:{port}/act")
