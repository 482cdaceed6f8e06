"""Push runs: the server under test calls the policy server of the kit."""

import contextlib
import ipaddress
import socket
import time
from collections.abc import Iterator
from typing import Any
from urllib.parse import urlsplit

from conformance.client.adaptive_timeouts import GrowingPauses
from conformance.client.check_context import CheckContext
from conformance.client.connections.loopback import loopback
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.policy.scripted_chat import ScriptedChat
from conformance.policy.scripted_policy import ScriptedPolicy
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed, Violation

END_TIMEOUT_S = 15.0
FAULT_TIMEOUT_S = 8.0
ENDED = ("completed", "failed", "stopped")
_FIRST_CALL_TIMEOUT_S = 5.0
_POLL_S = 0.01
_POLL_LONGEST_S = 0.1


@contextlib.contextmanager
def policy_server(context: CheckContext) -> Iterator[ScriptedPolicy]:
    """Serve a policy at an address that the server under test can reach."""
    with ScriptedPolicy(own_address(context.shared.settings.url)) as policy:
        yield policy


@contextlib.contextmanager
def chat_server(context: CheckContext, reply: Any = "1") -> Iterator[ScriptedChat]:
    """Serve a chat model at an address that the server under test can reach."""
    with ScriptedChat(reply, own_address(context.shared.settings.url)) as chat:
        yield chat


def push_body(url: str, *tasks: str, **config: Any) -> dict[str, Any]:
    """Give a body of submit_run; all but `options` are members of policy_server."""
    options = {"tasks": list(tasks or ("score",)), **config.pop("options", {})}
    server = {"url": url, "protocol": "proctor", "call_timeout_s": 5.0}
    server |= {"max_retries": 0} | config
    return CheckContext.submit_body(mode="push", policy_server=server, options=options)


def submit_push_run(
    context: CheckContext, policy: ScriptedPolicy, *tasks: str, **config: Any
) -> RunClient:
    """Submit a run and wait for the first call; SetUpFailed if there is none."""
    body = push_body(policy.url, *tasks, **config)
    before = len(policy.calls)
    answer = context.call("submit_run", json=body)
    require_permitted(answer, policy.url)
    run = context.adopt(expect.require(answer, 201, "`submit_run` with mode push"))
    deadline = time.monotonic() + _FIRST_CALL_TIMEOUT_S
    while len(policy.calls) == before and run.get()["state"] not in ENDED:
        if time.monotonic() > deadline:
            require_place(run)
            raise expect.missed(
                f"a call of the policy server at {policy.url}",
                f"none within {_FIRST_CALL_TIMEOUT_S:g} s in a run that is "
                f"`{run.body['state']}`",
            )
        time.sleep(_POLL_S)
    if len(policy.calls) == before:
        raise SetUpFailed(
            f"server cannot connect to the policy server of the kit at {policy.url}: "
            f"{run.body['reason']}",
            allowed=not is_local(context.shared.settings.url),
        )
    return run


def pointers_of(answer: Answer) -> set[str]:
    """Give the pointers of the errors in a refusal."""
    errors = answer.json.get("errors", []) if isinstance(answer.json, dict) else []
    return {str(error.get("pointer")) for error in errors}


def require_permitted(answer: Answer, url: str) -> None:
    """Raise SetUpFailed when the operator does not allow calls of this URL."""
    if "/policy_server/url" in pointers_of(answer):
        raise SetUpFailed(
            f"server refuses policy servers at {urlsplit(url).hostname}: "
            f"{expect.describe_answer(answer)} "
            "Allow it to call that address (the reference server: "
            f"`--allow-private-policies {urlsplit(url).hostname}`), or let the kit "
            "start the server.",
            allowed=True,
        )


def require_place(run: RunClient) -> None:
    """Require a run that is not queued: a server with few places proves nothing."""
    if run.body["state"] == "queued":
        raise SetUpFailed("the server has no place for a run, which stays `queued`")


def expect_end(run: RunClient, state: str) -> dict[str, Any]:
    """Expect a run to end in a state, and give its body."""
    deadline = time.monotonic() + END_TIMEOUT_S
    pauses = GrowingPauses(_POLL_S, _POLL_LONGEST_S)
    while (body := run.get())["state"] not in ENDED:
        if time.monotonic() > deadline:
            require_place(run)
            raise expect.missed(
                f"a run that becomes `{state}`",
                f"`{body['state']}` after {END_TIMEOUT_S:g} s",
            )
        pauses.wait()
    if body["state"] != state:
        observed = f"a run that is `{body['state']}` ({body['reason']})"
        raise Violation(f"a run that becomes `{state}`", observed)
    return body


def expect_policy_fault(
    run: RunClient, within_s: float = FAULT_TIMEOUT_S
) -> dict[str, Any]:
    """Expect `policy_fault` in the first episode, and give the episode."""
    deadline = time.monotonic() + within_s
    pauses = GrowingPauses(_POLL_S, _POLL_LONGEST_S)
    while "policy_fault" not in (episode := run.episodes()[0]):
        if time.monotonic() > deadline:
            raise expect.missed(
                f"`policy_fault` of an episode within {within_s:g} s",
                expect.format_value(dict(episode)),
            )
        pauses.wait()
    expect.true(episode["policy_fault"], "a text in `policy_fault`")
    return episode


def own_address(url: str) -> str:
    """Give the address of this machine by which the server at a URL can reach it."""
    parts = urlsplit(url)
    if is_local(url):
        host = parts.hostname or ""
        return host if ":" in host else loopback()
    port = parts.port or (443 if parts.scheme == "https" else 80)
    try:
        places = socket.getaddrinfo(parts.hostname, port, type=socket.SOCK_DGRAM)
        family, kind, protocol, _, address = places[0]
        with socket.socket(family, kind, protocol) as probe:
            probe.connect(address)  # sends nothing
            return str(probe.getsockname()[0])
    except OSError as error:
        reason = f"no address of this machine is reachable from {url}: {error}"
        raise SetUpFailed(reason, allowed=True) from error


def is_local(url: str) -> bool:
    host = urlsplit(url).hostname or ""
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return host == "localhost"
