"""The command line of the server: every setting is an option. Says what is wrong.

Values are checked where settings are: a wrong flag and a wrong variable of the
environment get the same answer.
"""

from __future__ import annotations

import typing
from collections.abc import Sequence

from pydantic import ValidationError
from pydantic.fields import FieldInfo
from pydantic_settings import SettingsError

from reference_record.command_line.click_commands import (
    Command,
    WrongUsage,
    option,
    parse_options,
)
from reference_server.settings.server_settings import Settings, describe_faults

PROGRAM = "proctor-server"
_PLACEHOLDERS = {"str": "TEXT", "int": "N", "float": "SECONDS"}


def build_command() -> Command:
    """The command `proctor-server`, with an option for each setting."""
    options = [
        option(
            f"--{name.replace('_', '-')}",
            metavar=_placeholder(name, field),
            help=_help(field),
        )
        for name, field in Settings.model_fields.items()
    ]
    return Command(PROGRAM, {"": options}, help=Settings.__doc__)


def read_settings(arguments: Sequence[str]) -> Settings:
    """Settings of flags and the environment; flags win.

    Raises WrongUsage, which names each setting that is wrong and what it may be.
    """
    values = vars(parse_options(build_command(), arguments))
    given = {name: value for name, value in values.items() if value is not None}
    try:
        return Settings(**given)
    except ValidationError as error:
        raise WrongUsage(f"bad settings: {describe_faults(error)}") from error
    except SettingsError as error:
        raise WrongUsage(f"bad settings: {error}") from error


def _help(field: FieldInfo) -> str:
    default = "" if field.default == "" else f" (default: {field.default})"
    return f"{field.description}{default}"


def _placeholder(name: str, field: FieldInfo) -> str:
    if choices := typing.get_args(field.annotation):
        return f"[{'|'.join(choices)}]"
    if name.endswith("_days"):
        return "DAYS"
    return _PLACEHOLDERS[str(getattr(field.annotation, "__name__", ""))]
