"""The reference server with a clock, a resolver and a network of a campaign's own.

`python -m tests.campaigns.patched_server`, with a directory in CAMPAIGN_DIRECTORY:
- its file `clock` holds seconds that the wall clock is wrong by, read at each look;
- a name NAME.attack.example resolves as `Names` says;
- a connection beyond the loopback interface, and the network in CAMPAIGN_NETWORK, is
  written to its file `connections` and refused: no packet leaves this machine.
"""

from __future__ import annotations

import itertools
import os
import socket
import sys
import time
from collections import Counter
from ipaddress import ip_address, ip_network
from pathlib import Path
from typing import Any

DOMAIN = ".attack.example"


class Names:
    """`ADDRESS--ADDRESS….attack.example` has one address after another, then the last.

    An address is written with `-` for `.` (or `_` for `:`); `both` between two means
    that both are given at once. A name that begins with `slow` takes 10 s to resolve.
    """

    def __init__(self) -> None:
        self._seen: Counter[str] = Counter()

    def resolve(self, host: str) -> list[str]:
        name = host.lower().removesuffix(DOMAIN)
        if name.startswith("slow"):
            time.sleep(10)
            return ["127.0.0.1"]
        answers = name.partition("---")[0].split("--")
        self._seen[host] += 1
        answer = answers[min(self._seen[host], len(answers)) - 1]
        return [one.replace("-", ".").replace("_", ":") for one in answer.split("both")]


def _patch_resolver() -> None:
    original, names = socket.getaddrinfo, Names()

    def getaddrinfo(host: Any, port: Any, *rest: Any, **options: Any) -> Any:
        if not isinstance(host, str) or not host.lower().endswith(DOMAIN):
            return original(host, port, *rest, **options)
        found = (original(one, port, *rest, **options) for one in names.resolve(host))
        return list(itertools.chain.from_iterable(found))

    socket.getaddrinfo = getaddrinfo


def _patch_connections(log: Path) -> None:
    original = socket.socket.connect
    allowed = ip_network(os.environ.get("CAMPAIGN_NETWORK", "127.0.0.0/8"))

    def connect(self: socket.socket, address: Any) -> None:
        if self.family in (socket.AF_INET, socket.AF_INET6):
            host = ip_address(address[0].partition("%")[0])
            if not host.is_loopback and host not in allowed:
                with log.open("a") as file:
                    file.write(f"{host} {address[1]}\n")
                raise OSError("the attack lets no connection leave this machine")
        original(self, address)

    setattr(socket.socket, "connect", connect)  # noqa: B010 - a method, for mypy


def _patch_clock(file: Path) -> None:
    original = time.time

    def wrong_time() -> float:
        try:
            return original() + float(file.read_text() or 0)
        except (OSError, ValueError):
            return original()

    time.time = wrong_time


def main() -> int:
    directory = Path(os.environ["CAMPAIGN_DIRECTORY"])
    _patch_resolver()
    _patch_connections(directory / "connections")
    _patch_clock(directory / "clock")
    from reference_server.__main__ import main as serve

    return serve()


if __name__ == "__main__":
    sys.exit(main())
