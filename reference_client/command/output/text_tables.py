"""Tables of the command, as text, Markdown or LaTeX.

On a terminal, a table drops the columns that its maker names as dispensable until it
fits, and says which. One that would still have columns of a few letters is written as
names and values, row by row. Elsewhere, a line is never wrapped, unless COLUMNS gives
a width: programs read it.
"""

from __future__ import annotations

import errno
import json
import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TextIO

from pydantic_core import to_jsonable_python
from rich.cells import cell_len
from rich.console import Console, RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from reference_client.printable_text import printable
from reference_record.texts.terminal_width import columns_of

_UNBOUNDED = 100_000
# A column of texts that is narrower than this is hard to read.
_READABLE = 20
_MINUS = re.compile(r"(?<![\w.-])-(?=\d)")  # before a number, and no hyphen
_LATEX_SPECIAL = {
    "\\": r"\textbackslash{}",
    **{char: f"\\{char}" for char in "&%$#_{}"},
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    '"': "''",
    "-": "-{}",  # two of them would become one dash
    "[": "{[}",  # behind the end of a row these two are an argument of it
    "*": "{*}",
    "–": "--",
    "—": "---",
    "…": r"\ldots{}",
    "“": "``",
    "”": "''",
    "’": "'",
    "°": r"$^{\circ}$",
    "±": r"$\pm$",
    "·": r"$\cdot$",
    "×": r"$\times$",
    "−": "$-$",
    "≤": r"$\leq$",
    "≥": r"$\geq$",
    "→": r"$\rightarrow$",
    "µ": r"$\mu$",
    "α": r"$\alpha$",
}


@dataclass
class TextTable:
    """Rows of texts under column names; a name that begins with > is right-aligned.

    dispensable: names of the columns that a narrow terminal drops, in this order; a
    score is none of them.
    has_header: without it, the rows are names and values. breaks_first: whether the
    first column may be broken, which is otherwise an id, to be copied.
    """

    columns: Sequence[str]
    dispensable: Sequence[str] = ()
    has_header: bool = True
    breaks_first: bool = False
    rows: list[tuple[str, ...]] = field(default_factory=list)

    def add(self, *cells: str) -> None:
        assert len(cells) == len(self.columns)
        self.rows.append(tuple(map(printable, cells)))

    @property
    def names(self) -> list[str]:
        return [name.lstrip(">") for name in self.columns]

    def without(self, name: str) -> TextTable:
        kept = [i for i, column in enumerate(self.names) if column != name]
        return TextTable(
            [self.columns[i] for i in kept],
            [column for column in self.dispensable if column != name],
            self.has_header,
            self.breaks_first,
            [tuple(row[i] for i in kept) for row in self.rows],
        )


class Prose(str):
    """Sentences, which a narrow terminal breaks between words; a comment in LaTeX."""

    __slots__ = ()


def fact_table(rows: Mapping[str, object]) -> TextTable:
    """A table of names and values; None values are omitted."""
    table = TextTable(("name", "value"), has_header=False)
    for name, value in rows.items():
        if value is not None:
            table.add(name, str(value))
    return table


class _ResultConsole(Console):
    """A console whose end, as of `| head`, ends the program as SIGPIPE does."""

    def on_broken_pipe(self) -> None:
        """Raise what was raised; the library would exit with 1."""
        raise BrokenPipeError(errno.EPIPE, os.strerror(errno.EPIPE))


