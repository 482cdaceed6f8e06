"""The servers of the kit listen at addresses of IPv4 and IPv6."""

import httpx
import pytest

from conformance.client.connections import loopback
from conformance.policy.push_run import own_address
from conformance.policy.scripted_policy import ScriptedPolicy


@pytest.mark.parametrize(
    ("host", "place"), [("127.0.0.1", "127.0.0.1"), ("::1", "[::1]")]
)
def test_a_policy_is_served_at_either(host: str, place: str) -> None:
    with ScriptedPolicy(host) as policy:
        assert policy.url.startswith(f"http://{place}:")
        answer = httpx.get(f"{policy.url}/v1/policy", trust_env=False)
    assert answer.status_code == 200


@pytest.mark.parametrize(
    ("url", "address"),
    [
        ("http://127.0.0.1:1", "127.0.0.1"),
        ("http://localhost:1", loopback.loopback()),
        ("http://[::1]:1", "::1"),
    ],
)
def test_a_server_on_this_machine_calls_the_address_that_it_has(
    url: str, address: str
) -> None:
    assert own_address(url) == address
