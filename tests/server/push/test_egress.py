"""Egress: only public addresses are called, and those that the operator allows.

A name that resolves to another address later, or a redirect, changes nothing.
"""

import asyncio
import signal
import tempfile
import threading
from collections.abc import Coroutine, Iterator
from ipaddress import ip_address
from pathlib import Path
from typing import Any

import httpx
import pytest

from conformance.policy.scripted_policy import ScriptedPolicy
from reference_server.push import egress
from reference_server.push.calls_with_retries import CallLimits, HttpCalls, PolicyFault
from reference_server.push.egress import (
    AddressNotAllowed,
    EgressPolicy,
    HostNotResolved,
)
from reference_server.settings.allowed_networks import Address
from tests.support.push_runs import push_submission
from tests.support.server.certificates import create_certificate
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_in_loop

PUBLIC = ["93.184.215.14", "1.1.1.1", "2606:4700:4700::1111", "2002:5db8:d70e::1"]
NOT_PUBLIC = [
    "127.0.0.1",
    "127.255.0.9",
    "0.0.0.0",  # noqa: S104 - an address, not a place to listen
    "10.1.2.3",
    "172.16.0.1",
    "192.168.1.1",
    "169.254.169.254",  # where clouds return secrets to every caller inside
    "100.64.0.1",
    "192.0.0.170",
    "192.0.2.1",
    "198.18.0.1",
    "198.51.100.1",
    "224.0.0.1",
    "239.1.1.1",
    "240.0.0.1",
    "255.255.255.255",
    "::",
    "::1",
    "fe80::1",
    "fec0::1",
    "fc00::1",
    "fd12::1",
    "ff02::1",
    "2001:db8::1",
    "::ffff:127.0.0.1",
    "::ffff:10.0.0.1",
    "64:ff9b::7f00:1",
    "64:ff9b::a9fe:a9fe",
    "2002:7f00:1::1",
    "64:ff9b:1::7f00:1",  # a translator's of one's own (RFC 8215)
    "::7f00:1",
    "::ffff:0:7f00:1",
    "192.88.99.1",  # relays of 6to4
    "2002:c058:6301::1",
    "64:ff9b::c058:6301",
    "192.0.0.9",
    "2001::1",  # Teredo: 127.0.0.1 and others can be written so
    "2001:0:7f00:1::",
    "2001:2::1",
    "2001:10::1",
    "3fff::1",
    "5f00::1",
    "100::1",
]


@pytest.mark.parametrize("text", PUBLIC)
def test_public_addresses_are_admitted(text: str) -> None:
    assert EgressPolicy().allows(ip_address(text))


@pytest.mark.parametrize("text", NOT_PUBLIC)
def test_other_addresses_are_refused_unless_allowed(text: str) -> None:
    assert not EgressPolicy().allows(ip_address(text))
    assert not EgressPolicy("203.0.113.0/24").allows(ip_address(text))
    assert EgressPolicy("all").allows(ip_address(text))


def test_a_network_admits_what_it_holds_and_no_more() -> None:
    egress = EgressPolicy("10.0.0.0/8, 127.0.0.1, fd00::/8")
    for text in ("10.9.9.9", "127.0.0.1", "::ffff:127.0.0.1", "fd00::5"):
        assert egress.allows(ip_address(text)), text
    for text in ("127.0.0.2", "192.168.0.1", "::1", "fc00::5"):
        assert not egress.allows(ip_address(text)), text


@pytest.mark.parametrize("text", ["nonsense", "10.0.0.1/8", "10.0.0.0/33", "all,x"])
def test_an_invalid_network_is_an_error(text: str) -> None:
    with pytest.raises(ValueError, match=r"."):
        EgressPolicy(text)


def run(work: Coroutine[Any, Any, Any]) -> Any:
    return asyncio.run(work)


@pytest.mark.parametrize(
    "host", ["localhost", "127.1", "2130706433", "0x7f.1", "0177.0.0.1", "[::1]"]
)
def test_a_name_is_judged_by_what_it_resolves_to(host: str) -> None:
    with pytest.raises(AddressNotAllowed, match="is not in a network"):
        run(EgressPolicy().resolve(host, 80))


@pytest.mark.parametrize("host", ["unknown.invalid", "", "a" * 64 + ".example", "a..b"])
def test_a_name_without_address_is_unresolved(host: str) -> None:
    with pytest.raises((HostNotResolved, AddressNotAllowed)):
        run(EgressPolicy().resolve(host, 80))


def patch_resolver(
    monkeypatch: pytest.MonkeyPatch, *answers: list[str]
) -> list[tuple[str, int]]:
    """Let every name resolve to one answer after the other; the last one stays."""
    left = list(answers)
    resolved_names: list[tuple[str, int]] = []

    def resolve(host: str, port: int) -> list[Address]:
        resolved_names.append((host, port))
        return [ip_address(a) for a in (left.pop(0) if len(left) > 1 else left[0])]

    monkeypatch.setattr(egress, "_resolve", resolve)
    return resolved_names


