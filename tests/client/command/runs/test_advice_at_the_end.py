"""The advice of `proctor run` when it ends without a score."""

import contextlib
from types import SimpleNamespace
from typing import Any, cast

import pytest
from proctor_client import Run

from reference_client.command.command_line.arguments import parse
from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.output.printer import Printer
from reference_client.command.runs import running
from reference_client.command.runs.running import _EvaluationCommand
from reference_client.errors import (
    NOT_TRUSTED,
    POLICY_FAILED,
    UNREACHABLE,
    WORKER_DIED,
    ProctorError,
    RunFailed,
    RunStopped,
    as_sentence,
)
from reference_client.evaluation.status_board import describe_left
from reference_client.protocol.worker_session import LeftEpisode
from reference_record.command_line.default_server import DEFAULT_URL
from tests.support.paths import ROOT

AT_ONCE = "\nTo continue:\n  proctor run --run-id run_1"
MENDED = "\nWhen that is mended, to continue:\n  proctor run --run-id run_1"
REFUSED = ProctorError("benchmark_unavailable", "It has changed.")
NEVER = "\nThis run cannot be continued.\n"


def run_of(reason: str, *, retryable: bool = True) -> Run:
    run = SimpleNamespace(run_id="run_1", reason=reason, retryable=retryable)
    return cast("Run", run)


RUN = cast(
    "Run",
    SimpleNamespace(
        run_id="run_1",
        benchmark_id="kitchen",
        select=SimpleNamespace(tasks=["stir", "fry"], splits=None),
    ),
)
ANEW = "proctor run --policy mine.py:P --benchmark kitchen --tasks stir,fry --workers 2"
FAILED = RunFailed(run_of("Episode e0000 faulted 3 times"))


