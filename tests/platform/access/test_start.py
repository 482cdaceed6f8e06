"""The start of `proctor-host`: its port first, then the password."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from pathlib import Path

import httpx
import pytest

from tests.support.paths import ROOT
from tests.support.platform.hosted_server import HostedServer, MailReceiver

pytestmark = pytest.mark.slow("starts hosts")


def test_a_start_that_fails_shows_no_password(
    tmp_path: Path, mail: MailReceiver
) -> None:
    """Another program has the port. Expect its password at the start that succeeds."""
    with socket.create_server(("127.0.0.1", 0)) as other:
        port = str(other.getsockname()[1])
        refused = subprocess.run(
            [
                *(sys.executable, "-m", "reference_platform", "--submissions", "off"),
                *("--database", str(tmp_path / "platform.sqlite"), "--", "--port"),
                port,
            ],
            cwd=ROOT, capture_output=True, text=True, timeout=60, check=False,
            env=os.environ | {"PROCTOR_DATABASE": str(tmp_path / "proctor.sqlite")},
        )  # fmt: skip
    assert refused.returncode == 2
    assert (refused.stdout, "cannot listen" in refused.stderr) == ("", True)
    with HostedServer(tmp_path, mail.url) as host:
        assert host.password


def test_a_host_whose_server_has_named_names_starts(
    tmp_path: Path, mail: MailReceiver
) -> None:
    """The platform reads its server by an address. Expect others refused as before."""
    with HostedServer(tmp_path, mail.url) as host:
        host.end()
        host.start("--allowed-hosts", "eval.example.org")
        answers = [
            httpx.get(f"{host.url}/pages/login", headers={"Host": name})
            for name in ("eval.example.org", "another.example.org")
        ]
        assert [answer.status_code for answer in answers] == [303, 422]
    assert "not known to `track put`" not in (tmp_path / "log").read_text()
