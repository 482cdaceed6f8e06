"""How long a line may be that a program writes to a stream."""

from __future__ import annotations

import contextlib
import os
from typing import Any

# In less than this nothing can be read. Editors and remote shells that know no width
# say 0 or 1.
COLUMNS_MIN = 20
COLUMNS_UNKNOWN = 80


def given_columns() -> int | None:
    """The width that COLUMNS gives; None where it gives none that can be read."""
    text = os.environ.get("COLUMNS", "")
    columns = int(text) if text.isdecimal() else 0
    return columns if columns >= COLUMNS_MIN else None


def columns_of(stream: Any) -> int | None:
    """The width that COLUMNS gives, or the terminal has; None for no terminal.

    A stream that a program has put in the place of another one may only write.
    """
    if (given := given_columns()) is not None:
        return given
    with contextlib.suppress(AttributeError, ValueError, OSError):
        if not stream.isatty():
            return None
        columns = os.get_terminal_size(stream.fileno()).columns
        return columns if columns >= COLUMNS_MIN else COLUMNS_UNKNOWN
    return COLUMNS_UNKNOWN