@pytest.mark.parametrize(
    ("error", "advice"),
    [
        (ProctorError(UNREACHABLE, "No answer.", retryable=True), AT_ONCE),
        (ProctorError(WORKER_DIED, "It exited.", retryable=True), AT_ONCE),
        (RunStopped(run_of("Stopped by its submitter.")), AT_ONCE),
        (FAILED, MENDED),
        (ProctorError(NOT_TRUSTED, "Its certificate is not accepted."), MENDED),
        (ProctorError(POLICY_FAILED, "The policy raised."), MENDED),
        (ProctorError("unauthenticated", "Unknown token."), MENDED),
        (ProctorError("convention_mismatch", "Radians."), MENDED),
        (RunFailed(run_of("A task cannot be played", retryable=False)), NEVER),
        (REFUSED, MENDED),
        (ProctorError("not_found", "There is no run run_1."), NEVER),
    ],
    ids=lambda value: getattr(value, "code", ""),
)
def test_a_command_is_advised_that_can_help(
    error: ProctorError,
    advice: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(_EvaluationCommand, "_new_run_may_help", lambda *_: False)
    args = parse(["run", "--policy", "mine.py:P", "--benchmark", "tabletop"])
    command = _EvaluationCommand(args, Printer(as_json=False), None)
    command._run = run_of("")
    ended: Any = command._report_refusal(error)
    assert advice in capsys.readouterr().err
    assert ("resume" in ended.value) == (advice != NEVER)


@pytest.mark.parametrize(
    ("error", "benchmark", "helps"),
    [
        (FAILED, {"simulator": {"sources": {"b.py": "0f"}}}, True),
        (FAILED, {"simulator": {"sources": {}}}, False),
        (FAILED, {"simulator": {}}, False),
        (FAILED, None, False),
        (REFUSED, {"simulator": {}}, True),
        (REFUSED, {"unavailable_reason": "It needs a robot."}, False),
        (REFUSED, None, False),
        (ProctorError(POLICY_FAILED, "Submit another run."), {}, False),
    ],
    ids=[
        "failed-with-files",
        "failed-with-no-file",
        "failed",
        "failed-and-gone",
        "another-manifest",
        "unavailable",
        "gone",
        "other-code",
    ],
)
def test_where_a_new_run_may_help_its_command_is_printed(
    error: ProctorError,
    benchmark: dict[str, Any] | None,
    helps: bool,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """It chooses the episodes as the run did, which may be one that was continued."""
    command = command_at(benchmark, monkeypatch)
    command._run = RUN
    ended: Any = command._report_refusal(error)
    said = capsys.readouterr().err
    assert (f"\nIf files were changed, a new run:\n  {ANEW}\n" in said) == helps
    assert MENDED in said
    assert ended.value.get("new_run") == (ANEW if helps else None)


def test_a_run_that_is_refused_at_once_has_the_same_advice(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    ended: Any = command_at({}, monkeypatch)._report_refusal(REFUSED)
    assert MENDED in capsys.readouterr().err
    assert ended.value["new_run"] == ANEW


def command_at(
    benchmark: dict[str, Any] | None, monkeypatch: pytest.MonkeyPatch
) -> _EvaluationCommand:
    """A command that continues a run, at a server with this benchmark."""
    client = SimpleNamespace(
        benchmark=lambda name: described({"kitchen": benchmark}[name]),
        read=lambda name: {"run_1": RUN}[name],
    )
    opened = contextlib.nullcontext(client)
    monkeypatch.setattr(running, "open_control_client", lambda *_: opened)
    args = parse(["run", "--policy", "mine.py:P", "--run-id", "run_1", "--workers=2"])
    return _EvaluationCommand(args, Printer(as_json=False), None)


def described(benchmark: dict[str, Any] | None) -> SimpleNamespace:
    """Raises ProctorError for None, a benchmark that is no longer offered."""
    if benchmark is None:
        raise ProctorError("not_found", "It has no such benchmark.")
    members = {"unavailable_reason": None, "simulator": {}} | benchmark
    sources = members.pop("simulator").get("sources")
    return SimpleNamespace(**members, simulator=SimpleNamespace(sources=sources))


@pytest.mark.parametrize(
    ("reason", "sentence"),
    [
        ("restart the server", "restart the server."),
        ("It is stopped.", "It is stopped."),
        ("really?", "really?"),
        ("no more…", "no more…"),
        ("a line\n", "a line."),
        ("", ""),
        (None, ""),
    ],
)
def test_reasons_of_servers_end_as_sentences(reason: str | None, sentence: str) -> None:
    assert as_sentence(reason) == sentence
    if sentence:
        failed = RunFailed(run_of(reason or ""))
        assert f"failed: {sentence} Scored episodes are kept" in failed.detail


@pytest.mark.parametrize(
    ("variable", "flags", "says"),
    [
        (None, "", "proctor stop run_1"),
        (None, "--url http://h:1", "proctor stop run_1 --url http://h:1"),
        (None, "--host h --port 1", "proctor stop run_1 --url http://h:1"),
        ("http://h:1", "", "proctor stop run_1"),
        (
            "http://h:1",
            f"--url {DEFAULT_URL}",
            f"proctor stop run_1 --url {DEFAULT_URL}",
        ),
        (None, "--ca a.pem", "proctor stop run_1 --ca a.pem"),
    ],
)
def test_a_command_to_copy_reaches_the_same_server(
    variable: str | None, flags: str, says: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("PROCTOR_URL", raising=False)
    if variable:
        monkeypatch.setenv("PROCTOR_URL", variable)
    monkeypatch.setenv("PROCTOR_CA", "")  # --ca sets it
    assert command_text(parse(["status", *flags.split()]), "stop", "run_1") == says


def test_commands_to_copy_are_made_in_one_place() -> None:
    files = (ROOT / "reference_client").rglob("*.py")
    users = {file.name for file in files if "shlex" in file.read_text()}
    assert users == {"commands_to_copy.py"}


@pytest.mark.parametrize(
    ("until", "text"),
    [
        ("2100-01-01T01:02:03Z", "e0 waits at step 4 until 01:02:03 UTC; attempt 1"),
        (
            "2001-01-01T01:02:03Z",
            "e0 waited at step 4 until 01:02:03 UTC, which is over; attempt 1",
        ),
    ],
)
def test_a_wait_that_is_over_is_said_to_be(until: str, text: str) -> None:
    left = SimpleNamespace(episode_id="e0", step=4, until=until, attempt=1)
    assert describe_left(cast("LeftEpisode", left)) == text
