"""Tables of the command, as text, Markdown or LaTeX.

On a terminal, a table drops the columns that its maker names as dispensable until it
fits. Elsewhere, a line is never wrapped: programs read it.
"""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TextIO

from pydantic_core import to_jsonable_python
from rich.console import Console
from rich.table import Table

from reference_client.printable_text import printable

_UNBOUNDED = 100_000
_LATEX_SPECIAL = {
    "\\": r"\textbackslash{}",
    **{char: f"\\{char}" for char in "&%$#_{}"},
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "–": "--",
}


@dataclass
class TextTable:
    """Rows of texts under column names; a name that begins with > is right-aligned.

    dispensable: names of the columns that a narrow terminal drops, in this order.
    has_header: without it, the rows are names and values.
    """

    columns: Sequence[str]
    dispensable: Sequence[str] = ()
    has_header: bool = True
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
            [tuple(row[i] for i in kept) for row in self.rows],
        )


def fact_table(rows: Mapping[str, object]) -> TextTable:
    """A table of names and values; None values are omitted."""
    table = TextTable(("name", "value"), has_header=False)
    for name, value in rows.items():
        if value is not None:
            table.add(name, str(value))
    return table


class TablePrinter:
    """Prints results to `stream`: JSON, texts, tables in one of arguments.FORMATS."""

    def __init__(self, stream: TextIO, style: str = "text") -> None:
        self.stream = stream
        self._style = style
        fixed = os.environ.get("COLUMNS", "").isdecimal()
        self._console = Console(
            file=stream,
            highlight=False,
            markup=False,
            emoji=False,
            width=None if fixed or stream.isatty() else _UNBOUNDED,
        )

    def print_json(self, value: Any) -> None:
        self.stream.write(json.dumps(to_jsonable_python(value)) + "\n")
        self.stream.flush()

    def print(self, parts: Sequence[TextTable | str]) -> None:
        for number, part in enumerate(parts):
            if number:
                self.stream.write("\n")
            if isinstance(part, str):
                self.stream.write(f"{printable(part)}\n")
            elif self._style == "text":
                self._print_text(part)
            else:
                write = {"markdown": markdown, "latex": latex}[self._style]
                self.stream.write(write(part))
        self.stream.flush()

    def _print_text(self, table: TextTable) -> None:
        width = self._console.width
        shown = table
        while shown.dispensable and _width(self._console, shown) > width:
            shown = shown.without(shown.dispensable[0])
        with self._console.capture() as capture:
            self._console.print(_rich(shown))
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
    return "".join(_LATEX_SPECIAL.get(char, char) for char in text)


def _rich(table: TextTable) -> Table:
    made = Table(
        box=None, pad_edge=False, show_header=table.has_header, header_style=""
    )
    for number, name in enumerate(table.columns):
        made.add_column(
            name.lstrip(">"),
            no_wrap=number == 0,  # an id or a name, to be copied
            justify="right" if name.startswith(">") else "left",
            overflow="fold",
        )
    for row in table.rows:
        made.add_row(*row)
    return made


def _width(console: Console, table: TextTable) -> int:
    widest = console.options.update(max_width=_UNBOUNDED)
    return console.measure(_rich(table), options=widest).maximum
