"""A second person judges a sample of a run from the recordings."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_client import evaluate
from reference_client.command.main import main
from reference_record.comparison.judge_agreement import second_sample
from reference_record.formats.bundle import open_bundle
from reference_record.generated.answers import Rubric
from reference_record.pages.record_documents import read_reported_run
from reference_server.cells.act_log import ActLog
from reference_server.cells.second_judge import SecondJudge
from reference_server.rules.refusal import Refused
from tests.support.cells.scripted_operator import ScriptedOperator
from tests.support.cells.stop_cases import CELL_ID, SECOND_OPERATOR, Drive, StopBench
from tests.support.servers import TOKENS

RUBRIC: Rubric = {"success": "It is there.", "criteria": ["It moved."]}
PLACE = "/v1/second_judgements"
FIRST: dict[str, Any] = {
    "cell": "arm",
    "run": "run_1",
    "episode": "e0000",
    "operator": "olga",
}


def judge_of(*acts: dict[str, Any]) -> tuple[SecondJudge, str]:
    log = ActLog(None)
    for act in acts:
        log.add(**act)
    return SecondJudge(log), log.second_id("run_1", "e0000")


JUDGED = FIRST | {"act": "judge", "success": True, "note": "", "drawn": True}


@pytest.mark.parametrize(
    ("acts", "account", "is_offered"),
    [
        ([JUDGED], "otto", True),
        ([JUDGED], "olga", False),
        ([JUDGED | {"drawn": False}], "otto", False),
        ([FIRST | {"act": "ready"}], "otto", False),
        # A person beside the robot has seen more than the recording shows.
        ([FIRST | {"act": "stop", "operator": "otto"}, JUDGED], "otto", False),
        ([{"cell": "arm", "act": "claim", "operator": "otto"}, JUDGED], "otto", True),
        ([FIRST | {"act": "void", "reason": "dark"}, JUDGED], "otto", True),
    ],
)
def test_a_sample_is_offered_to_others(
    acts: list[dict[str, Any]], account: str, is_offered: bool
) -> None:
    judge, judgement_id = judge_of(*acts)
    offered = [one.judgement_id for one in judge.waiting_for(account)]
    assert offered == [judgement_id] * is_offered
    if not is_offered:
        with pytest.raises(Refused) as refused:
            judge.find(judgement_id, account)
        assert refused.value.code == "not_found"


async def test_an_episode_has_one_second_judgement() -> None:
    judge, judgement_id = judge_of(JUDGED)
    found = judge.find(judgement_id, "otto")
    with pytest.raises(Refused) as refused:
        await judge.judge(found, "otto", RUBRIC, success=False, met=[1], note="")
    assert refused.value.errors[0][0] == "/met"
    await judge.judge(found, "otto", RUBRIC, success=False, met=[0, 0], note="slow")
    assert list(judge.waiting_for("otto")) == []
    with pytest.raises(Refused) as refused:
        await judge.judge(found, "anna", RUBRIC, success=True, met=[], note="")
    assert refused.value.requirement == "PHY-027"


@pytest.fixture
def judge(bench: StopBench) -> Iterator[httpx.Client]:
    with bench.server.client("alice") as client:
        client.headers["Authorization"] = f"Bearer {SECOND_OPERATOR}"
        yield client


def check_setup_and_refusal(judge: httpx.Client, place: str) -> None:
    shown = judge.get(place).json()
    assert shown["rubric"]["criteria"]
    assert shown["setup"]["has_picture"]
    assert judge.get(f"{place}/picture").content.startswith(b"\x89PNG")
    refused = judge.post(place, json={"met": []}).json()
    assert [error["pointer"] for error in refused["errors"]] == ["/success"]


@pytest.mark.slow("starts a server, and a robot that plays")
def test_a_second_person_judges_from_the_pictures(
    bench: StopBench,
    judge: httpx.Client,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The first judge says no four times; the second yes, then no, to the sample.

    Expect nothing that could bias him, results that stay, and one count of how often
    both agreed: for the run, its record, its row and the command.
    """
    since = len(judge.get(PLACE).json()["judgements"])
    operator = ScriptedOperator(bench, "failure")
    with operator.working():
        token = TOKENS["alice"]
        score = evaluate(Drive, url=bench.server.url, token=token, benchmark=CELL_ID)
    assert operator.errors == []
    waiting = judge.get(PLACE).json()["judgements"][since:]
    assert (
        bench._operator.get(f"{PLACE}/{waiting[0]['judgement_id']}").status_code == 404
    )
    assert len(waiting) == 2
    for number, one in enumerate(waiting):
        place = f"{PLACE}/{one['judgement_id']}"
        shown = judge.get(place)
        for name in (score.run_id, "alice", "Drive", "seen", "olga", "judge_"):
            assert name not in shown.text
        check_setup_and_refusal(judge, place)
        pictures = shown.json()["pictures"]
        # Before the first action, after each turn of 20, and of what was left.
        assert [picture["step"] for picture in pictures] == [0, 20, 40, 60]
        data = judge.get(f"{place}/pictures/3").content
        assert data.startswith(b"\xff\xd8")
        assert judge.get(f"{place}/pictures/4").status_code == 404
        body = {"success": number == 0, "met": [0], "note": "dim"}
        assert judge.post(place, json=body).json()["judged"]
        assert judge.post(place, json=body).json()["code"] == "illegal_transition"
    with bench.server.client("alice") as client:
        run = f"/v1/runs/{score.run_id}"
        assert client.get(PLACE).status_code == 403
        second = client.get(run).json()["judged"]["second"]
        counts = [second[k] for k in ("both", "first_alone", "second_alone", "neither")]
        assert (second["drawn"], counts, second["kappa"]) == (2, [0, 0, 1, 1], 0.0)
        assert client.get(f"{run}/score").json()["counts"]["success"] == 0
        entry = {"model_name": "Drive", "is_public": True}
        published = client.put(f"{run}/entry", json=entry).json()
        assert published["score"]["second_judge"] == second
        record = tmp_path / "run.proctor"
        record.write_bytes(client.get(f"{run}/record").content)
        physical = client.get(f"/v1/benchmarks/{CELL_ID}").json()["physical"]
    names = [f"e{index:04d}" for index in range(4)]
    drawn = [line["episode"] for line in bench.acts() if line.get("drawn")][-2:]
    assert second_sample(physical, score.run_id, names) == set(drawn)
    assert main(["verify", str(record)]) == 0
    reported = read_reported_run(open_bundle(record), {})
    for episode in reported.episodes:
        reported.read(episode)
    assert reported.run["judged"]["second"] == second
    login = ["--url", bench.server.url, "--token", TOKENS["alice"]]
    assert main(["results", score.run_id, *login]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "the judges agreed on 1 of 2. Cohen's kappa 0.00, n = 2: too few" in said
    assert main(["board", CELL_ID, *login]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "people of this host" in said
    assert "Drive: the judges agreed on 1 of 2." in said
