"""`make cluster`: what it starts and says, and that it leaves nothing.

With Ray it runs in .venv-cluster, which `make test` makes.
"""

import contextlib
import os
import re
import select
import signal
import socket
import subprocess
import sys
from pathlib import Path
from typing import IO, Self

import httpx
import pytest

from tests.support.paths import ROOT
from tests.support.processes import descendants, is_alive, process_commands
from tests.support.server.http_runs import attach, predict_body, submit, worker_path
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

WITH_RAY = str(ROOT / ".venv-cluster" / "bin" / "python")
START_S = 150.0  # 20 s for the whole on a machine with nothing else to do
SAID = re.compile(
    r"A cluster of (?P<nodes>\d) nodes is listening at (?P<url>\S+)\n"
    r"nodes: (?P<addresses>.+)\n"
    r"(?P<services>(?:Ray: .+, logs in (?P<temporary>\S+)\n)?(?:PostgreSQL: .+\n)?)"
    r"token, kept in \S+:\n(?P<token>\S+)\ntry:\n(?s:.+)"
    r"certify:\nmake (?:-C \S+ \\\n )?conformance \\\n"
    r" URL=(?P=url) \\\n TOKEN=\"\$\(cat \S+\)\"\n"
)


def free_ports(size: int, first: int) -> int:
    """The first of so many free ports in a row, below those that systems give out.

    first: another one for each test, as tests run at once.
    """
    for port in range(first, first + 1000, size):
        with contextlib.ExitStack() as opened, contextlib.suppress(OSError):
            for one in range(port, port + size):
                opened.enter_context(socket.create_server(("127.0.0.1", one)))
            return port
    raise AssertionError("no free ports")


class LocalCluster:
    """One that is started, with its files in a folder."""

    def __init__(
        self, folder: Path, port: int, *options: str, python: str = sys.executable
    ) -> None:
        settings = {"PROCTOR_PORT": str(port), "PYTHONPATH": str(ROOT)}
        inherited = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
        command = [python, "-m", "tools", "cluster", "--folder", str(folder)]
        self._log = folder.with_suffix(".log")
        with self._log.open("wb") as log:
            self.process = subprocess.Popen(
                [*command, *options],
                cwd=folder.parent,  # an SQLite file is in var/ there
                env=inherited | settings,
                stdout=subprocess.PIPE,
                stderr=log,
            )
        self._started: set[int] = set()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGTERM)
            self.process.wait(TIMEOUT_S)
        assert self.process.stdout is not None
        self.process.stdout.close()

    def client(self) -> httpx.Client:
        """Of its balancer, once it has started; `said` is what it says then."""
        assert self.process.stdout is not None
        text = read_until(self.process.stdout, b"TOKEN=", START_S)
        said = SAID.fullmatch(text)
        assert said is not None, text + self.log()
        self.said = said
        return self.client_again()

    def client_again(self) -> httpx.Client:
        """Another one, with connections of its own."""
        return httpx.Client(
            base_url=self.said["url"],
            headers={"Authorization": f"Bearer {self.said['token']}"},
            timeout=START_S,
            trust_env=False,
        )

    def end(self, number: signal.Signals | None = signal.SIGTERM) -> int:
        """Its exit code. Nothing that it has started is left, at once."""
        self.note_started()
        if number is not None:
            self.process.send_signal(number)
        wait_until(self._has_ended, "the cluster has ended", START_S)
        assert {pid for pid in self._started if is_alive(pid)} == set()
        return self.process.wait()

    def note_started(self) -> set[int]:
        """What it has started until now."""
        self._started |= descendants(self.process.pid)
        return self._started

    def _has_ended(self) -> bool:
        self.note_started()
        return self.process.poll() is not None

    def log(self) -> str:
        """All that it has written to the standard error."""
        return self._log.read_text()


def read_until(stream: IO[bytes], mark: bytes, timeout_s: float) -> str:
    """A pipe's text to the end of the line with the mark, or what comes before that."""
    text = b""
    while not (mark in text and text.endswith(b"\n")):
        if not select.select([stream], [], [], timeout_s)[0]:
            break
        if not (read := os.read(stream.fileno(), 4096)):
            break
        text += read
    return text.decode()


def play(client: httpx.Client) -> str:
    """A run of two episodes, each of one turn. Expect that both are scored."""
    run_id = submit(client, "score", "score")
    turn = attach(client, run_id)
    while not turn["done"]:
        path = f"{worker_path(run_id)}/predict"
        answer = client.post(path, json=predict_body(turn, end=1))
        assert answer.status_code == 200, answer.text
        turn = answer.json()
    score = client.get(f"/v1/runs/{run_id}/score").raise_for_status().json()
    assert score["counts"]["total"] == 2
    return run_id


@pytest.mark.slow("starts a cluster of two servers")
def test_the_address_and_the_token_are_printed_at_once(tmp_path: Path) -> None:
    """Into a pipe, which is not flushed line by line. Expect a token that is valid."""
    with LocalCluster(tmp_path / "c", free_ports(3, 21000)) as cluster:
        with cluster.client() as client:
            assert client.get("/v1/benchmarks").status_code == 200
            served = client.get("/v1").json()
            assert {"record", "board"} <= set(served["profiles"])
        assert cluster.end() == 0
        assert cluster.said["nodes"] == "2"
        assert cluster.said["services"] == ""
        assert (tmp_path / "var" / "proctor.sqlite").exists()


