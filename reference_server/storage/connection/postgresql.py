"""PostgreSQL: its driver, its connections and its failures.

asyncpg is the driver. A server with an SQLite file does not need it: it is imported
only when a URL names PostgreSQL.
"""

from __future__ import annotations

import importlib.util
import inspect
import os
import re
from collections.abc import Mapping
from typing import Any

import sqlalchemy as sa
from sqlalchemy.ext.asyncio import AsyncEngine, create_async_engine

from reference_record.command_line.installation import install_command

# Connections of one server; one more holds its lock.
CONNECTIONS_MAX = 10
# Reads at once; the other connections are for writes, which never wait for reads.
READS_MAX = 8
# A node keeps so many connections free of reads, so that its lease and its claims do
# not wait for requests.
FOR_NODES = 2
CONNECT_TIMEOUT_S = 5.0
# Timeouts of a statement, and of a request that waits for a connection.
STATEMENT_TIMEOUT_S, POOL_TIMEOUT_S = 30.0, 10.0
# Timeouts of a node's transaction, which others may wait for: a node that is paused or
# cut off inside of one would keep its locks until it goes on.
NODE_STATEMENT_TIMEOUT_S, NODE_IDLE_TIMEOUT_S = 10.0, 5.0
# How long a claim waits for what such a node locks; it is tried again.
CLAIM_LOCK_TIMEOUT_S = 1.0
# The renewal of a lease over a connection that was lost; a second try is in time.
RENEWAL_TIMEOUT_S = 2.0
# A machine that lost its power, or its network, loses its connections in 25 s: each
# takes one of the places of PostgreSQL, and perhaps holds the lock.
_NOTICES_LOST_CLIENTS = {
    "tcp_keepalives_idle": "10",
    "tcp_keepalives_interval": "5",
    "tcp_keepalives_count": "3",
}
_OPTIONS_OF_SQLALCHEMY = frozenset(
    {"prepared_statement_cache_size", "prepared_statement_name_func"}
)


class MissingDriver(ImportError):
    """asyncpg is not installed; the text says how to install it."""


def with_dialect(url: str) -> str:
    """`postgres://`, which other programs write, is `postgresql://`.

    Several hosts, which other programs write with commas, become options of the URL.
    Raises ArgumentError for a password that would be read as a host. The name of a
    database may have an @, which a / does not follow.
    """
    url = re.sub(r"^postgres(?=:|\+)", "postgresql", url)
    if re.match(r"postgresql[^/]*//[^:/]*:[^@]*@([^/?]*@|[^?]*@[^?]*/)", url):
        raise sa.exc.ArgumentError(
            "the URL has more than one @: write @ as %40 and / as %2F in its password"
        )
    several = re.match(
        r"(postgresql[^/]*//(?:[^@]*@)?)([^/?@]+,[^/?@]+)([/?].*|)$", url
    )
    if several is None:
        return url
    beginning, hosts, rest = several.groups()
    path, _, query = rest.partition("?")
    named = [f"host={host}" for host in hosts.split(",")]
    return f"{beginning}{path}?{'&'.join([*named, *filter(None, [query])])}"


def _hosts_of(url: sa.URL) -> list[tuple[str, str]]:
    """Host and port of each place that the URL names."""
    named = url.query.get("host") or url.host or "localhost"
    default = str(url.port or 5432)
    if isinstance(named, str):
        return [(named, default)]
    split = [host.rpartition(":") for host in named]
    return [
        (host, port) if host and port.isdigit() else (whole, default)
        for (host, _, port), whole in zip(split, named, strict=True)
    ]


def with_driver(url: sa.URL) -> sa.URL:
    """The URL for asyncpg. Raises ArgumentError, MissingDriver."""
    if url.drivername not in ("postgresql", "postgresql+asyncpg"):
        raise sa.exc.ArgumentError(
            f"{url.drivername} is not supported; write postgresql://"
        )
    if importlib.util.find_spec("asyncpg") is None:
        raise MissingDriver(
            "PostgreSQL needs the package asyncpg: "
            f"{install_command('server,postgresql')}"
        )
    import asyncpg

    query = dict(url.query)
    if "sslmode" in query:  # as other programs call it
        query["ssl"] = query.pop("sslmode")
    options = inspect.signature(asyncpg.connect).parameters.keys()
    if unknown := query.keys() - options - _OPTIONS_OF_SQLALCHEMY:
        raise sa.exc.ArgumentError(
            f"the URL has an unknown option {min(unknown)}; see the page of databases"
        )
    return url.set(drivername="postgresql+asyncpg", query=query)


