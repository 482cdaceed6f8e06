"""Logs on the disk: bounded, durable, complete after a full disk; what owners see."""

from __future__ import annotations

import errno
import os
from pathlib import Path
from typing import Any

import pytest

from reference_platform.pages.submission_pages import log_entries
from reference_platform.submissions.interfaces import LogLine
from reference_platform.submissions.log_redaction import LogRedaction
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
    [("all", "ValueError: the new weights are missing"), ("platform", "")],
)
def test_the_exception_of_the_last_try_is_found(
    tmp_path: Path, shows: Any, expected: str
) -> None:
    """Expect that a phase which does not show what policies print does not show it."""
    logs = logs_in(tmp_path)
    redaction = LogRedaction(shows, ())
    for try_ in ("old", "new"):
        logs.write("sub1", "platform", "The verification begins.")
        before = redaction.last_exception(logs.read("sub1"))
        assert before == "", "of an earlier try"
        logs.write("sub1", "policy", TRACEBACK.format(try_))
    assert redaction.last_exception(logs.read("sub1")) == expected


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
