"""`proctor submit --submission` follows, and starts nothing that counts unasked."""

from dataclasses import dataclass, field
from typing import Any, cast

import pytest

from reference_client.command.command_line.arguments import parse
from reference_client.command.output.printer import Printer
from reference_client.errors import UNREACHABLE, ProctorError
from reference_client.hosting import submit_command
from reference_client.hosting.hosting_client import (
    HostedSubmission,
    HostingClient,
    LogLine,
    SubmissionLog,
)
from reference_client.hosting.next_commands import SubmissionCommands
from reference_client.hosting.submit_command import _Follower

NAME = "sub_1"
FOLLOW = f"proctor submit --submission {NAME}"
START = f"{FOLLOW} --start"
HAND_IN = ("--track", "letters", "--code", "mine", "--preset", "python")


def submission(state: str) -> HostedSubmission:
    return HostedSubmission(NAME, state, "Why.", kind="code")


def commands(*words: str) -> SubmissionCommands:
    return SubmissionCommands(parse(["submit", *words]))


@dataclass
class FakeHost:
    """states: of the submission, one at each look; the host is lost after the last.

    refusal: of its start. log_texts: of its log, one at each look.
    """

    states: list[str]
    refusal: ProctorError | None = None
    log_texts: list[str] = field(default_factory=list)
    started: list[str] = field(default_factory=list)

    def read(self, name: str) -> HostedSubmission:
        if not self.states:
            raise ProctorError(UNREACHABLE, "It is unreachable.")
        assert name == NAME
        return submission(self.states.pop(0))

    def log(self, _name: str, after: int) -> SubmissionLog:
        text = self.log_texts.pop(0) if self.log_texts else ""
        lines = [LogLine(after + 1, "platform", text)] if text else []
        return SubmissionLog(lines, is_ended=not self.log_texts)

    def start(self, name: str) -> None:
        self.started.append(name)
        if self.refusal is not None:
            raise self.refusal


def followed(host: FakeHost, *words: str) -> HostedSubmission:
    follower = _Follower(
        parse(["submit", *words]),
        cast("HostingClient", host),
        submission("uploaded"),
        Printer(as_json=True),
    )
    with follower.saying_what_follows():
        return follower.follow()


@pytest.fixture(autouse=True)
def no_pauses(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(submit_command, "_LOOK_S", 0.0)


@pytest.mark.parametrize(
    ("words", "ends_as", "starts"),
    [
        (("--submission", NAME), "verified", 0),
        (("--submission", NAME, "--verify-only"), "verified", 0),
        ((*HAND_IN, "--verify-only"), "verified", 0),
        (("--submission", NAME, "--start"), "completed", 1),
        (HAND_IN, "completed", 1),
    ],
    ids=str,
)
def test_only_a_command_that_says_so_starts_the_evaluation(
    words: tuple[str, ...], ends_as: str, starts: int
) -> None:
    host = FakeHost(["verifying", "verified", "running", "completed"])
    assert followed(host, *words).state == ends_as
    assert host.started == [NAME] * starts


@pytest.mark.parametrize(
    ("state", "label", "command"),
    [
        ("created", "to upload it", f"{FOLLOW} --code FOLDER"),
        ("uploaded", "to follow it", FOLLOW),
        ("verifying", "to follow it", FOLLOW),
        ("verified", "to start it, which counts", START),
        ("queued", "to follow it", FOLLOW),
        ("running", "to follow it", FOLLOW),
    ],
)
def test_a_printed_command_does_what_stands_beside_it(
    state: str, label: str, command: str
) -> None:
    shown = commands("--submission", NAME)
    assert shown.named(submission(state)) == {label: command}
    host = FakeHost([state, "verified", "completed"])
    if state != "created":
        words = command.removeprefix("proctor submit ").split()
        followed(host, *words)
    assert bool(host.started) == ("which counts" in label)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (HAND_IN, "--code mine --start` continues it, and then starts its evaluation"),
        ((*HAND_IN, "--verify-only"), "--code mine` continues it"),
        (("--submission", NAME, "--code", "mine"), "--code mine` continues it"),
    ],
    ids=str,
)
def test_an_interrupted_upload_goes_on_as_it_began(
    words: tuple[str, ...], said: str
) -> None:
    sentence = commands(*words).sentence(submission("created"))
    assert sentence.startswith(f"{NAME} waits for its upload; `{FOLLOW} {said}")
    assert ("starts" in sentence) == ("starts" in said)


@pytest.mark.parametrize("state", ["completed", "failed", "stopped", "expired"])
def test_what_has_ended_has_no_next_command(state: str) -> None:
    assert commands(*HAND_IN).named(submission(state)) == {}
    said = commands(*HAND_IN).sentence(submission(state))
    assert said == f"{NAME} has ended; `{FOLLOW}` shows how"


@pytest.mark.parametrize(
    ("states", "words", "said"),
    [
        (["verifying"], ("--submission", NAME), f"; `{FOLLOW}` follows it again."),
        (
            ["verifying"],
            HAND_IN,
            f"again, and `{START}` also starts its evaluation, which counts.",
        ),
        (["running"], HAND_IN, f"without this program; `{FOLLOW}` follows it again."),
        (
            [],
            ("--submission", NAME),
            f"{NAME} goes on at the host without this program; `{FOLLOW}` follows",
        ),
    ],
    ids=str,
)
def test_a_lost_host_is_no_end_of_the_submission(
    states: list[str], words: tuple[str, ...], said: str
) -> None:
    with pytest.raises(ProctorError) as caught:
        followed(FakeHost(states), *words)
    assert caught.value.code == UNREACHABLE
    assert said in caught.value.detail


def test_a_refused_start_says_how_to_start_it_later() -> None:
    refusal = ProctorError("quota_exceeded", "The window opens again at noon.")
    with pytest.raises(ProctorError) as caught:
        followed(FakeHost(["verified"], refusal), *HAND_IN)
    assert f"{NAME} stays verified; `{START}` starts" in caught.value.detail


def test_one_that_was_started_elsewhere_is_followed() -> None:
    refusal = ProctorError("illegal_transition", "It is queued.")
    host = FakeHost(["verified", "running", "completed"], refusal)
    assert followed(host, *HAND_IN).state == "completed"


def test_the_log_is_followed_to_its_last_line(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Expect lines that come after the last state, and after a look without any."""
    host = FakeHost(["running", "failed"], log_texts=["Begins.", "", "", "Failed."])
    assert followed(host, *HAND_IN).state == "failed"
    assert "platform | Failed." in capsys.readouterr().err


def test_ctrl_c_prints_the_same(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(_seconds: float) -> Any:
        raise KeyboardInterrupt

    monkeypatch.setattr("time.sleep", interrupt)
    with pytest.raises(KeyboardInterrupt):
        followed(FakeHost(["running"]), "--submission", NAME)
    assert f"`{FOLLOW}` follows it again" in capsys.readouterr().err
