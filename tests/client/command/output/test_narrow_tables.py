"""Tables in terminals of all widths: whatever is not shown is named, nothing is cut."""

import contextlib
import fcntl
import io
import os
import pty
import struct
import sys
import termios
from collections import Counter
from collections.abc import Iterator
from datetime import UTC, datetime
from types import SimpleNamespace
from typing import IO, Any, cast

import pytest
from proctor_client import Benchmark, Run
from rich.console import Console

from reference_client.command.output.answer_tables import (
    benchmark_tables,
    episode_list,
    run_list,
)
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import (
    Prose,
    TablePrinter,
    TextTable,
    fact_table,
)
from reference_record.command_line.click_commands import WIDTH_MAX, _Formatter
from reference_record.texts.terminal_width import (
    COLUMNS_MIN,
    COLUMNS_UNKNOWN,
    columns_of,
)
from reference_sim import benchmark_registry

RUN_ID = "run_f70ade35e2bfd890a5ddcf79"
MANIFEST = "7074439e7027e21aa4c7b9f42c132de7e3b317fda4ee01f7e9e70bca44670ffa"
TITLE = "Mobile bimanual, commanded by end-effector poses"
MODEL = "a model with a name that is rather long"


def benchmarks() -> TextTable:
    table = TextTable(("benchmark", "version", ">episodes", "title"))
    table.add("mobile_bimanual_table_top_manip", "1", "60", TITLE)
    table.add("tabletop", "2", "64", "Tabletop")
    return table


def ranking() -> TextTable:
    heads = ("model", ">rank", "level")
    table = TextTable(heads, dispensable=("level",), breaks_first=True)
    table.add(MODEL, "1–2", "signed by a host")
    return table


def runs() -> TextTable:
    progress = SimpleNamespace(episodes_scored=3, episodes_total=64)
    run: Any = SimpleNamespace(
        run_id=RUN_ID, account="alice", state=SimpleNamespace(value="completed"),
        select=None,
        benchmark_id="tabletop_state", policy=SimpleNamespace(name="evaluate.py:Mine"),
        progress=progress, created_at=datetime(2026, 11, 30, tzinfo=UTC),
    )  # fmt: skip
    score: Any = SimpleNamespace(to_dict=lambda: {"score": None, "mean": 0.98765})
    table, _ = run_list([run], {RUN_ID: score})
    assert isinstance(table, TextTable)
    return table


def episodes() -> TextTable:
    result: Any = SimpleNamespace(
        outcome=SimpleNamespace(value="failure"), score=0.98765, steps=200,
        clipped_actions=3, total_reward=1.5, player=None,
    )  # fmt: skip
    episode: Any = SimpleNamespace(
        episode_id="e0000", task="peg_in_hole", split="val_train", attempt=1,
        status=SimpleNamespace(value="scored"), result=result,
    )  # fmt: skip
    return episode_list([episode], cast("Run", SimpleNamespace(mode="pull")))


def facts() -> TextTable:
    return fact_table({"baseline played by": "P", "run": RUN_ID, "manifest": MANIFEST})


def tasks() -> TextTable:
    table = TextTable(("task, splits mixed", ">scored", ">success", ">mean"))
    table.add("pick_and_place_the_cube", "1/8", "0", "0.125")
    return table


TABLES = [benchmarks(), ranking(), runs(), episodes(), tasks()]
SENTENCE = Prose("A rank is an interval: entries with a letter in common are equal.")


def lines_of(
    part: TextTable | str, columns: str, monkeypatch: pytest.MonkeyPatch
) -> list[str]:
    monkeypatch.setenv("COLUMNS", columns)
    if not columns:
        monkeypatch.delenv("COLUMNS")  # as in a pipe
    stream = io.StringIO()
    TablePrinter(stream).print([part])
    return stream.getvalue().splitlines()


