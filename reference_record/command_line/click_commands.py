"""Command lines of the library click: options under headings, errors in one line.

A program declares its commands and options. This module decides how the help of all
programs looks and how a mistake is explained. Nothing is printed in colour.
"""

from __future__ import annotations

import io
import os
import re
import sys
import textwrap
from collections.abc import Callable, Mapping, Sequence
from types import SimpleNamespace
from typing import Any

import click

from reference_record.command_line.spelling import did_you_mean, unknown
from reference_record.texts.terminal_width import columns_of

HELP_FLAGS = ["-h", "--help"]
WIDTH_MAX = 80  # a longer line is hard to read
# A number without another bound has this one, and nan is refused everywhere.
MOST = 1e9
DAYS_MAX = 36_500.0  # a later date may not be one that can be written
Parameters = Sequence[click.Parameter]
CHOICES_WIDTH_MAX = 24  # so that a terminal of 40 columns shows them


_TYPED = click.core.ParameterSource.COMMANDLINE


class WrongUsage(Exception):
    """The command line is invalid; the text says why and where the help is."""


class Options(SimpleNamespace):
    """The values of a command line, by the names of its options."""


class OneOf(click.Choice[str]):
    """A value of a list. A wrong one is answered with the list."""

    def get_invalid_choice_message(self, value: Any, ctx: click.Context | None) -> str:
        return unknown("value", str(value), self.choices)


