"""The stages of a server: each rule is in one, and a server of a stage can obey it."""

from __future__ import annotations

import json
import re
import sys
from pathlib import Path

import pytest

from conformance.run_settings import Settings
from conformance.specification import stages
from conformance.specification.document import load_spec
from conformance.specification.ledger import LEVELS, PROFILES, load_ledger
from conformance.specification.stages import (
    LAST,
    STAGES,
    advice_when_done,
    stage_of,
    stage_of_operation,
)
from tests.support.kit.concluded_results import concluded
from tests.support.kit.null_servers import SERVICE, Reply, Request, run_server
from tests.support.kit.run_kit import run_kit

HEAD = {"Content-Type": "application/json", "Proctor-Version": "1.0"}


def selected(stage: int | None) -> set[str]:
    settings = Settings(stage=stage, profiles=list(PROFILES))
    return {row.id for row in settings.selected_rules}


def test_stages_grow_to_the_whole() -> None:
    sizes = [len(selected(stage.number)) for stage in STAGES]
    assert sizes == sorted(set(sizes))
    assert selected(LAST) == selected(None)


def test_exceptions_are_rules_that_their_area_places_elsewhere() -> None:
    rules = load_ledger()
    for id_, number in stages._BY_ID.items():
        assert number != stages._BY_AREA.get(rules[id_].area, LAST), id_


def test_profiles_belong_to_the_last_stage() -> None:
    assert stage_of(load_ledger()["EVT-001"]) == LAST
    assert stage_of(load_ledger()["CRASH-001"]) == LAST


def test_a_rule_about_the_score_belongs_to_the_stage_that_serves_it() -> None:
    assert "get_score" in STAGES[LAST - 1].operations
    assert stage_of(load_ledger()["RES-003"]) == LAST


def test_advice_names_what_comes_next() -> None:
    assert "--stage 2" in advice_when_done(1, None, skips=False)
    assert "without --stage" in advice_when_done(LAST, None, skips=False)


@pytest.mark.parametrize("level", [None, "core", "service"])
def test_stages_name_each_operation_of_the_level_once(level: str | None) -> None:
    said = " ".join(stage.adds(level) for stage in STAGES)
    profiles = LEVELS[level or "service"]
    operations = load_spec().operations.values()
    due = [o.operation_id for o in operations if o.profile in profiles]
    named = [name for name in re.findall("`(.*?)`", said) if name != "calibration"]
    assert sorted(named) == sorted(due)


def test_a_core_server_is_sent_past_the_stage_of_leases() -> None:
    assert "--stage 6 --level core" in advice_when_done(4, "core", skips=False)
    assert "Idempotency" not in advice_when_done(2, "core", skips=False)


def test_tokens_and_refusals_belong_to_the_stage_that_serves_them_first() -> None:
    rules = load_ledger()
    for id_, number in (("AUTH-001", 2), ("ERR-001", 2), ("ERR-003", 4)):
        assert stage_of(rules[id_]) == number
    assert stage_of_operation("predict") == stage_of(rules["PRED-001"])
    assert stage_of(rules["STOP-002"], "core") < stage_of(rules["STOP-002"])


def test_a_stage_is_not_done_while_rules_are_skipped() -> None:
    assert "done" not in advice_when_done(LAST, None, skips=True)
    service = {"profiles": ["core"]}
    settings = Settings(stage=3, quick=True, profiles=["core"], service=service)
    result = concluded(settings)
    assert result.exit_code == 0
    said = result.advice()
    assert said is not None
    assert "done" not in said
    assert "without --quick" in said


def serve_first_stage(request: Request) -> Reply:
    """Serve `describe_service` and nothing else."""
    if request.path != "/v1":
        return 404, HEAD, b"{}"
    return 200, HEAD, json.dumps(SERVICE | {"profiles": ["core"]}).encode()


@pytest.mark.slow("starts kits")
@pytest.mark.parametrize(
    ("stage", "code", "says"),
    [(1, 0, "stage 1 of 6 (describe) is done; next,"), (2, 2, "stage 2 of 6")],
)
def test_a_server_of_the_first_stage(
    tmp_path: Path, stage: int, code: int, says: str
) -> None:
    """Nothing else is needed to be judged: no token, no benchmark."""
    with run_server(serve_first_stage) as url:
        kit = run_kit(tmp_path, "--url", url, "--stage", str(stage))
    assert kit.code == code, kit.output
    assert says in kit.output
    assert kit.report["stage"] == stage


@pytest.mark.release("a server and a kit for each stage of a level")
@pytest.mark.parametrize("stage", [2, 3, 4, 5])
@pytest.mark.parametrize("level", LEVELS)
def test_a_server_of_a_stage_can_finish_it(
    tmp_path: Path, stage: int, level: str
) -> None:
    """The server has the operations of the stage and none of a later one."""
    command = f"{sys.executable} -m tests.support.kit.server_of_profiles"
    kit = run_kit(
        tmp_path,
        *("--start-cmd", command, "--stage", str(stage), "--level", level),
        ONLY_PROFILES=",".join(LEVELS[level]),
        UP_TO_STAGE=str(stage),
    )
    assert kit.code == 0, kit.output
    assert "is done; next, serve " in kit.output
