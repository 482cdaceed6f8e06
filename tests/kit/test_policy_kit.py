"""The kit for policy servers: it passes ours, and fails exactly what each broken one
breaks.
"""

import json
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema_rs
import numpy as np
import openapi_spec_validator
import pytest
from starlette.requests import Request

from conformance.cli.kit_command import BadArguments
from conformance.policy.benchmark_source import _EvaluationServer, read_benchmark
from conformance.policy.turn_builder import calibration
from conformance.specification.document import load_policy_spec, load_spec
from conformance.specification.ledger import POLICY, load_ledger
from reference_client import Observation
from reference_client.policies import policy_http_app
from reference_client.policies.policy_http_app import PolicyApp, Refusal
from reference_client.policies.policy_thread import PolicyThread
from reference_sim.benchmarks.tabletop.plans import PLANS
from tests.support.client import policy_apps
from tests.support.client.policy_apps import ACTION, KEY, CountingPolicy, make_app
from tests.support.kit.run_kit import KitRun, run_policy_kit
from tests.support.paths import ROOT
from tests.support.repository.specification import load
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("starts policy servers and kits")


def judge(url: str, folder: Path, *options: str, key: str | None = KEY) -> KitRun:
    flags = ("--url", url, *options, "--seed", "1")
    environment = {} if key is None else {"PROCTOR_POLICY_KEY": key}
    return run_policy_kit(folder, *flags, **environment)


# --- policies that are broken on purpose; each is an app and the row that it breaks ---


def answers(operation: str, **changes: Any) -> Callable[[PolicyApp], None]:
    """Change members of an answer; a function of the answer gives the value."""

    def break_it(app: PolicyApp) -> None:
        right = getattr(app, operation)

        async def wrong(request: Request) -> dict[str, Any]:
            body: dict[str, Any] = await right(request)
            return body | {
                name: change(body) if callable(change) else change
                for name, change in changes.items()
            }

        setattr(app, operation, wrong)

    return break_it


def answers_randomly(app: PolicyApp) -> None:
    def action(_body: Any) -> Any:
        return [{"values": ACTION | {"score": [random.random()]}}]

    answers("predict", actions=action)(app)


async def session_of(request: Request) -> str:
    found = re.search(rb'"session_id": ?"([^"]+)"', await request.body())
    return found[1].decode() if found else ""


def plays_without_a_reset(app: PolicyApp) -> None:
    class Ready(CountingPolicy):
        acts = 0

    right = app.predict

    async def wrong(request: Request) -> policy_http_app.Answer:
        session_id = await session_of(request)
        ready = policy_http_app._ServedSession(
            Ready(), PolicyThread(), is_ready=True, run_id="run_kit"
        )
        app._sessions.setdefault(session_id, ready)
        return await right(request)

    app.predict = wrong  # type: ignore[method-assign]


def is_reset_once(app: PolicyApp) -> None:
    right = app.reset

    async def wrong(request: Request) -> policy_http_app.Answer:
        if await session_of(request) in app._sessions:
            raise Refusal("session_ended", "Once is enough.")
        return await right(request)

    app.reset = wrong  # type: ignore[method-assign]


def announces_too_many_sessions(app: PolicyApp) -> None:
    answers("describe_policy", max_sessions=16)(app)
    app._max_sessions = 1


def answers_another_code(there: str, here: str) -> Callable[[PolicyApp], None]:
    """Refuse with another code."""

    def break_it(app: PolicyApp) -> None:
        for operation in ("reset", "predict"):
            right = getattr(app, operation)

            async def wrong(request: Request, right: Any = right) -> Any:
                try:
                    return await right(request)
                except Refusal as refusal:
                    code = here if refusal.code == there else refusal.code
                    raise Refusal(code, str(refusal)) from refusal

            setattr(app, operation, wrong)

    return break_it


def checks_the_key_only_at_describe_and_reset(app: PolicyApp) -> None:
    right = app._authenticate

    def wrong(request: Request) -> None:
        if not request.url.path.endswith("predict"):
            right(request)

    app._authenticate = wrong  # type: ignore[method-assign]


def refuses_unknown_members(app: PolicyApp) -> None:
    for operation in ("reset", "predict"):
        right = getattr(app, operation)

        async def wrong(request: Request, right: Any = right) -> Any:
            if b"of_a_later_version" in await request.body():
                raise Refusal("invalid_request", "What is that?")
            return await right(request)

        setattr(app, operation, wrong)


