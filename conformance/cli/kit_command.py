"""The command lines of the kit, with the library click: help, and errors in one line.

The kit is installed without the other packages of this project, which have a module of
the same purpose. Nothing is printed in colour.
"""

import difflib
import shutil
from collections.abc import Iterable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any

import click

from conformance.client.connections.transport.printable_text import prepare_output

COLUMNS_MAX = 80


class BadArguments(Exception):
    """The command line is invalid; the text gives the reason."""


class KitOptions(SimpleNamespace):
    """The values of a command line, by the names of its options."""


class _Formatter(click.HelpFormatter):
    """Fits the terminal, which may have 40 columns; the library needs 50."""

    def __init__(self, *_: Any, **__: Any) -> None:
        columns = min(shutil.get_terminal_size().columns, COLUMNS_MAX)
        super().__init__(width=max(columns - 2, 30))

    def write_dl(self, rows: Any, col_max: int = 30, col_spacing: int = 2) -> None:
        # A third of the line is for the names, so that the texts stay readable.
        super().write_dl(rows, min(col_max, self.width // 3), col_spacing)


class _Context(click.Context):
    formatter_class = _Formatter


class KitCommand(click.Command):
    """A command whose value is its KitOptions; --help shows them under `headings`."""

    context_class = _Context

    def __init__(
        self, name: str, headings: Mapping[str, Sequence[click.Option]], **more: str
    ) -> None:
        self._headings = headings
        super().__init__(
            name,
            context_settings={"help_option_names": ["-h", "--help"]},
            params=[option for options in headings.values() for option in options],
            callback=KitOptions,
            help=more["help"],
            epilog=more["epilog"],
        )

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Refuse a list that is given twice: the library takes the last one alone."""
        _, _, given = self.make_parser(ctx).parse_args([*args])
        for parameter in given:
            if given.count(parameter) > 1 and "," in parameter.make_metavar(ctx):
                name = parameter.opts[0]
                text = "give it once, with commas between its values"
                raise click.UsageError(f"{name} is given twice: {text}")
        return super().parse_args(ctx, args)

    def format_options(
        self, ctx: click.Context, formatter: click.HelpFormatter
    ) -> None:
        shown = [option for options in self._headings.values() for option in options]
        rest = [option for option in self.get_params(ctx) if option not in shown]
        for heading, options in {"Options": rest, **self._headings}.items():
            records = [option.get_help_record(ctx) for option in options]
            with formatter.section(heading):
                formatter.write_dl(filter(None, records))


def option(name: str, text: str, metavar: str = "", **more: Any) -> click.Option:
    """An option. Without `metavar`, the name of its value is its own in capitals."""
    metavar = metavar or name.strip("-").replace("-", "_").upper()
    return click.Option([name], help=text, metavar=metavar, **more)


def flag(name: str, text: str, **more: Any) -> click.Option:
    """An option without a value."""
    return click.Option([name], is_flag=True, help=text, **more)


def parse_options(command: click.Command, arguments: Sequence[str]) -> KitOptions:
    """The options. Raises BadArguments.

    Ends the process after --help, and when a shell asks at Tab what it may complete.
    """
    prepare_output()
    try:
        parsed = command.main(
            [*arguments], prog_name=command.name, standalone_mode=False
        )
    except click.UsageError as error:
        raise BadArguments(error.format_message().rstrip(".")) from error
    if isinstance(parsed, KitOptions):
        return parsed
    raise SystemExit(parsed)


def close_names(word: str, names: Iterable[str]) -> str:
    """`; did you mean NAME or NAME?`; empty if no name is close."""
    close = difflib.get_close_matches(word, [*names], n=3, cutoff=0.6)
    return f"; did you mean {' or '.join(close)}?" if close else ""
