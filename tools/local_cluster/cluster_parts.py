"""All parts of a local cluster, in the order in which they start and end.

Settings that must be equal on all nodes have their defaults here: the database, the
simulators, the token, the keys and the folder of recordings.
"""

import asyncio
import contextlib
import os
import shutil
import socket
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from reference_server.http.tokens import made_token
from tools.local_cluster.balancer import Balancer
from tools.local_cluster.local_postgresql import start_postgresql
from tools.local_cluster.nodes import start_nodes
from tools.local_cluster.part_processes import NotStarted, at_once
from tools.local_cluster.ray_machines import (
    ENVIRONMENT,
    MACHINES,
    PLACES,
    RESOURCES,
    start_ray,
)

SQLITE = "var/proctor.sqlite"
CONNECTIONS_OF_NODE = 20  # to PostgreSQL; a node has 13 at most


@dataclass(frozen=True)
class Plan:
    """The parts to start. The balancer is at the port, the nodes at those behind it.

    database: `sqlite`, or `postgresql` for one of its own. simulators: `local`, or
    `ray` for a Ray cluster of its own. PROCTOR_DATABASE and PROCTOR_SIMULATORS, where
    they are set, are used instead. folder: of PostgreSQL, keys and recordings.
    """

    host: str
    port: int
    nodes: int
    database: str
    simulators: str
    folder: Path

    @property
    def node_ports(self) -> list[int]:
        """So that a restart finds the same addresses."""
        return [self.port + 1 + number for number in range(self.nodes)]


@dataclass
class Parts:
    """The parts that were started. vital: by name, those that all nodes need.

    settings: those of the nodes. lines: a description for people.
    """

    nodes: list[asyncio.subprocess.Process] = field(default_factory=list)
    vital: dict[str, asyncio.subprocess.Process] = field(default_factory=dict)
    settings: dict[str, str] = field(default_factory=dict)
    lines: list[str] = field(default_factory=list)

    def set_default(self, name: str, value: str | Path) -> None:
        """A setting of the nodes that the environment does not have."""
        if not os.environ.get(name):
            self.settings.setdefault(name, str(value))


async def start_cluster(ends: contextlib.AsyncExitStack, plan: Plan) -> Parts:
    """Returns when requests are accepted; `ends` ends all of it. Raises NotStarted."""
    # Before anything is started: another cluster at this address, most often.
    for port in (plan.port, *plan.node_ports):
        try:
            socket.create_server((plan.host, port)).close()
        except OSError as error:
            raise _cannot_listen(plan.host, port, error) from None
    parts = Parts()
    await _start_services(ends, plan, parts)
    balancer = Balancer([(plan.host, port) for port in plan.node_ports])
    ends.push_async_callback(balancer.close)  # after the nodes: they complete answers
    path = _set_files(plan, parts)
    secret = _set_token(parts, path)
    parts.nodes = await start_nodes(ends, plan.node_ports, parts.settings)
    try:
        server = await balancer.listen(plan.host, plan.port)
    except OSError as error:
        raise _cannot_listen(plan.host, plan.port, error) from None
    ends.callback(server.close)
    made_token.publish(server.sockets[0], path if secret else None)
    addresses = ", ".join(
        f"http://{plan.host}:{port} (process {node.pid})"
        for port, node in zip(plan.node_ports, parts.nodes, strict=True)
    )
    url = f"http://{plan.host}:{plan.port}"
    parts.lines = [
        f"A cluster of {plan.nodes} nodes is listening at {url}",
        f"nodes: {addresses}",
        *parts.lines,
        *(
            made_token.startup_lines(secret, path, url)
            if secret
            else made_token.certify_lines(url, "…")
        ),
    ]
    return parts


def _cannot_listen(host: str, port: int, error: OSError) -> NotStarted:
    why = os.strerror(error.errno) if error.errno else str(error)
    return NotStarted(
        f"cannot listen on {host}:{port} ({why}); end what listens there "
        "or choose another port with PROCTOR_PORT"
    )


# --- PostgreSQL and Ray ---


