"""Logs on the disk: bounded, durable, complete after a full disk; what owners see."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from proctor_client import OutcomeCounts

from reference_platform.pages.submission_pages import log_entries, without_repeats
from reference_platform.submissions.interfaces import LogLine
from reference_platform.submissions.log_redaction import LogRedaction
from reference_platform.submissions.server_runs import score_text
from reference_platform.submissions.submission_logs import FileLogs
from reference_platform.tracks.track_rules import Phase, Track, check_track
from reference_server.rules.refusal import Refused


def logs_in(folder: Path, **settings: Any) -> FileLogs:
    return FileLogs(folder / "logs", lambda _: True, **settings)


def texts(logs: FileLogs, name: str = "sub1") -> list[str]:
    return [line.text for line in logs.read(name)]


def test_the_limit_of_a_policy_is_said_in_the_log(tmp_path: Path) -> None:
    """Before and after a restart. Expect the first bytes, the limit, and the end."""
    for _ in range(2):
        logs = logs_in(tmp_path, policy_bytes_max=2**10)
        for _ in range(10):
            logs.write("sub1", "policy", "x" * 255)
    logs.write("sub1", "platform", "The end.")
    assert texts(logs)[:4] == ["x" * 255] * 4
    full, end = texts(logs)[4:]
    assert "the first 0.000976562 MiB that the policy printed" in full
    assert end == logs.last_text("sub1") == "The end."


TRACEBACK = """predict 1
Traceback (most recent call last):
  File "/policy/main.py", line 3, in act
    raise ValueError
