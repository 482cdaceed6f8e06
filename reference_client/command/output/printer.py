"""Printer: prints tables for people, or one JSON value for scripts.

Texts of a server may hold control characters: here they pass `printable`; JSON has
escapes of its own.

Results go to stdout; progress, notes and errors go to stderr.
"""

from __future__ import annotations

import os
import sys
import time
from typing import IO, Any, Self, cast

from rich.console import Console
from rich.progress import BarColumn, TaskID, TextColumn, TimeElapsedColumn
from rich.progress import Progress as Bars

from reference_client.command.exit_codes import with_flag_names
from reference_client.command.output.text_tables import TablePrinter, TextTable
from reference_client.command.usage_error import UsageError
from reference_client.errors import first_sentence
from reference_client.evaluation.status_board import Pace, Progress
from reference_client.printable_text import (
    LenientStream,
    discard_output,
    printable,
)
from reference_client.protocol.retry_policy import REPEATS
from reference_record.command_line.closed_output import unwritable
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure
from reference_record.texts.terminal_width import given_columns

LOG_S = 10.0  # between two lines of progress where stderr is not a terminal
# A wait that comes again and again, as on a network that cuts, is said so often.
REPEATED_S = 60.0


class MessageConsole(Console):
    """A console whose end, as of `2>&1 | head`, does not end the program."""

    @property
    def file(self) -> IO[str]:
        """The stream that sys.stderr is now: a policy may have replaced it."""
        return cast("IO[str]", LenientStream(super().file))

    @file.setter
    def file(self, new_file: IO[str]) -> None:
        self._file = new_file


class Printer:
    """Prints results and messages; as_json: results are one JSON value on stdout.

    style: of tables, one of arguments.FORMATS.
    """

    def __init__(self, *, as_json: bool, style: str = "text") -> None:
        self.as_json = as_json
        # Kept from now: during an evaluation, sys.stdout is redirected to stderr.
        self._out = TablePrinter(sys.stdout, style)
        self.err = MessageConsole(
            stderr=True,
            highlight=False,
            markup=False,
            emoji=False,
            width=given_columns(),  # else the terminal's, which may change
            _environ={k: v for k, v in os.environ.items() if k != "COLUMNS"},
        )

    def say(self, line: str) -> None:
        """Print a message to stderr."""
        self.err.print(printable(line), soft_wrap=True)

    def answer(self, value: Any, *tables: TextTable | str, again: str = "") -> None:
        """Print the result to stdout: `value` as JSON, or the tables.

        again: the command that shows it later. Raises UsageError if the result cannot
        be written.
        """
        try:
            if self.as_json:
                self._out.print_json(value)
            else:
                self._out.print(tables)
        except BrokenPipeError:  # `proctor results | head`
            raise
        except OSError as error:
            discard_output(self._out.stream)
            later = f"; `{again}` shows it again" if again else ""
            raise UsageError(f"{unwritable(error)}{later}") from error


class ProgressDisplay:
    """Shows progress: a bar on a terminal, otherwise a line every LOG_S seconds.

    A context manager that ends the bar.
    """

    def __init__(self, printer: Printer) -> None:
        self._printer = printer
        self._waiting: str | None = None
        self._said_at: dict[str, float] = {}
        self._is_away = False  # the server, as was said
        self._logged_at = time.monotonic()
        self._logged = -1
        self._bars: Bars | None = None
        self._task: TaskID | None = None
        self._pace = Pace()
        self.latest: Progress | None = None
        if printer.err.is_terminal:
            self._bars = Bars(
                TextColumn("{task.fields[done]}"),
                BarColumn(bar_width=None),
                TextColumn("{task.fields[mean]}"),
                TimeElapsedColumn(),
                TextColumn("{task.fields[left]}"),
                console=printer.err,
                refresh_per_second=4,
            )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def end(self) -> None:
        if self._bars is not None:
            self._bars.stop()

    def __call__(self, progress: Progress) -> None:
        self.latest = progress
        left = self._pace.left(progress)
        about = None if progress.waiting is None else first_sentence(progress.waiting)
        if about != self._waiting:
            self._waiting = about
            if progress.waiting is not None:
                self._say_wait(progress.waiting)
            elif self._is_away:
                self._is_away = False
                self._printer.say("The server answers again.")
        if self._bars is None:
            self._log(progress, left)
            return
        fields: dict[str, Any] = {
            "done": episodes_text(progress),
            "mean": mean_of(progress),
            # While something is waited for, an estimate by the pace is too short.
            "left": "waiting" if progress.waiting else left,
        }
        if self._task is None:
            self._bars.start()
            self._task = self._bars.add_task("", total=None, **fields)
        self._bars.update(
            self._task,
            total=progress.episodes_total,
            completed=progress.episodes_scored,
            **fields,
        )

    def _say_wait(self, waiting: str) -> None:
        now, about = time.monotonic(), first_sentence(waiting)
        if REPEATS in waiting:  # all workers wait for one server: that is said once
            self._is_away, about = True, about.partition(": ")[2]
        if now >= self._said_at.get(about, -REPEATED_S) + REPEATED_S:
            self._said_at[about] = now
            self._printer.say(with_flag_names(waiting))

    def _log(self, progress: Progress, left: str) -> None:
        now = time.monotonic()
        if progress.episodes_scored == self._logged or now < self._logged_at + LOG_S:
            return
        self._logged_at, self._logged = now, progress.episodes_scored
        parts = [episodes_text(progress), mean_of(progress), left]
        self._printer.say("  ".join(filter(None, parts)))


def episodes_text(progress: Progress) -> str:
    return f"{progress.episodes_scored}/{counted(progress.episodes_total, 'episode')}"


def scored_text(progress: Progress) -> str:
    """How many episodes are scored, and how many of them were given up with score 0."""
    scored = f"{episodes_text(progress)} scored"
    if progress.episodes_abandoned:
        return (
            f"{scored}, {progress.episodes_abandoned} of them abandoned with score 0: "
            "their attempts are used up."
        )
    return f"{scored}; scores are kept."


def mean_of(progress: Progress) -> str:
    return (
        "no score yet" if progress.mean is None else f"mean {figure(progress.mean, 3)}"
    )
