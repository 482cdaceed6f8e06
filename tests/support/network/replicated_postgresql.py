"""PostgreSQL on two hosts: a primary, and a standby that can take its place.

A commit waits until the standby has it, so a standby that is promoted lacks nothing
that was acknowledged. Nodes name both hosts and use the one that can be written to.
"""

from typing import Self

from tests.support.network.hosts import Host
from tests.support.server.postgresql_server import (
    LIBFAKETIME,
    PASSWORD,
    PostgresqlServer,
)
from tests.support.waiting import wait_until

PORT = 5432
_HAS_CLOCK = LIBFAKETIME is not None
_FOLLOWS = "SELECT count(*) FROM pg_stat_replication WHERE state = 'streaming'"


class ReplicatedPostgresql:
    """Both run once constructed; as a context manager it removes them at the end."""

    def __init__(self, one: Host, other: Host) -> None:
        self.primary = PostgresqlServer(has_clock=_HAS_CLOCK, host=one)
        self.standby = self._follow(other)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        for server in (self.standby, self.primary):
            server.__exit__()

    def _follow(self, host: Host) -> PostgresqlServer:
        """A new standby of the primary, which commits wait for from now on."""
        standby = PostgresqlServer(
            has_clock=_HAS_CLOCK, host=host, primary=self.primary
        )
        wait_until(self._has_standby, "the standby follows")
        self.primary.wait_for_standby(waits=True)
        return standby

    def _has_standby(self) -> bool:
        return bool(self.primary.execute("postgres", _FOLLOWS)[0][0])

    @property
    def hosts(self) -> tuple[Host, Host]:
        """Those of the primary and of the standby."""
        one, other = self.primary.host, self.standby.host
        assert one is not None
        assert other is not None
        return one, other

    def promote(self) -> None:
        """The standby is the primary from now on. The other one may still run."""
        self.standby.wait_for_standby(waits=False)
        self.standby.execute("postgres", "SELECT pg_promote(true, 60)")
        self.primary, self.standby = self.standby, self.primary

    def replace_standby(self) -> None:
        """In the place of what was the primary before, without its data."""
        _, host = self.hosts
        self.standby.__exit__()
        self.standby = self._follow(host)

    def url(self, user: str, database: str) -> str:
        """The URL for a node, wherever the primary is."""
        hosts = ",".join(f"{host.address}:{PORT}" for host in self.hosts)
        return f"postgresql://{user}:{PASSWORD}@{hosts}/{database}"

    def create(self) -> str:
        """The name of a new, empty database."""
        return self.primary.create().partition("@/")[2].partition("?")[0]
