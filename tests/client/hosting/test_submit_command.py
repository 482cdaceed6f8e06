"""`proctor submit --track` finds what is handed in already, so that it counts once."""

from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest

from reference_client.command.command_line.arguments import parse
from reference_client.command.output.printer import Printer
from reference_client.hosting.hosting_client import (
    HostedSubmission,
    HostingClient,
    LogLine,
    SubmissionLog,
)
from reference_client.hosting.submit_command import (
    _find_same,
    _FollowedLog,
    _PolicyFile,
)

NOW = datetime.now(UTC)
LONG_AGO = NOW - timedelta(days=3)
MEMBERS = {
    "track_id": "letters",
    "phase_id": "",
    "kind": "code",
    "preset": "python",
    "policy_name": "mine",
}


def submission(digest: str, **members: Any) -> HostedSubmission:
    known = MEMBERS | {"submission_id": "sub_1", "reason": "", "state": "running"}
    return HostedSubmission(**known | {"phase_id": "dev", "digest": digest} | members)


class FakeClient:
    def __init__(
        self,
        *submissions: HostedSubmission,
        begun: bool = False,
        open_phase: str | None = "dev",
    ) -> None:
        self._submissions, self._begun = submissions, begun
        self._open_phase = open_phase

    def phase_of_next(self, track_id: str) -> str | None:
        assert track_id == MEMBERS["track_id"]
        return self._open_phase

    def all(self) -> list[HostedSubmission]:
        return list(self._submissions)

    def has_begun(self, _digest: str) -> bool:
        return self._begun


@pytest.mark.parametrize("state", ["uploaded", "verifying", "verified", "queued"])
def test_what_waits_is_gone_on_with(state: str) -> None:
    assert is_same(submission("sha256:a", state=state))


@pytest.mark.parametrize(
    ("members", "same"),
    [
        ({}, True),
        ({"digest": "sha256:b"}, False),
        ({"track_id": "words"}, False),
        ({"preset": "python-numpy"}, False),
        ({"policy_name": "other"}, False),
        ({"kind": "image"}, False),
        ({"state": "failed"}, False),
        ({"state": "stopped"}, False),
        ({"state": "expired"}, False),
        ({"state": "completed", "entered_at": NOW}, True),
        ({"state": "completed", "entered_at": LONG_AGO}, False),
        ({"state": "completed"}, False),
        ({"state": "created", "digest": ""}, False),
    ],
    # Processes that share the tests must name them alike, and the times differ.
    ids=lambda given: " ".join(given) if isinstance(given, dict) else str(given),
)
def test_only_the_same_policy_is_gone_on_with(
    members: dict[str, Any], same: bool
) -> None:
    assert is_same(submission(**{"digest": "sha256:a"} | members)) == same


@pytest.mark.parametrize("phase", ["dev", "test"])
def test_a_phase_that_is_named_must_be_that_of_the_submission(phase: str) -> None:
    there = submission("sha256:a")
    assert is_same(there, members=MEMBERS | {"phase_id": phase}) == (phase == "dev")


@pytest.mark.parametrize(
    ("state", "open_phase", "same"),
    [
        ("completed", "dev", True),
        ("completed", "test", False),
        ("running", "test", False),
        ("running", None, False),
    ],
)
def test_without_a_phase_it_is_the_one_that_the_server_would_take(
    state: str, open_phase: str | None, same: bool
) -> None:
    there = submission("sha256:a", state=state, entered_at=NOW)
    client = cast("HostingClient", FakeClient(there, open_phase=open_phase))
    found = _find_same(MEMBERS, file_of("sha256:a"), client)
    assert (found is there) == same


BROKEN_OFF = submission("", state="created")
ENDED = submission("sha256:a", submission_id="sub_0", state="failed")


@pytest.mark.parametrize(
    ("there", "begun", "same"),
    [
        ([BROKEN_OFF], True, True),
        ([BROKEN_OFF], False, False),  # its upload is of another file
        ([BROKEN_OFF, ENDED], True, False),  # the bytes are of the one that ended
        (
            [BROKEN_OFF, submission("", submission_id="sub_0", state="created")],
            True,
            False,
        ),
    ],
    ids=["begun", "another file", "of another submission", "one of two"],
)
def test_an_upload_of_the_same_file_that_broke_off_is_gone_on_with(
    there: list[HostedSubmission], begun: bool, same: bool
) -> None:
    client = cast("HostingClient", FakeClient(*there, begun=begun))
    found = _find_same(MEMBERS, file_of("sha256:a"), client)
    assert (found is BROKEN_OFF) == same


def test_the_newest_of_several_is_gone_on_with() -> None:
    gone = submission("sha256:a", submission_id="sub_3", state="failed")
    newer = submission("sha256:a", submission_id="sub_2")
    client = FakeClient(gone, newer, submission("sha256:a"), begun=False)
    found = _find_same(MEMBERS, file_of("sha256:a"), cast("HostingClient", client))
    assert found is newer


def test_a_folder_is_packed_once_and_only_when_it_is_needed(tmp_path: Path) -> None:
    (tmp_path / "main.py").write_text("pass")
    args = parse(["submit", "--track", "letters", "--code", str(tmp_path)])
    with _PolicyFile(args, Printer(as_json=False)) as file:
        client = FakeClient(submission("sha256:a", track_id="words"), begun=True)
        assert _find_same(MEMBERS, file, cast("HostingClient", client)) is None
        assert "path" not in vars(file)
        assert file.digest.startswith("sha256:")
        archive = file.path
        assert archive.is_file()
    assert not archive.exists()


def is_same(
    there: HostedSubmission, *, members: dict[str, str] = MEMBERS, begun: bool = False
) -> bool:
    client = cast("HostingClient", FakeClient(there, begun=begun))
    return _find_same(members, file_of("sha256:a"), client) is there


def file_of(digest: str) -> _PolicyFile:
    return cast("_PolicyFile", SimpleNamespace(digest=digest))


class GrowingLog:
    """A log that has one part more at each look."""

    def __init__(self, *parts: list[str]) -> None:
        self._parts, self._number = list(parts), 0

    def log(self, _name: str, after: int) -> SubmissionLog:
        assert after == self._number, "each line is read once"
        lines = []
        for text in self._parts.pop(0):
            self._number += 1
            source = "platform" if text.endswith("attempt.") else "policy"
            lines.append(LogLine(number=self._number, source=source, text=text))
        return SubmissionLog(lines, is_ended=not self._parts)


def test_a_followed_log_shows_a_traceback_that_comes_again_once() -> None:
    """Of calls that fail alike, over several looks, between lines of the platform."""
    traceback = ["Traceback:", "  File", "ValueError: no"]
    log = GrowingLog(
        ["start", *traceback], traceback, [*traceback, "An attempt."], [traceback[0]]
    )
    said: list[str] = []
    printer = cast("Printer", SimpleNamespace(say=said.append))
    followed = _FollowedLog(cast("HostingClient", log), "sub_1", printer)
    for _ in range(4):
        followed.print_new()
    followed.end()
    shown = ["start", *traceback, "(the same 3 lines, 2 times more)"]
    assert said == [
        *(f"policy   | {text}" for text in shown),
        "platform | An attempt.",
        "policy   | Traceback:",
    ]