async def _start_services(
    ends: contextlib.AsyncExitStack, plan: Plan, parts: Parts
) -> None:
    """Those that the plan has and the environment does not name, at once."""
    starting = {}
    if plan.simulators == "ray" and not os.environ.get("PROCTOR_SIMULATORS"):
        starting["Ray"] = _start_ray
    if plan.database == "postgresql" and not os.environ.get("PROCTOR_DATABASE"):
        starting["PostgreSQL"] = _start_postgresql
    if not starting:
        return
    print(f"starting {' and '.join(starting)}, then the nodes", file=sys.stderr)
    plan.folder.mkdir(parents=True, exist_ok=True)
    temporary = _make_temporary_folder(ends)
    parts.lines += await at_once(
        *(start(ends, plan, parts, temporary) for start in starting.values())
    )


def _make_temporary_folder(ends: contextlib.AsyncExitStack) -> Path:
    """Removed at the end. Paths of sockets are in it, which are short."""
    folder = Path(tempfile.mkdtemp(prefix="proctor-", dir="/tmp"))
    # The account that PostgreSQL runs as finds its own files in it, and lists none.
    folder.chmod(0o711)
    ends.callback(shutil.rmtree, folder, ignore_errors=True)
    return folder


async def _start_postgresql(
    ends: contextlib.AsyncExitStack, plan: Plan, parts: Parts, temporary: Path
) -> str:
    process, url = await start_postgresql(
        ends, plan.folder, temporary, plan.nodes * CONNECTIONS_OF_NODE
    )
    parts.vital["PostgreSQL"] = process
    parts.settings["PROCTOR_DATABASE"] = url
    return f"PostgreSQL: process {process.pid}, data in {plan.folder / 'postgresql'}"


async def _start_ray(
    ends: contextlib.AsyncExitStack, plan: Plan, parts: Parts, temporary: Path
) -> str:
    process, address = await start_ray(ends, plan.folder, temporary)
    parts.vital["Ray"] = process
    joins = {"PROCTOR_SIMULATORS": "ray", "RAY_ADDRESS": address}
    parts.settings |= ENVIRONMENT | joins
    parts.set_default("PROCTOR_RAY_RESOURCES", RESOURCES)
    return (
        f"Ray: {MACHINES} machines at {address}, each with {PLACES} places for "
        f"simulators, logs in {temporary / 'ray'}"
    )


# --- files that the nodes share ---


def _set_files(plan: Plan, parts: Parts) -> Path:
    """Database, keys and recordings; returns the file of the token."""
    parts.set_default("PROCTOR_DATABASE", SQLITE)
    settings = os.environ | parts.settings
    database, folder = settings["PROCTOR_DATABASE"], plan.folder.absolute()
    if "://" in database:
        records, token = folder / "records", folder / "token"
        parts.set_default("PROCTOR_TOKENS_FILE", folder / "tokens")
        parts.set_default("PROCTOR_SEALING_KEY", folder / "key")
        parts.set_default("PROCTOR_SEED_SECRET", folder / "seeds")
        parts.set_default("PROCTOR_SIGNING_KEY", folder / "signing-key")
    else:  # the nodes find what is beside the file
        records = Path(f"{database}.records").absolute()
        token = Path(f"{database}.token").absolute()
    parts.set_default("PROCTOR_RECORDS_DIR", records)
    if settings.get("PROCTOR_RECORDINGS") != "off":
        parts.set_default("PROCTOR_FAILOVER", "replay")
        parts.set_default("PROCTOR_RECORD_IMPORTS", "on")
    return token


def _set_token(parts: Parts, path: Path) -> str:
    """Returns it; empty where PROCTOR_TOKENS has others. Raises NotStarted."""
    if os.environ.get("PROCTOR_TOKENS"):
        return ""
    try:
        secret = made_token.read_or_make(path)
    except made_token.BadTokenFile as error:
        raise NotStarted(str(error)) from None
    parts.settings["PROCTOR_TOKENS"] = f"local:read+run+host:{secret}"
    return secret
