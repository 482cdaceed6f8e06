"""Faults of hosts, which are network namespaces; each test runs inside of its own.

Where the machine lets none be made, they are skipped with its reason.
"""

from __future__ import annotations

import subprocess
import sys
from functools import partial
from pathlib import Path

import psutil
import pytest

from tests.campaigns.chaos.chaos_campaign import OWN_DISKS, play_faults
from tests.campaigns.chaos.chaos_faults import HOSTS, faults_of
from tests.support.network.hosts import Disk, Host, Hosts, plays_inside, why_none
from tests.support.paths import ROOT
from tests.support.processes import descendants
from tests.support.waiting import wait_until

ANSWERS = """
import socket
server = socket.create_server(("0.0.0.0", 80))
while True:
    connection, _ = server.accept()
    connection.sendall(connection.recv(1))
"""
ASKS = """
import socket, sys
with socket.create_connection((sys.argv[1], 80), 0.5) as connection:
    connection.sendall(b"x")
    sys.exit(connection.recv(1) != b"x")
"""


def _reaches(sender: Host, receiver: Host) -> bool:
    asked = sender.command([sys.executable, "-c", ASKS, receiver.address])
    done = subprocess.run(asked, check=False, capture_output=True)
    return done.returncode == 0


@pytest.mark.release("all attacks of make attack, and all faults of make chaos")
def test_packets_between_hosts_can_be_lost(
    request: pytest.FixtureRequest, tmp_path: Path
) -> None:
    if not plays_inside(request):
        return
    hosts = Hosts()
    one, other, third = (hosts.add(name) for name in ("one", "other", "third"))
    ends = [
        subprocess.Popen(host.command([sys.executable, "-c", ANSWERS]))
        for host in (hosts.here, one, other, third)
    ]
    for host in (hosts.here, one, other, third):
        wait_until(partial(_reaches, third, host), "it listens")
    hosts.partition(one, other)
    assert not _reaches(one, other)
    assert not _reaches(other, one)
    assert _reaches(one, third)
    assert _reaches(hosts.here, one)
    hosts.heal()
    assert _reaches(one, other)
    hosts.lose_way(other, one)  # its answers alone
    assert not _reaches(one, other)
    hosts.heal()
    hosts.partition(hosts.here, third)
    assert not _reaches(hosts.here, third)
    assert _reaches(one, third)
    hosts.heal()
    hosts.slow(one, 20, 64)
    assert _reaches(one, third)
    hosts.heal()
    for end in ends:
        end.kill()
        end.wait()
    disk = Disk(tmp_path / "disk", 1)
    disk.fill()
    with pytest.raises(OSError, match="No space left"):
        (tmp_path / "disk" / "file").write_bytes(b"x" * 4096)
    disk.clear()
    (tmp_path / "disk" / "file").write_bytes(b"x" * 4096)
    disk.remove()


ENDLESS = """
import time
from tests.support.network import hosts
if hosts.is_inside():
    host = hosts.Hosts().add("one")
    print(host.address, flush=True)
    time.sleep(600)
else:
    hosts.run_inside(["{}", "-c", open("{}").read()])
"""


@pytest.mark.release("all attacks of make attack, and all faults of make chaos")
def test_hosts_end_with_the_process_that_made_them(tmp_path: Path) -> None:
    """However it ends; the name of its program shows what is left."""
    if reason := why_none():
        pytest.skip(reason)
    program = tmp_path / "program.py"
    program.write_text(ENDLESS.format(sys.executable, program))
    command = [sys.executable, "-c", program.read_text()]
    with subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline()
        started = descendants(process.pid)
        assert len(started) >= 3
        process.kill()
    wait_until(lambda: not any(map(psutil.pid_exists, started)), "all have ended")
    assert "hosts" not in Path("/proc/mounts").read_text().split()


@pytest.mark.release("all attacks of make attack, and all faults of make chaos")
@pytest.mark.parametrize("name", faults_of({HOSTS}))
def test_a_cluster_of_hosts_goes_on_after_each_fault(
    name: str, request: pytest.FixtureRequest
) -> None:
    if plays_inside(request):
        own_disks = {OWN_DISKS} if "disk" in name else set[str]()
        play_faults([name], seed=3, players=3, kinds={HOSTS, *own_disks})
