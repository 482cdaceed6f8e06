"""Records that are handed in: what is kept, how much, and what a restart does."""

from __future__ import annotations

import contextlib
import json
import sqlite3
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_record.recordings.recording import Turn
from tests.support.paths import ROOT
from tests.support.record.played_records import save_calibration_record
from tests.support.servers import ReferenceServer
from tests.support.sim.calibration_action import calibration_action
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("servers")

VECTORS = ROOT / "spec" / "vectors" / "record"
BROKEN = [
    (VECTORS / one["record"], one["file"], one["rule"])
    for one in json.loads((VECTORS / "records.json").read_text())["records"]
    if one["rule"] is not None
]
ON = {"PROCTOR_RECORD_IMPORTS": "on"}
ZIP = {"Content-Type": "application/zip"}


@pytest.fixture(scope="module")
def archive(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    folder = tmp_path_factory.mktemp("record")
    return save_calibration_record(folder / "r.proctor", folder).read_bytes()


@pytest.fixture
def server(tmp_path: Path) -> Iterator[ReferenceServer]:
    settings = {
        **ON,
        "PROCTOR_MAX_IMPORTED_BYTES": "65536",
        "PROCTOR_MAX_RECORD_BYTES": "65536",
    }
    with ReferenceServer(tmp_path, **settings) as server:
        yield server


def hand_in(client: httpx.Client, content: Any) -> httpx.Response:
    return client.post("/v1/records", content=content, headers=ZIP)


def wait_for_state(client: httpx.Client, import_id: str, state: str) -> dict[str, Any]:
    """The import in this state. It fails at once when the state can no longer come."""
    until = time.monotonic() + 30
    while True:
        one: dict[str, Any] = client.get(f"/v1/records/{import_id}").json()
        if one["state"] == state:
            return one
        assert one["state"] != "finished", one
        assert time.monotonic() < until, one
        time.sleep(0.02)


def finished(client: httpx.Client, import_id: str) -> dict[str, Any]:
    return wait_for_state(client, import_id, "finished")


def kept_files(folder: Path) -> list[str]:
    return sorted(
        p.name for p in (folder / "proctor.sqlite.records.imported").iterdir()
    )


def rows_of_imports(folder: Path) -> int:
    with contextlib.closing(sqlite3.connect(folder / "proctor.sqlite")) as connection:
        (count,) = connection.execute("SELECT count(*) FROM record_imports").fetchone()
    return int(count)


def test_nothing_is_kept_of_a_broken_record(
    server: ReferenceServer, tmp_path: Path
) -> None:
    """Every broken vector is refused with its file and rule (REC-113)."""
    with server.client() as client:
        for path, file, rule in BROKEN:
            refused = hand_in(client, path.read_bytes())
            assert refused.status_code == 422, path.name
            problem = refused.json()
            assert problem["code"] == "record_broken", path.name
            assert problem["requirement"] == rule, path.name
            assert problem["errors"][0]["pointer"] == f"record:{file}", path.name
        assert client.get("/v1/records").json()["imports"] == []
    assert kept_files(tmp_path) == []
    assert rows_of_imports(tmp_path) == 0


def test_nothing_is_kept_of_a_body_that_is_too_long_or_cut(
    server: ReferenceServer, tmp_path: Path, archive: bytes
) -> None:
    def parts(count: int) -> Iterator[bytes]:
        for _ in range(count):
            yield bytes(2**14)

    with server.client() as client:
        assert hand_in(client, bytes(65537)).status_code == 413
        chunked = hand_in(client, parts(5))
        assert (chunked.status_code, chunked.json()["requirement"]) == (413, "REC-126")

        def break_off() -> Iterator[bytes]:
            yield archive[:1000]
            raise InterruptedError

        with pytest.raises(InterruptedError):
            hand_in(client, break_off())
        wrong_type = client.post("/v1/records", content=archive)
        assert wrong_type.status_code == 415
    # An ended request is noticed by the server, not by this test.
    wait_until(lambda: kept_files(tmp_path) == [], "nothing is kept")


def test_an_account_fills_its_space_and_makes_room(
    server: ReferenceServer, tmp_path: Path, archive: bytes
) -> None:
    """REC-122; the space of one account is not that of another one."""
    others = [VECTORS / name for name in ("good.proctor", "good_replayed.proctor")]
    assert len(archive) + sum(p.stat().st_size for p in others) > 65536
    with server.client() as client, server.client("bob") as bob:
        first, second, full = (
            hand_in(client, content)
            for content in (archive, *(path.read_bytes() for path in others))
        )
        assert (first.status_code, second.status_code) == (202, 202)
        assert (full.status_code, full.json()["requirement"]) == (429, "REC-122")
        assert hand_in(client, archive).json()["import_id"] == first.json()["import_id"]
        assert hand_in(bob, archive).status_code == 202
        assert client.delete(first.headers["Location"]).status_code == 204
        assert hand_in(client, others[1].read_bytes()).status_code == 202
    assert len(kept_files(tmp_path)) == 3


def slow_record(folder: Path, turn_s: float) -> bytes:
    """Of six turns that take so long each when they are replayed."""

    def slow(index: int, number: int, turn: Turn) -> Turn:
        del index, number
        turn.actions = [calibration_action(delay_s=turn_s), *turn.actions[1:]]
        return turn

    folder.mkdir()
    return save_calibration_record(folder / "r", folder, slow).read_bytes()


def test_what_is_deleted_in_its_replay_is_gone(tmp_path: Path) -> None:
    """The next one does not wait for it."""
    content = slow_record(tmp_path / "slow", turn_s=20.0)
    good = (VECTORS / "good.proctor").read_bytes()
    with ReferenceServer(tmp_path, **ON) as server, server.client() as client:
        ids = [hand_in(client, one).json()["import_id"] for one in (content, good)]
        assert client.delete(f"/v1/records/{ids[0]}").status_code == 204
        assert finished(client, ids[1])["reason"].startswith("It cannot be replayed")
        listed = client.get("/v1/records").json()["imports"]
        assert [one["import_id"] for one in listed] == ids[1:]
    assert kept_files(tmp_path) == [f"{ids[1]}.proctor"]