@pytest.mark.parametrize(
    ("host", "connected_to"),
    [
        ("1.1.1.1", "1.1.1.1"),
        ("[2606:4700::1]", "2606:4700::1"),
        ("2606:4700::1%eth0", "2606:4700::1"),
        ("127.0.0.1", None),
        ("::1", None),
    ],
)
def test_an_address_is_judged_without_a_resolver(
    monkeypatch: pytest.MonkeyPatch, host: str, connected_to: str | None
) -> None:
    """Slow name resolution delays other resolutions only."""
    resolved_names = patch_resolver(monkeypatch, ["9.9.9.9"])
    if connected_to is None:
        with pytest.raises(AddressNotAllowed):
            run(EgressPolicy().resolve(host, 80))
    else:
        assert run(EgressPolicy().resolve(host, 80)) == [connected_to]
    assert resolved_names == []


def test_one_private_address_among_public_ones_refuses_the_name(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    patch_resolver(monkeypatch, ["1.1.1.1", "10.0.0.1"])
    with pytest.raises(AddressNotAllowed):
        run(EgressPolicy().resolve("policy.example", 443))


HOSTED = f"{'0a' * 16}.sandbox.invalid"


@pytest.mark.parametrize(
    ("host", "is_hosted"),
    [
        (HOSTED, True),
        (HOSTED.upper(), False),
        (f"x.{HOSTED}", False),
        (f"{HOSTED}.", False),
        ("..%2f..%2fserver.sandbox.invalid", False),
        ("sandbox.invalid", False),
    ],
)
def test_only_a_name_of_the_host_has_a_socket(
    tmp_path: Path, host: str, is_hosted: bool
) -> None:
    path = EgressPolicy("", tmp_path).socket_of(host)
    assert path == (tmp_path / f"{'0a' * 16}.sock" if is_hosted else None)
    assert EgressPolicy().socket_of(host) is None


def test_a_hosted_policy_is_called_at_its_socket() -> None:
    answer = b"HTTP/1.1 200 OK\r\nContent-Length: 13\r\n"
    answer += b'Content-Type: application/json\r\n\r\n{"name": "a"}'

    async def call(folder: Path) -> Any:
        async def serve(
            reader: asyncio.StreamReader, writer: asyncio.StreamWriter
        ) -> None:
            await reader.readuntil(b"\r\n\r\n")
            writer.write(answer)
            writer.close()

        path = str(folder / f"{'0a' * 16}.sock")
        async with await asyncio.start_unix_server(serve, path):
            return await call_describe(f"http://{HOSTED}", EgressPolicy("", folder))

    # Paths of sockets have at most 107 characters; those of pytest have more.
    with tempfile.TemporaryDirectory() as folder:
        assert run(call(Path(folder))) == {"name": "a"}
        elsewhere = EgressPolicy("", Path(folder, "other"))
        with pytest.raises(PolicyFault, match="unreachable"):
            run(call_describe(f"http://{HOSTED}", elsewhere))


async def call_describe(url: str, egress: EgressPolicy) -> Any:
    async with HttpCalls(
        url, egress, CallLimits(TIMEOUT_S, 1, 0, 10_000), "sesame"
    ) as calls:
        return await calls.get("/v1/policy")


@pytest.fixture
def policy() -> Iterator[ScriptedPolicy]:
    with ScriptedPolicy() as server:
        yield server


@pytest.mark.slow("starts a server")
def test_a_connection_uses_the_address_that_was_checked(
    monkeypatch: pytest.MonkeyPatch, policy: ScriptedPolicy
) -> None:
    """Nothing looks at the name again between the judgement and the connection."""
    resolved_names = patch_resolver(monkeypatch, ["127.0.0.1"], ["10.0.0.1"])
    url = policy.url.replace("127.0.0.1", "policy.example")
    answer = run(call_describe(url, EgressPolicy("127.0.0.1")))
    assert answer["name"] == "policy server of the conformance kit"
    assert [host for host, _ in resolved_names] == ["policy.example"]
    (call,) = policy.calls
    assert call.headers["host"] == url.removeprefix("http://")


def test_a_name_that_turns_private_is_not_connected_to(
    monkeypatch: pytest.MonkeyPatch, policy: ScriptedPolicy
) -> None:
    """Rebinding: public when it was looked at first, this machine afterwards."""
    patch_resolver(monkeypatch, ["1.1.1.1"], ["127.0.0.1"])
    egress = EgressPolicy()
    url = policy.url.replace("127.0.0.1", "policy.example")
    assert run(egress.resolve("policy.example", 80)) == ["1.1.1.1"]
    with pytest.raises(PolicyFault, match=r"is not allowed: policy\.example is not"):
        run(call_describe(url, egress))
    assert policy.calls == []


def test_the_next_address_is_tried(
    monkeypatch: pytest.MonkeyPatch, policy: ScriptedPolicy
) -> None:
    patch_resolver(monkeypatch, ["127.0.0.9", "127.0.0.1"])
    url = policy.url.replace("127.0.0.1", "policy.example")
    assert run(call_describe(url, EgressPolicy("all")))["max_sessions"] == 16


def test_the_key_is_not_sent_to_a_server_without_tls(policy: ScriptedPolicy) -> None:
    """TLS to a server without it: an error is reported, and the key is not sent."""
    with pytest.raises(PolicyFault, match=r"is unreachable|closed the connection"):
        run(call_describe(policy.url.replace("http:", "https:"), EgressPolicy("all")))
    assert policy.calls == []


@pytest.mark.parametrize(
    ("name", "trusted", "reached"),
    [
        ("policy.example", True, True),
        ("other.example", True, False),
        ("policy.example", False, False),
    ],
)
def test_a_certificate_is_verified_against_the_name(
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    name: str,
    trusted: bool,
    reached: bool,
) -> None:
    """The address is pinned, and TLS still asks for who was meant."""
    patch_resolver(monkeypatch, ["127.0.0.1"])
    pem, context = create_certificate(tmp_path, "policy.example")
    if trusted:
        monkeypatch.setenv("SSL_CERT_FILE", str(pem))
    policy = ScriptedPolicy()
    plain = policy._server.socket
    policy._server.socket = context.wrap_socket(plain, server_side=True)
    with policy:
        url = policy.url.replace("http://127.0.0.1", f"https://{name}")
        if reached:
            assert run(call_describe(url, EgressPolicy("all")))["max_sessions"] == 16
        else:
            with pytest.raises(PolicyFault, match="is unreachable"):
                run(call_describe(url, EgressPolicy("all")))
    assert len(policy.calls) == reached


# --- a slow resolver ---


def test_names_that_resolve_slowly_delay_only_their_account(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """One account looks up many names whose name server does not answer."""
    answers = threading.Event()
    began: list[str] = []

    def resolve(host: str, _port: int) -> list[Address]:
        began.append(host)
        if host.startswith("slow"):
            assert answers.wait(2 * TIMEOUT_S)
        return [ip_address("1.1.1.1")]

    async def scenario() -> None:
        policy = EgressPolicy()
        slow = [
            asyncio.ensure_future(policy.resolve(f"slow{n}.example", 80, "alice"))
            for n in range(20)
        ]
        await wait_in_loop(lambda: len(began) == 2)
        try:
            async with asyncio.timeout(TIMEOUT_S):
                found = await policy.resolve("policy.example", 80, "bob")
            assert found == ["1.1.1.1"]
            assert sorted(began[:2]) == ["slow0.example", "slow1.example"]
            assert began[2:] == ["policy.example"]
            slow[0].cancel()  # the request goes away; the thread is still taken
            await asyncio.sleep(0.05)
            assert len(began) == 3
        finally:
            answers.set()
        assert await asyncio.gather(*slow[1:]) == [["1.1.1.1"]] * 19
        policy.close()

    monkeypatch.setattr(egress, "_resolve", resolve)
    run(scenario())


def test_a_name_that_does_not_resolve_in_time_is_unresolved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    answers = threading.Event()
    monkeypatch.setattr(egress, "_resolve", lambda *_: answers.wait(TIMEOUT_S) and [])
    monkeypatch.setattr(egress, "RESOLVE_S", 0.05)
    try:
        with pytest.raises(HostNotResolved, match="is not resolved within"):
            run(EgressPolicy().resolve("slow.example", 80))
    finally:
        answers.set()


# --- a server with nothing allowed ---


@pytest.fixture(scope="module")
def client_without_allowed_networks(
    tmp_path_factory: pytest.TempPathFactory,
) -> Iterator[httpx.Client]:
    server = ReferenceServer(tmp_path_factory.mktemp("client_without_allowed_networks"))
    with server.client() as client:
        yield client
    server.end(signal.SIGKILL)


@pytest.mark.slow("starts a server or a kit")
@pytest.mark.parametrize(
    "url",
    [
        "ftp://example.org",
        "file:///etc/passwd",
        "http://",
        "http://user:secret@example.org",
        "http://example.org/?key=1",
        "http://example.org/#x",
        "http://example.org\r\nX: y",
        "http://exämple.org",
        "http://①②⑦.0.0.1",
        "http://127。0。0。1",
        "http://127.0.0.3@127.0.0.1/",
        "http://127.0.0.3\\@127.0.0.1/",
        "http://127.0.0.1%00.127.0.0.3",
        "http://127.0.0.1%2f@127.0.0.3",
        "HTTP://127.0.0.1",
        "http://example.org:99999",
        "http://example.org:x",
        "//example.org",
        "http://" + "a" * 500,
    ],
)
def test_an_invalid_url_is_refused(
    client_without_allowed_networks: httpx.Client, url: str
) -> None:
    answer = client_without_allowed_networks.post("/v1/runs", json=push_submission(url))
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid_request")
    assert "secret" not in answer.text
    assert {e["pointer"] for e in answer.json()["errors"]} == {"/policy_server/url"}
