"""Records that are handed in to one node of a cluster are records of all."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.record.played_records import save_calibration_record
from tests.support.server.cluster_nodes import Cluster
from tests.support.server.databases import UsedDatabase
from tests.support.waiting import wait_until

ZIP = {"Content-Type": "application/zip"}


@pytest.mark.slow("starts three servers")
def test_a_record_is_handed_in_shown_replayed_and_deleted_at_any_node(
    tmp_path: Path, database: UsedDatabase
) -> None:
    record = save_calibration_record(tmp_path / "r.proctor", tmp_path).read_bytes()
    settings = {
        "PROCTOR_RECORD_IMPORTS": "on",
        # Each node names the cluster, as a signer, by the URL of its readers.
        "PROCTOR_PUBLIC_URL": "http://balancer.example",
    }
    with Cluster.of(tmp_path, database.setting, 3, **settings) as cluster:
        ids = set()
        for client in cluster.clients:  # REC-119: the same archive is the same import
            answer = client.post("/v1/records", content=record, headers=ZIP)
            assert answer.status_code in (200, 202), answer.text
            ids.add(answer.json()["import_id"])
        assert len(ids) == 1
        path = f"/v1/records/{ids.pop()}"
        cluster.kill(0)
        first, second = cluster.clients[1:]

        def is_finished() -> bool:
            return bool(second.get(path).json()["state"] == "finished")

        wait_until(is_finished, "one of those that are left has replayed it")
        shown = [client.get(path).json() for client in (first, second)]
        assert shown[0] == shown[1]
        assert shown[0]["replay"]["result"] == "exact", shown[0]
        lists = [client.get("/v1/records").json() for client in (first, second)]
        assert lists[0] == lists[1]
        assert first.get(f"{path}/archive").content
        assert first.delete(path).status_code == 204
        assert second.get(path).status_code == 404
        left = tmp_path / "records" / ".imported"
        wait_until(lambda: not list(left.glob("*.proctor")), "its file is removed")
