"""The profiles on several nodes: requests that name a run in a body, or several."""

from __future__ import annotations

import shlex
import threading
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from conformance.policy.scripted_chat import ChatRequest, ScriptedChat
from conformance.specification.ledger import load_ledger
from tests.support.forking.forked_servers import server_command
from tests.support.kit.run_kit import run_kit
from tests.support.profiles.flageval_client import (
    get_evaldiffs,
    get_progress,
    is_refused,
    model_info,
    post,
    submit_evaluation,
    wait_until_finished,
)
from tests.support.push_runs import ALLOW_LOOPBACK
from tests.support.server.cluster_nodes import Cluster
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

PROFILES = {"PROCTOR_PROFILES": "ebench,flageval"}


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    folder = tmp_path_factory.mktemp("profiles")
    database = str(folder / "cluster.sqlite")
    with Cluster.of(folder, database, 3, **PROFILES, **ALLOW_LOOPBACK) as cluster:
        yield cluster


# --- FlagEval ---


@pytest.mark.slow("starts three servers")
def test_a_request_with_runs_of_several_nodes(cluster: Cluster) -> None:
    """Stopped, resumed and compared through a node that has none of them."""
    first, second, third = cluster.clients
    may_continue = threading.Event()

    def respond(request: ChatRequest) -> str:
        may_continue.wait(TIMEOUT_S)
        return "1" if request.body["model"] == "m-nvidia-origin" else "0.5"

    with ScriptedChat(respond) as chat:
        try:
            ids = [
                submit_evaluation(http, model_info(chat, name))
                for http, name in ((first, "m-nvidia-origin"), (second, "m-other"))
            ]
            request_id = ".".join(ids)
            wait_until(lambda: len(chat.requests) == 2, "both models are asked")
            assert get_progress(third, request_id)["status"] == "R"
            stopped = post(third, "/stop_evaluation", request_id=request_id)
            assert stopped["err_code"] == 0, stopped
            assert statuses(third, request_id) == ["C", "C"]
            assert {state_of(http, one) for http in cluster.clients for one in ids} == {
                "stopped"
            }
        finally:
            may_continue.set()
        resumed = post(third, "/resume_evaluation", request_id=request_id)
        assert resumed["err_code"] == 0, resumed
        assert wait_until_finished(third, request_id)["status"] == "S"
    results = get_evaldiffs(third, request_id)["eval_results"]
    assert results["m-nvidia-origin"]["release"] is True
    assert results["m-other"]["details"][0]["diff"] == 0.5
    for http in cluster.clients:
        for path in ("/stop_evaluation", "/resume_evaluation"):
            assert is_refused(post(http, path, request_id=request_id), "completed")


@pytest.mark.slow("starts three servers")
def test_one_unknown_run_of_a_request_changes_no_other(cluster: Cluster) -> None:
    first, second, _ = cluster.clients
    may_continue = threading.Event()
    with ScriptedChat(lambda _: "1" * may_continue.wait(TIMEOUT_S)) as chat:
        try:
            request_id = submit_evaluation(first, model_info(chat, "n-plays"))
            asked = {"request_id": f"{request_id}.run_unknown"}
            assert is_refused(post(second, "/stop_evaluation", **asked), "run_unknown")
            assert statuses(second, request_id) == ["R"]
        finally:
            may_continue.set()
        assert wait_until_finished(second, request_id)["status"] == "S"


def statuses(http: httpx.Client, request_id: str) -> list[str]:
    results = get_evaldiffs(http, request_id)["eval_results"].values()
    return [str(result["status"]) for result in results]


def state_of(http: httpx.Client, run_id: str) -> str:
    return str(http.get(f"/v1/runs/{run_id}").json()["state"])


# --- the rules of both ---


@pytest.mark.slow("starts two servers and a kit")
def test_the_rules_of_both_hold_on_nodes(tmp_path: Path) -> None:
    server = [*server_command(), "--cluster", "on", "--recordings", "off"]
    server += ["--node-lease-s", "60"]  # a busy machine takes no run from a node
    server += ["--profiles", PROFILES["PROCTOR_PROFILES"]]
    options = ("--nodes", "2", "--only", "EBE,FLE", "--start-cmd", shlex.join(server))
    kit = run_kit(tmp_path, *options)
    assert kit.code == 0, kit.output[-3000:]
    ledger = load_ledger().values()
    asked = {row.id for row in ledger if row.profile in ("ebench", "flageval")}
    # What an operator has chosen, or only the storage shows, is seen by other tests.
    not_seen = {"EBE-029", "FLE-017", "FLE-023", "FLE-024"}
    assert kit.rules_with("passed") == asked - not_seen
