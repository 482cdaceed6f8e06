"""The verdict on each level, in words, in the exit code and as a badge."""

import sys
from pathlib import Path

import pytest

from conformance.reports.badge import level_badge
from conformance.run_settings import Settings
from conformance.specification.document import load_spec
from conformance.specification.ledger import LEVELS, PROFILES, SERVICE, load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded
from tests.support.kit.run_kit import run_kit

SERVER = "-m tests.support.kit.server_of_profiles"
THREE = ("sessions", "control", "faults")


def judged(
    announced: list[str], violated: str = "", level: str | None = None, only: str = ""
) -> Result:
    """Conclude that every rule passed but one, of a server with these profiles."""
    settings = Settings(
        profiles=list(LEVELS[level] if level else PROFILES),
        level=level,
        only=[only] if only else [],
        service={"profiles": announced},
    )
    failed = [Verdict(violated, Outcome.FAILED)] if violated else []
    return concluded(settings, *failed)


@pytest.mark.parametrize(
    ("result", "core", "service", "code"),
    [
        (judged([*SERVICE]), "conformant", "conformant", 0),
        (judged([], level="core"), "conformant", "10 profiles missing", 0),
        (judged(["core"]), "conformant", "10 profiles missing", 0),
        (
            judged([name for name in SERVICE if name not in THREE]),
            "conformant",
            "3 profiles missing: sessions, control, faults",
            0,
        ),
        (
            judged([*SERVICE[1:]], level="service"),
            "conformant",
            "1 profile missing: sessions",
            1,
        ),
        (judged([*SERVICE], "LEASE-001"), "conformant", "NOT conformant, 1", 1),
        (judged([*SERVICE], "PRED-001"), "NOT conformant, 1", "NOT conformant, 1", 1),
        (judged([*SERVICE], "CMP-001", "service"), "conformant", "conformant", 0),
        (
            judged([*SERVICE], only="PRED"),
            "not judged as a whole",
            "not judged as a whole",
            0,
        ),
    ],
)
def test_each_level_has_a_verdict(
    result: Result, core: str, service: str, code: int
) -> None:
    of_core, of_service = result.level_lines()
    assert of_core.startswith(f"Core: {core}")
    assert of_service.startswith(f"Service: {service}")
    assert result.exit_code == code
    for verdict in result.levels():
        drawn = level_badge(verdict)
        assert ("#1f7a38" in drawn) == (verdict.text == "conformant")
        assert ("#c62828" in drawn) == verdict.text.startswith("NOT")


def test_a_level_that_is_missed_is_named_in_the_conclusion() -> None:
    result = judged([*SERVICE[1:]], level="service")
    assert result.conclusion() == "NOT conformant: sessions missing"
    assert not judged([], level="core").is_partial


@pytest.mark.slow("a server and a kit")
def test_a_server_of_core_alone_is_conformant(tmp_path: Path) -> None:
    """The server refuses whatever belongs to a profile. Expect Core verified."""
    command = f"{sys.executable} {SERVER}"
    kit = run_kit(tmp_path, "--not-durable", "--start-cmd", command)
    assert kit.code == 0, kit.output
    core = {rule.id for rule in load_ledger().values() if rule.profile == "core"}
    assert kit.rules_with("passed") == core
    assert kit.report["levels"]["core"] == "conformant"
    assert kit.report["levels"]["service"].startswith("10 profiles missing")
    assert (tmp_path / "badge-core.svg").exists()
    assert kit.last_line == "conformant"


@pytest.mark.release("a server and a kit for each profile of Service")
@pytest.mark.parametrize("profile", SERVICE)
def test_a_profile_needs_only_those_that_it_names(tmp_path: Path, profile: str) -> None:
    """The server has Core, the profile and its needs. Expect nothing to be violated."""
    names = ("core", profile, *load_spec().document["x-needs"].get(profile, ()))
    kit = run_kit(
        tmp_path,
        *("--not-durable", "--quick", "--profile", ",".join(names)),
        *("--start-cmd", f"{sys.executable} {SERVER}"),
        ONLY_PROFILES=",".join(names),
    )
    assert kit.code == 0, kit.output
    assert not kit.rules_with("failed") | kit.rules_with("kit_error")
