"""TOML files that people write: a mistake in one is said with the name of the file."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

from reference_record.command_line.text_file import NotText, read_text_file


class NotToml(ValueError):
    """The file cannot be read as TOML; the message names it and says why."""


def read_toml_file(path: str | Path) -> dict[str, Any]:
    """The table of a file. Raises NotToml."""
    try:
        return tomllib.loads(read_text_file(path))
    except FileNotFoundError as error:
        raise NotToml(f"there is no file {path}") from error
    except OSError as error:
        raise NotToml(f"{path}: it cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, NotText) as error:
        raise NotToml(f"{path}: it is not valid TOML: {error}") from error
