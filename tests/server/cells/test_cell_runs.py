"""A whole run on a robot: any client plays, and a person operates."""

from __future__ import annotations

import json
import time
from pathlib import Path
from typing import Any

import pytest

from reference_client import evaluate
from reference_client.command.main import main
from reference_record.formats.bundle import open_bundle
from reference_record.pages.record_documents import read_reported_run
from tests.support.cells.scripted_operator import ScriptedOperator, judgements_of
from tests.support.cells.stop_cases import (
    CELL_ID,
    OPERATOR,
    UNANSWERED,
    Drive,
    StopBench,
)
from tests.support.pages.page_reader import PageReader, fields_of
from tests.support.servers import TOKENS
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts a server, and a robot that plays")


def test_the_result_the_record_and_the_acts_agree(
    bench: StopBench, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A void trial, a stop that is judged, and judgements against the robot's own.

    Expect the score of the person's own count, a record that verifies, and a row that
    says who judged.
    """
    operator = ScriptedOperator(bench, "void", "stop", "success", "failure", "success")
    with operator.working():
        score = evaluate(
            Drive, url=bench.server.url, token=TOKENS["alice"], benchmark=CELL_ID
        )
    assert operator.errors == []
    successes = sum(success for _, success in operator.judged)
    assert (score.counts.total, score.counts.success) == (4, successes) == (4, 2)
    assert score.score == pytest.approx((2 + 2 / 3) / 4)
    with bench.server.client("alice") as client:
        run = f"/v1/runs/{score.run_id}"
        episodes = client.get(f"{run}/episodes").json()["episodes"]
        assert [episode["faults"] for episode in episodes] == [1, 0, 0, 0]
        assert [episode["attempt"] for episode in episodes] == [1] * 4
        record = tmp_path / "run.proctor"
        record.write_bytes(client.get(f"{run}/record").content)
        entry = {"model_name": "Drive", "is_public": True}
        published = client.put(f"{run}/entry", json=entry)
        assert published.json()["score"]["judged_by"] == "people", published.text
    assert main(["verify", str(record)]) == 0
    assert "promise no replay" in " ".join(capsys.readouterr().out.split())
    judged = judgements_of(record)
    assert [said["success"] for said in judged] == [ok for _, ok in operator.judged]
    assert {said["judge"][:6] for said in judged} == {"judge_"}
    assert {(said["note"], said["blind"]) for said in judged} == {("seen", True)}
    assert bench.cell()["voids"]["the light went out"] == 1
    with bench.server.client("alice") as client:
        shown = client.get(run).json()["judged"]
        assert shown["judges"] == [judged[0]["judge"]]
        assert (shown["judgements"], shown["blind"]) == (4, True)
        assert shown["voids"] == {"the light went out": 1}
        assert shown["notes"] == dict.fromkeys(
            [episode["episode_id"] for episode in episodes], "seen"
        )
    login = ["--url", bench.server.url, "--token", TOKENS["alice"]]
    assert main(["results", score.run_id, *login]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "of the simulator" not in said  # a void trial counts as none
    assert f"judged by {judged[0]['judge']}, blind" in said
    assert "void trials 1: the light went out" in said
    assert "e0000: seen" in said
    reported = read_reported_run(open_bundle(record), {})
    for _ in range(2):  # a report reads what it compares once more
        for episode in reported.episodes:
            reported.read(episode)
    assert reported.run["judged"] == shown


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_smoke_test_asks_for_no_trial_that_it_does_not_play(
    bench: StopBench, tmp_path: Path, processes: list[str]
) -> None:
    """Two of four episodes are wanted. Expect two trials, and a free cell."""
    policy = tmp_path / "drive.py"
    policy.write_text("from tests.support.cells.stop_cases import Drive\n")
    login = ["--url", bench.server.url, "--token", TOKENS["alice"]]
    run = ["run", "--policy", f"{policy}:Drive", "--benchmark", CELL_ID, *login]
    before = bench.cell()["trial"] or 0
    operator = ScriptedOperator(bench, "success")
    with operator.working():
        assert main([*run, "--episodes", "2", *processes]) == 0
        wait_until(lambda: bench.cell()["phase"] == "free", "the cell is free")
    assert operator.errors == []
    assert bench.cell()["trial"] - before == len(operator.judged) == 2


def check_unanswered_form(bench: StopBench) -> None:
    """The page of the operator says what is missing, and the trial stays as it is."""
    before = bench.cell() | {"since_s": 0}
    reader, place = PageReader(bench.server.url), f"/pages/cells/{CELL_ID}"
    with reader.client:
        reader.sign_in(OPERATOR)
        form = fields_of(reader.text(place)) | {"act": "judge", "note": "slowly"}
        assert UNANSWERED in reader.client.post(f"{place}/act", data=form).text
    assert bench.cell() | {"since_s": 0} == before


@pytest.mark.parametrize("act", ["judge", "void"])
def test_a_turn_that_comes_after_the_judgement_shows_it(
    bench: StopBench, act: str
) -> None:
    """A stop between turns; the operator goes on before the next turn comes.

    Expect the result of the judgement in that turn, or the attempt again after a void.
    """
    run = bench.begin()
    bench.bring_into("between turns", run)
    bench.act("stop").raise_for_status()
    trial = bench.cell()["trial"]
    check_unanswered_form(bench)
    members: dict[str, Any] = (
        {"success": True} if act == "judge" else {"reason": "dark"}
    )
    bench.act(act, trial=trial, **members).raise_for_status()
    if act == "judge":
        bench.act("next", trial=trial).raise_for_status()
    wait_until(lambda: bench.cell()["phase"] == "free", "the cell is free")
    bench.predict_later(run)
    wait_until(lambda: bench.cell()["phase"] == "preparing", "another trial")
    with bench.server.client("alice") as client:
        first = client.get(f"{run}/episodes").json()["episodes"][0]
    assert first["faults"] == (act == "void")
    assert (first.get("result") or {}).get("outcome") == (
        "success" if act == "judge" else None
    )


@pytest.mark.parametrize("ended_by", ["lease_ended", "detached"])
def test_a_judgement_counts_although_the_client_is_away(
    bench: StopBench, ended_by: str
) -> None:
    """A stop between turns, a judgement, and no other turn of the client.

    Expect its result when the session ends, its recording, and no other attempt.
    """
    run = bench.begin()
    bench.bring_into("between turns", run)
    bench.act("stop").raise_for_status()
    trial = bench.cell()["trial"]
    bench.act("judge", trial=trial, success=False, met=[1]).raise_for_status()
    bench.act("next", trial=trial).raise_for_status()
    with bench.server.client("alice") as client:

        def first() -> Any:
            return client.get(f"{run}/episodes").json()["episodes"][0]

        if ended_by == "detached":
            session = {"session_id": bench._turn["session_id"]}
            client.delete(f"{run}/workers/w", params=session).raise_for_status()
        wait_until(lambda: first()["status"] == "scored", "the attempt is counted")
        result = first()["result"]
        assert (result["outcome"], result["attempt"]) == ("failure", 1)
        assert result["score"] == pytest.approx(1 / 3)
        recording = client.get(f"{run}/episodes/e0000/recording")
        assert b"/judgement" in recording.content


@pytest.mark.parametrize("is_stopped", [False, True])
def test_a_worker_that_attaches_again_has_its_trial(
    bench: StopBench, is_stopped: bool
) -> None:
    """Its client was started again. Expect stops and the judgement as before."""
    run = bench.begin()
    bench.bring_into("between turns", run)
    if is_stopped:
        bench.act("stop").raise_for_status()
    with bench.server.client("alice") as client:
        body = {"attach_key": "n" * 16, "takeover": True}
        answer = client.put(f"{run}/workers/w", json=body)
        bench._turn = answer.raise_for_status().json()
        if not is_stopped:
            bench.act("stop").raise_for_status()
        bench.predict_later(run)
        trial = bench.cell()["trial"]
        bench.act("judge", trial=trial, success=True).raise_for_status()
        bench.act("next", trial=trial).raise_for_status()
        wait_until(lambda: bench.cell()["trial"] == trial + 1, "the next trial")
        episodes = client.get(f"{run}/episodes").json()["episodes"]
        assert episodes[0]["result"]["outcome"] == "success"
        assert episodes[0]["result"]["steps"] == 0


def test_a_client_sees_that_a_person_prepares(bench: StopBench) -> None:
    """No operator is there for a while. Expect refusals that say so."""
    run = bench.begin()
    with bench.server.client("alice") as client:
        body = {"attach_key": "k" * 16}
        answer = client.put(f"{run}/workers/w", json=body)
        problem = answer.json()
        assert (answer.status_code, problem["code"]) == (503, "no_capacity")
        assert "A person prepares the robot, since " in problem["detail"]
        assert answer.headers["Retry-After"] == "1"


def test_an_operator_learns_nothing_of_the_policy(bench: StopBench) -> None:
    """Expect neither run nor policy nor account in what an operator reads."""
    run = bench.begin()
    shown = json.dumps(bench.cell())
    with bench.server.client("alice") as client:
        refused = bench._operator.get(run)
        assert refused.status_code == 403
        assert client.get(f"/v1/cells/{CELL_ID}").status_code == 403
    for name in (run.rpartition("/")[2], "alice", '"p"'):
        assert name not in shown


@pytest.mark.release("waits for 15 seconds")
def test_a_client_that_went_away_frees_the_cell(bench: StopBench) -> None:
    """Its requests stop while a person prepares. Expect the trial to be given up."""
    run = bench.begin()
    began = time.monotonic()
    bench._turn = {"stopped": True}  # the worker of the bench repeats nothing any more
    wait_until(lambda: bench.cell()["phase"] == "free", "the trial is given up")
    assert time.monotonic() - began < 30
    with bench.server.client("alice") as client:
        episodes = client.get(f"{run}/episodes").json()["episodes"]
        assert {episode["attempt"] for episode in episodes} == {1}