BROKEN: dict[str, Callable[[PolicyApp], None]] = {
    "POL-001": answers("describe_policy", protocol={"min": "2.0", "max": "2.1"}),
    "POL-002": answers("describe_policy", name=7),
    "POL-003": answers("reset", attempt=1),
    "POL-004": answers("predict", seq=lambda body: body["seq"] + 1),
    "POL-005": answers("predict", actions=[{"values": ACTION | {"score": [2.0]}}]),
    "POL-006": answers_randomly,
    "POL-007": plays_without_a_reset,
    "POL-008": is_reset_once,
    "POL-009": announces_too_many_sessions,
    "POL-010": answers_another_code("malformed_body", "invalid_request"),
    "POL-011": answers_another_code("invalid_request", "malformed_body"),
    "POL-012": checks_the_key_only_at_describe_and_reset,
    "POL-013": refuses_unknown_members,
}


def broken_app(break_it: Callable[[PolicyApp], None]) -> PolicyApp:
    """Broken before its routes are made, which take its methods as they are then."""
    app = PolicyApp.__new__(PolicyApp)
    break_late = PolicyApp._as_endpoint

    def guarded(operation: Any) -> Any:
        name = operation.__name__

        async def latest(request: Request) -> Any:
            return await getattr(app, name)(request)

        return break_late(app, latest)

    app._as_endpoint = guarded  # type: ignore[method-assign]
    app.__init__(CountingPolicy, "broken", key=KEY)  # type: ignore[misc]
    break_it(app)
    return app


def test_every_rule_that_can_be_seen_has_a_server_that_breaks_it() -> None:
    rows = [row for row in load_ledger().values() if row.profile == POLICY]
    assert {row.id for row in rows if row.is_observable} == set(BROKEN)


def test_our_own_server_is_conformant(tmp_path: Path) -> None:
    with policy_apps.run_app(make_app().app) as url:
        kit = judge(url, tmp_path)
    assert (kit.code, kit.report["problem"]) == (0, None)
    assert set(kit.outcomes.values()) == {"passed"}
    assert kit.report["conclusion"] == "conformant"


@pytest.mark.parametrize("row", BROKEN)
def test_a_broken_server_fails_exactly_its_row(row: str, tmp_path: Path) -> None:
    with policy_apps.run_app(broken_app(BROKEN[row]).app) as url:
        kit = judge(url, tmp_path)
    assert kit.code == 1
    assert kit.rules_with("failed") == {row}


def test_without_a_key_the_key_rule_is_not_applicable(tmp_path: Path) -> None:
    with policy_apps.run_app(make_app(key=None).app) as url:
        kit = judge(url, tmp_path, "--only", "POL-012,POL-004", key=None)
    assert kit.code == 0
    assert kit.outcomes == {"POL-012": "not_applicable", "POL-004": "passed"}


def test_a_benchmark_of_ones_own_is_played(tmp_path: Path) -> None:
    """The policy answers for calibration, and the file wants something else."""
    actions = calibration()["action_space"]
    elsewhere = actions["score"] | {"minimum": [2], "maximum": [3]}
    other = calibration() | {"action_space": actions | {"score": elsewhere}}
    (tmp_path / "b.json").write_text(json.dumps(other))
    with policy_apps.run_app(make_app().app) as url:
        flag = ("--benchmark", str(tmp_path / "b.json"), "--only", "POL-00")
        kit = judge(url, tmp_path, *flag)
    assert kit.code == 1
    assert kit.rules_with("failed") == {"POL-005"}


class KnowsItsInstructions:
    """As scripted experts: it fails by any instruction that `tabletop` does not have,
    and by a quaternion that is zero."""

    def reset(self, instruction: str) -> None:
        PLANS[instruction.split(maxsplit=1)[0]]

    def act(self, observation: Observation) -> dict[str, Any]:
        assert np.linalg.norm(observation.state["ee_pose"][3:7]) > 0.5
        joints = observation.state["joint_position"]
        return {"joint_position": joints, "gripper": [1.0]}


