"""`proctor admin seeds open`: sealed records are replayed when seeds are opened."""

from __future__ import annotations

import signal
from pathlib import Path

import httpx
import pytest

from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_server.http.tokens import admin_command as admin
from reference_sim.replay.__main__ import main as replay
from tests.support.server.http_runs import attach, predict_body, worker_path
from tests.support.servers import ReferenceServer

TASKS = ["score"] * 4


def save_record(client: httpx.Client, folder: Path, **more: object) -> Path:
    """Of a sealed run, played."""
    body = {
        "benchmark_id": "calibration",
        "policy": {"name": "p"},
        "options": {"tasks": TASKS, "sealed": True},
    }
    answer = client.post("/v1/runs", json=body | more).raise_for_status()
    run_id = answer.json()["run_id"]
    turn = attach(client, run_id)
    while not turn["done"]:
        played = predict_body(turn, score=0.5, end=1)
        path = f"{worker_path(run_id)}/predict"
        turn = client.post(path, json=played).raise_for_status().json()
    saved = folder / f"{run_id}.proctor"
    answer = client.get(f"/v1/runs/{run_id}/record").raise_for_status()
    saved.write_bytes(answer.content)
    return saved


@pytest.mark.slow("a server, and simulators in processes of their own")
def test_sealed_records_are_replayed_when_their_seeds_are_opened(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Also the record of a run of a part; both are verified before."""
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    with ReferenceServer(tmp_path) as server, server.client() as client:
        whole = save_record(client, tmp_path)
        part = save_record(client, tmp_path, select={"splits": ["odd"]})
        server.end(signal.SIGTERM)
    assert [verify(open_bundle(one)).episodes for one in (whole, part)] == [4, 2]
    seeds = tmp_path / "seeds.json"
    opened = ["seeds", "open", "calibration", "--output", str(seeds)]
    words = ["--no-verdict", "--processes", "1"]
    assert replay([str(whole), *words]) == 0
    assert "2 of 2 episodes exact" in capsys.readouterr().out
    assert replay([str(part), *words]) == 2
    assert "--seeds" in capsys.readouterr().err
    assert admin.main(opened) == 0
    assert "2 seeds, of 1 choices of options" in capsys.readouterr().out
    assert admin.main(opened) == 2
    assert "replace it with --force" in capsys.readouterr().err
    words += ["--seeds", str(seeds)]
    assert [replay([str(one), *words]) for one in (whole, part)] == [0, 0]
    said = capsys.readouterr().out
    assert "4 of 4 episodes exact" in said
    assert "2 of 2 episodes exact" in said
    # Another secret opens nothing.
    (tmp_path / "proctor.sqlite.seeds").write_text("00" * 32)
    assert admin.main([*opened, "--force"]) == 2
    said = capsys.readouterr().err
    assert "was played with other seeds" in said
    assert "no run of calibration has sealed seeds that can be opened" in said


def test_nothing_is_opened_without_a_secret(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    output = ["--output", str(tmp_path / "seeds.json")]
    assert admin.main(["seeds", "open", "calibration", *output]) == 2
    assert "see the setting seed_secret" in capsys.readouterr().err
    (tmp_path / "proctor.sqlite.seeds").write_text("no secret")
    assert admin.main(["seeds", "open", "calibration", *output]) == 2
    assert "hexadecimal" in capsys.readouterr().err
