"""`proctor board verify` of a server that was given another signing key meanwhile."""

import base64
import signal
from pathlib import Path

import httpx
import pytest

from reference_record.history import checkpoint
from reference_server.http.tokens import admin_command as admin
from tests.support.client.command import Proctor
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import ReferenceServer

pytestmark = pytest.mark.slow("a server that is started twice")


def publish_another(client: httpx.Client, policy: str) -> None:
    run_id = submit(client, "score", policy={"name": policy})
    body = predict_body(attach(client, run_id), score=1, success=1, end=1)
    path = f"{worker_path(run_id)}/predict"
    client.post(path, json=body).raise_for_status()
    described = {"model_name": "m", "is_public": True}
    client.put(f"/v1/runs/{run_id}/entry", json=described).raise_for_status()


def signed_root(client: httpx.Client) -> tuple[str, str, int]:
    """The note of the checkpoint, the keyid of its key, the size of the tree."""
    said = client.get("/v1/history/checkpoint").raise_for_status().json()
    return said["note"], said["keyid"], said["tree_size"]


@pytest.mark.usefixtures("policy_folder")
def test_old_and_new_checkpoints_are_right_and_the_history_only_grew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The retired key stays published, so what it signed can be checked."""
    kept = ["board", "verify", "--state", str(tmp_path / "kept.json")]
    with ReferenceServer(tmp_path) as server, server.client() as client:
        proctor = Proctor(server.url, capsys)
        publish_another(client, "first")
        assert proctor.json(*kept)["key_changed"] is False
        old = signed_root(client)
        server.end(signal.SIGTERM)
        monkeypatch.setenv("PROCTOR_DATABASE", str(server.database_file))
        assert admin.main(["keys", "rotate"]) == 0
        capsys.readouterr()
        server.start()
        publish_another(client, "second")
        new = signed_root(client)
        assert new[1] != old[1]
        listed = client.get("/v1/keys").raise_for_status().json()["keys"]
        keys = {one["keyid"]: base64.b64decode(one["public_key"]) for one in listed}
        for note, keyid, size in (old, new):
            assert checkpoint.read(note, keys[keyid]).tree_size == size
        assert proctor(*kept) == 0
        assert "which the host has retired and still publishes" in proctor.out
        again = proctor.json(*kept)
        assert (again["key_changed"], again["seen_before"]) == (False, new[2])
