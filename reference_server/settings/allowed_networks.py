"""A list of networks that an operator allows or trusts, parsed.

Pure: the standard library's address types and nothing else, so that the settings can
validate a list without importing what opens connections.
"""

from __future__ import annotations

from dataclasses import dataclass
from ipaddress import (
    IPv4Address,
    IPv4Network,
    IPv6Address,
    IPv6Network,
    ip_network,
)
from typing import TypeAlias

Address: TypeAlias = IPv4Address | IPv6Address
Network: TypeAlias = IPv4Network | IPv6Network

ALL_NETWORKS = "all"


@dataclass(frozen=True, slots=True)
class AllowedNetworks:
    """Networks by prefix; `all_addresses` allows every address."""

    networks: tuple[Network, ...] = ()
    all_addresses: bool = False

    @classmethod
    def parse(cls, text: str) -> AllowedNetworks:
        """Comma-separated: `10.0.0.0/8, 127.0.0.1`, or `all`. Raises ValueError."""
        names = [name.strip() for name in text.split(",") if name.strip()]
        networks = [ip_network(name) for name in names if name != ALL_NETWORKS]
        return cls(tuple(networks), ALL_NETWORKS in names)

    def contains_any(self, addresses: set[Address]) -> bool:
        """Whether one of the addresses is in one of the networks."""
        return self.all_addresses or any(
            address.version == network.version and address in network
            for network in self.networks
            for address in addresses
        )
