"""A server with a leaderboard over HTTP: what its host alone may do, who reads it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.server.http_runs import predict_body, submit
from tests.support.servers import TIMEOUT_S, ReferenceServer

pytestmark = pytest.mark.slow("starts servers")
TOKENS = "alice:read+run:alice,host:read+run+host:host"


def client(server: ReferenceServer, token: str | None) -> httpx.Client:
    headers = {} if token is None else {"Authorization": f"Bearer {token}"}
    return httpx.Client(
        base_url=server.url, headers=headers, trust_env=False, timeout=TIMEOUT_S
    )


def publish(http: httpx.Client, success: float) -> dict[str, Any]:
    """The entry of a run of one episode."""
    run_id = submit(http, "score")
    worker = f"/v1/runs/{run_id}/workers/w"
    turn = http.put(worker, json={"attach_key": "k"}).json()
    body = predict_body(turn, score=success, success=success, end=1.0)
    assert http.post(f"{worker}/predict", json=body).status_code == 200
    described = {"model_name": f"model {success:g}", "is_public": True}
    answer = http.put(f"/v1/runs/{run_id}/entry", json=described)
    assert answer.status_code == 201, answer.text
    entry: dict[str, Any] = answer.json()
    return entry


def ranked(http: httpx.Client, manifest: str) -> list[tuple[str, bool, str | None]]:
    """Each row's model, whether it has a rank, and the reason of its flag."""
    path = "/v1/benchmarks/calibration/ranking"
    rows = http.get(path, params={"manifest_sha256": manifest}).json()["rows"]
    return [
        (
            row["entry"]["model_name"],
            "rank" in row,
            row["entry"].get("flag", {}).get("reason"),
        )
        for row in rows
    ]


def test_a_host_flags_entries(tmp_path: Path) -> None:
    """Expect a reason, no rank, a leaf for each change; and no flag by others."""
    with (
        ReferenceServer(tmp_path, PROCTOR_TOKENS=TOKENS) as server,
        client(server, "alice") as alice,
        client(server, "host") as host,
    ):
        best, other = publish(alice, 1), publish(alice, 0)
        manifest = best["manifest_sha256"]
        path = f"/v1/entries/{best['entry_id']}/flag"
        body = {"flagged": True, "reason": "trained on the test"}
        assert alice.put(path, json=body).json()["code"] == "forbidden"
        assert host.put(path, json={"flagged": True}).status_code == 422
        assert host.put(path, json=body).status_code == 200
        assert ranked(alice, manifest) == [
            ("model 0", True, None),
            ("model 1", False, "trained on the test"),
        ]
        shown = alice.get(f"/v1/entries/{best['entry_id']}").json()
        assert shown["flag"]["reason"] == "trained on the test"
        assert host.put(path, json=body | {"flagged": False}).status_code == 200
        assert [one[1] for one in ranked(alice, manifest)] == [True, True]
        leaves = alice.get("/v1/history").json()["leaves"]
        kinds = [
            kind
            for leaf in leaves
            for kind in ("publish", "unflag", "flag")
            if f'"kind":"{kind}"' in leaf["leaf"]
        ]
        assert kinds == ["publish", "publish", "flag", "unflag"]
        unknown = host.put("/v1/entries/entry_1/flag", json=body)
        assert unknown.json()["code"] == "not_found"
        assert other["attempts"] == 2


@pytest.mark.parametrize("setting", ["off", "on"])
def test_who_reads_without_a_token_is_the_host_s_choice(
    tmp_path: Path, setting: str
) -> None:
    with (
        ReferenceServer(tmp_path, PROCTOR_PUBLIC_BOARD=setting) as server,
        client(server, None) as http,
    ):
        offered = http.get("/v1").json()["profiles"]
        assert "board" in offered
        assert ("public_board" in offered) is (setting == "on")
        status = 200 if setting == "on" else 401
        for path in ("/v1/entries", "/v1/history", "/v1/history/checkpoint"):
            assert http.get(path).status_code == status
        # What writes, and what shows runs, needs one always.
        assert http.get("/v1/runs").status_code == 401
        assert http.delete("/v1/runs/run_1/entry").status_code == 401


def test_without_recordings_there_is_no_leaderboard(tmp_path: Path) -> None:
    with (
        ReferenceServer(tmp_path, PROCTOR_RECORDINGS="off") as server,
        client(server, "alice-token") as http,
    ):
        assert "board" not in http.get("/v1").json()["profiles"]
        for path in ("/v1/entries", "/v1/history/checkpoint"):
            answer = http.get(path)
            assert answer.status_code == 404
            assert "no leaderboard" in answer.json()["detail"]