def url_of_programs(url: sa.URL) -> str:
    """The URL as pg_dump and psql read it, without the password."""
    query = dict(url.query)
    if "ssl" in query:
        query["sslmode"] = query.pop("ssl")
    query = {k: v for k, v in query.items() if k not in _OPTIONS_OF_SQLALCHEMY}
    if isinstance(query.get("host"), tuple):  # several: these programs want commas
        hosts, ports = zip(*_hosts_of(url), strict=True)
        query |= {"host": ",".join(hosts), "port": ",".join(ports)}
    plain = sa.URL.create(
        "postgresql", url.username, None, url.host, url.port, url.database, query
    )
    return plain.render_as_string()


def _arguments(
    server_settings: Mapping[str, str] | None = None, **options: Any
) -> dict[str, Any]:
    """Arguments of each connection. asyncpg is imported only here and below."""
    from reference_server.storage.connection import postgresql_hosts

    return {
        "async_creator_fn": postgresql_hosts.connect,
        "server_settings": _NOTICES_LOST_CLIENTS | dict(server_settings or {}),
        **options,
    }


def engine_options(*, is_shared: bool = False) -> dict[str, Any]:
    """Options of the engine for requests. is_shared: other nodes use the database."""
    arguments = _arguments(
        timeout=CONNECT_TIMEOUT_S, command_timeout=STATEMENT_TIMEOUT_S
    )
    if is_shared:
        idle_ms = str(round(NODE_IDLE_TIMEOUT_S * 1000))
        arguments["command_timeout"] = NODE_STATEMENT_TIMEOUT_S
        arguments["server_settings"]["idle_in_transaction_session_timeout"] = idle_ms
    return {
        "pool_size": CONNECTIONS_MAX - (FOR_NODES if is_shared else 0),
        "max_overflow": 0,
        "pool_timeout": POOL_TIMEOUT_S,
        # After a restart of PostgreSQL no request gets a connection of before.
        "pool_pre_ping": True,
        "connect_args": arguments,
    }


def node_engine_options() -> dict[str, Any]:
    """Options of the engine of a node for its lease and its claims of runs."""
    options = engine_options(is_shared=True)
    arguments = options["connect_args"]
    lock_ms = str(round(CLAIM_LOCK_TIMEOUT_S * 1000))
    arguments["server_settings"]["lock_timeout"] = lock_ms
    arguments |= {"timeout": RENEWAL_TIMEOUT_S, "command_timeout": RENEWAL_TIMEOUT_S}
    return options | {"pool_size": FOR_NODES, "pool_timeout": RENEWAL_TIMEOUT_S}


def engine_without_timeout(url: sa.URL) -> AsyncEngine:
    """An engine for long statements; each connection is closed after its use."""
    arguments = _arguments(timeout=CONNECT_TIMEOUT_S)
    return create_async_engine(url, poolclass=sa.NullPool, connect_args=arguments)


def engine_of_lock(url: sa.URL, name: str) -> AsyncEngine:
    """An engine of one connection without transactions. name: shown by PostgreSQL."""
    arguments = _arguments(
        {"application_name": name},
        timeout=CONNECT_TIMEOUT_S,
        command_timeout=STATEMENT_TIMEOUT_S,
    )
    return create_async_engine(
        url,
        poolclass=sa.NullPool,
        isolation_level="AUTOCOMMIT",
        connect_args=arguments,
    )


def code_of(error: Exception) -> str | None:
    """SQLSTATE."""
    return getattr(getattr(error, "orig", None), "sqlstate", None)


def describe(url: sa.URL, error: Exception) -> str:
    """Describe an error for the host in one line, without the password."""
    where = " and ".join(f"{host}:{port}" for host, port in _hosts_of(url))
    code = code_of(error)
    text = " ".join(str(getattr(error, "orig", None) or error).split())
    # SQLAlchemy puts the name of a class before what the server says.
    text = re.sub(r"^<class '[^']*'>: ", "", text)
    if isinstance(error, TimeoutError) and not isinstance(
        error, sa.exc.SQLAlchemyError
    ):
        return f"PostgreSQL at {where} does not answer in time"
    if isinstance(error, OSError):
        return f"there is no PostgreSQL at {where} ({_reason(error)})"
    if "None of the hosts match the target attribute" in text:  # of asyncpg
        return (
            f"none of {where} can be written to: promote a standby, or start the "
            "primary"
        )
    # The driver chooses so, too.
    named = url.query.get("database") or url.database
    name = named or os.environ.get("PGDATABASE") or url.username or ""
    refused = f"PostgreSQL at {where} refuses the user {url.username}: {text}"
    full = f"PostgreSQL at {where} takes no connection: {text}"
    by_code = {
        **dict.fromkeys(("28P01", "28000"), refused),
        **dict.fromkeys(("53300", "57P03"), full),
        "3D000": f"{text} at {where}; create it: createdb {name}",
        "25006": f"PostgreSQL at {where} is a standby, or read-only: name the primary",
    }
    return by_code.get(code or "", text)


def _reason(error: OSError) -> str:
    return error.strerror or str(error).partition("\n")[0]
