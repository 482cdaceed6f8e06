"""Nodes that share no folder: what is finished is in object storage, here a folder."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from tests.support.server.cluster_nodes import Cluster, attach, predict
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import submit
from tests.support.waiting import wait_until

ZIP = {"Content-Type": "application/zip"}


def settings(folder: Path) -> dict[str, str]:
    return {
        "PROCTOR_RECORDS_DIR": str(folder / "node{}" / "records"),
        "PROCTOR_RECORDS_STORAGE": (folder / "bucket").as_uri(),
        "PROCTOR_RECORD_IMPORTS": "on",
        "PROCTOR_FAILOVER": "replay",
        "PROCTOR_DELETE_PLAYED_RUNS": "on",
    }


@pytest.mark.slow("starts three servers")
def test_every_node_has_every_record_though_none_shares_a_folder(
    tmp_path: Path, database: UsedDatabase
) -> None:
    bucket = tmp_path / "bucket"
    with Cluster.of(tmp_path, database.setting, 3, **settings(tmp_path)) as cluster:
        first, second, third = cluster.clients
        run_id = submit(first, "score", "score")
        turn = attach(first, run_id)
        turn = predict(first, run_id, turn, score=0.5, end=1).json()
        assert [path.name for path in bucket.glob(f"{run_id}/*")] == [
            "00000.fence1.mcap"
        ], "a result counts when its recording is stored"
        predict(first, run_id, turn, score=1)
        cluster.kill(0)
        shutil.rmtree(tmp_path / "node0" / "records")  # with its machine
        turn = attach(second, run_id)  # what it had played was there alone
        assert turn["episode"]["step"] == 0
        assert turn["episode"]["attempt"] == 1
        assert predict(second, run_id, turn, score=1, end=1).json()["done"]
        record = third.get(f"/v1/runs/{run_id}/record")
        assert record.status_code == 200, record.text
        path = tmp_path / "run.proctor"
        path.write_bytes(record.content)
        assert verify(open_bundle(path)).episodes == 2
        shown = third.get(f"/v1/runs/{run_id}/episodes/e0000/recording")
        assert shown.status_code == 200

        taken = second.post("/v1/records", content=record.content, headers=ZIP).json()
        import_path = f"/v1/records/{taken['import_id']}"

        def is_finished() -> bool:
            return bool(third.get(import_path).json()["state"] == "finished")

        wait_until(is_finished, "it was replayed")
        assert third.get(import_path).json()["replay"]["result"] == "exact"
        for client in (second, third):
            assert client.get(f"{import_path}/archive").status_code == 200
        assert third.delete(import_path).status_code == 204
        assert third.delete(f"/v1/runs/{run_id}").status_code == 204
        wait_until(lambda: not list(bucket.glob("*/*")), "nothing is stored any more")
