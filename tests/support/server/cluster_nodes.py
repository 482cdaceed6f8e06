"""Several reference servers over one database, each a node of a cluster."""

from __future__ import annotations

import contextlib
import secrets
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx

from tests.support.server.http_runs import predict_body
from tests.support.servers import ReferenceServer
from tests.support.waiting import wait_until

# A node that gets no processor for so long loses its runs.
LEASE_S = 2.0


def node_settings(directory: Path, lease_s: float) -> dict[str, str]:
    """All nodes of a cluster have these."""
    return {
        "PROCTOR_CLUSTER": "on",
        "PROCTOR_RECORDS_DIR": str(directory / "records"),
        "PROCTOR_SIGNING_KEY": str(directory / "signing-key"),
        "PROCTOR_NODE_LEASE_S": str(lease_s),
        "PROCTOR_SPARE_SIMULATORS": "1",
        "PROCTOR_LOG_LEVEL": "info",
        "PROCTOR_SEALING_KEY": str(directory / "key"),
        "PROCTOR_SEED_SECRET": str(directory / "seeds"),
    }


class Cluster:
    """Nodes with one database. Those that a test ended stay in the list.

    clients: of each node, in the same order.
    """

    def __init__(self, nodes: list[ReferenceServer]) -> None:
        self.nodes = nodes
        self.clients: list[httpx.Client] = []

    @classmethod
    @contextlib.contextmanager
    def of(
        cls, directory: Path, database: str, size: int = 2, **settings: str
    ) -> Iterator[Cluster]:
        """Nodes with this database; killed at the end, also when they are paused.

        settings: {} in one of them is the number of the node.
        """
        with contextlib.ExitStack() as stack:
            nodes = []
            for number in range(size):
                folder = directory / f"node{number}"
                folder.mkdir()
                given = node_settings(directory, LEASE_S)
                given |= {"PROCTOR_DATABASE": database}
                given |= {key: value.format(number) for key, value in settings.items()}
                nodes.append(stack.enter_context(ReferenceServer(folder, **given)))
            cluster = cls(nodes)
            for node in nodes:
                cluster.clients.append(stack.enter_context(node.client()))
            yield cluster

    def start_again(self) -> None:
        """Every node that a test has ended."""
        for node in self.nodes:
            if node.process.poll() is not None:
                node.start()

    def kill(self, number: int) -> None:
        """End a node so that it can do nothing more."""
        self.nodes[number].end(signal.SIGKILL)


def pause(node: ReferenceServer) -> None:
    """Until `go_on`: its lease ends."""
    node.process.send_signal(signal.SIGSTOP)


def go_on(node: ReferenceServer) -> None:
    node.process.send_signal(signal.SIGCONT)


def attach(client: httpx.Client, run_id: str, worker: str = "w") -> dict[str, Any]:
    """Turn 0 of a new session, as soon as a node can be reached that plays the run."""
    body = {"attach_key": secrets.token_hex(8)}
    answers: list[httpx.Response] = []

    def is_attached() -> bool:
        answers.append(client.put(f"/v1/runs/{run_id}/workers/{worker}", json=body))
        return answers[-1].status_code != 503

    wait_until(is_attached, "a node plays the run")
    assert answers[-1].status_code == 200, answers[-1].text
    return dict(answers[-1].json())


def predict(
    client: httpx.Client, run_id: str, turn: dict[str, Any], **values: float
) -> httpx.Response:
    """One action after this turn."""
    body = predict_body(turn, **values)
    return client.post(f"/v1/runs/{run_id}/workers/w/predict", json=body)