class _Formatter(click.HelpFormatter):
    """Fits the terminal, which may have 40 columns; the library needs 50."""

    def __init__(
        self,
        indent_increment: int = 2,
        width: int | None = None,
        max_width: int | None = None,
    ) -> None:
        columns = min(columns_of(sys.stdout) or WIDTH_MAX, max_width or WIDTH_MAX)
        super().__init__(indent_increment, width or max(columns - 2, 30))

    def write_dl(self, rows: Any, col_max: int = 30, col_spacing: int = 2) -> None:
        # A third of the line is for the names, so that the texts stay readable.
        super().write_dl(rows, min(col_max, self.width // 3), col_spacing)

    def write_heading(self, heading: str) -> None:
        self.write(textwrap.fill(f"{heading}:", self.width) + "\n")


class _Context(click.Context):
    formatter_class = _Formatter


class _Option(click.Option):
    """Refuses empty texts: those of $VARIABLE or $(cat FILE) where there is none."""

    may_be_empty = False

    def resolve_envvar_value(self, ctx: click.Context) -> str | None:
        named = self.envvar if isinstance(self.envvar, str) else ""
        value = os.environ.get(named)
        if value is not None and not value.strip() and not ctx.resilient_parsing:
            text = f"{named} is set and empty: give it a value, or `unset {named}`"
            raise WrongUsage(text)
        return super().resolve_envvar_value(ctx)

    def process_value(self, ctx: click.Context, value: Any) -> Any:
        is_typed = ctx.get_parameter_source(str(self.name)) is _TYPED
        is_text = self.type is click.STRING and not self.may_be_empty
        if value == "" and is_typed and is_text:
            text = "it is empty: give it a value, or leave it out"
            raise click.BadParameter(text, ctx, self)
        return super().process_value(ctx, value)


def option(
    name: str,
    text: str,
    also: str | None = None,
    *,
    may_be_empty: bool = False,
    **more: Any,
) -> click.Option:
    """An option with its help, and a second name for it.

    may_be_empty: an empty text is a value of its own, and none that was forgotten.
    Without `metavar`, the name of its value is its own in capitals. Values that are too
    long for that column are listed in the help.
    """
    names = [name] if also is None else [name, also]
    made = _Option(names, help=text, **more)
    made.may_be_empty = may_be_empty
    if made.metavar is None:
        made.metavar, listed = placeholder(made.name, made.type)
        made.help = f"{text}: {listed}" if listed else text
    return made


def placeholder(name: str, kind: Any) -> tuple[str, str]:
    """The word that --help shows for a value, and the values if these are many."""
    if not isinstance(kind, click.Choice):
        return name.upper(), ""
    shown = f"[{'|'.join(kind.choices)}]"
    if len(shown) <= CHOICES_WIDTH_MAX:
        return shown, ""
    return name.upper(), ", ".join(kind.choices)


def flag(name: str, text: str, **more: Any) -> click.Option:
    """An option without a value."""
    return click.Option([name], is_flag=True, help=text, **more)


def argument(name: str, text: str, **more: Any) -> click.Argument:
    """A value that is given by its place."""
    return click.Argument([name], help=text, **more)


class Command(click.Command):
    """A command whose value is its Options.

    parameters: all, or those that --help shows under each heading; the heading "" comes
    first. constants: further members of the Options.
    """

    context_class = _Context

    def __init__(
        self,
        name: str,
        summary: str,
        parameters: Parameters | Mapping[str, Parameters],
        *,
        help_text: str | None = None,
        epilog: str | None = None,
        **constants: Any,
    ) -> None:
        if not isinstance(parameters, Mapping):
            parameters = {"": parameters}
        self._headings = parameters
        self._constants = constants
        super().__init__(
            name,
            context_settings={"help_option_names": HELP_FLAGS},
            params=[made for group in self._headings.values() for made in group],
            callback=self._values,
            short_help=summary,
            help=help_text or _sentence(summary),
            epilog=epilog,
        )

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except click.UsageError as error:
            error.ctx = error.ctx or ctx  # names the command whose help is meant
            raise

    def _values(self, **values: Any) -> Options:
        lists = {
            name: [*value] or None
            for name, value in values.items()
            if isinstance(value, tuple)
        }
        return Options(**self._constants | values | lists)

    def format_options(
        self, ctx: click.Context, formatter: click.HelpFormatter
    ) -> None:
        groups = {"": [], **self._headings}
        help_option = self.get_help_option(ctx)
        for heading, parameters in groups.items():
            shown = [p for p in parameters if isinstance(p, click.Option)]
            if heading == "" and help_option is not None:
                shown.insert(0, help_option)
            records = [p.get_help_record(ctx) for p in shown]
            if rows := [record for record in records if record is not None]:
                with formatter.section(heading or "Options"):
                    formatter.write_dl(rows)


class Group(click.Group):
    """A command that has commands.

    commands: all, or those that --help shows under each heading.
    """

    context_class = _Context

    def __init__(
        self,
        name: str,
        summary: str,
        commands: Sequence[click.Command] | Mapping[str, Sequence[click.Command]],
        *,
        help_text: str | None = None,
        **more: Any,
    ) -> None:
        if not isinstance(commands, Mapping):
            commands = {"Commands": commands}
        self._headings = commands
        super().__init__(
            name,
            context_settings={"help_option_names": HELP_FLAGS},
            commands=[made for group in commands.values() for made in group],
            no_args_is_help=False,
            subcommand_metavar="COMMAND …",
            short_help=summary,
            help=help_text or _sentence(summary),
            **more,
        )

    def list_commands(self, ctx: click.Context) -> list[str]:
        return [*self.commands]  # in their order, which goes from first to last use

    def format_commands(
        self, ctx: click.Context, formatter: click.HelpFormatter
    ) -> None:
        for heading, commands in self._headings.items():
            rows = [(made.name or "", made.short_help or "") for made in commands]
            with formatter.section(heading):
                formatter.write_dl(rows)


def parse_options(
    command: click.Command, arguments: Sequence[str] | None = None
) -> Options:
    """The options of these arguments, or those of this process. Raises WrongUsage.

    Ends the process after --help, and when a shell asks at Tab what it may complete.
    """
    _show_every_character()
    output = sys.stdout
    try:
        parsed = command.main(
            sys.argv[1:] if arguments is None else [*arguments],
            prog_name=command.name,
            standalone_mode=False,
        )
    except click.UsageError as error:
        raise WrongUsage(_explain(error, command)) from error
    except click.Abort as aborted:  # what the library makes of an interruption
        raise KeyboardInterrupt(*getattr(aborted.__cause__, "args", ())) from None
    except SystemExit as ended:
        if sys.stdout is not output:  # closed: the library replaces it, to exit with 1
            raise BrokenPipeError from ended
        raise
    if isinstance(parsed, Options):
        return parsed
    raise SystemExit(parsed)


def _show_every_character() -> None:
    """A terminal of an old code page gets `?` for `…`, and the program does not end."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def checked(check: Callable[[str], Any]) -> Callable[[str], Any]:
    """A type of values from a function that raises ValueError with the reason."""

    def convert(text: Any) -> Any:
        try:
            return check(text) if isinstance(text, str) else text  # a default value
        except ValueError as error:
            raise click.BadParameter(str(error)) from error

    return convert


@checked
def count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= MOST:
        raise ValueError(f"{text}: expected an integer >= 1")
    return int(text)


@checked
def seconds(text: str) -> float:
    return _number(text, MOST, "seconds >= 0")


@checked
def fraction(text: str) -> float:
    return _number(text, 1.0, "a number from 0 to 1")


@checked
def number_of_days(text: str) -> float:
    return _number(text, DAYS_MAX, f"a number of days from 0 to {DAYS_MAX:g}")


@checked
def amount(text: str) -> float:
    expected = f"a number > 0, at most {MOST:g}"
    if (given := _number(text, MOST, expected)) == 0:
        raise ValueError(f"{text}: expected {expected}")
    return given


def _number(text: str, most: float, expected: str) -> float:
    try:
        given = float(text)
    except ValueError:
        given = -1.0
    if not 0 <= given <= most:  # nor nan, of which no comparison holds
        raise ValueError(f"{text}: expected {expected}")
    return given


@checked
def episode_indices(text: str) -> list[int]:
    """Indices from 0, or ids as the pages show them: `0,3,12`, `e0003`."""
    if not re.fullmatch(r"e?\d{1,5}(,e?\d{1,5})*", text):
        raise ValueError(
            f"{text}: expected indices such as 0,3,12, or ids such as e0003"
        )
    return [int(name.removeprefix("e")) for name in text.split(",")]


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _explain(error: click.UsageError, command: click.Command) -> str:
    context = error.ctx
    path = context.command_path if context else command.name
    return f"{_reason(error).rstrip('.')}; see {path} --help"


def _reason(error: click.UsageError) -> str:
    context = error.ctx
    match error:
        case click.NoSuchOption() if context is not None:
            word = error.option_name
            if owners := _owners(word, context):
                return f"{word} is an option of {', '.join(owners)} only"
            return f"unknown option {word}{did_you_mean(word, _flags(context.command))}"
        case click.NoSuchCommand() if context is not None:
            commands = getattr(context.command, "commands", {})
            word = error.command_name
            return f"unknown command {word}{did_you_mean(word, commands)}"
        case click.MissingParameter() | click.NoSuchOption():
            return error.format_message()
        case click.BadParameter(param=parameter) if parameter is not None:
            names = [*parameter.opts] if parameter.opts else []
            if isinstance(parameter, click.Argument):
                names = [parameter.human_readable_name]
            return f"{'/'.join(names)}: {error.message}"
    return error.format_message()


def _flags(command: click.Command) -> list[str]:
    """The options of a command; of a group, those of its commands, too."""
    commands = [command, *getattr(command, "commands", {}).values()]
    return [flag for made in commands for p in made.params for flag in _flags_of(p)]


def _flags_of(parameter: click.Parameter) -> list[str]:
    return parameter.opts if isinstance(parameter, click.Option) else []


def _owners(word: str, context: click.Context) -> list[str]:
    """The other commands of the program that have an option of this name."""
    parent = context.parent or context
    return [
        f"{parent.command_path} {name}"
        for name, made in getattr(parent.command, "commands", {}).items()
        if any(word in _flags_of(parameter) for parameter in made.params)
    ]