ValueError: the {} weights are missing
----"""


@pytest.mark.parametrize(
    ("shows", "expected"),
    [
        ("all", "The last traceback in its log ends with: ValueError: the new weights"),
        ("platform", ""),
    ],
)
def test_the_exception_of_the_last_try_is_found(
    tmp_path: Path, shows: Any, expected: str
) -> None:
    """Expect that a phase which does not show what policies print does not show it."""
    logs = logs_in(tmp_path)
    redaction = LogRedaction(shows, ())

    def last_words() -> str:
        return redaction.last_words(logs.read("sub1"), has_exited=False)

    for try_ in ("old", "new"):
        logs.write("sub1", "platform", "The verification begins.")
        assert last_words() == "", "of an earlier try"
        logs.write("sub1", "policy", TRACEBACK.format(try_))
    assert last_words().startswith(expected)
    assert bool(last_words()) == bool(expected)


NO_NETWORK = "A policy in a sandbox has no network: put all that it needs"
RAISED = "Traceback (most recent call last):\n  File x\n"
UNREADABLE = """  File "/policy/main.py", line 9
    def f(:
          ^
SyntaxError: invalid syntax"""


@pytest.mark.parametrize(
    ("printed", "has_exited", "said"),
    [
        (UNREADABLE, True, "invalid syntax (/policy/main.py:9)"),
        (UNREADABLE, False, "ends with: SyntaxError: invalid syntax"),
        (f"{RAISED}{UNREADABLE}", True, "ends with: SyntaxError: invalid syntax"),
        ("sh: 1: exec: policy: not found\n\n", True, "is: sh: 1: exec: policy: not"),
        ("python: can't open file '/policy/main.py'", True, "is: python: can't open"),
        ("step 41", False, ""),
        ("", True, ""),
        (f"{RAISED}ConnectionRefusedError: [Errno 111]", False, NO_NETWORK),
        (f"{RAISED}urllib.error.URLError: <urlopen error>", False, NO_NETWORK),
        (f"{RAISED}socket.gaierror: [Errno -3] Temporary", False, NO_NETWORK),
        (f"{RAISED}requests.ConnectionError: Failed to resolve 'x'", False, NO_NETWORK),
        (f"{RAISED}OSError: [Errno 101] Network is unreachable", False, NO_NETWORK),
        (f"{RAISED}OSError: [Errno 30] Read-only file system: '/policy/cache'", False,
         "can write to /tmp alone"),
        (f"{RAISED}OSError: [Errno 28] No space left on device", True, "room in /tmp"),
        (f"{RAISED}ValueError: step 41", False, "ends with: ValueError: step 41"),
    ],
)  # fmt: skip
def test_the_last_words_of_a_policy_say_how_it_ended(
    tmp_path: Path, printed: str, has_exited: bool, said: str
) -> None:
    """Also without the word Traceback, and with what the host alone knows."""
    logs = logs_in(tmp_path)
    logs.write("sub1", "platform", "The verification begins.")
    logs.write("sub1", "policy", printed)
    lines = logs.read("sub1")
    words = LogRedaction("all", ()).last_words(lines, has_exited=has_exited)
    assert said in words
    assert bool(said) == bool(words)
    assert (NO_NETWORK in words) == (said is NO_NETWORK)


def test_a_page_shows_a_traceback_that_comes_again_once(tmp_path: Path) -> None:
    """Nine calls that fail alike, around a line of the platform."""
    logs = logs_in(tmp_path)
    for text in ("policy 1", *[f"{RAISED}ValueError: no"] * 9):
        logs.write("sub1", "policy", text)
    logs.write("sub1", "platform", "The end.")
    shown = [line.text for line in without_repeats(logs.read("sub1"))]
    once = ["policy 1", *RAISED.splitlines(), "ValueError: no"]
    assert shown == [*once, "(the same 3 lines, 8 times more)", "The end."]


def test_lines_of_one_second_are_one_entry() -> None:
    times = (5.1, 5.2, 5.3, 7.0)
    sources: list[Any] = ["policy", "policy", "platform", "platform"]
    lines = [
        LogLine(number, at, source, str(number))
        for number, (at, source) in enumerate(zip(times, sources, strict=True))
    ]
    assert [one.text for one in log_entries(lines)] == ["0\n1", "2", "3"]


@pytest.mark.parametrize("refused", ["open", "write", "fsync", "half a write"])
def test_a_full_disk_loses_and_doubles_no_line(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, refused: str
) -> None:
    logs = logs_in(tmp_path)
    logs.write("sub1", "policy", "before")
    write = os.write

    def fail(*_: Any) -> int:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        if refused == "half a write":
            patch.setattr(os, "write", lambda fd, text: write(fd, text[:9]))
        else:
            patch.setattr(os, refused, fail)
        logs.write("sub1", "policy", "during")
        assert not logs.is_durable("sub1")
        assert refused == "half a write" or "No space left" in logs.problem
        logs.write("sub1", "platform", "later")
    assert logs.is_durable("sub1")
    assert (texts(logs), logs.problem) == (["before", "during", "later"], "")
    assert texts(logs_in(tmp_path)) == texts(logs)
    assert [line.number for line in logs.read("sub1")] == [1, 2, 3]


@pytest.mark.parametrize(
    ("shows", "seen"),
    [
        ("all", ["seed [removed]", "at [removed]: x", "It has ended."]),
        ("platform", ["It has ended."]),
        ("none", []),
    ],
)
def test_a_track_decides_what_its_participants_see(
    tmp_path: Path, shows: Any, seen: list[str]
) -> None:
    phase = Phase("p", "b", 0.0, 1.0, log_shows=shows, log_removes=(r"\b\d{4,}",))
    logs = logs_in(tmp_path)
    for source, text in (
        ("policy", "seed 12345"),
        ("policy", "at /srv/host/roots/sha256-1/main.py: x"),
        ("platform", "It has ended."),
    ):
        logs.write("sub1", source, text)  # type: ignore[arg-type]
    redaction = LogRedaction.of(phase, [Path("/srv/host")])
    assert [line.text for line in redaction.shown(logs.read("sub1"))] == seen
    assert bool(redaction.explanation) == (shows != "all")


@pytest.mark.parametrize("pattern", ["(", "", "a*"])
def test_a_pattern_that_is_wrong_or_everywhere_is_refused(pattern: str) -> None:
    phase = Phase("p", "b", 0.0, 1.0, log_removes=(pattern,))
    track = Track("t", "T", (phase,))
    with pytest.raises(Refused, match="log_removes"):
        check_track(track)


def test_the_line_on_a_score_says_what_was_abandoned() -> None:
    counts = OutcomeCounts(total=4, success=3, failure=0, abandoned=1, unscored=0)
    score: Any = SimpleNamespace(score=0.75, counts=counts)
    assert score_text(score) == (
        "The score is 0.750 over 4 episodes, 1 of them abandoned with score 0: their "
        "attempts are used up."
    )
