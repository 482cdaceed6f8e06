"""The lines of a log that participants see, by its phase. Pure: no disk.

The host reads whole logs with `proctor admin submission log`. Nothing is removed from
the files: when the policy of a phase changes, it holds for older lines, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final, get_args

from reference_platform.submissions.interfaces import LogLine, Purpose, beginning_of
from reference_platform.tracks.track_rules import LogVisibility, Phase

REMOVED: Final = "[removed]"
_EXPLANATIONS: Final[dict[LogVisibility, str]] = {
    "all": "",
    "platform": "This phase does not show what policies print.",
    "none": "This phase shows no logs.",
}


# Lines of the log with which a policy is played, again or for the first time.
_BEGINNINGS: Final = tuple(map(beginning_of, get_args(Purpose)))
_TRACEBACK: Final = "Traceback (most recent call last):"
# Begins the report of code that Python cannot read, which has no traceback.
_UNREADABLE: Final = re.compile(r'  File "(?P<file>[^"]*)", line (?P<line>[0-9]+)$')
_SHOWN_CHARS_MAX: Final = 300
# How an exception ends that follows from a promise of the sandbox → what to do.
_BOUNDS: Final = {
    re.compile(
        r"URLError|NewConnectionError|MaxRetryError|gaierror|ConnectTimeout"
        r"|ConnectError|ConnectionRefusedError|ClientConnector|LocalEntryNotFound"
        r"|Network is unreachable|[Nn]ame resolution|Name or service not known"
        r"|Connection refused|Failed to (resolve|connect)"
    ): "A policy in a sandbox has no network: put all that it needs into what you hand "
    "in.",
    re.compile(
        r"Read-only file system"
    ): "A policy in a sandbox can write to /tmp alone.",
    re.compile(
        r"No space left on device"
    ): "A policy in a sandbox has only so much room in /tmp; the host's page says how "
    "much.",
}


@dataclass(frozen=True, slots=True)
class LogRedaction:
    """HST-041. folders: of the host, whose paths no participant sees."""

    visibility: LogVisibility
    patterns: Sequence[re.Pattern[str]]

    @classmethod
    def of(cls, phase: Phase, folders: Iterable[Path]) -> LogRedaction:
        paths = [rf"{re.escape(str(folder))}[^\s'\":;,)]*" for folder in folders]
        patterns = [re.compile(text) for text in (*paths, *phase.log_removes)]
        return cls(phase.log_shows, patterns)

    @property
    def explanation(self) -> str:
        """Why lines are missing; empty if none is."""
        return _EXPLANATIONS[self.visibility]

    def shown(self, lines: Iterable[LogLine]) -> list[LogLine]:
        """The lines that are shown, under the numbers that they have in the file."""
        sources = {"all": ("policy", "platform"), "platform": ("platform",), "none": ()}
        visible = sources[self.visibility]
        return [
            LogLine(line.number, line.at, line.source, self.clean(line.text))
            for line in lines
            if line.source in visible
        ]

    def last_words(self, lines: Iterable[LogLine], *, has_exited: bool) -> str:
        """A sentence with what a policy said last of its end; empty if it said nothing.

        That is the end of the last traceback of its last try, or else, of a program
        that has exited, its last line.
        """
        printed: list[str] = []
        for line in self.shown(lines):
            if line.source == "policy":
                printed.append(line.text)
            elif line.text in _BEGINNINGS:
                printed.clear()
        if raised := _last_exception(printed):
            text = f"The last traceback in its log ends with: {raised}"
            bounds = [bound for end, bound in _BOUNDS.items() if end.search(raised)]
            return ". ".join([text, *bounds[:1]])
        last = next((text for text in reversed(printed) if text.strip()), "")
        if not last or not has_exited:
            return ""
        return f"The last line in its log is: {last.strip()[:_SHOWN_CHARS_MAX]}"

    def clean(self, text: str) -> str:
        for pattern in self.patterns:
            text = pattern.sub(REMOVED, text)
        return text


def _last_exception(printed: Iterable[str]) -> str:
    """The end of the last traceback; with the place, where Python read no code."""
    found, is_open, place = "", False, ""
    for text in printed:
        if text.startswith(_TRACEBACK):
            is_open, place = True, ""
        elif not is_open and (unreadable := _UNREADABLE.match(text)):
            is_open, place = True, f" ({unreadable['file']}:{unreadable['line']})"
        elif is_open and text and not text[0].isspace():
            found, is_open = text[:_SHOWN_CHARS_MAX] + place, False
    return found
