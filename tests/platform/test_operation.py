"""What administrators see and do: status, use, retention, keys, backup and restore."""

from __future__ import annotations

import asyncio
import contextlib
import os
import re
import sqlite3
import time
from pathlib import Path

import httpx
import pytest

from reference_platform.accounts.organisations import Owner
from reference_platform.command_line import challenge_command
from reference_platform.parts import Parts
from reference_platform.storage.backup import BackupFailed, back_up, restore
from reference_platform.storage.host_status import host_status, uses
from reference_platform.storage.retention import clean
from reference_platform.submissions.lifecycle import Event
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.tracks.track_rules import Phase, Track
from tests.support.platform.approved_accounts import Clock, approved, key_of

DAY_S = 86_400.0


def submitted(parts: Parts, account: str, *events: Event) -> str:
    now = parts.clock()
    phase = Phase("main", "calibration", now, now + 1e7)
    parts.tracks.put(Track("t", "T", (phase,)), "a test")
    parts.tracks.enter("t", Owner(account))
    made = parts.submissions.create(account, "t")
    for event in events:
        parts.submissions.move(made.submission_id, event, digest="sha256:1")
    return made.submission_id


VERIFIED: tuple[Event, ...] = ("upload", "begin_verification", "pass_verification")


@pytest.mark.parametrize(
    ("moves", "why"),
    [
        (1, "waits for a review"),
        (2, "over its deadline"),
        (3, ""),
        (4, "for a place; see --sandboxes"),
    ],
)
async def test_the_status_says_what_is_stuck_and_why(
    parts: Parts, clock: Clock, ada: str, moves: int, why: str
) -> None:
    """A day and a half later."""
    name = submitted(parts, ada, *(*VERIFIED, "start")[:moves])
    assert not host_status(parts, None, {}).stuck
    clock.now += 1.5 * DAY_S
    stuck = host_status(parts, None, {}).stuck
    assert [one.submission.submission_id for one in stuck] == ([name] if why else [])
    assert all(why in one.why for one in stuck)