def test_a_benchmark_is_read_from_a_server_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect the kit to begin an episode of it as the server does and to leave no run
    there, to name what a server does not have, and what is wrong with the token."""
    with (
        ReferenceServer(tmp_path) as server,
        policy_apps.run_app(make_app().app) as url,
        policy_apps.run_app(PolicyApp(KnowsItsInstructions, "n", key=KEY).app) as knows,
    ):
        flags = ["--server", server.url, "--benchmark"]
        monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
        kit = judge(knows, tmp_path, *flags, "tabletop_state")
        assert (kit.code, set(kit.outcomes.values())) == (0, {"passed"})
        kit = judge(url, tmp_path, *flags, "calibration", "--only", "POL-005")
        assert (kit.code, kit.outcomes["POL-005"]) == (0, "passed")
        kit = judge(url, tmp_path, *flags, "tabletop_state", "--only", "POL-005")
        assert (kit.code, kit.outcomes["POL-005"]) == (2, "not_verified")
        with server.client("alice") as client:
            assert client.get("/v1/runs").json()["runs"] == []
        kit = judge(url, tmp_path, *flags, "tabletopp")
        assert (kit.code, "has no such benchmark" in kit.report["problem"]) == (2, True)
        for token, said in (
            (None, "requires a token; set PROCTOR_TOKEN"),
            ("stale", "refused the token of PROCTOR_TOKEN"),
            (TOKENS["reader"], "403"),
        ):
            if token is None:
                monkeypatch.delenv("PROCTOR_TOKEN")
            else:
                monkeypatch.setenv("PROCTOR_TOKEN", token)
            kit = judge(url, tmp_path, *flags, "calibration")
            assert (kit.code, said in kit.report["problem"]) == (2, True), said


@pytest.mark.parametrize(
    ("changes", "instruction", "said"),
    [
        ({}, None, None),
        ({"benchmark_id": "mine"}, "Lift the cube.", None),
        ({"benchmark_id": "mine"}, None, "--instruction TEXT"),
    ],
)
def test_an_instruction_is_made_up_for_no_benchmark_that_is_named(
    changes: dict[str, Any], instruction: str | None, said: str | None, tmp_path: Path
) -> None:
    path = tmp_path / "b.json"
    path.write_text(json.dumps(calibration() | changes))
    if said is not None:
        with pytest.raises(BadArguments, match=said):
            read_benchmark(str(path), instruction, "http://127.0.0.1:1", None)
        return
    _, beginning = read_benchmark(str(path), instruction, "http://127.0.0.1:1", None)
    assert beginning.instruction == (instruction or "Calibration task score.")


@pytest.mark.parametrize(
    "changes", [{"physical": {}}, {"unavailable_reason": "Install MuJoCo."}]
)
def test_no_robot_begins_for_the_kit(
    changes: dict[str, Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    described = calibration() | changes
    monkeypatch.setattr(
        _EvaluationServer, "_send", lambda *_: (200, json.dumps(described).encode())
    )
    with pytest.raises(BadArguments, match="--instruction TEXT"):
        read_benchmark("cell", None, "http://127.0.0.1:1", None)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["http://127.0.0.1:1"], "no response from"),
        (["ftp://127.0.0.1"], "must be like http://"),
        (["http://127.0.0.1:1", "--only", "PRED"], "no rule id starts with PRED"),
        (["http://127.0.0.1:1", "--benchmark", "nowhere.json"], "nowhere.json"),
        (
            [
                "http://127.0.0.1:1",
                *("--benchmark", "tabletop", "--server", "http://127.0.0.1:1"),
            ],
            "no response from http://127.0.0.1:1",
        ),
    ],
)
def test_what_cannot_be_judged_ends_with_2(
    arguments: list[str], said: str, tmp_path: Path
) -> None:
    kit = judge(arguments[0], tmp_path, *arguments[1:])
    assert kit.code == 2
    assert said in kit.report["problem"]


def test_a_wrong_key_cannot_be_judged(tmp_path: Path) -> None:
    with policy_apps.run_app(make_app().app) as url:
        kit = judge(url, tmp_path, key="wrong")
    assert kit.code == 2
    assert "PROCTOR_POLICY_KEY" in kit.report["problem"]


# --- the document ---

DOCUMENT = load((ROOT / "spec" / "policy.yaml").read_text())


def test_the_document_is_valid_openapi() -> None:
    base = (ROOT / "spec" / "policy.yaml").as_uri()
    openapi_spec_validator.validate(DOCUMENT, base_uri=base)


def test_policy_rules_name_operations() -> None:
    operations = load_policy_spec().operations.keys()
    for rule in load_ledger().values():
        if rule.profile == "policy":
            assert rule.operations
            assert operations >= set(rule.operations)


def test_policy_problems_match_openapi_yaml() -> None:
    assert set(DOCUMENT["x-problems"]) <= set(load_spec().problems)
    assert not set(DOCUMENT["x-problems-of-policies"]) & set(load_spec().problems)
    ours = {
        code: (entry["status"], entry["retryable"])
        for code, entry in load_policy_spec().problems.items()
        if code in policy_http_app.PROBLEMS
    }
    assert ours == {code: entry[:2] for code, entry in policy_http_app.PROBLEMS.items()}


def test_the_kits_own_calibration_fits_the_schema() -> None:
    jsonschema_rs.validate(load_spec().schema("Benchmark"), calibration())
