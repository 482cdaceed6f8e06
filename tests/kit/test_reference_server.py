"""The kit on our server: rules that no other test of `make test` judges as a whole."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from conformance.specification.ledger import load_ledger
from tests.support.forking.forked_servers import server_command
from tests.support.kit.run_kit import run_kit


@pytest.mark.slow("starts a server and a kit")
@pytest.mark.parametrize(
    ("profiles", "areas"),
    [
        # Rules of episodes hold for runs that these clients play, too.
        ("ebench,flageval", ("EBE", "FLE", "EPI")),
        *(("", ("CHAT",)), ("", ("CRASH",)), ("", ("PUSH",))),
    ],
)
def test_the_reference_server_obeys_the_rules_of_areas(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    profiles: str,
    areas: tuple[str, ...],
) -> None:
    # The kit's model servers are on this machine.
    monkeypatch.setenv("PROCTOR_ALLOW_PRIVATE_POLICIES", "127.0.0.0/8")
    monkeypatch.setenv("PROCTOR_PROFILES", profiles)
    options = ("--start-cmd", shlex.join(server_command()), "--only", ",".join(areas))
    kit = run_kit(tmp_path, *options)
    assert kit.code == 0, kit.output[-3000:]
    assert kit.outcomes == {
        row.id: "passed" if row.is_observable else "not_verified"
        for row in load_ledger().values()
        if row.id.partition("-")[0] in areas
    }
