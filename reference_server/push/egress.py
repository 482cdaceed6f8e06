"""Where this server may connect to when a stranger tells it a URL.

Only to public addresses, and to networks that the operator names. A name is resolved
where the connection is made, and the connection goes to the address that was looked at:
a name that resolves otherwise a moment later changes nothing. Knows nothing of runs.
"""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from ipaddress import (
    IPv4Address,
    IPv4Network,
    IPv6Address,
    IPv6Network,
    ip_address,
    ip_network,
)
from typing import TypeAlias

import httpcore

Address: TypeAlias = IPv4Address | IPv6Address
Network: TypeAlias = IPv4Network | IPv6Network

ALL_NETWORKS = "all"
# A translator would carry what follows these 96 bits into its IPv4 network.
_NAT64 = IPv6Network("64:ff9b::/96")
# All that is given out for use in public. Elsewhere are other forms of IPv4 addresses
# (a local translator's, compatible ones), which end in whatever network there is.
_PUBLIC_6 = IPv6Network("2000::/3")


class AddressNotAllowed(Exception):
    """The address is not public, and the operator has not named its network."""


class HostNotResolved(Exception):
    """The name has no address."""


class EgressPolicy:
    """Says which addresses are connected to.

    allowed: networks, comma-separated (`10.0.0.0/8, 127.0.0.1`), that are admitted
    although they are not public; `all` admits every address. Raises ValueError.
    """

    def __init__(self, allowed: str = "") -> None:
        names = [name.strip() for name in allowed.split(",") if name.strip()]
        self._allows_all = ALL_NETWORKS in names
        self._networks = [ip_network(n) for n in names if n != ALL_NETWORKS]
        # Resolvers block, and a stranger's may take its time: threads of their own.
        self._threads = ThreadPoolExecutor(4, thread_name_prefix="resolve")

    def close(self) -> None:
        self._threads.shutdown(wait=False, cancel_futures=True)

    def allows(self, address: Address) -> bool:
        effective = _effective_address(address)
        if self._allows_all or any(
            _network_has_any(n, {address, effective}) for n in self._networks
        ):
            return True
        is_assigned = effective.version == 4 or effective in _PUBLIC_6
        return is_assigned and effective.is_global and not effective.is_multicast

    async def resolve(self, host: str, port: int) -> list[str]:
        """All addresses of a host, each of them admitted.

        Raises NotAllowed when any is not, and Unresolved.
        """
        found = _literal_address(host) or await self._resolved(host, port)
        if not all(self.allows(address) for address in found):
            raise AddressNotAllowed(
                f"{host} is in a network that this server does not call policies in"
            )
        return [str(address) for address in found]

    async def _resolved(self, host: str, port: int) -> list[Address]:
        loop = asyncio.get_running_loop()
        try:
            return await loop.run_in_executor(self._threads, _resolve, host, port)
        except (OSError, UnicodeError) as error:
            raise HostNotResolved(f"{host} has no address") from error


class CheckedBackend(httpcore.AsyncNetworkBackend):
    """Makes httpcore's connections, to addresses that the gate admits."""

    def __init__(self, egress: EgressPolicy) -> None:
        self._egress = egress
        self._backend = httpcore.AnyIOBackend()

    async def connect_tcp(
        self,
        host: str,
        port: int,
        timeout: float | None = None,  # noqa: ASYNC109 - httpcore's interface
        local_address: str | None = None,
        socket_options: Iterable[httpcore.SOCKET_OPTION] | None = None,
    ) -> httpcore.AsyncNetworkStream:
        """Raises NotAllowed, Unresolved and httpcore.ConnectError."""
        failed: Exception | None = None
        for address in await self._egress.resolve(host, port):
            try:
                return await self._backend.connect_tcp(
                    address, port, timeout, local_address, socket_options
                )
            except (httpcore.ConnectError, httpcore.ConnectTimeout) as error:
                failed = error
        raise failed or HostNotResolved(f"{host} has no address")

    async def sleep(self, seconds: float) -> None:
        await self._backend.sleep(seconds)


def _literal_address(host: str) -> list[Address]:
    """The address that a host is written as: it needs no resolver."""
    try:
        return [_address(host.removeprefix("[").removesuffix("]"))]
    except ValueError:
        return []


def _resolve(host: str, port: int) -> list[Address]:
    found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    return list(dict.fromkeys(_address(str(entry[4][0])) for entry in found))


def _address(text: str) -> Address:
    # A scope (`fe80::1%eth0`) is the machine's own business.
    return ip_address(str(ip_address(text)).partition("%")[0])


def _effective_address(address: Address) -> Address:
    """The IPv4 address that an IPv6 address stands for, if it does."""
    if isinstance(address, IPv4Address):
        return address
    if address in _NAT64:
        return IPv4Address(int(address) & 0xFFFFFFFF)
    return address.ipv4_mapped or address.sixtofour or address


def _network_has_any(network: Network, addresses: set[Address]) -> bool:
    return any(a.version == network.version and a in network for a in addresses)
