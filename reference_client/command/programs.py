"""Programs that `proctor` starts in its place, and what each needs."""

from __future__ import annotations

import importlib.util
import os
import sys
from collections.abc import Sequence

from reference_client.command.usage_error import UsageError
from reference_record.command_line.installation import install_command

# Command → module to start, modules that it needs, and the extras that install them.
PROGRAMS = {
    "serve": (
        "reference_server",
        ("reference_server", "pydantic_settings", "sqlalchemy"),
        "server",
    ),
    "admin": (
        "reference_server.http.tokens.admin_command",
        ("reference_server", "pydantic_settings", "sqlalchemy"),
        "server",
    ),
    "admin account": (
        "reference_platform.command_line.challenge_command",
        ("reference_platform", "argon2"),
        "platform",
    ),
    "serve-policy": (
        "reference_client.policies.serve_command",
        ("starlette", "uvicorn"),
        "client",
    ),
    "replay": ("reference_sim.replay", ("reference_sim", "mujoco"), "server"),
    "conformance": ("conformance", ("conformance", "hypothesis"), "kit"),
    "export --to every-eval-ever": ("reference_sim.exports", (), "client"),
    "export --to parquet": ("reference_sim.exports", ("pyarrow",), "client,parquet"),
    "export --to lerobot": (
        "reference_sim.exports",
        ("mujoco", "av", "pyarrow"),
        "server,parquet,video",
    ),
    "video": ("reference_sim.exports", ("mujoco", "av"), "server,video"),
}


# Areas of `proctor admin` that belong to the platform beside the server.
PLATFORM_AREAS = (
    *("account", "track", "image", "submission", "platform", "preset", "key", "audit"),
)


def program_of(words: Sequence[str]) -> tuple[str, Sequence[str]]:
    """The program that a command line starts, and what is left for it.

    That of the platform has the areas of the server, too.
    """
    command, rest = words[0], words[1:]
    has_both = not _missing("admin account") and not _missing("admin")
    if command == "admin" and (has_both or (rest and rest[0] in PLATFORM_AREAS)):
        return "admin account", rest
    return command, rest


def start(command: str, arguments: Sequence[str]) -> int:
    """Replaces this process by the program. Raises UsageError if it is missing."""
    module = require(command)
    # Printing never ends the program, whatever the encoding of a terminal or a pipe.
    os.environ.setdefault("PYTHONIOENCODING", ":backslashreplace")
    os.execv(sys.executable, [sys.executable, "-m", module, *arguments])  # noqa: S606


def require(command: str) -> str:
    """The module of a program. Raises UsageError if something it needs is missing."""
    module, _, extra = PROGRAMS[command]
    if missing := _missing(command):
        raise UsageError(
            f"{command} needs {missing[0]}, which is not installed: "
            f"{install_command(extra)}"
        )
    return module


def _missing(command: str) -> list[str]:
    """The modules that a program needs and that are not installed."""
    _, needed, _ = PROGRAMS[command]
    return [name for name in needed if importlib.util.find_spec(name) is None]
