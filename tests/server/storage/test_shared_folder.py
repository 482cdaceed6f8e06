"""What nodes have in common to record, and what late writers leave in their folder."""

from __future__ import annotations

import asyncio
import os
import shutil
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import msgspec
import pytest

from reference_record.recordings.mcap_reader import McapReader
from reference_record.recordings.recording_file import DRAFT_SUFFIX
from reference_server.assembly.node_parts import compare_node, make_node
from reference_server.assembly.run_parts import Secrets
from reference_server.cluster.membership import Membership
from reference_server.files.seed_secret import SeedSecret
from reference_server.http.auth import Tokens
from reference_server.push.key_encryption import KeyEncryption
from reference_server.records import shared_folder
from reference_server.records.recordings import Recordings
from reference_server.records.shared_folder import (
    ID_FILE,
    NODES,
    STARTING_S,
    NotShared,
    check_shared,
    show_node,
    watch_nodes,
)
from reference_server.rules.runs.run import Recording, Result
from reference_server.settings import Settings
from reference_server.storage.node_store import Node, NodeStore
from reference_server.storage.record_store import NotTheNext, RecordStore
from reference_server.storage.runs.run_store import Store
from tests.support.server.databases import UsedDatabase

LEASE_S = 60.0
URLS = "http://127.0.0.1:1", "http://127.0.0.1:2"
FACTS = {
    "recordings": "on",
    "signing_key": "key",
    "host": "host",
    "seed_secret": "digest of a secret",
    "sealing_key": "digest of a key",
    "node_lease_s": str(LEASE_S),
    "version": "1.2",
    "accounts": "not accepted",
}
SECRETS = Secrets(SeedSecret(), KeyEncryption())
ABANDONED = Result("abandoned", 0.0, 1, 0, False, False, 0.0, 1.0)


@asynccontextmanager
async def opened(database: UsedDatabase) -> AsyncIterator[tuple[Store, NodeStore]]:
    store = Store(database.url, is_shared=True)
    await store.open()
    try:
        yield store, NodeStore(store, LEASE_S)
    finally:
        await store.close()


# --- what they have in common ---


async def test_a_node_with_another_folder_is_refused(
    database: UsedDatabase, tmp_path: Path
) -> None:
    """Also when no other node lives, and with a folder of another cluster.

    What it would have in common with others is not stored then.
    """
    right, other = tmp_path / "records", tmp_path / "other"
    async with opened(database) as (_, nodes):
        for url in URLS:
            await check_shared(nodes, url, FACTS, right)
        agreed = await nodes.facts()
        for _again in range(2):
            with pytest.raises(NotShared, match=f"{other} is not the folder") as said:
                await check_shared(nodes, URLS[1], dict.fromkeys(FACTS, "mine"), other)
            assert await nodes.facts() == agreed
            other.mkdir(exist_ok=True)
            (other / ID_FILE).write_text("of another cluster")
        assert (right / ID_FILE).read_text() in str(said.value)
        await check_shared(nodes, URLS[1], FACTS, right)


async def test_a_node_with_a_copy_of_the_folder_is_refused(
    database: UsedDatabase, tmp_path: Path
) -> None:
    """It has the id of the right one, and not what those that live write there."""
    right, copied = tmp_path / "records", tmp_path / "copied"
    async with opened(database) as (_, nodes):
        await check_shared(nodes, URLS[0], FACTS, right)
        shutil.copytree(right, copied)
        show_node(right, "a")
        await nodes.join(Node("a", URLS[0], "secret"))
        with pytest.raises(NotShared, match=f"the node at {URLS[0]}, but a copy"):
            await check_shared(nodes, URLS[1], FACTS, copied)
        for name, age_s in (("killed", STARTING_S + 9), ("starts", 0), ("a", 1e6)):
            show_node(right, name)
            os.utime(right / NODES / name, (0, time.time() - age_s))
        await check_shared(nodes, URLS[1], FACTS, right)
        assert {path.name for path in (right / NODES).iterdir()} == {"a", "starts"}


