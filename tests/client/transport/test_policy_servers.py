"""Policy servers behind proxies and TLS, reached as the evaluation server is."""

import re
import threading
import tomllib
from pathlib import Path
from typing import Any

import pytest
from websockets.sync.server import serve

from reference_client import ProctorError
from reference_client.policies import PolicyMapping, load
from reference_client.policies.servers.gr00t.gr00t_client import Gr00tClient
from reference_client.policies.servers.policy_server_client import PolicyServerClient
from tests.support.client.policy_apps import KEY, make_app, run_app
from tests.support.client.policy_wires import (
    READY,
    connected,
    observation,
    play,
    start_http,
    start_wire,
)
from tests.support.network.forward_proxy import run_forward_proxy
from tests.support.server.certificates import create_certificate

pytestmark = pytest.mark.usefixtures("no_proxies")
NAME = "policies.behind.example"
PASSWORD = "user:s3cret@"


def moved_to(host: str, reference: str) -> tuple[str, tuple[str, int]]:
    """The reference with another host, and the address that it had."""
    port = re.findall(r"127\.0\.0\.1:(\d+)", reference)[0]
    return reference.replace("127.0.0.1", host), ("127.0.0.1", int(port))


@pytest.mark.parametrize("name", ["droid", "vla_eval", "positronic", "xvla"])
def test_a_policy_server_plays_through_the_proxy(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with start_wire(name) as (reference, _):
        moved, address = moved_to(NAME, reference)
        with run_forward_proxy({NAME: address}, password=PASSWORD[:-1]) as proxy:
            monkeypatch.setenv("HTTP_PROXY", proxy.url.replace("//", f"//{PASSWORD}"))
            with connected(moved, READY[name]) as policy:
                assert play(policy, "a", "b")
    assert proxy.requests
    assert all(NAME in request for request in proxy.requests)


def test_a_policy_server_of_this_protocol_is_reached_through_the_proxy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("PROCTOR_POLICY_KEY", KEY)
    with run_app(make_app().app) as url:
        moved, address = moved_to(NAME, url)
        with run_forward_proxy({NAME: address}) as proxy:
            monkeypatch.setenv("all_proxy", proxy.url)
            assert PolicyServerClient(moved).described_name() == "counting"
    assert proxy.requests == [f"GET {moved}/v1/policy"]


MAP = """
[observation]
x = { from = "state.gripper" }
[server]
answer_s = 5
[action.values]
gripper = { value = [0] }
"""
SOURCES = {
    "droid": f"openpi:ws://{NAME}:1",
    "vla_eval": f"vla-eval:ws://{NAME}:1",
    "xvla": f"http://{NAME}:1/act",
}


@pytest.mark.parametrize(
    ("variables", "texts"),
    [
        ({}, ["is unreachable (", "; without a proxy: no proxy is set)", "names one"]),
        (
            {"http_proxy": "http://user:s3cret@127.0.0.1:1"},
            [
                "through the proxy http://127.0.0.1:1 of http_proxy (Connection refu",
                f"Correct http_proxy; NO_PROXY={NAME} goes past it",
            ],
        ),
        (
            {"ALL_PROXY": "FREE", "NO_PROXY": ".example"},
            ["without a proxy: NO_PROXY excludes this host"],
        ),
        ({"ALL_PROXY": "socks5://u:s3cret@h:1"}, ["ALL_PROXY names a SOCKS proxy"]),
        ({"http_proxy": "FREE"}, ["502", "the proxy FREE of http_proxy"]),
        (
            {"PROCTOR_PROXY": "WANTS"},
            [
                "reached: the proxy WANTS of PROCTOR_PROXY refused the way to ",
                "Give it in PROCTOR_PROXY=http://USER:PASSWORD@HOST:PORT",
            ],
        ),
    ],
)
@pytest.mark.parametrize("name", SOURCES)
def test_an_error_names_the_way(
    name: str,
    variables: dict[str, str],
    texts: list[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for module in ("websocket_client", "http_policy_client"):
        where = f"reference_client.policies.servers.{module}.FIRST_CONTACT_S"
        monkeypatch.setattr(where, 0.0)
    with (
        run_forward_proxy({NAME: ("127.0.0.1", 1)}) as free,
        run_forward_proxy(password="user:s3cret") as wants,
    ):
        places = {"FREE": free.url, "WANTS": wants.url}
        for variable, value in variables.items():
            monkeypatch.setenv(variable, places.get(value, value))
        with (
            pytest.raises(ProctorError) as caught,
            connected(SOURCES[name], READY[name]),
        ):
            pass
    said = caught.value.detail
    place = SOURCES[name].removeprefix("openpi:").removeprefix("vla-eval:")
    assert said.startswith(f"The policy server at {place} ")
    for text in texts:
        for word, place in places.items():
            text = text.replace(f"{word} of", f"{place} of")  # noqa: PLW2901
        assert text in said
    assert "s3cret" not in said


@pytest.mark.parametrize(
    ("reply", "said"),
    [
        ((403, b"blocked by IT"), "answered 403: blocked by IT; "),
        ((404, b"no"), "answered 404: no; "),
        ((200, b"<html>sign in</html>"), "not JSON with numpy arrays"),
    ],
)
@pytest.mark.parametrize("source", ["http://{}:1/act", "proctor:http://{}:1"])
def test_an_answer_over_http_may_be_that_of_the_proxy(
    source: str, reply: tuple[int, bytes], said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page of the proxy in place of the server's answer. Expect both to be named."""
    for module in ("http_policy_client", "policy_server_client"):
        where = f"reference_client.policies.servers.{module}.FIRST_CONTACT_S"
        monkeypatch.setattr(where, 0.0)

    def talk(path: str, *_: object) -> tuple[int, bytes]:
        is_first = path.startswith("GET") and "/v1" not in path
        return (200, b"") if is_first else reply

    with start_http(talk) as (address, _):
        monkeypatch.setenv("http_proxy", f"http://{address}")
        mapping = None if "proctor" in source else PolicyMapping.of(tomllib.loads(MAP))
        made = load(source.format(NAME), mapping)
        call: Any = getattr(made, "described_name", None)
        with pytest.raises(ProctorError) as caught:
            call() if call else made().act(observation())
    text = caught.value.detail
    proxy = f"the proxy http://{address} of http_proxy may have answered in its place"
    assert f"{proxy} (NO_PROXY={NAME} goes past it)" in text
    if mapping is not None:
        assert said in text
    assert ("PROCTOR_POLICY_KEY" in text) == (reply[0] == 403)


@pytest.mark.parametrize("scheme", ["wss", "https"])
def test_a_certificate_is_accepted_or_its_fault_is_named(
    scheme: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pem, context = create_certificate(tmp_path, "localhost")
    with serve(lambda _: None, "localhost", 0, ssl=context) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"localhost:{server.socket.getsockname()[1]}"
        names = {"wss": ("droid", "openpi:wss"), "https": ("xvla", scheme)}
        name, source = names[scheme]
        with (
            pytest.raises(ProctorError, match="not trusted: The certificate"),
            connected(f"{source}://{address}", READY[name]),
        ):
            pass
        monkeypatch.setenv("PROCTOR_CA", str(pem))
        with (
            pytest.raises(ProctorError, match=r"closed the connection|426|WebSocket"),
            connected(f"{source}://{address}", READY[name]),
        ):
            pass


def test_zeromq_goes_past_proxies(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PROCTOR_PROXY", "http://127.0.0.1:1")
    client = Gr00tClient("127.0.0.1", 9, retry_timeout_s=0.0)
    with pytest.raises(ProctorError, match="ZeroMQ goes past the proxy of PROCTOR_PR"):
        client.begin_episode(None)
