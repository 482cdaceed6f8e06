"""The report on a terminal or in a CI log.

Eighty columns, colour only on a terminal, one line per rule, one card per failure.
"""

import contextlib
import itertools
import sys
import textwrap
import time
from collections.abc import Iterator

from rich.console import Console
from rich.text import Text

from conformance.client.connections.transport.printable_text import (
    discard_output,
    prepare_output,
    printable,
)
from conformance.reports.failure_card import CARD_WIDTH, OUTCOME_WORDS, card, sentence
from conformance.specification.document import spec_name
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict

_EVERY_S = 3.0
_IDS_SHOWN = 12
_SENTENCES_SHOWN = 12
_NO_BREAK = "\N{NO-BREAK SPACE}"
_STYLES = {
    Outcome.PASSED: "green",
    Outcome.FAILED: "bold red",
    Outcome.NOT_VERIFIED: "yellow",
    Outcome.NOT_APPLICABLE: "dim",
    Outcome.INCONCLUSIVE: "yellow",
    Outcome.KIT_ERROR: "bold magenta",
}


class _Console(Console):
    """A console whose end, as of `| head`, does not end the kit."""

    def on_broken_pipe(self) -> None:
        """Write no more; the library would exit with 1, as for a violation."""
        discard_output(self.file)


class Terminal:
    """Writes progress while checks run, and the report at the end."""

    def __init__(self) -> None:
        prepare_output()
        # No hard line breaks: commands must survive copying.
        self._console = _Console(
            highlight=False, markup=False, emoji=False, soft_wrap=True
        )
        self._seen = 0
        self._failed = 0
        self._last_line_at = time.monotonic()
        self.lost: OSError | None = None  # why what was written is not shown

    def say(self, text: str, style: str = "") -> None:
        """Write one line."""
        self._print(Text(printable(text), style=style))

    def progress(self, verdict: Verdict, total: int) -> None:
        """Report that a check has ended: on one line, or every few seconds in a log."""
        self._seen += 1
        self._failed += verdict.outcome == Outcome.FAILED
        of = f"/{total}" if total else ""
        line = f"{self._seen}{of} checked, {self._failed} failed"
        if self._console.is_terminal:
            self._write(f"\r\x1b[K{line}  {verdict.requirement_id}")
        elif time.monotonic() - self._last_line_at > _EVERY_S:
            self._last_line_at = time.monotonic()
            self.say(line)

    def report(self, result: Result) -> None:
        """Write rows, failure cards and the conclusion."""
        if self._console.is_terminal and self._seen:
            self._write("\r\x1b[K")
        if result.problem is None or self._seen:
            self._rows(result)
            for first, *others in result.causes(Outcome.FAILED, Outcome.KIT_ERROR):
                self._card(first, others, result)
            self.say("")
            self._open_rules(result)
            self._wrapped(" · ".join(map(_unbroken, result.profile_texts())))
            self.say(f"{result.headline()} ({result.elapsed_s:.1f} s)", "bold")
            if result.coverage.histories:
                self._wrapped(result.coverage.sentence(result.settings))
            self.say(
                f"reports in {result.settings.report}/, seed {result.settings.seed}, "
                f"specification {spec_name()}"
            )
        for note in result.notes:
            self.say(f"note: {note}", "yellow")
        self._sentences(result)
        self._wrapped(" ".join(result.level_lines()))
        style = {0: "bold green", 1: "bold red"}.get(result.verdict_code, "bold yellow")
        self.say(result.conclusion(), style)
        if (advice := result.advice()) is not None:
            self._wrapped(advice)

    def _rows(self, result: Result) -> None:
        ledger = load_ledger()
        # Rules of profiles that are not announced are counted, in the last lines.
        areas = itertools.groupby(
            result.applicable(), lambda row: ledger[row.requirement_id].area
        )
        for _, verdicts in areas:
            self.say("")
            for verdict in verdicts:
                self._row(verdict)

    def _row(self, verdict: Verdict) -> None:
        row = load_ledger()[verdict.requirement_id]
        line = Text(f"{row.id:<10}")
        word = OUTCOME_WORDS[verdict.outcome]
        if verdict.is_known_failure:
            word = "known fail."
        line.append(f"{word:<13}", _STYLES[verdict.outcome])
        is_plain = verdict.outcome == Outcome.PASSED or not verdict.reason
        summary = row.text if is_plain else verdict.reason.split("\n")[0]
        line.append(_cut(printable(summary), CARD_WIDTH - len(line)))
        self._print(line)

    def _print(self, text: Text) -> None:
        with self._lossy_output():
            self._console.print(text, soft_wrap=True)

    def _write(self, text: str) -> None:
        with self._lossy_output():
            sys.stdout.write(text)

    @contextlib.contextmanager
    def _lossy_output(self) -> Iterator[None]:
        """Write on, to nowhere, after the end of the output: checks go on."""
        try:
            yield
            sys.stdout.flush()
        except (OSError, ValueError) as error:
            if isinstance(error, OSError) and not isinstance(error, BrokenPipeError):
                self.lost = error
            discard_output(sys.stdout)

    def _open_rules(self, result: Result) -> None:
        """Name the rules that are not green, except those of profiles not announced."""
        for why, ids in result.open_rules().items():
            if why == "violated":
                continue  # each has its sentence
            shown, left = ids[:_IDS_SHOWN], len(ids) - _IDS_SHOWN
            more = f" and {left} more" if left > 0 else ""
            self._wrapped(f"{why}: {', '.join(shown)}{more}", "yellow")

    def _sentences(self, result: Result) -> None:
        """Say in a sentence what each failure is, where a reader looks first."""
        causes = result.causes(Outcome.FAILED, Outcome.KIT_ERROR)
        for first, *others in causes[:_SENTENCES_SHOWN]:
            self._wrapped(printable(sentence(first, others)), _STYLES[first.outcome])
        if len(causes) > _SENTENCES_SHOWN:
            self.say(f"and {len(causes) - _SENTENCES_SHOWN} more failures, shown above")

    def _wrapped(self, text: str, style: str = "") -> None:
        for line in textwrap.wrap(text, CARD_WIDTH, subsequent_indent="  "):
            self.say(line.replace(_NO_BREAK, " "), style)

    def _card(self, verdict: Verdict, others: list[Verdict], result: Result) -> None:
        self.say("")
        self.say("─" * CARD_WIDTH, "red")
        for line in card(verdict, result, others):
            self.say(line)


def _unbroken(text: str) -> str:
    return text.replace(" ", _NO_BREAK)


def _cut(text: str, length: int) -> str:
    return text if len(text) <= length else text[: length - 1].rstrip() + "…"
