"""FlagEval's API as its scripts use it, over push runs of a scripted chat model."""

from __future__ import annotations

import re
from typing import Any

import pytest

from conformance.policy.scripted_chat import ScriptedChat
from reference_server.http.handlers import Handlers
from reference_server.profiles.flageval.evaluation_responses import TOLERANCE, status_of
from reference_server.profiles.operation_tables import profile_tables
from reference_server.rules.runs.run import Episode
from reference_server.settings import Settings
from tests.support.paths import ROOT
from tests.support.server.runs import make_run
from tests.support.servers import TOKENS, ReferenceServer


@pytest.mark.parametrize(
    ("state", "retryable", "faults", "letter"),
    [
        ("queued", None, 0, "R"),
        ("ready", None, 0, "R"),
        ("running", None, 0, "R"),
        ("stopping", None, 0, "C"),
        ("stopped", None, 0, "C"),
        ("completed", None, 0, "S"),
        ("failed", True, 0, "OOR"),
        ("failed", True, 2, "OOR"),
        ("failed", True, 3, "F"),
        ("failed", False, 0, "F"),
    ],
)
def test_status_letters_follow_from_the_run_state(
    state: Any, retryable: Any, faults: int, letter: str
) -> None:
    run = make_run(state=state, retryable=retryable)
    run.manifest = {**run.manifest, "max_faults": 3}
    broken = Episode(0, "a", "x", 1)
    broken.faults = faults
    assert status_of(run, [broken]) == letter


def test_the_profile_is_offered_only_when_enabled(server: ReferenceServer) -> None:
    with server.client() as client:
        assert "flageval" in client.get("/v1").json()["profiles"]
        assert client.get("/evaldiffs?request_id=none").json()["err_code"] == 1
    nothing: Any = None
    for asked, paths in (("", 0), ("flageval", 6)):
        routes = Handlers(Settings(profiles=asked), nothing)
        assert len(profile_tables(routes)) == paths


# --- docs/evaluate/flageval.md ---


def test_the_script_of_the_page_runs(
    server: ReferenceServer, chat: ScriptedChat, capsys: pytest.CaptureFixture[str]
) -> None:
    page = (ROOT / "docs" / "evaluate" / "flageval.md").read_text()
    (script,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names = {
        "TOKEN": TOKENS["alice"],
        "URL": server.url,
        "EVAL_URL": chat.completions_url,
        "MODE": "calibration",
    }
    exec(compile(script, "flageval.md", "exec"), names)  # noqa: S102 - our own page
    assert capsys.readouterr().out.splitlines() == [
        "Qwen3-8B-nvidia-origin S release",
        "Qwen3-8B-other S release",
    ]


def test_the_page_states_the_tolerance() -> None:
    page = (ROOT / "docs" / "evaluate" / "flageval.md").read_text()
    assert f"beyond {TOLERANCE:g}," in page
