"""Egress: the addresses this server may connect to when a submitter gives it a URL.

PUSH-015: only public addresses, and networks that the operator allows. A host name is
resolved when the connection is opened, and the connection goes to the address that was
checked: a name that resolves to another address a moment later changes nothing. A
policy that the host itself runs has a name that no resolver knows, and a Unix socket in
a folder of the host. It must not know runs, policies or HTTP.
"""

from __future__ import annotations

import asyncio
import re
import socket
from collections.abc import Iterable
from functools import partial
from ipaddress import IPv4Address, IPv6Network, ip_address, ip_network
from pathlib import Path
from urllib.parse import urlsplit

import httpcore

from reference_server.outgoing.outgoing_streams import OutgoingBackend
from reference_server.push.account_threads import AccountThreads
from reference_server.settings.allowed_networks import Address, AllowedNetworks, Network

# Look-ups at once, of all accounts and of one. The system's resolver blocks a thread,
# for half a minute if a name server does not answer, and cannot be cancelled.
RESOLVER_THREADS = 16
ACCOUNT_THREADS = 2
RESOLVE_S = 10.0
# A hosted policy: http://NAME.sandbox.invalid; NAME is not guessed, and no path.
HOSTED = "sandbox.invalid"
_HOSTED_NAME = re.compile(r"([0-9a-f]{32})\.sandbox\.invalid")
# NAT64: a translator forwards to the IPv4 address in the last 32 bits.
_NAT64 = IPv6Network("64:ff9b::/96")
# All IPv6 addresses that are assigned for public use. Outside of it are other forms of
# IPv4 addresses (of a local translator, IPv4-compatible), which may lead anywhere.
_PUBLIC_6 = IPv6Network("2000::/3")
# Addresses that are not globally reachable by IANA's registries of special-purpose
# addresses, but are missing in `is_global` of some releases of Python.
_SPECIAL: tuple[Network, ...] = tuple(
    ip_network(text)
    for text in (
        "192.0.0.0/24",  # protocol assignments
        "192.88.99.0/24",  # relays of 6to4, deprecated: leads to any of them
        "2001::/23",  # protocol assignments; among them Teredo, which hides an IPv4
        "2001:db8::/32",  # documentation
        "3fff::/20",  # documentation
    )
)


def is_hosted(url: str) -> bool:
    """Whether a URL is that of a policy in a sandbox."""
    return (urlsplit(url).hostname or "").endswith(f".{HOSTED}")


class AddressNotAllowed(Exception):
    """The address is not public, and the operator has not allowed its network."""


class HostNotResolved(Exception):
    """The host name cannot be resolved to an address."""


class EgressPolicy:
    """Decides which addresses may be connected to, and resolves host names.

    allowed: networks that may be called although they are not public, as text (see
    `AllowedNetworks.parse`). sockets: the folder with those of hosted policies.
    Raises ValueError.
    """

    def __init__(self, allowed: str = "", sockets: Path | None = None) -> None:
        self._sockets = sockets
        self._allowed = AllowedNetworks.parse(allowed)
        self._threads = AccountThreads("resolve", RESOLVER_THREADS, ACCOUNT_THREADS)

    def close(self) -> None:
        self._threads.close()

    def allows(self, address: Address) -> bool:
        """PUSH-015: whether the address is public, or in an allowed network."""
        effective = _effective_address(address)
        if self._allowed.contains_any({address, effective}):
            return True
        is_assigned = effective.version == 4 or effective in _PUBLIC_6
        if not is_assigned or any(effective in network for network in _SPECIAL):
            return False
        return effective.is_global and not effective.is_multicast

    def socket_of(self, host: str) -> Path | None:
        """The Unix socket of a hosted policy; None: the host is not one."""
        name = _HOSTED_NAME.fullmatch(host)
        if name is None or self._sockets is None:
            return None
        return self._sockets / f"{name[1]}.sock"

    async def resolve(self, host: str, port: int, account: str = "") -> list[str]:
        """All addresses of a host, each of them allowed.

        account: whose share of the threads a look-up takes.
        Raises AddressNotAllowed when any is not, and HostNotResolved.
        """
        addresses = _literal_address(host) or await self._resolved(host, port, account)
        if not all(self.allows(address) for address in addresses):
            raise AddressNotAllowed(
                f"{host} is not in a network that this server is allowed to call; its "
                "operator allows networks with --allow-private-policies"
            )
        return [str(address) for address in addresses]

    async def _resolved(self, host: str, port: int, account: str) -> list[Address]:
        try:
            async with asyncio.timeout(RESOLVE_S):
                return await self._threads.call(account, partial(_resolve, host, port))
        except TimeoutError as error:
            text = f"{host} is not resolved within {RESOLVE_S:g} s"
            raise HostNotResolved(text) from error
        except (OSError, UnicodeError) as error:
            raise HostNotResolved(f"{host} cannot be resolved") from error


class CheckedBackend(httpcore.AsyncNetworkBackend):
    """Opens httpcore's connections, only to addresses that the egress policy allows.

    PUSH-015: each connection resolves and checks again, whatever was checked before.
    """

    def __init__(self, egress: EgressPolicy, account: str) -> None:
        self._egress = egress
        self._account = account
        self._backend = OutgoingBackend()

    async def connect_tcp(
        self,
        host: str,
        port: int,
        timeout: float | None = None,  # noqa: ASYNC109 - httpcore's interface
        local_address: str | None = None,
        socket_options: Iterable[httpcore.SOCKET_OPTION] | None = None,
    ) -> httpcore.AsyncNetworkStream:
        """Raises AddressNotAllowed, HostNotResolved and httpcore.ConnectError."""
        if path := self._egress.socket_of(host):
            return await self._backend.connect_unix_socket(str(path), timeout)
        failed: Exception | None = None
        for address in await self._egress.resolve(host, port, self._account):
            try:
                return await self._backend.connect_tcp(
                    address, port, timeout, local_address, socket_options
                )
            except (httpcore.ConnectError, httpcore.ConnectTimeout) as error:
                failed = error
        raise failed or HostNotResolved(f"{host} cannot be resolved")

    async def sleep(self, seconds: float) -> None:
        await self._backend.sleep(seconds)


def _literal_address(host: str) -> list[Address]:
    """The address that a host is written as, if it is one; else an empty list."""
    try:
        return [_address(host.removeprefix("[").removesuffix("]"))]
    except ValueError:
        return []


def _resolve(host: str, port: int) -> list[Address]:
    entries = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    return list(dict.fromkeys(_address(str(entry[4][0])) for entry in entries))


def _address(text: str) -> Address:
    # A scope (`fe80::1%eth0`) names an interface of this machine: not part of it.
    return ip_address(str(ip_address(text)).partition("%")[0])


def _effective_address(address: Address) -> Address:
    """The IPv4 address that an IPv6 address stands for, if it does."""
    if isinstance(address, IPv4Address):
        return address
    if address in _NAT64:
        return IPv4Address(int(address) & 0xFFFFFFFF)
    return address.ipv4_mapped or address.sixtofour or address