@pytest.mark.slow("starts PostgreSQL, Ray and three servers")
def test_all_of_it_plays_and_leaves_nothing(tmp_path: Path) -> None:
    """What `make cluster` starts, and one node is killed. Expect scores, no process."""
    options = ("--nodes", "3", "--database", "postgresql", "--simulators", "ray")
    port = free_ports(4, 22000)
    with LocalCluster(tmp_path / "c", port, *options, python=WITH_RAY) as cluster:
        with cluster.client() as client:
            run_ids = [play(client) for _ in range(3)]
            record = client.get(f"/v1/runs/{run_ids[0]}/record")
            assert record.status_code == 200
            assert any("SimulatorActor" in line for line in process_commands())
        cluster.note_started()
        node = re.search(r"process (\d+)", cluster.said["addresses"])
        assert node is not None
        os.kill(int(node[1]), signal.SIGKILL)
        with cluster.client_again() as client:
            assert {play(client) for _ in range(3)}.isdisjoint(run_ids)
        temporary = Path(cluster.said["temporary"]).parent
        assert temporary.is_dir()
        assert cluster.end() == 0
        assert not temporary.exists()
        assert not (tmp_path / "var").exists()


@pytest.mark.slow("starts PostgreSQL and a server, twice")
@pytest.mark.release("a local cluster that is started again on its data")
def test_data_of_its_own_postgresql_stay(tmp_path: Path) -> None:
    options = ("--nodes", "1", "--database", "postgresql")
    port = free_ports(2, 24000)
    with LocalCluster(tmp_path / "c", port, *options) as cluster:
        with cluster.client() as client:
            run_id = play(client)
        assert cluster.end() == 0
        token = cluster.said["token"]
    with LocalCluster(tmp_path / "c", port, *options) as cluster:
        with cluster.client() as client:
            kept = client.get(f"/v1/runs/{run_id}").raise_for_status().json()
            assert kept["state"] == "completed"
        assert cluster.end() == 0
        assert cluster.said["token"] == token


# --- what does not start ---


@pytest.mark.slow("starts an interpreter")
@pytest.mark.parametrize("behind", [0, 1])
def test_a_port_in_use_is_one_sentence(tmp_path: Path, behind: int) -> None:
    """That of the balancer, or of a node. Expect that nothing else was started."""
    port = free_ports(2, 25000 + behind * 1000)
    with (
        socket.create_server(("127.0.0.1", port + behind)),
        LocalCluster(tmp_path / "c", port, "--database", "postgresql") as cluster,
    ):
        assert cluster.end(None) == 2
        (line,) = cluster.log().splitlines()
        assert f"cannot listen on 127.0.0.1:{port + behind} (" in line
        assert "PROCTOR_PORT" in line
        assert not (tmp_path / "c").exists()


@pytest.mark.slow("starts an interpreter")
def test_without_ray_one_sentence_says_so(tmp_path: Path) -> None:
    options = ("--simulators", "ray")
    with LocalCluster(tmp_path / "c", free_ports(3, 27000), *options) as cluster:
        assert cluster.end(None) == 2
        _, line = cluster.log().splitlines()
        assert "Ray is not installed here; `make cluster` installs it" in line


@pytest.mark.slow("starts PostgreSQL")
def test_a_node_that_does_not_start_leaves_nothing(tmp_path: Path) -> None:
    """PostgreSQL runs already. Expect the sentence of the node, and that it ends."""
    options = ("--nodes", "1", "--database", "postgresql")
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "key").write_text("not a key")
    with LocalCluster(tmp_path / "c", free_ports(2, 28000), *options) as cluster:
        assert cluster.end(None) == 2
        _, why, what = cluster.log().splitlines()
        assert why.startswith("proctor: cannot use the key in")
        assert "the node at port" in what


@pytest.mark.slow("starts PostgreSQL and Ray")
def test_a_database_that_does_not_start_leaves_nothing(tmp_path: Path) -> None:
    """Its data are none, and Ray is starting. Expect a sentence, and that Ray ends."""
    options = ("--database", "postgresql", "--simulators", "ray")
    (tmp_path / "c" / "postgresql").mkdir(parents=True)
    port = free_ports(3, 30000)
    with LocalCluster(tmp_path / "c", port, *options, python=WITH_RAY) as cluster:
        assert cluster.end(None) == 2
        _, line = cluster.log().splitlines()
        assert "PostgreSQL did not start (" in line


@pytest.mark.slow("starts PostgreSQL")
def test_ctrl_c_while_it_starts_leaves_nothing(tmp_path: Path) -> None:
    options = ("--nodes", "1", "--database", "postgresql")
    with LocalCluster(tmp_path / "c", free_ports(2, 29000), *options) as cluster:
        wait_until(cluster.note_started, "something has been started", START_S)
        assert cluster.end(signal.SIGINT) == 0
        assert len(cluster.log().splitlines()) == 1  # that it is starting