@pytest.mark.parametrize("place", ["copied", "records"])
async def test_a_node_sees_that_the_others_use_its_folder(
    database: UsedDatabase, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    """A copy that was made while they live has all of their files, as they were."""
    monkeypatch.setattr(shared_folder, "SHOWN_WITHIN_S", 0.5 - LEASE_S)
    right, copied = tmp_path / "records", tmp_path / "copied"
    async with opened(database) as (_, nodes):

        def announce(node_id: str) -> None:
            show_node(right, node_id)

        async def look() -> None:
            await check_shared(nodes, URLS[1], FACTS, tmp_path / place)
            await watch_nodes(nodes, URLS[1], tmp_path / place)

        await check_shared(nodes, URLS[0], FACTS, right)
        member = Membership(
            nodes, URLS[0], LEASE_S, lambda: None, lambda _: None, announce=announce
        )
        await member.open()
        shutil.copytree(right, copied)
        member.start()
        try:
            if place == "records":
                monkeypatch.setattr(shared_folder, "SHOWN_WITHIN_S", 60)
                await look()
            else:
                with pytest.raises(NotShared, match=f"the node at {URLS[0]}, but a c"):
                    await look()
        finally:
            await member.close()
        await look()  # no other node lives


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("recordings", "recordings are .* at this one: set recordings"),
        ("signing_key", "set signing_key to a copy"),
        ("host", "set public_url"),
        ("seed_secret", "another secret than this one would: set seed_secret"),
        ("sealing_key", "another key than this one would: set sealing_key"),
        ("node_lease_s", "would have .* s: set node_lease_s"),
        ("version", "nodes are Proctor .*, and this one is .*: end them all before"),
        ("accounts", "account_service are .* give all nodes the same"),
    ],
)
async def test_a_node_has_the_values_of_those_that_live(
    database: UsedDatabase, tmp_path: Path, name: str, text: str
) -> None:
    """Who is alone may have another value; the next ones need the same."""
    mine = FACTS | {name: "61.0" if name == "node_lease_s" else "other"}
    async with opened(database) as (_, nodes):
        await check_shared(nodes, URLS[0], FACTS, tmp_path)
        await nodes.join(Node("a", URLS[0], "secret"))
        show_node(tmp_path, "a")
        with pytest.raises(NotShared, match=text):
            await check_shared(nodes, URLS[1], mine, tmp_path)
        await check_shared(nodes, URLS[1], FACTS, tmp_path)
        # The same node again, after a crash: its own lease does not stand against it.
        await check_shared(nodes, URLS[0], mine, tmp_path)
        with pytest.raises(NotShared, match=text):
            await check_shared(nodes, URLS[1], FACTS, tmp_path)


async def test_nodes_that_start_at_once_make_one_id(
    database: UsedDatabase, tmp_path: Path
) -> None:
    async def start(url: str) -> None:
        async with opened(database) as (_, nodes):
            await check_shared(nodes, url, FACTS, tmp_path / "records")

    async with opened(database):
        await asyncio.gather(*map(start, URLS))


class StartingNode:
    """A node whose parts are opened up to its part in the cluster.

    used_keys: of all nodes, as they are stored as those that sign.
    """

    def __init__(
        self, store: Store, folder: Path, url: str, keyid: str, used_keys: list[str]
    ) -> None:
        self.url, self.keyid = url, keyid
        self.nodes = NodeStore(store, LEASE_S)
        self.settings = Settings(
            cluster="on",
            node_url=url,
            node_lease_s=LEASE_S,
            public_url="http://host",
            records_dir=str(folder),
        )

        async def use_key() -> None:
            used_keys.append(keyid)

        records = SimpleNamespace(key=SimpleNamespace(keyid=keyid), use_key=use_key)
        node = make_node(self.settings, store, SECRETS, Tokens({}), records)  # type: ignore[arg-type]
        assert node is not None
        self.node = node

    async def check_before(self) -> None:
        """As the program does before it listens."""
        await compare_node(self.nodes, self.url, self.settings, SECRETS, self.keyid)


@pytest.mark.parametrize("join_first", [False, True])
async def test_of_nodes_that_start_at_once_with_two_keys_one_is_refused(
    database: UsedDatabase,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    *,
    join_first: bool,
) -> None:
    """None of them was there when they were compared first.

    join_first: both have joined before either is compared again. Expect that the one
    that is refused leaves at once, and that its key is never stored.
    """
    used_keys: list[str] = []
    async with opened(database) as (store, nodes):
        both = [
            StartingNode(store, tmp_path, url, keyid, used_keys)
            for url, keyid in zip(URLS, ("key 1", "key 2"), strict=True)
        ]
        for one in both:
            await one.check_before()
        if join_first:
            barrier = asyncio.Barrier(2)
            join = NodeStore.join

            async def join_with_other(*given: Any, **named: Any) -> Any:
                joined = await join(*given, **named)
                await barrier.wait()
                return joined

            monkeypatch.setattr(NodeStore, "join", join_with_other)
            starts = [one.node.open() for one in both]
            ends = await asyncio.gather(*starts, return_exceptions=True)
        else:
            ends = []
            for one in both:
                ends += await asyncio.gather(one.node.open(), return_exceptions=True)
        refused = [one for one in ends if one is not None]
        assert len(refused) == 1, ends
        with pytest.raises(NotShared, match=r"this cluster: .* set signing_key"):
            raise refused[0]
        (stays,) = (one for one, end in zip(both, ends, strict=True) if end is None)
        assert used_keys == [stays.keyid]
        assert [one.node.url for one in (await nodes.listed()).values()] == [stays.url]
        await stays.check_before()
        await stays.node.close()


# --- one chain ---


async def test_a_statement_names_the_last_one(database: UsedDatabase) -> None:
    """Expect no second one behind the same, and none of a run that has one."""
    async with opened(database) as (store, _):
        records = RecordStore(store.transactions)
        await records.add_statement("run_1", b"1", "sha of 1", None)
        for late in (None, "sha of 2"):
            with pytest.raises(NotTheNext):
                await records.add_statement("run_2", b"2", "sha of 2", late)
        with pytest.raises(NotTheNext):
            await records.add_statement("run_1", b"again", "sha of it", "sha of 1")
        await records.add_statement("run_2", b"2", "sha of 2", "sha of 1")
        assert await records.last_statement_sha256() == "sha of 2"
        assert await records.find_statement("run_1") == b"1"


