"""Two robots that serve one benchmark: one queue, and a record that says which one."""

from __future__ import annotations

import contextlib
import json
import threading
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_client import evaluate
from reference_record.formats.bundle import open_bundle
from reference_record.pages.record_documents import read_reported_run
from tests.support.cells.scripted_operator import ScriptedOperator, judgements_of
from tests.support.cells.stop_cases import (
    CELL_ID,
    OPERATOR,
    SECOND_OPERATOR,
    Drive,
    running_robot,
    serving_cells,
)
from tests.support.servers import TOKENS, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts a server and two robots")
LEFT, RIGHT = f"{CELL_ID}_left", f"{CELL_ID}_right"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("cells")
    with (
        running_robot(folder, "left") as left,
        running_robot(folder, "right") as right,
        serving_cells(
            folder, f'cells = {{left = "unix:{left}", right = "unix:{right}"}}', 2
        ) as server,
    ):
        yield server


@dataclass
class Cell:
    """One of the cells, and who operates it."""

    client: httpx.Client
    cell_id: str

    def cell(self) -> dict[str, Any]:
        shown: dict[str, Any] = self.client.get(f"/v1/cells/{self.cell_id}").json()
        return shown

    def act(self, act: str, **members: Any) -> httpx.Response:
        body = {"act": act, **members}
        return self.client.post(f"/v1/cells/{self.cell_id}/acts", json=body)


@pytest.fixture
def cells(server: ReferenceServer) -> Iterator[list[Cell]]:
    """Both, each with an operator of its own."""
    with contextlib.ExitStack() as clients:
        both = []
        for cell_id, token in ((LEFT, OPERATOR), (RIGHT, SECOND_OPERATOR)):
            client = clients.enter_context(server.client("alice"))
            client.headers["Authorization"] = f"Bearer {token}"
            cell = Cell(client, cell_id)
            cell.act("claim", takes_over=True).raise_for_status()
            both.append(cell)
        yield both


def test_trials_go_to_the_cell_that_is_free(
    server: ReferenceServer, cells: list[Cell], tmp_path: Path
) -> None:
    """Two policies of four episodes each, at two cells.

    Expect each trial at one cell, both cells used, both runs whole, and one count of
    which cell it was: in the acts, the runs and the records.
    """
    operators = [ScriptedOperator(cell, "success") for cell in cells]
    scores: dict[str, Any] = {}

    def play(name: str) -> None:
        url, token = server.url, TOKENS["alice"]
        scores[name] = evaluate(
            Drive, url=url, token=token, benchmark=CELL_ID, name=name
        )

    players = [threading.Thread(target=play, args=(name,)) for name in ("a", "b")]
    with operators[0].working(), operators[1].working():
        for player in players:
            player.start()
        for player in players:
            player.join()
    assert [by.errors for by in operators] == [[], []]
    acts = server.database_file.with_name("proctor.sqlite.cells.jsonl").read_text()
    judged = [json.loads(line) for line in acts.splitlines()]
    judged = [line for line in judged if line.get("act") == "judge"]
    assert set(Counter(line["cell"] for line in judged)) == {LEFT, RIGHT}
    for name in ("a", "b"):
        run_id = scores[name].run_id
        own = {
            line["episode"]: line["cell"] for line in judged if line["run"] == run_id
        }
        assert len(own) == scores[name].counts.success == 4
        with server.client("alice") as client:
            shown = client.get(f"/v1/runs/{run_id}").json()["judged"]
            record = tmp_path / f"{name}.proctor"
            record.write_bytes(client.get(f"/v1/runs/{run_id}/record").content)
        assert shown["cells"] == own
        assert [given["cell"] for given in judgements_of(record)] == [
            own[episode] for episode in sorted(own)
        ]
        reported = read_reported_run(open_bundle(record), {})
        for episode in reported.episodes:
            reported.read(episode)
        assert reported.run["judged"]["cells"] == own


def test_a_paused_cell_leaves_the_trials_to_the_other(
    server: ReferenceServer, cells: list[Cell]
) -> None:
    """Expect a void trial to be offered again, and stops to reach the robot it has."""
    left, right = cells
    left.act("pause").raise_for_status()
    client = threading.Thread(
        target=lambda: evaluate(
            Drive, url=server.url, token=TOKENS["alice"], benchmark=CELL_ID
        )
    )
    client.start()
    wait_until(lambda: right.cell()["phase"] == "preparing", "the other cell has it")
    assert left.cell()["phase"] == "free"
    trial = right.cell()["trial"]
    right.act("pause").raise_for_status()
    left.act("continue").raise_for_status()
    right.act("void", trial=trial, reason="the light went out").raise_for_status()
    wait_until(lambda: left.cell()["phase"] == "preparing", "the first cell has it")
    assert (right.cell()["phase"], right.cell()["voids"]) == (
        "free",
        {"the light went out": 1},
    )
    right.act("continue").raise_for_status()
    operators = [ScriptedOperator(cell, "stop") for cell in cells]
    with operators[0].working(), operators[1].working():
        client.join()
    assert sum(len(by.judged) for by in operators) == 4
