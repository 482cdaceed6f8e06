"""The command line of the server: every setting is an option. Says what is wrong.

Values are checked where settings are: a wrong flag and a wrong variable of the
environment get the same answer.
"""

from __future__ import annotations

import typing
from collections.abc import Iterable, Iterator, Sequence

import click
from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_settings import SettingsError

from reference_record.command_line.click_commands import (
    Command,
    OneOf,
    WrongUsage,
    argument,
    option,
    parse_options,
    placeholder,
)
from reference_record.command_line.spelling import did_you_mean
from reference_server.settings.server_settings import Settings, describe_faults

PROGRAM = "proctor-server"
_NAMED = "named"
_PREFIX = str(Settings.model_config.get("env_prefix"))
# A variable that is less like a setting is another program's, such as POLICY_KEY.
LIKENESS = 0.77
# Variables of other programs of the project whose names are as close.
_OF_OTHERS = {f"{_PREFIX}{name}" for name in ("TOKEN", "POLICY_SOCKET", "BENCHMARK")}
_PLACEHOLDERS = {str(str): "TEXT", str(int): "N", str(float): "SECONDS"}


def build_command() -> Command:
    """The command `proctor-server`, with an option for each setting."""
    options = [_option(name, field) for name, field in Settings.model_fields.items()]
    named = argument(
        _NAMED,
        "as in --benchmarks, such as my_env.py:Kitchen",
        nargs=-1,
        metavar="[BENCHMARK]...",
    )
    return Command(PROGRAM, "", [named, *options], help_text=Settings.__doc__)


def read_settings(arguments: Sequence[str]) -> Settings:
    """Settings of flags and the environment; flags win. Words are benchmarks.

    Raises WrongUsage, which names each setting that is wrong and what it may be.
    """
    values = vars(parse_options(build_command(), arguments))
    named = values.pop(_NAMED) or []
    given = {name: value for name, value in values.items() if value is not None}
    if named:
        given["benchmarks"] = ",".join([*filter(None, [values["benchmarks"]]), *named])
    try:
        return Settings(**given)
    except ValidationError as error:
        raise WrongUsage(f"bad settings: {describe_faults(error)}") from error
    except SettingsError as error:
        raise WrongUsage(f"bad settings: {error}") from error


def misspelled_variables(names: Iterable[str]) -> Iterator[str]:
    """A sentence for each variable whose name is close to that of a setting."""
    given = {name.upper() for name in names if name.upper().startswith(_PREFIX)}
    for variable in sorted(given - _OF_OTHERS):
        name = variable.removeprefix(_PREFIX).lower()
        meant = did_you_mean(name, Settings.model_fields, LIKENESS)
        if meant and name not in Settings.model_fields:
            yield f"{variable} has no effect: there is no setting {name}{meant}"


def _option(name: str, field: FieldInfo) -> click.Option:
    """The option of a setting. Its value stays a text, which Settings checks."""
    default = "" if field.default == "" else f" (default: {field.default})"
    metavar, listed = _PLACEHOLDERS.get(str(field.annotation), ""), ""
    if choices := typing.get_args(field.annotation):
        metavar, listed = placeholder("value", OneOf(choices))
    elif name.endswith("_days"):
        metavar = "DAYS"
    return option(
        f"--{name.replace('_', '-')}",
        f"{field.description}{f' One of {listed}.' if listed else ''}{default}",
        metavar=metavar,
    )