async def test_nodes_add_one_statement_after_another(database: UsedDatabase) -> None:
    """Four nodes add five each, and begin again behind what came before."""

    async def sign(node: int) -> None:
        async with opened(database) as (store, _):
            records = RecordStore(store.transactions)
            for number in range(5):
                name = f"{node} {number}"
                while True:
                    last = await records.last_statement_sha256()
                    said = (last or "").encode()
                    try:
                        await records.add_statement(name, said, name, last)
                    except NotTheNext:
                        continue
                    break

    async with opened(database):
        await asyncio.gather(*map(sign, range(4)))
    rows = database.execute("SELECT statement, sha256 FROM statements ORDER BY number")
    assert len(rows) == 20
    assert [bytes(said).decode() for said, _ in rows[1:]] == [s for _, s in rows[:-1]]


# --- recordings of several owners ---


class Owner:
    """A node that owns, or owned, the run `run_1` with a fence."""

    def __init__(self, folder: Path, fence: int) -> None:
        self.recordings = Recordings(folder, is_shared=True)
        self.recordings.open()
        self.episode: Any = SimpleNamespace(index=0, attempt=1, recording="finished")
        self.run: Any = SimpleNamespace(
            run_id="run_1", fence=fence, episodes=[self.episode]
        )

    async def add_fault(self, detail: str) -> None:
        add = self.recordings.add_fault
        add(self.run, self.episode, 0, "simulator_fault", detail)
        await self.recordings.begin(self.run, self.episode)

    async def finish(self) -> Recording:
        return await self.recordings.finish(self.run, self.episode, ABANDONED)

    def path(self) -> Path:
        return self.recordings.path("run_1", 0, self.run.fence)


async def finish_twice(folder: Path, fence: int = 1) -> tuple[Owner, Owner]:
    """The second owner's recording is finished, and then, late, that of the first.

    fence: of the first one; 0 for a server that had the database for itself.
    """
    first, second = Owner(folder, fence), Owner(folder, 12)
    await first.add_fault("before")
    await second.add_fault("after")
    await second.finish()
    before = second.path().read_bytes()
    await first.add_fault("late")
    recording = await first.finish()
    assert (recording.fence, second.path().read_bytes()) == (fence, before)
    for owner in (first, second):
        await owner.recordings.close()
    return first, second


@pytest.mark.parametrize("fence", [0, 1])
def test_an_earlier_owner_changes_no_file_of_a_later_one(
    tmp_path: Path, fence: int
) -> None:
    """What it wrote before is in it, and comes first; what it writes late is not."""
    _, second = asyncio.run(finish_twice(tmp_path, fence))
    path = second.path()
    with path.open("rb") as file:
        messages = list(McapReader(path.name, file, path.stat().st_size).messages())
    faults = [
        msgspec.json.decode(data) for topic, data in messages if topic == "/fault"
    ]
    assert [fault["detail"] for fault in faults] == ["before", "after"]


async def test_parts_of_all_owners_are_removed_when_a_result_is_stored(
    tmp_path: Path,
) -> None:
    first, second = Owner(tmp_path, 1), Owner(tmp_path, 2)
    for owner in (first, second):
        await owner.add_fault("before")
        await owner.finish()
    second.recordings.remove_parts(second.run, {0})
    for owner in (first, second):
        await owner.recordings.close()
    names = {path.name for path in (tmp_path / "run_1").iterdir()}
    assert names == {"00000.fence1.mcap", "00000.fence2.mcap"}


def test_what_late_writers_left_is_removed_from_completed_runs(tmp_path: Path) -> None:
    """A draft is only known to be of no use when the run is completed."""
    _, second = asyncio.run(finish_twice(tmp_path))
    folder, recordings = tmp_path / "run_1", second.recordings
    draft = (folder / "00000.fence1.mcap").with_suffix(DRAFT_SUFFIX)
    draft.touch()
    os.utime(draft, (1.0, 1.0))
    for name in ("00001.fence1.parts", "00002.fence3.draft", "notes.mcap"):
        (folder / name).touch()
    kept = {"00000.fence12.mcap", "00001.fence1.parts", "notes.mcap"}
    recordings.remove_drafts()
    assert draft.exists()
    assert recordings.runs_with_leftovers() == ["run_1"]
    changed_at = folder.stat().st_mtime
    assert recordings.runs_with_leftovers(changed_at) == ["run_1"]
    assert recordings.runs_with_leftovers(changed_at + 1) == []
    recordings.remove_unused("run_1", {0: 12, 2: 3})
    assert {path.name for path in folder.iterdir()} == kept
    assert recordings.runs_with_leftovers() == []


def test_the_id_of_a_folder_is_no_run(tmp_path: Path) -> None:
    (tmp_path / ID_FILE).touch()
    (tmp_path / "run_1").mkdir()
    recordings = Recordings(tmp_path, is_shared=True)
    assert recordings.run_ids() == ["run_1"]
    assert recordings.runs_with_leftovers() == []
