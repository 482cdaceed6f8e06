"""`proctor admin seeds open`: sealed records are replayed when seeds are opened."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_client.command.main import main as proctor
from reference_record.formats.bundle import open_bundle
from reference_record.verification import verify
from reference_server.http.tokens import admin_command as admin
from reference_sim.replay.__main__ import main as replay
from tests.support.server.http_runs import attach, predict_body, worker_path
from tests.support.servers import TIMEOUT_S, ReferenceServer

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
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also the record of a run of a part; both are verified before."""
    monkeypatch.chdir(tmp_path)  # another machine, which does not have the secret
    monkeypatch.setenv("COLUMNS", "200")  # a row of a table is a line
    with ReferenceServer(tmp_path) as server, server.client() as client:
        whole = save_record(client, tmp_path)
        part = save_record(client, tmp_path, select={"splits": ["odd"]})
        server.end(signal.SIGTERM)
    assert [verify(open_bundle(one)).episodes for one in (whole, part)] == [4, 2]
    seeds = tmp_path / "seeds.json"
    opened = ["seeds", "open", "calibration", "--output", str(seeds)]
    words = ["--no-verdict", "--processes", "1"]
    assert replay([str(whole), *words]) == 0
    said = capsys.readouterr().out
    assert "2 of 2 episodes exact" in said
    assert "2 of 4 episodes are of sealed splits: left out" in said
    assert replay([str(part), *words]) == 2
    assert "--seeds" in capsys.readouterr().err
    # From here on, as on the machine of the host.
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    assert replay([str(part), *words]) == 0
    assert "their seeds are drawn with" in capsys.readouterr().out
    assert admin.main(opened) == 0
    assert "2 seeds, of 1 choices of options" in capsys.readouterr().out
    assert admin.main(opened) == 2
    assert "replace it with --force" in capsys.readouterr().err
    words += ["--seeds", str(seeds)]
    assert [replay([str(one), *words]) for one in (whole, part)] == [0, 0]
    said = capsys.readouterr().out
    assert "4 of 4 episodes exact" in said
    assert "2 of 2 episodes exact" in said
    assert f"sealed splits: their seeds are those opened in {seeds}" in said
    assert proctor(["verify", str(whole)]) == 0
    shown = capsys.readouterr().out.splitlines()
    (sealed,) = [line.split(maxsplit=1)[1] for line in shown if line[:6] == "sealed"]
    assert sealed.startswith("2 of 4 episodes: their seeds are the secret of the host")
    assert proctor(["verify", str(whole), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["sealed_episodes"] == 2
    assert replay([str(whole), *words, "--json"]) == 0
    value = json.loads(capsys.readouterr().out)
    assert (value["sealed_episodes"], value["secret_seeds"]) == (2, 0)
    # Another secret opens nothing.
    (tmp_path / "proctor.sqlite.seeds").write_text("00" * 32)
    assert admin.main([*opened, "--force"]) == 2
    said = capsys.readouterr().err
    assert "was played with other seeds" in said
    assert "no run of calibration has sealed seeds that can be opened" in said


@pytest.mark.slow("servers, and simulators in processes of their own")
def test_a_server_replays_sealed_episodes_whose_seeds_were_opened(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of a record that is handed in, in whichever file they are; a server without it
    leaves them out."""
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    with ReferenceServer(tmp_path) as server, server.client() as client:
        whole = save_record(client, tmp_path)
        part = save_record(client, tmp_path, select={"splits": ["odd"]})
        server.end(signal.SIGTERM)
    seeds = tmp_path / "seeds.json"
    assert admin.main(["seeds", "open", "calibration", "--output", str(seeds)]) == 0
    spoilt = tmp_path / "spoilt.json"
    content = json.loads(seeds.read_bytes())
    content["opened"][0]["episodes"][0]["seed"] += 1
    spoilt.write_text(json.dumps(content))
    of_another_host = tmp_path / "other.json"
    content["opened"][0]["seeds_sha256"] = "0" * 64
    of_another_host.write_text(json.dumps(content))
    both = f"{of_another_host}, {seeds}"
    found = {}
    for files in ("", both, str(spoilt)):
        folder = tmp_path / f"of-{Path(files).stem}"
        folder.mkdir()
        on = {"PROCTOR_RECORD_IMPORTS": "on", "PROCTOR_OPENED_SEEDS": files}
        with ReferenceServer(folder, **on) as server, server.client() as client:
            for one in (whole, part):
                found[files, one] = handed_in(client, one.read_bytes())
    with_seeds = [found[both, one] for one in (whole, part)]
    assert [one["replay"]["exact"] for one in with_seeds] == [4, 2]
    assert with_seeds[0]["level_text"].endswith("(exact, 4 of 4 episodes)")
    assert found["", whole]["replay"]["episodes"] == 2
    assert "has no file in which it has opened them" in found["", part]["reason"]
    assert "not those to which the record commits" in found[str(spoilt), part]["reason"]


def handed_in(client: httpx.Client, content: bytes) -> dict[str, Any]:
    """What is shown of a record after its replay."""
    headers = {"Content-Type": "application/zip"}
    taken = client.post("/v1/records", content=content, headers=headers)
    until = time.monotonic() + 30
    while True:
        path = taken.raise_for_status().headers["Location"]
        shown: dict[str, Any] = client.get(path).json()
        if shown["state"] == "finished":
            return shown
        assert time.monotonic() < until, shown
        time.sleep(0.02)


@pytest.mark.slow("starts a server")
def test_a_file_without_opened_seeds_ends_the_start_with_one_line(
    tmp_path: Path,
) -> None:
    (tmp_path / "seeds.json").write_text("{}")
    files = ["--opened-seeds", str(tmp_path / "seeds.json")]
    others = ["--database", str(tmp_path / "x.sqlite"), "--port", "0"]
    done = subprocess.run(
        [sys.executable, "-m", "reference_server", *files, *others],
        capture_output=True,
        text=True,
        check=False,
        timeout=2 * TIMEOUT_S,
    )
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert "cannot use the opened seeds in" in done.stderr


def test_nothing_is_opened_without_a_secret(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    database = tmp_path / "proctor.sqlite"
    database.touch()
    monkeypatch.setenv("PROCTOR_DATABASE", str(database))
    output = ["--output", str(tmp_path / "seeds.json")]
    assert admin.main(["seeds", "open", "calibration", *output]) == 2
    assert "see the setting seed_secret" in capsys.readouterr().err
    (tmp_path / "proctor.sqlite.seeds").write_text("no secret")
    assert admin.main(["seeds", "open", "calibration", *output]) == 2
    assert "hexadecimal" in capsys.readouterr().err