class TablePrinter:
    """Prints results to `stream`: JSON, texts, tables in one of arguments.FORMATS."""

    def __init__(self, stream: TextIO, style: str = "text") -> None:
        self.stream = stream
        self._style = style
        self._console = _ResultConsole(
            file=stream,
            highlight=False,
            markup=False,
            emoji=False,
            width=columns_of(stream) or _UNBOUNDED,
        )

    def print_json(self, value: Any) -> None:
        self.stream.write(json.dumps(to_jsonable_python(value)) + "\n")
        self.stream.flush()

    def print(self, parts: Sequence[TextTable | str]) -> None:
        for number, part in enumerate(parts):
            if number:
                self.stream.write("\n")
            if isinstance(part, Prose) and self._style == "latex":
                self.stream.write(f"% {' '.join(printable(part).split())}\n")
            elif isinstance(part, Prose):
                self._write(Text(printable(part)))
            elif isinstance(part, str):
                self.stream.write(f"{printable(part)}\n")
            elif self._style == "text":
                self._print_text(part)
            else:
                write = {"markdown": markdown, "latex": latex}[self._style]
                self.stream.write(write(part))
        self.stream.flush()

    def _print_text(self, table: TextTable) -> None:
        shown = table
        while shown.dispensable and self._excess(shown) > 0:
            shown = shown.without(shown.dispensable[0])
        if not shown.has_header and self._breaks_a_word(shown):
            for name, value in shown.rows:
                self.stream.write(f"{name}\n")
                self._write(Padding(Text(value, overflow="fold"), (0, 0, 0, 2)))
            return
        if shown.has_header and 0 < self._excess(shown) > _spare(shown):
            if heading := table.names[0]:  # it may say what the rows are of
                self._write(Text(f"{heading}:\n"))
            for number, row in enumerate(table.rows):
                self.stream.write("\n" * (number > 0) + f"{row[0]}\n")
                facts = {
                    f"  {name}": cell
                    for name, cell in zip(table.names, row, strict=True)
                }
                del facts[f"  {table.names[0]}"]
                self._write(_rich(fact_table(facts)))
            return
        self._write(_rich(shown))
        if left_out := [name for name in table.names if name not in shown.names]:
            self._write(f"not shown at this width: {', '.join(left_out)}")

    def _excess(self, table: TextTable) -> int:
        """How much wider a table is than the terminal; negative if it fits."""
        return _width(self._console, table) - self._console.width

    def _breaks_a_word(self, facts: TextTable) -> bool:
        """Whether a value, such as an id, would be whole below its name alone."""
        below = self._console.width - 2
        beside = below - max(cell_len(name) for name, _ in facts.rows)
        words = (word for _, value in facts.rows for word in value.split())
        return any(beside < cell_len(word) <= below for word in words)

    def _write(self, shown: RenderableType) -> None:
        with self._console.capture() as capture:
            self._console.print(shown)
        lines = (line.rstrip() for line in capture.get().splitlines())
        self.stream.write("\n".join(lines) + "\n")


def markdown(table: TextTable) -> str:
    rule = ["---:" if name.startswith(">") else "---" for name in table.columns]
    head = table.names if table.has_header else [""] * len(table.columns)
    rows = [[cell.replace("|", "\\|") for cell in row] for row in table.rows]
    lines = [f"| {' | '.join(row)} |" for row in [head, rule, *rows]]
    return "\n".join(lines) + "\n"


def latex(table: TextTable) -> str:
    """A `tabular` that needs no package."""
    sides = "".join("r" if name.startswith(">") else "l" for name in table.columns)
    rows = [" & ".join(map(_latex_text, row)) + r" \\" for row in table.rows]
    if table.has_header:
        rows.insert(0, " & ".join(map(_latex_text, table.names)) + r" \\ \hline")
    lines = [rf"\begin{{tabular}}{{{sides}}}", *rows, r"\end{tabular}"]
    return "\n".join(lines) + "\n"


def _latex_text(text: str) -> str:
    text = _MINUS.sub("−", text)
    return "".join(_LATEX_SPECIAL.get(char, char) for char in text)


def _rich(table: TextTable) -> Table:
    made = Table(
        box=None, pad_edge=False, show_header=table.has_header, header_style=""
    )
    for number, name in enumerate(table.columns):
        made.add_column(
            name.lstrip(">"),
            no_wrap=number == 0 and not table.breaks_first,
            justify="right" if name.startswith(">") else "left",
            overflow="fold",
        )
    for row in table.rows:
        made.add_row(*row)
    return made


def _spare(table: TextTable) -> int:
    """How much narrower the widest text that may be broken can become."""
    rows = [row[not table.breaks_first :] for row in (table.names, *table.rows)]
    widest = max((cell_len(cell) for row in rows for cell in row), default=0)
    return widest - _READABLE


def _width(console: Console, table: TextTable) -> int:
    widest = console.options.update(max_width=_UNBOUNDED)
    return console.measure(_rich(table), options=widest).maximum
