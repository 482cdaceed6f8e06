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
_EXCEPTION_CHARS_MAX: Final = 300


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

    def last_exception(self, lines: Iterable[LogLine]) -> str:
        """The end of the last traceback that a policy printed in its last try."""
        found, is_open = "", False
        for line in self.shown(lines):
            if line.source == "platform":
                if line.text in _BEGINNINGS:
                    found, is_open = "", False
            elif line.text.startswith(_TRACEBACK):
                is_open = True
            elif is_open and line.text and not line.text[0].isspace():
                found, is_open = line.text[:_EXCEPTION_CHARS_MAX], False
        return found

    def clean(self, text: str) -> str:
        for pattern in self.patterns:
            text = pattern.sub(REMOVED, text)
        return text