async def test_the_page_of_an_administrator_shows_it(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    name = submitted(parts, ada, "upload", "begin_verification")
    submission = parts.submissions.get(name)
    parts.submissions.note_use(submission, "verification", 3600.0, 1800.0)
    parts.submissions.move(name, "requeue", reason="It is tried again. Machine <lost>.")
    boss = await approved(parts, "boss", "administrator")
    for account, status in ((ada, 404), (boss, 200)):
        client.cookies.clear()
        cookie = parts.sessions.begin(account, parts.clock())
        client.cookies.set("proctor_hosting", cookie)
        answer = await client.get("/hosting/operation")
        assert answer.status_code == status
    assert "Machine &lt;lost&gt;." in answer.text
    (use, _) = uses(parts, 30)
    assert (use.account, use.submissions, use.sandbox_s, use.cpu_s) == (
        ada, 1, 3600.0, 1800.0,
    )  # fmt: skip
    assert re.search(">1.00</td><td[^>]*>0.50</td>", answer.text)


async def test_old_files_and_secrets_are_removed(
    parts: Parts, clock: Clock, ada: str, tmp_path: Path
) -> None:
    """Those of a submission that has not ended are kept, whatever their age."""
    ended, still_open = submitted(parts, ada, "stop"), submitted(parts, ada, "upload")
    old = clock.now - 20 * DAY_S
    kept = [f"logs/{still_open}.jsonl", "uploads/ada/1", "logs/young.jsonl"]
    gone = [f"logs/{ended}.jsonl", "uploads/ada/2", "uploads/eve/3.part"]
    for name in kept + gone:
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
        os.utime(file, (old, clock.now + 50 * DAY_S if "young" in name else old))
    key_of(parts, ada)
    clock.now += 60 * DAY_S
    young = key_of(parts, ada)
    removed = clean(parts, tmp_path, 90.0, "a test")
    assert not any(removed.values())
    removed = clean(parts, tmp_path, 30.0, "a test")
    assert (removed["logs"], removed["uploads"], removed["keys"]) == (1, 2, 1)
    assert all((tmp_path / name).exists() for name in kept)
    assert not any((tmp_path / name).exists() for name in gone)
    assert parts.keys.find(young, parts.clock())


async def test_a_backup_is_restored_where_nothing_is(
    parts: Parts, ada: str, tmp_path: Path
) -> None:
    """While the platform writes; the same submission, log and key are there again."""
    name, folder = submitted(parts, ada, "upload"), tmp_path / "submissions"
    FileLogs(folder / "logs", lambda _: False).write(name, "platform", "It waits.")
    (folder / "uploads" / "ada").mkdir(parents=True)
    (folder / "uploads" / "ada" / "1").write_bytes(b"code")
    (folder / "roots" / "large").mkdir(parents=True)
    (folder / "presets" / "python").mkdir(parents=True)
    modes = {"uploads": 0o700, "presets": 0o711, "presets/python": 0o755}
    for place, mode in modes.items():
        (folder / place).chmod(mode)
    key, copy = key_of(parts, ada), tmp_path / "backup"
    with parts.database.transaction():  # not finished when the copy begins
        parts.database.execute("UPDATE accounts SET full_name = 'Half'")
        list(back_up(parts.database.path, folder, copy))
    assert "uploads: 1 files, 0 of them new" in [
        *back_up(parts.database.path, folder, copy)
    ]
    assert not (copy / "roots").exists()
    places = tmp_path / "new" / "platform.sqlite", tmp_path / "new" / "submissions"
    list(restore(copy, *places))
    for place, mode in modes.items():  # sandboxes of the new host enter presets
        assert (places[1] / place).stat().st_mode & 0o777 == mode
    restored = Parts.of(places[0], clock=parts.clock)
    assert restored.submissions.get(name) == parts.submissions.get(name)
    assert restored.keys.find(key, parts.clock())
    assert FileLogs(places[1] / "logs", lambda _: False).last_text(name) == "It waits."
    restored.database.close()
    with pytest.raises(BackupFailed, match="exists; move it away"):
        list(restore(copy, *places))
    with pytest.raises(BackupFailed, match="is no backup"):
        list(restore(folder, tmp_path / "a", tmp_path / "b"))


async def test_the_commands_print_what_the_page_shows(
    parts: Parts, ada: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = submitted(parts, ada, "upload")
    FileLogs(tmp_path / "logs", lambda _: False).write(name, "policy", "seed 1234")
    key_id = parts.keys.make(ada, "mine", ("read",), DAY_S, time.time())[0].key_id

    def admin(*words: str) -> str:
        database = ("--database", str(parts.database.path))
        has_files = words[0] in FILES and words[1] != "usage"
        folder = ("--submissions", str(tmp_path)) if has_files else ()
        assert challenge_command.main([*words, *folder, *database]) == 0
        return capsys.readouterr().out

    assert "1 uploaded" in admin("platform", "status")
    assert f"{ada}  " in admin("platform", "usage")
    assert "seed 1234" in admin("submission", "log", name)
    assert key_id in admin("key", "list")
    assert "revoked" in admin("key", "revoke", ada, key_id)
    assert key_id not in admin("key", "list")
    assert f"revoke_key  {ada} {key_id}" in admin("audit")
    assert "uploads" in admin("platform", "clean")
    assert "platform.sqlite" in admin("platform", "backup", str(tmp_path / "copy"))


FILES = ("platform", "submission")


async def test_a_lock_of_another_process_lets_readers_go_on(
    client: httpx.AsyncClient, parts: Parts, ada: str
) -> None:
    """A program writes for a while. Expect reads at once, and a write after it."""
    parts.database.wait_briefly()
    key = {"Authorization": f"Bearer {key_of(parts, ada)}"}
    path = "/v1/hosting/keys"
    with contextlib.closing(sqlite3.connect(parts.database.path)) as other:
        other.execute("BEGIN IMMEDIATE")
        body = {"label": "made later", "scopes": ["read"]}
        writing = asyncio.ensure_future(client.post(path, json=body, headers=key))
        for _ in range(3):
            answer = await client.get(path, headers=key)
            assert answer.status_code == 200
            assert "made later" not in answer.text
        assert not writing.done()
        with pytest.raises(sqlite3.OperationalError, match="locked"):
            await parts.database.until_free(0.05)
        other.rollback()
    assert (await writing).status_code == 201


def test_a_commit_that_fails_leaves_no_transaction_open(parts: Parts) -> None:
    """A reference to no row is refused at the commit. Expect the next write stored."""
    database = parts.database
    for statement in (
        "PRAGMA foreign_keys = ON",
        "CREATE TABLE whole (id INTEGER PRIMARY KEY)",
        "CREATE TABLE part (id INTEGER REFERENCES whole DEFERRABLE INITIALLY DEFERRED)",
    ):
        database.execute(statement)
    with pytest.raises(sqlite3.IntegrityError), database.transaction():
        database.execute("INSERT INTO part VALUES (1)")
    with database.transaction():
        database.execute("INSERT INTO whole VALUES (2)")
    other = sqlite3.connect(database.path)
    with contextlib.closing(other):
        assert other.execute("SELECT * FROM whole").fetchall() == [(2,)]
        assert other.execute("SELECT * FROM part").fetchall() == []
