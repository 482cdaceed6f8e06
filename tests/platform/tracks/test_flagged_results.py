"""Flags at the server of a host, and ranks of the results of its tracks (HST-044)."""

from __future__ import annotations

import asyncio
import sys

import httpx
import pytest

from reference_platform.accounts.organisations import Owner
from tests.support.paths import ROOT
from tests.support.platform.approved_accounts import approved, key_of, quick_parts
from tests.support.platform.hosted_server import TRACK, HostedServer, sign_in
from tests.support.processes import PROGRAM_S, run_program
from tests.support.server.http_runs import (
    attach,
    predict_body,
    submit,
    worker_path,
)

pytestmark = pytest.mark.slow("starts a host")
ONE_TASK = '[phases.options]\ntasks = ["score"]\n'


def keys_of(host: HostedServer) -> list[str]:
    """Of two that have entered the track, and a token of the server's host."""
    parts = quick_parts(host.database)
    keys = []
    for name in ("ada", "eve"):
        asyncio.run(approved(parts, name))
        parts.tracks.enter("letters", Owner(name))
        keys.append(key_of(parts, name, "read", "run"))
    parts.database.close()
    file = host.directory / "proctor.sqlite.tokens"
    words = ("token", "add", "host", "--scopes", "read+run+host", "--file", str(file))
    command = [sys.executable, "-m", "reference_client.command", "admin", *words]
    done = run_program(command, cwd=ROOT, timeout=PROGRAM_S)
    assert done.returncode == 0, done.stderr
    return [*keys, done.stdout.strip()]


def publish(client: httpx.Client, score: float) -> str:
    """The entry of a run of the track with this score."""
    run_id = submit(client, "score")
    body = predict_body(attach(client, run_id), score=score, end=1.0)
    answer = client.post(f"{worker_path(run_id)}/predict", json=body)
    assert answer.status_code == 200, answer.text
    described = {"model_name": f"model {score:g}", "is_public": True}
    answer = client.put(f"/v1/runs/{run_id}/entry", json=described)
    assert answer.status_code == 201, answer.text
    return str(answer.json()["entry_id"])


def order(client: httpx.Client, page: httpx.Client) -> list[tuple[str, str | None]]:
    """The submitters as the page of the track lists them, and who has no rank."""
    answer = client.get("/v1/hosting/tracks/letters/results")
    excluded = {row["submitter"]: row["excluded"] for row in answer.json()["results"]}
    table = page.get("/hosting/tracks/letters").text.partition('id="results"')[2]
    return sorted(excluded.items(), key=lambda row: table.index(f">{row[0]}<"))


def test_a_flag_at_the_server_takes_the_rank_of_a_result(host: HostedServer) -> None:
    """The platform reads each change in the history of its server."""
    host.put_track(TRACK + ONE_TASK)
    of_ada, of_eve, of_host = map(host.client, keys_of(host))
    page = host.client(follow_redirects=True)
    with of_ada, of_eve, of_host, page:
        sign_in(page, "ada", "correct horse")
        publish(of_ada, 0.25)
        entry_id = publish(of_eve, 0.75)
        assert order(of_ada, page) == [("eve", None), ("ada", None)]
        flag = {"flagged": True, "reason": "trained on it"}
        for is_flagged in (True, False):
            body = flag | {"flagged": is_flagged}
            answer = of_host.put(f"/v1/entries/{entry_id}/flag", json=body)
            assert answer.status_code == 200, answer.text
            assert order(of_ada, page) == (
                [("ada", None), ("eve", "flagged")]
                if is_flagged
                else [("eve", None), ("ada", None)]
            )
