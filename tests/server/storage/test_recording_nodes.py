"""Nodes that share a folder of recordings: one record of each run, and one chain."""

from __future__ import annotations

import os
import signal
import subprocess
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import msgspec
import pytest

from reference_record.contents.statement import read_lines
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.names import (
    EPISODES,
    MANIFEST,
    is_recording,
    recording_name,
)
from reference_record.recordings.mcap_reader import McapReader
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.replay.episode_replay import replay_episode
from reference_sim.replay.record_replay import resolve
from tests.support.paths import ROOT
from tests.support.processes import descendants
from tests.support.server.cluster_nodes import (
    Cluster,
    attach,
    go_on,
    pause,
    predict,
)
from tests.support.server.databases import UsedDatabase
from tests.support.server.http_runs import predict_body, submit
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts two servers")
# Longer than a busy machine takes to pause the node that plays it.
TURN_S = 3.0


@pytest.fixture(scope="module", params=["sqlite", "postgresql"])
def used(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> UsedDatabase:
    """The database of the shared cluster."""
    if request.param == "sqlite":
        folder = tmp_path_factory.mktemp("database")
        return UsedDatabase.of_file(folder / "proctor.sqlite")
    server: PostgresqlServer = request.getfixturevalue("postgresql")
    return UsedDatabase(server.create(), server=server)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Of the shared cluster."""
    return tmp_path_factory.mktemp("nodes")


@pytest.fixture(scope="module")
def shared_cluster(used: UsedDatabase, folder: Path) -> Iterator[Cluster]:
    folder = folder / ("sqlite" if used.server is None else "postgresql")
    folder.mkdir()
    with Cluster.of(folder, used.setting) as cluster:
        yield cluster


@pytest.fixture
def cluster(shared_cluster: Cluster) -> Cluster:
    """All its nodes run."""
    shared_cluster.start_again()
    return shared_cluster


def end_episode(
    client: httpx.Client, run_id: str, turn: dict[str, Any], **values: float
) -> dict[str, Any]:
    """With one action."""
    answer = predict(client, run_id, turn, **values, end=1)
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


def fetch_record(client: httpx.Client, run_id: str) -> bytes:
    """As soon as a node answers that shows the run completed."""
    answers: list[httpx.Response] = []

    def is_answered() -> bool:
        answers.append(client.get(f"/v1/runs/{run_id}/record"))
        return answers[-1].status_code != 503

    wait_until(is_answered, "a node sends the record")
    assert answers[-1].status_code == 200, answers[-1].text
    return answers[-1].content


def check_record(path: Path, content: bytes) -> Bundle:
    """Verified, and each episode replayed: no state differs."""
    path.write_bytes(content)
    bundle = open_bundle(path)
    verified = verify(bundle)
    benchmark = resolve(verified.evaluation, bundle.read(MANIFEST))
    simulator = benchmark_registry.make(benchmark.config)
    for line in read_lines(bundle.blocks(EPISODES)):
        found = replay_episode(
            path, simulator, benchmark.plan_of(line.index), line.result
        )
        assert found.result == "exact", line
    return bundle


def recorded(bundle: Bundle) -> list[list[tuple[str, dict[str, Any]]]]:
    """The messages of each episode, with their topics."""
    found = []
    for name in sorted(filter(is_recording, bundle.sizes)):
        with bundle.open(name) as file:
            messages = McapReader(name, file, bundle.sizes[name]).messages()
            found.append(
                [(topic, msgspec.json.decode(data)) for topic, data in messages]
            )
    return found


def recorded_scores(bundle: Bundle) -> list[list[float]]:
    """What each turn of each episode commanded as its score, as it was recorded."""
    return [
        [
            action["score"][0]
            for topic, turn in messages
            if topic == "/turn"
            for action in turn["actions"]
        ]
        for messages in recorded(bundle)
    ]


def test_a_run_of_two_owners_has_one_record(cluster: Cluster, tmp_path: Path) -> None:
    """The first one is killed inside an episode: what it answered is recorded, too."""
    first, second = cluster.clients
    run_id = submit(first, "score", "score")
    turn = end_episode(first, run_id, attach(first, run_id), score=0.25)
    assert turn["episode_result"]["score"] == 0.25
    assert predict(first, run_id, turn, score=0.5).status_code == 200
    cluster.kill(0)
    turn = attach(second, run_id)
    assert end_episode(second, run_id, turn, score=0.75)["done"]
    content = fetch_record(second, run_id)
    bundle = check_record(tmp_path / "run.proctor", content)
    assert recorded_scores(bundle) == [[0.25], [0.5, 0.75]]
    lines = list(read_lines(bundle.blocks(EPISODES)))
    assert [(line.score, line.attempts) for line in lines] == [(0.25, 1), (0.75, 1)]
    cluster.start_again()
    assert fetch_record(first, run_id) == content
    for index in (0, 1):
        path = f"/v1/runs/{run_id}/episodes/e{index:04d}/recording"
        alone = [client.get(path).content for client in (first, second)]
        assert alone[0] == alone[1] == bundle.read(recording_name(index))


def test_an_owner_that_was_paused_changes_no_recording(
    cluster: Cluster, tmp_path: Path
) -> None:
    """It was paused in a turn that ends the episode, and goes on while its successor
    plays it: what it then does with its result, or records as the end of its attempt,
    does not stand between the turns of the other one."""
    first, second = cluster.clients
    run_id = submit(first, "delay")
    turn = attach(first, run_id)
    body = predict_body(turn, delay_s=TURN_S, end=1)
    taken_over = cluster.nodes[0].log().count("have taken over")
    with ThreadPoolExecutor(1) as thread:
        late = thread.submit(
            first.post, f"/v1/runs/{run_id}/workers/w/predict", json=body
        )
        wait_until(lambda: is_played(first, run_id), "the turn is in play")
        pause(cluster.nodes[0])
        turn = attach(second, run_id)
        turn = predict(second, run_id, turn, delay_s=0).json()
        time.sleep(TURN_S)  # then its simulator has ended the episode
        go_on(cluster.nodes[0])
        late.result()
    wait_until(
        lambda: cluster.nodes[0].log().count("have taken over") > taken_over,
        "the node knows that",
    )
    assert end_episode(second, run_id, turn, delay_s=0)["done"]
    content = fetch_record(second, run_id)
    assert fetch_record(first, run_id) == content
    bundle = check_record(tmp_path / "run.proctor", content)
    (line,) = read_lines(bundle.blocks(EPISODES))
    assert (line.steps, line.attempts) == (2, 1)
    (messages,) = recorded(bundle)
    begins = max(
        n for n, (_, said) in enumerate(messages) if "started" in said.values()
    )
    topics = [topic for topic, _ in messages[begins:]]
    assert topics == ["/attempt", "/turn", "/turn", "/attempt", "/result"]


def test_a_machine_that_was_paused_answers_no_turn_that_is_not_recorded(
    cluster: Cluster,
) -> None:
    """Node and simulators stand still in a turn, until the other node has completed
    the run. Expect no answer to that turn."""
    first, second = cluster.clients
    run_id = submit(first, "delay")
    turn = attach(first, run_id)
    body = predict_body(turn, delay_s=TURN_S)
    node = cluster.nodes[0]
    with ThreadPoolExecutor(1) as thread:
        late = thread.submit(
            first.post, f"/v1/runs/{run_id}/workers/w/predict", json=body
        )
        wait_until(lambda: is_played(first, run_id), "the turn is in play")
        pause(node)
        simulators = descendants(node.process.pid)
        for pid in simulators:
            os.kill(pid, signal.SIGSTOP)
        assert end_episode(second, run_id, attach(second, run_id), delay_s=0)["done"]
        fetch_record(second, run_id)
        for pid in simulators:
            os.kill(pid, signal.SIGCONT)
        time.sleep(TURN_S)  # so long it takes at most from here
        go_on(node)
        assert late.result().status_code in (404, 410, 503), late.result().text


def is_played(client: httpx.Client, run_id: str) -> bool:
    return client.get(f"/v1/runs/{run_id}").json().get("runs_played_before") is not None


def complete(client: httpx.Client, score: float = 0.5) -> str:
    """The id of a new run that is completed."""
    run_id = submit(client, "score")
    assert end_episode(client, run_id, attach(client, run_id), score=score)["done"]
    return run_id


def test_nodes_that_publish_at_once_make_one_history(cluster: Cluster) -> None:
    first, second = cluster.clients
    run_ids = [complete(first, score=number / 4) for number in range(4)]
    body = {"model_name": "m", "is_public": True}

    def publish(number: int) -> int:
        client = cluster.clients[number % 2]
        answer = client.put(f"/v1/runs/{run_ids[number // 2]}/entry", json=body)
        return answer.status_code

    before = first.get("/v1/history/checkpoint").json()["tree_size"]
    with ThreadPoolExecutor(8) as threads:
        statuses = list(threads.map(publish, range(8)))
    assert sorted(statuses) == [200] * 4 + [201] * 4
    checkpoints = [one.get("/v1/history/checkpoint").json() for one in (first, second)]
    assert checkpoints[0] == checkpoints[1]
    assert checkpoints[0]["tree_size"] == before + 4
    entry = second.delete(f"/v1/runs/{run_ids[0]}/entry").json()
    assert entry["state"] == "withdrawn"
    assert first.get(f"/v1/entries/{entry['entry_id']}").json() == entry


@pytest.mark.parametrize(
    ("setting", "says"),
    [
        (
            "PROCTOR_RECORDS_DIR",
            "is not the folder with the recordings of this cluster",
        ),
        ("PROCTOR_SIGNING_KEY", "set signing_key to a copy of their file"),
    ],
)
def test_a_node_that_would_record_apart_does_not_start(
    cluster: Cluster, tmp_path: Path, setting: str, says: str
) -> None:
    inherited = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
    own = {setting: str(tmp_path / "other"), "PROCTOR_TOKENS": "a:run:a-token"}
    refused = subprocess.run(
        [*ReferenceServer.command, "--port", "0"],
        check=False,
        cwd=ROOT,
        env=inherited | cluster.nodes[0].settings | own,
        capture_output=True,
        text=True,
        timeout=TIMEOUT_S,
    )
    assert refused.returncode == 2, refused.stderr
    assert "cannot be a node of this cluster" in refused.stderr
    assert says in refused.stderr
    assert fetch_keys(cluster.clients[0]) == 1


def fetch_keys(client: httpx.Client) -> int:
    """How many keys have signed, or would."""
    return len(client.get("/v1/keys").json()["keys"])
