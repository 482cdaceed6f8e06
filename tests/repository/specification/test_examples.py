"""The examples are promises: a server in another language obeys every rule.

They were written from the specification alone; when one fails and the reference server
does not, suspect the kit of knowing the reference server.
"""

import subprocess
from pathlib import Path

import pytest

from conformance.specification.ledger import CORE, PROFILES, SERVICE, load_ledger
from tests.support.kit.run_kit import run_kit
from tools.example_servers import (
    GO,
    SERVER_GO,
    START_SERVER_JS,
    build_server_go,
    run_go,
)

pytestmark = pytest.mark.slow("a server and a kit")

needs_go = pytest.mark.skipif(not GO, reason="set-up brings no Go")
# No outsider can see these.
UNSEEN = {"AUTH-006", "AUTH-007", "AUTH-008", "ATT-009", "LIFE-808", "LIFE-809"}
# Both serve `calibration` alone.
ONE_BENCHMARK = {"RUN-007"}


def not_offered(profiles: set[str]) -> set[str]:
    """Rules of the profiles that a server does not announce."""
    others = set(PROFILES) - profiles
    return {row.id for row in load_ledger().values() if row.profile in others}


def without_verdict(command: str, reports: Path) -> set[str]:
    """Judge the server with the whole kit; return the rules that did not pass."""
    kit = run_kit(reports, "--seed", "7", "--start-cmd", command)
    assert kit.code == 0, kit.output
    return kit.rows.keys() - kit.rules_with("passed")


def test_server_js_is_conformant(tmp_path: Path) -> None:
    """The kit starts and judges it. Expect every rule of Core to hold."""
    rest = ONE_BENCHMARK | not_offered({CORE})
    assert without_verdict(START_SERVER_JS, tmp_path) == rest


@needs_go
def test_server_go_is_conformant(tmp_path: Path) -> None:
    """The kit also kills the server in Go, built here. Expect the level Service."""
    server = build_server_go(tmp_path)
    rest = UNSEEN | ONE_BENCHMARK
    rest |= not_offered({CORE, *SERVICE, "msgpack", "crash", "compare", "events"})
    assert without_verdict(str(server), tmp_path / "report") == rest


@needs_go
def test_server_go_is_clean() -> None:
    """Expect nothing from gofmt and vet, and the golden vectors to hold."""
    assert GO is not None
    gofmt = Path(GO).resolve().with_name("gofmt")
    assert subprocess.check_output([gofmt, "-l", "."], cwd=SERVER_GO) == b""
    run_go("vet", "./...")
    run_go("test", "./...")
