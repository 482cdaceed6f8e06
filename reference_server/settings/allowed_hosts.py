"""Which host names a request may be sent to: the header Host, which run.endpoint shows.

Without it a client behind a rebound DNS name, or a cache, could spread an endpoint that
is not this server.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from ipaddress import ip_address
from typing import Final

from reference_server.rules.refusal import Refused

_HOST = re.compile(r"([A-Za-z0-9._-]{1,253}|\[[0-9A-Fa-f:.]{2,45}\])(:[0-9]{1,5})?")
_NAME = re.compile(r"(\*\.)?[A-Za-z0-9._-]{1,253}|\[[0-9A-Fa-f:.]{2,45}\]")


@dataclass(frozen=True, slots=True)
class AllowedHosts:
    """Names without ports; `.example.org` stands for every name that ends so."""

    names: frozenset[str] = frozenset()
    suffixes: tuple[str, ...] = ()

    @classmethod
    def parse(cls, text: str) -> AllowedHosts:
        """Comma-separated: `example.org, *.example.org, [::1]`. Raises ValueError."""
        hosts = [name.strip().lower() for name in text.split(",") if name.strip()]
        for name in hosts:
            if not _NAME.fullmatch(name):
                raise ValueError(f"{name!r} is not a host name without port")
        suffixes = [name[1:] for name in hosts if name.startswith("*.")]
        names = [name for name in hosts if not name.startswith("*.")]
        return cls(frozenset(names), tuple(suffixes))

    def __bool__(self) -> bool:
        return bool(self.names or self.suffixes)

    def check(self, host: str) -> None:
        """Refuse a text that is not a host; if there are names, also any other host."""
        match = _HOST.fullmatch(host)
        if match is None:
            raise _refused("must be a host name or an address, and a port if any")
        name = match[1].lower()
        if self and name not in self.names and not name.endswith(self.suffixes):
            # A rebound name is never one of these, and programs of this machine use it.
            if is_loopback(name.strip("[]")):
                return
            raise _refused("is not a name of this server")


ANY_HOST: Final = AllowedHosts()


def is_loopback(host: str) -> bool:
    """Whether an address, or a name, without a port is this machine's own."""
    if host == "localhost":
        return True
    try:
        return ip_address(host).is_loopback
    except ValueError:
        return False


# Who listens there listens at every address, and each machine takes them for itself.
_EVERY_ADDRESS = {"": "127.0.0.1", "0.0.0.0": "127.0.0.1", "::": "::1"}  # noqa: S104


def own_address(host: str) -> str:
    """The address at which this machine reaches its server that listens at `host`."""
    return _EVERY_ADDRESS.get(host, host)


def _refused(detail: str) -> Refused:
    return Refused(
        "invalid_request",
        "The header Host names another server.",
        errors=[("header:host", detail)],
    )
