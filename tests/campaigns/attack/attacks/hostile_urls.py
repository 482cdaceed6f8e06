"""URLs of policy servers that lead where the server must not go.

The server has a resolver of the attack's own (`patched_server`): names that turn
private, names of several addresses, slow names. Redirects come from a policy server
at an address that is allowed. No connection may reach another one.
"""

from __future__ import annotations

import socket
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from ipaddress import ip_address

from conformance.policy.scripted_policy import PolicyCall, PolicyReply, ScriptedPolicy
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attacks.process_kills import server_of
from tests.campaigns.players.raw_client import RawClient
from tests.campaigns.players.run_history import Report
from tests.support.push_runs import push_submission

ALLOWED = "127.0.0.3"
SLOW_NAMES = 12
SLOW_BOUND_S = 8.0
SPECIAL = (
    "127.0.0.1", "127.1", "2130706433", "0x7f.1", "0177.0.0.1", "0.0.0.0",  # noqa: S104
    "10.0.0.1", "172.16.0.1", "192.168.1.1", "169.254.169.254", "100.64.0.1",
    "192.0.0.170", "192.0.2.1", "192.88.99.1", "198.18.0.1", "198.51.100.1",
    "203.0.113.1", "224.0.0.1", "240.0.0.1", "255.255.255.255", "localhost",
    "[::]", "[::1]", "[fe80::1]", "[fec0::1]", "[fc00::1]", "[fd12::1]", "[ff02::1]",
    "[2001:db8::1]", "[::ffff:127.0.0.1]", "[::ffff:10.0.0.1]", "[64:ff9b::7f00:1]",
    "[64:ff9b::a9fe:a9fe]", "[64:ff9b:1::7f00:1]", "[2002:7f00:1::1]", "[::7f00:1]",
    "[2001::1]", "[2001:2::1]", "[5f00::1]", "[100::1]",
)  # fmt: skip
# One address after another: at submit, at the first connection, at all others.
NAMES = (
    "127-0-0-1", "169-254-169-254", "_fake--127-0-0-1", "10-0-0-1both127-0-0-3",
    "127-0-0-3--127-0-0-1", "127-0-0-3--127-0-0-3--127-0-0-1",
    "127-0-0-3--127-0-0-3both127-0-0-1", "127-0-0-3--169-254-169-254",
    "127-0-0-3--__1", "127-0-0-3--__ffff_127.0.0.1",
)  # fmt: skip
SYNTAX = (
    "http://127.0.0.3@127.0.0.1:{port}/", "http://127.0.0.1:{port}#@127.0.0.3/",
    "http://127.0.0.3:{port}\\@127.0.0.1/", "http:///127.0.0.1:{port}",
    "file:///etc/passwd", "gopher://127.0.0.1:{port}/x", "ftp://127.0.0.3/",
    "http://127.0.0.1%00.127.0.0.3:{port}", "http://127.0.0.1%2f@127.0.0.3:{port}",
    "http://①②⑦.0.0.1:{port}", "http://127。0。0。1:{port}", "HTTP://127.0.0.1:{port}",
)  # fmt: skip


class Listener:
    """Counts the connections to a port of an address that must not be called."""

    def __init__(self, host: str) -> None:
        self.accepted = 0
        self._socket = socket.create_server((host, 0))
        self.port = self._socket.getsockname()[1]
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            try:
                connection, _ = self._socket.accept()
            except OSError:
                return
            self.accepted += 1
            connection.close()

    def close(self) -> None:
        self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()


def submit_hostile_urls(target: Target) -> Report:
    report, server = Report(), server_of(target)
    with ExitStack() as stack:
        client = stack.enter_context(target.client(30.0))
        listener = Listener("127.0.0.1")
        stack.callback(listener.close)
        port = listener.port
        hosts = [
            *SPECIAL,
            *(f"{name}---{n}.attack.example" for n, name in enumerate(NAMES)),
        ]
        urls = [f"http://{host}:{port}/" for host in hosts]
        urls += [form.format(port=port) for form in SYNTAX]
        runs = [run for url in urls if (run := _submit(client, url, report))]
        runs += _submit_redirects(stack, client, listener, report)
        report.figures["accepted"] = len(runs)
        _wait_until_ended(client, runs, report)
        if listener.accepted:
            report.violations.append(f"{listener.accepted} forbidden connections")
    connected = server.directory / "connections"
    if connected.exists():
        lines = connected.read_text().splitlines()
        bad = [one for one in lines if not ip_address(one.split()[0]).is_global]
        report.violations += [f"a connection to {one}" for one in bad]
    _resolve_slow_names(target, report)
    return report


def _submit(client: RawClient, url: str, report: Report) -> str | None:
    body = push_submission(url, api_key="sesame")
    answer = client.request("POST", "/v1/runs", body)
    report.add_answer(answer)
    return answer.json()["run_id"] if answer.status == 201 else None


def _submit_redirects(
    stack: ExitStack, client: RawClient, listener: Listener, report: Report
) -> list[str]:
    """From the allowed address to the forbidden one, by each status."""
    found = []
    for status in (301, 302, 303, 307, 308):
        policy = stack.enter_context(ScriptedPolicy(ALLOWED))
        location = {"Location": f"http://127.0.0.1:{listener.port}/v1/policy"}

        def elsewhere(
            _: PolicyCall, status: int = status, headers: dict[str, str] = location
        ) -> PolicyReply:
            return PolicyReply(b"", status, headers)

        policy.on("describe_policy", elsewhere)
        if (run := _submit(client, policy.url, report)) is not None:
            found.append(run)
    return found


def _wait_until_ended(client: RawClient, runs: list[str], report: Report) -> None:
    deadline = time.monotonic() + 30
    left = list(runs)
    while left and time.monotonic() < deadline:
        run = client.request("GET", f"/v1/runs/{left[-1]}").json()
        if run["state"] in ("completed", "failed", "stopped"):
            if run["state"] == "completed":
                report.violations.append(f"a run was completed: {run['policy_server']}")
            left.pop()
        else:
            time.sleep(0.02)
    report.violations += [f"run {one} did not end in 30 s" for one in left]


def _resolve_slow_names(target: Target, report: Report) -> None:
    """Names that take 10 s; a fast one of another account is not behind them."""

    def submit(token: str, name: str) -> float:
        began_at = time.monotonic()
        with target.client(60.0, token) as client:
            url = f"http://{name}.attack.example:9/"
            report.add_answer(client.request("POST", "/v1/runs", push_submission(url)))
        return time.monotonic() - began_at

    with ThreadPoolExecutor(SLOW_NAMES + 1) as pool:
        slow = [
            pool.submit(submit, target.token, f"slow{n}") for n in range(SLOW_NAMES)
        ]
        time.sleep(0.5)
        took_s = pool.submit(submit, target.others[0], "127-0-0-1---fast").result()
        report.figures["fast_name_s"] = took_s
        for one in slow:
            one.result()
    if took_s > SLOW_BOUND_S:
        text = f"slow names delayed a name of another account by {took_s:.1f} s"
        report.violations.append(text)


ATTACKS = (
    Attack(
        "hostile urls",
        "special addresses, names that turn private, redirects, slow names",
        "67 URLs, 12 slow names",
        submit_hostile_urls,
        settings={"PROCTOR_ALLOW_PRIVATE_POLICIES": ALLOWED},
        long_size=1,
        is_beside=True,
    ),
)
