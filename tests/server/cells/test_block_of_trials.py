"""Two policies at ten setups each: all that readers see agrees with what people did."""

from __future__ import annotations

import random
import signal
import threading
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from reference_client import evaluate
from tests.support.cells.scripted_operator import ScriptedOperator, judgements_of
from tests.support.cells.stop_cases import (
    CELL_ID,
    SECOND_OPERATOR,
    Drive,
    StopBench,
    stop_bench,
)
from tests.support.servers import TOKENS
from tests.support.waiting import wait_until

pytestmark = pytest.mark.release("20 trials, a handover and a restart of the server")

JUDGED_BEFORE_CHANGE = 6  # trials, before the handover and before the restart
POLICIES = "first", "second"


def play_both(bench: StopBench, scores: dict[str, Any]) -> list[threading.Thread]:
    """One client for each policy, both at once."""

    def play(name: str) -> None:
        url, token = bench.server.url, TOKENS["alice"]
        scores[name] = evaluate(
            Drive, url=url, token=token, benchmark=CELL_ID, name=name
        )

    clients = [
        threading.Thread(target=play, args=(name,), daemon=True) for name in POLICIES
    ]
    for client in clients:
        client.start()
    return clients


def operate(bench: StopBench, plan: list[str], clients: list[threading.Thread]) -> Any:
    """Judge with a handover, and a restart during a trial; returns the operators."""
    operators = [ScriptedOperator(bench, *plan[at:]) for at in (0, 7, 14)]
    for number, operator in enumerate(operators[:2]):
        with operator.working():
            wait_until(
                operator.has_judged(JUDGED_BEFORE_CHANGE), "trials are judged", 120
            )
        if number == 0:
            bench.act("release").raise_for_status()
            bench.hand_over(SECOND_OPERATOR)
            bench.act("claim").raise_for_status()
    cell = bench.cell()
    if cell["phase"] == "preparing":
        bench.act("ready", trial=cell["trial"])
    wait_until(lambda: bench.cell()["phase"] in ("playing", "judging"), "it plays")
    bench.server.end(signal.SIGKILL)
    bench.restart()
    with operators[2].working():
        for client in clients:
            client.join(120)
            assert not client.is_alive()
    return operators


def own_count(bench: StopBench, operators: Any) -> dict[str, dict[str, bool]]:
    """run → episode → success, by what the operators themselves remember."""
    own = {k: v for by in operators for k, v in by.success_by_trial.items()}
    place = {
        line["trial"]: (line["run"], line["episode"])
        for line in bench.acts()
        if line.get("act") == "judge"
    }
    assert place.keys() == own.keys()
    counted: dict[str, dict[str, bool]] = {}
    for trial in sorted(own):
        run, episode = place[trial]
        counted.setdefault(run, {})[episode] = own[trial]
    return counted


def test_a_block_of_two_policies(tmp_path: Path) -> None:
    """Expect one count: in results, runs, records and on the leaderboard."""
    chance = random.Random(43)
    plan = chance.choices(["success", "failure", "stop"], k=20)
    plan[2] = plan[9] = plan[16] = "void"
    scores: dict[str, Any] = {}
    with stop_bench(tmp_path, repetitions=5) as bench:
        clients = play_both(bench, scores)
        operators = operate(bench, plan, clients)
        assert [by.errors for by in operators] == [[], [], []]
        counted, voids = own_count(bench, operators), Counter[str]()
        with bench.server.client("alice") as client:
            for name in POLICIES:
                run_id = scores[name].run_id
                own, path = counted[run_id], f"/v1/runs/{run_id}"
                listed = client.get(f"{path}/episodes").json()["episodes"]
                assert len(own) == 10
                assert own == {
                    episode["episode_id"]: episode["result"]["outcome"] == "success"
                    for episode in listed
                }
                judged = client.get(path).json()["judged"]
                assert (judged["judgements"], len(judged["judges"])) == (10, 2)
                voids.update(judged["voids"])
                record = tmp_path / f"{name}.proctor"
                record.write_bytes(client.get(f"{path}/record").content)
                recorded = [said["success"] for said in judgements_of(record)]
                assert recorded == [own[episode["episode_id"]] for episode in listed]
                entry = {"model_name": name, "is_public": True}
                published = client.put(f"{path}/entry", json=entry).json()
                assert published["score"]["counts"]["success"] == sum(own.values())
                assert scores[name].counts.success == sum(own.values())
        assert voids == {"the light went out": sum(by.voids for by in operators)}
        assert sum(voids.values()) >= 2
