"""The libraries' comparison in small: what is in our own environment.

A library that is not installed here is judged when all are measured: their environment
is one that `make test` does not make.
"""

import dataclasses
import re
import sys
from pathlib import Path

import pytest

from benchmarks.libraries import compared_libraries, samples
from benchmarks.measuring import ROOT
from benchmarks.round_trips.interleaved_rounds import Contender, started

pytestmark = pytest.mark.slow("starts servers")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A request and its answer, of a reference server."""
    made = tmp_path_factory.mktemp("samples")
    samples.capture(made)
    return made


def versions_in(lock: str) -> dict[str, str]:
    text = (ROOT / "requirements" / lock).read_text()
    return dict(re.findall(r"^([a-z0-9-]+)==(\S+)", text, re.MULTILINE))


def test_libraries_are_measured_in_the_locked_versions() -> None:
    bench, dev = versions_in("bench.txt"), versions_in("dev.txt")
    ours = {"httptools", "msgspec", "simplejpeg", "uvicorn", "uvloop"}
    assert {name: bench[name] for name in ours} == {name: dev[name] for name in ours}


def with_this_python(contender: Contender) -> Contender:
    """By the Python of the tests."""
    return dataclasses.replace(
        contender,
        server=[sys.executable, *contender.server[1:]],
        client=[sys.executable, *contender.client[1:]],
    )


@pytest.mark.parametrize("client", [compared_libraries.OURS, "http.client", "urllib3"])
def test_a_client_receives_the_sample(client: str, folder: Path) -> None:
    server = compared_libraries.CHOSEN_SERVER
    contender = compared_libraries.contender(client, server, client, folder)
    with started([with_this_python(contender)]) as (pair,):
        times = pair.play(3)
    assert len(times.ns) == 3
    assert min(times.server_cpu_s, times.client_cpu_s) > 0
