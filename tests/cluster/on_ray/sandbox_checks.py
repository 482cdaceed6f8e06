"""Sandboxes on a real Ray cluster: as the local ones, on a machine that may be lost.

Run by tests/cluster/on_ray/test_ray.py in .venv-cluster, where Ray is installed.
"""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from reference_platform.sandbox.cluster.ray_sandboxes import RayMaker
from reference_platform.sandbox.sandbox_interface import (
    NotListening,
    SandboxSpec,
    SandboxUnavailable,
)
from reference_platform.submissions.interfaces import Track
from reference_platform.submissions.sandboxed_runner import PolicyTimes
from tests.support.paths import ROOT
from tests.support.platform.sandboxes import (
    ECHO,
    SMALL,
    WrittenLog,
    python_command,
    system_binds,
)
from tests.support.platform.uploaded_policies import hosting, python_code, submission_of
from tests.support.processes import process_commands
from tests.support.sim.ray_cluster import RayCluster
from tests.support.waiting import wait_until

ON_ONE_CPU = replace(SMALL, cpus=1.0)
PLATFORM = """
import asyncio, sys
from tests.cluster.on_ray import sandbox_checks as checks
async def main():
    write = lambda *line: print(*line, flush=True)
    maker = checks.RayMaker(sys.argv[1])
    sandbox = await maker.start(checks.spec_of(checks.ECHO), write)
    await sandbox.wait()
asyncio.run(main())
"""


@pytest.fixture(scope="module")
def cluster() -> Iterator[RayCluster]:
    cluster = RayCluster(1)
    yield cluster
    cluster.close()


@pytest.fixture(autouse=True)
def _leaves_nothing(cluster: RayCluster) -> Iterator[None]:
    yield
    wait_until(
        lambda: not any(found() for found in (cluster.actor_processes, sandboxes)),
        "nothing is left",
        60.0,
    )


def sandboxes() -> list[str]:
    words = ("bwrap --unshare-all", "cluster.ray_launcher")
    return [one for one in process_commands() if any(word in one for word in words)]


def maker() -> RayMaker:
    return RayMaker(os.environ["RAY_ADDRESS"])


def spec_of(code: str, **changed: Any) -> SandboxSpec:
    spec = SandboxSpec([python_command(), "-c", code], binds=system_binds())
    return replace(spec, limits=ON_ONE_CPU, **changed)


async def test_a_policy_is_played_on_a_machine_of_the_cluster() -> None:
    """From the upload to the score, as on the machine of the platform."""
    with hosting(PolicyTimes(listen_s=30.0), maker(), ON_ONE_CPU) as host:
        archive = host.folder / "code"
        digest = python_code(archive)
        host.uploads.paths[digest] = archive
        submission = submission_of(digest, "code")
        track = Track("track", "calibration", verification_episodes=1)
        outcome = await host.runner.verify(submission, track)
        assert outcome.passed, host.logs.read("sub1")
        assert host.log("policy") == ["predict 0"]


async def test_the_socket_is_the_way_in() -> None:
    log = WrittenLog()
    sandbox = await maker().start(spec_of(ECHO), log)
    await log.first.wait()
    connection = await asyncio.to_thread(sandbox.connect)
    with connection:
        connection.sendall(b"hello")
        assert await asyncio.to_thread(connection.recv, 100) == b"hello"
    end = await sandbox.close("The test is over.")
    assert (end.reason, end.is_by_platform) == ("The test is over.", True)
    assert log.lines == [
        ("policy", "listening"),
        ("platform", "The sandbox has ended. The test is over."),
    ]
    with pytest.raises(NotListening):
        sandbox.connect()


async def test_an_end_has_its_reason_and_all_its_lines() -> None:
    log = WrittenLog()
    code = "for n in range(200): print(n)\nraise SystemExit(3)"
    sandbox = await maker().start(spec_of(code), log)
    end = await sandbox.wait()
    assert end.reason == "The policy ended by itself, with exit code 3."
    assert log.of("policy") == [str(number) for number in range(200)]


async def test_a_machine_that_is_lost_is_a_fault_of_the_host(
    cluster: RayCluster,
) -> None:
    log = WrittenLog()
    sandbox = await maker().start(spec_of(ECHO), log)
    await log.first.wait()
    for pid in cluster.actor_processes():
        os.kill(pid, signal.SIGKILL)
    end = await sandbox.wait()
    assert end.is_lost
    assert log.of("platform") == ["The machine of the sandbox was lost."]


@pytest.mark.parametrize("lacks", ["room", "cluster"])
async def test_a_cluster_without_a_place_is_said(lacks: str) -> None:
    large = replace(spec_of(ECHO), limits=replace(SMALL, cpus=64.0))
    address = os.environ["RAY_ADDRESS"] if lacks == "room" else "127.0.0.1:9"
    with pytest.raises(SandboxUnavailable, match="gave no place within 5 s"):
        await RayMaker(address, 5.0).start(large, WrittenLog())


async def test_a_folder_that_the_machine_lacks_is_named() -> None:
    spec = spec_of(ECHO, root=Path("/srv/not-shared"))
    with pytest.raises(SandboxUnavailable, match="has no /srv/not-shared"):
        await maker().start(spec, WrittenLog())


def test_a_killed_platform_leaves_nothing() -> None:
    with subprocess.Popen(
        [sys.executable, "-c", PLATFORM, os.environ["RAY_ADDRESS"]],
        cwd=ROOT,
        stdout=subprocess.PIPE,
        text=True,
    ) as platform:
        assert platform.stdout is not None
        assert platform.stdout.readline() == "policy listening\n"
        assert sandboxes()
        platform.kill()