@pytest.mark.parametrize("columns", ["20", "40", "60", "80", "200", ""])
@pytest.mark.parametrize("part", [*TABLES, facts(), SENTENCE])
def test_every_word_is_there_and_every_line_fits(
    part: TextTable | str, columns: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = lines_of(part, columns, monkeypatch)
    written = Counter("".join(lines))
    cells, longest = [str(part)], 0
    if isinstance(part, TextTable):
        note = " ".join(lines).partition("not shown at this width: ")[2]
        shown = part
        for name in filter(None, note.split(", ")):
            shown = shown.without(name)
        cells = [word for row in shown.rows for cell in row for word in cell.split()]
        if part.has_header:  # the first heading may be a caveat about all rows
            cells += [part.names[0].replace(" ", "")]
        longest = len(part.rows[0][0])  # an id is not broken
    assert not Counter("".join(cells).replace(" ", "")) - written
    if columns:
        assert max(map(len, lines)) <= max(int(columns), longest)


@pytest.mark.parametrize("columns", ["0", "1", "19", "-1", "wide", "1e3"])
@pytest.mark.parametrize("table", TABLES)
def test_what_is_no_width_bounds_nothing(
    table: TextTable, columns: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert lines_of(table, columns, monkeypatch) == lines_of(table, "", monkeypatch)


@pytest.mark.parametrize("columns", ["20", "40", "60", "80", "200", ""])
@pytest.mark.parametrize("table", [runs(), episodes()])
def test_a_list_always_has_its_scores(
    table: TextTable, columns: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = lines_of(table, columns, monkeypatch)
    assert any("0.988" in line for line in lines)
    assert any(table.rows[0][0] in line for line in lines)


def test_a_column_of_few_letters_is_not_shown(monkeypatch: pytest.MonkeyPatch) -> None:
    assert lines_of(benchmarks(), "40", monkeypatch)[:7] == [
        "benchmark:",
        "",
        "mobile_bimanual_table_top_manip",
        "  version   1",
        "  episodes  60",
        "  title     Mobile bimanual, commanded",
        "            by end-effector poses",
    ]
    assert len(lines_of(benchmarks(), "80", monkeypatch)) == 4
    assert len(lines_of(benchmarks(), "", monkeypatch)) == 3


def test_an_id_is_not_broken_where_it_fits(monkeypatch: pytest.MonkeyPatch) -> None:
    narrow = lines_of(facts(), "40", monkeypatch)
    assert narrow[2:4] == ["run", f"  {RUN_ID}"]
    assert any(RUN_ID in line for line in lines_of(facts(), "60", monkeypatch))


def test_columns_that_are_left_out_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    note = "not shown at this width: level"
    assert lines_of(ranking(), "50", monkeypatch)[2:] == [note]
    assert lines_of(ranking(), "40", monkeypatch)[1:3] == [
        "a model with a name that is rather   1–2",
        "long",
    ]


@pytest.mark.parametrize(
    ("name", "has_images"), [("tabletop_state", False), ("tabletop", True)]
)
def test_a_benchmark_shows_its_goals_and_pictures_only_where_it_has_cameras(
    name: str, has_images: bool
) -> None:
    found = benchmark_registry.resolve(name).manifest
    more = {"manifest_sha256": MANIFEST, "unavailable_reason": None}
    head, goals, _ = benchmark_tables(Benchmark.from_dict({**found, **more}))
    assert ("images" in [row[0] for row in head.rows]) is has_images
    reach = "The middle of the fingertips is within 2 cm of the ball's centre."
    assert ("reach", reach) in [tuple(row) for row in goals.rows]


def test_sentences_are_comments_in_latex_and_lines_elsewhere() -> None:
    """A file that a paper includes has nothing but its table."""
    for style, begin in (("latex", "% "), ("markdown", ""), ("text", "")):
        written = io.StringIO()
        TablePrinter(written, style).print([fact_table({"a": 1}), Prose("90 %,\nso.")])
        last = written.getvalue().rpartition("\n\n")[2]
        assert " ".join(last.split()) == f"{begin}90 %, so."


@pytest.mark.parametrize("given", ["", "0", "1", "19", "-40", "wide", "4e1", "²"])
@pytest.mark.parametrize("has", [0, 19, 40, 200])
def test_what_is_no_width_leaves_that_of_the_terminal(
    given: str, has: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Tables, the help, the progress line and the bar have it from one place."""
    monkeypatch.setenv("COLUMNS", given)
    width = has if has >= COLUMNS_MIN else COLUMNS_UNKNOWN
    with opened_terminal(has) as terminal:
        monkeypatch.setattr(sys, "stdout", terminal)
        monkeypatch.setattr(sys, "stderr", terminal)
        assert columns_of(terminal) == width
        printer = Printer(as_json=False)
        assert printer._out._console.width == width
        # The library asks the standard streams of the process, as it draws.
        assert printer.err.width == Console(_environ={}).width
        assert _Formatter().width == max(min(width, WIDTH_MAX) - 2, 30)
    assert columns_of(io.StringIO()) is None


@contextlib.contextmanager
def opened_terminal(columns: int) -> Iterator[IO[str]]:
    controller, file = pty.openpty()
    size = struct.pack("HHHH", 24, columns, 0, 0)
    fcntl.ioctl(file, termios.TIOCSWINSZ, size)
    with os.fdopen(file, "w") as terminal:
        yield terminal
    os.close(controller)
