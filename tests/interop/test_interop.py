"""The interop machine: no judge passes what is wrong or what was not run.

That the clients pass is in test_every_client.py.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_client.api.observation import decode_observation
from reference_client.generated import messages
from tests.interop import expected_values
from tests.interop.clients import LANGUAGES, PACKAGES, Language
from tests.interop.later_version import NEW, extended
from tests.interop.scenarios import (
    SCENARIOS,
    Program,
    Server,
    UnexpectedResult,
    apply_known_limits,
)
from tests.support.client.evaluations import play
from tests.support.client.policies import GradedPolicy
from tests.support.network.lossy_proxy import Proxy
from tests.support.paths import ROOT
from tools import interop

pytestmark = pytest.mark.slow("starts servers and clients")

PYTHON = LANGUAGES[0]


def program_printing(text: str, language: str = "python") -> Program:
    command = [sys.executable, "-c", f"print({text!r})"]
    return Program(language, command, {}, command)


@pytest.mark.parametrize("name", SCENARIOS)
def test_no_scenario_accepts_an_empty_result(name: str, server: Server) -> None:
    cell = interop.judge(name, server, program_printing("{}"))
    assert cell.outcome == interop.FAILED


def test_one_wrong_number_fails_the_scenario(server: Server) -> None:
    sound = {
        "executed": [4, 4, 2],
        "counts": [[1, 2, 3, 4], [5, 6, 7, 8], [9, 10]],
        "rewards": [4, 4, 2],
        "stopped_early": [False, False, True],
        "truncated": [False, False, True],
        "done": True,
        "steps": 10,
    }
    SCENARIOS["chunks"](server, program_printing(json.dumps(sound)))
    with pytest.raises(UnexpectedResult):
        SCENARIOS["chunks"](server, program_printing(json.dumps(sound | {"steps": 9})))


def test_the_proxy_loses_one_answer_of_a_kind(server: Server) -> None:
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    headers = {"Authorization": f"Bearer {server.token}", "Idempotency-Key": "proxy"}
    with (
        Proxy(server.url, drop=["submit"]) as proxy,
        httpx.Client(base_url=proxy.url, headers=headers, trust_env=False) as client,
    ):
        with pytest.raises(httpx.TransportError):
            client.post("/v1/runs", json=body)
        answer = client.post("/v1/runs", json=body)
    assert answer.status_code == 201
    assert answer.json()["endpoint"] == proxy.url
    assert proxy.dropped_answers == ["submit"]
    assert len(proxy.repeats("submit")) == 1
    listed = server.read("/v1/runs?limit=1000")["runs"]
    assert [run["run_id"] for run in listed].count(answer.json()["run_id"]) == 1


def test_the_reference_client_reads_a_later_version(server: Server) -> None:
    with Proxy(server.url, alter=extended) as proxy:
        assert play(proxy, GradedPolicy, "score", dry_turn=True).complete


def test_a_tensor_of_a_later_dtype_is_left_out() -> None:
    tensors = {
        "new": messages.Tensor(dtype=NEW, shape=[1], data=memoryview(b"\0")),
        "old": messages.Tensor(dtype="uint8", shape=[1], data=memoryview(b"\1")),
    }
    seen = messages.Observation(state={}, images={}, tensors=tensors)
    assert list(decode_observation(seen, "", "", 0).tensors) == ["old"]


def test_what_a_later_version_adds() -> None:
    answer = {"profiles": ["core"], "images": {"front": {"codec": "raw"}}, "code": "x"}
    assert extended(answer) == {
        "profiles": ["core", NEW],
        "images": {"front": {"codec": NEW, NEW: {"any": [1, None]}}},
        "code": NEW,
        NEW: {"any": [1, None]},
    }


def test_a_missing_toolchain_counts_as_not_run(
    server: Server, capsys: pytest.CaptureFixture[str]
) -> None:
    matrix = interop.Matrix()
    absent = replace(
        PYTHON, name="klingon", tools=("no-such-compiler",), install="a compiler of it"
    )
    interop.play(absent, server, ["chunks"], matrix)
    cell = matrix.cells["klingon"]["chunks"]
    why = "no-such-compiler not found; install a compiler of it"
    assert (cell.outcome, cell.why) == (interop.NOT_RUN, why)
    assert f"klingon: not run: {why}" in capsys.readouterr().out
    line = interop.last_line(matrix, ["python", "klingon"])
    assert line == "interop: languages played: none; not played: python, klingon"
    assert matrix.exit_code() == 2
    assert "✔" not in "\n".join(interop.table(matrix))
    matrix.cells["klingon"]["echo"] = interop.Cell(interop.FAILED, "why")
    assert matrix.exit_code() == 1


def test_a_build_that_fails_is_a_failure(
    server: Server, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tests.interop.clients.CACHE", tmp_path)
    broken = replace(PYTHON, steps=((sys.executable, "-c", "raise SystemExit('oh')"),))
    matrix = interop.Matrix()
    interop.play(broken, server, ["chunks"], matrix)
    assert matrix.cells["python"]["chunks"].outcome == interop.FAILED
    assert "oh" in matrix.cells["python"]["chunks"].why
    assert interop.Matrix().exit_code() == 2


def test_every_client_of_ours_is_played() -> None:
    present = {
        f"{folder}/{path.name}"
        for folder in ("clients", "generated_clients")
        for path in (ROOT / folder).iterdir()
        if path.is_dir()
    }
    assert present == {language.package for language in LANGUAGES}
    for language in LANGUAGES:
        assert (ROOT / language.package / "interop").is_dir()
        assert (ROOT / language.package / "example").is_dir()


def test_lock_files_name_no_address() -> None:
    for folder in ("clients", "generated_clients"):
        path = ROOT / folder / "typescript" / "package-lock.json"
        packages = json.loads(path.read_text())["packages"]
        assert all("resolved" not in package for package in packages.values())
    assert (ROOT / "clients" / "rust" / "Cargo.lock").exists()


@pytest.fixture(scope="module")
def faults(built: Callable[[Language], Program]) -> dict[str, Any]:
    """The output of the package at servers that are silent or answer wrongly."""
    package = PACKAGES["typescript"]
    file = "clients/typescript/interop/faults.js"
    command = package.start(package.directory, file)
    return replace(built(package), command=command).play("", "", "")


def test_typescript_keeps_a_lease_of_any_length(faults: dict[str, Any]) -> None:
    assert faults["heartbeats"] == 1
    assert faults["own_mistake"]["error"] == "URIError", "it must not be hidden"


def test_typescript_refuses_a_wrong_number_of_workers(faults: dict[str, Any]) -> None:
    assert faults["workers"] == {"errors": ["TypeError"] * 4, "requests": 0}


def test_typescript_says_which_attempt_was_lost_and_why(
    faults: dict[str, Any],
) -> None:
    """As the Python client does, by the same table."""
    assert faults["causes"] == [
        *("5.0 standstill", "5.0 unreached", "4.0 standstill", "4.5 request"),
        *("4.1 standstill", "60.6 suspended", "4.0 standstill"),
    ]
    said = "w lost its session before the first step of e: this program stood still"
    assert faults["lost"] == [f"{said} for longer than its lease of 3.1 s", None]


def test_typescript_names_what_makes_no_policy(faults: dict[str, Any]) -> None:
    assert faults["policies"] == ["TypeError", "TypeError"]


def test_typescript_repeats_a_poll_whose_body_is_lost(faults: dict[str, Any]) -> None:
    assert faults["lost_body"] == ["completed"]
    assert faults["html"]["error"] == "bad_answer"


def test_typescript_repeats_a_turn_that_a_dead_connection_lost(
    faults: dict[str, Any],
) -> None:
    """In time for the lease, and not after the minute that a busy server has."""
    seen = faults["dead_connection"]
    assert (seen["error"], seen["connections"]) == ("none", 2)
    assert seen["seconds"] < 20
    assert "answered 405 with a page, text/html" in faults["gateway"]


def test_a_silent_server_does_not_hold_typescript(faults: dict[str, Any]) -> None:
    # The requests themselves would be given up after 60 s.
    limits = {"interrupted": 10, "leave": 15, "service": 20}
    for name, error in (
        ("interrupted", "RangeError"),
        ("leave", "none"),
        ("service", "unreachable"),
    ):
        assert faults[name]["error"] == error
        assert faults[name]["seconds"] < limits[name]


def test_typescript_says_why_it_leaves_an_episode(faults: dict[str, Any]) -> None:
    """Before it detaches, as no action was executed; without secrets."""
    heartbeat, detach = faults["reason"]["requests"]
    said = {"session_id": "s", "reason": "http://host refused (token)"}
    assert json.loads(heartbeat.removeprefix("POST ")) == said
    assert detach == "DELETE "
    assert faults["reason"]["longest"] == "\U0001f916" * 499 + "…"


def test_typescript_refuses_partial_observations(faults: dict[str, Any]) -> None:
    assert faults["base64"] == ["none"] * 4 + ["bad_answer"] * 5
    assert faults["shapes"] == ["none"] * 3 + ["bad_answer"] * 3


def test_typescript_checks_actions_of_some_tasks(faults: dict[str, Any]) -> None:
    assert faults["optional_vector"] == ["none"] * 2 + ["invalid_request"] * 5


@pytest.mark.parametrize(
    ("one", "other", "equal"),
    [
        (1, 1.0, True),
        (True, 1, False),
        (0.0, -0.0, False),
        ({"a": [1]}, {"a": [1]}, True),
        ({"a": 1}, {"a": 1, "b": 2}, False),
        ([1], [1, 2], False),
        ({"a_at": "2026-03-01T12:00:00Z"}, {"a_at": "2026-03-01T13:00:00+01:00"}, True),
    ],
)
def test_what_counts_as_the_same_value(one: object, other: object, equal: bool) -> None:
    assert expected_values.values_equal(one, other) is equal


def test_only_documented_limits_are_tolerated() -> None:
    wanted = ["8000000000000000", "3fb999999999999a"]
    lost_sign = ["0000000000000000", "3fb999999999999a"]
    one_off = ["8000000000000000", "3fb9999999999999"]
    assert apply_known_limits("typescript", lost_sign, wanted) == wanted
    for language, observed in (("go", lost_sign), ("typescript", one_off)):
        assert apply_known_limits(language, observed, wanted) != wanted
    assert not expected_values.values_equal([0.1], [0.1 + 2**-56])
