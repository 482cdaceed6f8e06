"""Refuses a node that would record, sign or draw seeds apart from the others.

All nodes have one folder of recordings, one name of their host, and equal keys and
secrets; DIFFERENCES has the others. All are stored in the database, secrets as digests.
A node whose own ones differ does not start, and ends when it joins again.

The folder is stored by an id, which a file in the folder contains. A copy of the folder
has the same file. So each node also makes a file there that is named by the id of the
node, and gives it a new time again and again. A node that starts must see that of all
nodes that live. This module knows no HTTP.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import secrets
import time
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from reference_record.formats.private_file import read_or_create
from reference_server.rules.run_owner import NodeRefused, lease_is_over
from reference_server.storage.node_store import ListedNode, Node, NodeStore
from reference_server.storage.runs.run_store import StoreFailed
from reference_server.storage.tables.database_tables import LEASE

ID_FILE = ".folder-id"
# A folder in it, with an empty file for each node, named by its id.
NODES = ".nodes"
# A file that is older, of a node that is not in the list, is removed: it was killed.
STARTING_S = 3600.0
# How long a node that lives may leave its file as it is, and how often it is looked at.
SHOWN_WITHIN_S = 10.0
LOOK_S = 0.05

FOLDER, KEY, HOST = "records_folder", "signing_key", "host"
SEEDS, SEALING, RECORDINGS = "seed_secret", "sealing_key", "recordings"
VERSION, ACCOUNTS = "version", "accounts"
# Name of a value that must be equal on all nodes → why, and what to do.
DIFFERENCES = {
    RECORDINGS: "recordings are {theirs} at the other nodes, and {mine} at this one: "
    "set recordings as there",
    KEY: "the other nodes sign records with {theirs}, and this one would with {mine}: "
    "set signing_key to a copy of their file",
    HOST: "the records of the other nodes are of the host {theirs}, and those of this "
    "one would be of {mine}: set public_url, equal on all nodes",
    SEEDS: "the other nodes draw the seeds of sealed splits with another secret than "
    "this one would: set seed_secret to a copy of their file",
    SEALING: "the other nodes encrypt API keys of policy servers with another key than "
    "this one would: set sealing_key to a copy of their file",
    LEASE: "the other nodes have a lease of {theirs} s, and this one would have {mine} "
    "s: set node_lease_s, equal on all nodes",
    VERSION: "the other nodes are Proctor {theirs}, and this one is {mine}: end them "
    "all before an upgrade, and start one version",
    ACCOUNTS: "keys of an account_service are {theirs} at the other nodes, and {mine} "
    "at this one: give all nodes the same one, which is a program of one machine, or "
    "none",
}


class NotShared(NodeRefused):
    """This node has not what the others have; the text says what to do."""

    def __init__(self, detail: str) -> None:
        super().__init__(f"cannot be a node of this cluster: {detail}")


async def check_shared(
    nodes: NodeStore,
    url: str,
    facts: Mapping[str, str],
    folder: Path | None,
    *,
    storage: str = "",
) -> None:
    """Compare this node with the cluster.

    Before it joins, and whenever it has joined: two nodes that start at the same moment
    do not see each other before, and others may have changed what they agreed on while
    this one was away. url: of this node. facts: its values of DIFFERENCES, which may
    change when no other node lives. folder: of recordings, if it records. storage:
    where finished recordings are, if no folder is shared. Raises NotShared, StoreFailed
    and OSError.
    """
    if folder is not None and not storage:  # with a wrong one, nothing is stored
        _require_folder(folder, await nodes.facts())
    _compare(await nodes.agree_on(facts, url, lasting=()), facts)
    if folder is None:
        return
    if storage:
        agreed = await nodes.agree_on({FOLDER: storage}, url, lasting=())
        if agreed[FOLDER] != storage:
            raise NotShared(
                f"the other nodes keep recordings in {agreed[FOLDER]}, and this one "
                f"would in {storage}: set records_storage, equal on all nodes"
            )
        return
    listed = await nodes.listed()
    _forget_killed(folder, listed)
    agreed = await nodes.facts()
    if FOLDER not in agreed:
        mine = {FOLDER: _read_id(folder) or _make_id(folder)}
        agreed = await nodes.agree_on(mine, url, lasting={FOLDER})
    _require_folder(folder, agreed)
    for node in _others(listed, nodes.lease_s, url):
        if not (folder / NODES / node.node_id).exists():
            raise _is_copy(folder, node.url)


def _others(
    listed: Mapping[str, ListedNode], lease_s: float, url: str
) -> Iterator[Node]:
    """Those that live. url: of this node."""
    for peer in listed.values():
        if peer.node.url != url and not lease_is_over(peer.silent_s, lease_s):
            yield peer.node


def _require_folder(folder: Path, agreed: Mapping[str, str]) -> None:
    if FOLDER in agreed and agreed[FOLDER] != _read_id(folder):
        raise NotShared(
            f"{folder} is not the folder with the recordings of this cluster: set "
            "records_dir to the one that all nodes share; or, if that was lost for "
            f"good, write {agreed[FOLDER]} into {folder / ID_FILE}"
        )


async def watch_nodes(nodes: NodeStore, url: str, folder: Path) -> None:
    """Return when each node that lives has changed its file in this folder meanwhile.

    A copy has the files, as they were. Before this node joins, of which the others do
    not wait then. Raises NotShared, StoreFailed and OSError.
    """
    first: dict[str, int | None] = {}
    until = time.monotonic() + nodes.lease_s + SHOWN_WITHIN_S
    while True:
        unchanged = ""
        for node in _others(await nodes.listed(), nodes.lease_s, url):
            shown_at = _shown_at(folder, node.node_id)
            if shown_at == first.setdefault(node.node_id, shown_at):
                unchanged = node.url
        if not unchanged:
            return
        if time.monotonic() > until:
            raise _is_copy(folder, unchanged)
        await asyncio.sleep(LOOK_S)


def _shown_at(folder: Path, node_id: str) -> int | None:
    """A network file system asks its server when a file is opened."""
    try:
        with (folder / NODES / node_id).open("rb") as file:
            return os.fstat(file.fileno()).st_mtime_ns
    except FileNotFoundError:
        return None


def _is_copy(folder: Path, url: str) -> NotShared:
    return NotShared(
        f"{folder} is not the folder of the node at {url}, but a copy of it, or that "
        "node records nothing: set records_dir and recordings as there"
    )


def show_node(folder: Path, node_id: str) -> None:
    """Give the file of a node a new time; before it joins, too: the others look then.

    Raises StoreFailed.
    """
    try:
        (folder / NODES).mkdir(mode=0o700, parents=True, exist_ok=True)
        (folder / NODES / node_id).touch(mode=0o600)
    except OSError as error:
        raise StoreFailed(f"the folder of recordings: {error}") from error


def _forget_killed(folder: Path, listed: Collection[str]) -> None:
    before = time.time() - STARTING_S
    for path in (folder / NODES).glob("*"):
        with contextlib.suppress(OSError):
            if path.name not in listed and path.stat().st_mtime < before:
                path.unlink()


def _compare(agreed: Mapping[str, str], facts: Mapping[str, str]) -> None:
    """agreed: the values of the cluster. Raises NotShared."""
    for name, difference in DIFFERENCES.items():
        if name in facts and agreed[name] != facts[name]:
            raise NotShared(difference.format(theirs=agreed[name], mine=facts[name]))


def _read_id(folder: Path) -> str | None:
    """The id of the folder; None if no cluster has used the folder."""
    try:
        return (folder / ID_FILE).read_text().strip() or None
    except FileNotFoundError:
        return None


def _make_id(folder: Path) -> str:
    """Two nodes that start at once make one."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    made = secrets.token_hex(16).encode()
    return read_or_create(folder / ID_FILE, lambda: made).decode()
