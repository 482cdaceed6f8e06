"""The sentence on an output that cannot be written, of every command."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from reference_record.command_line.click_commands import WrongUsage


@contextmanager
def writing(path: Path, option: str, way_out: str = "") -> Iterator[None]:
    """Raise WrongUsage for an OSError: it names the place and how to choose another.

    option: it chooses the place. way_out: what to do where it does something else.
    """
    try:
        yield
    except BrokenPipeError:  # of the standard output
        raise
    except OSError as error:
        raise WrongUsage(
            f"{path.absolute()} cannot be written ({error.strerror or error}); "
            f"{option} {way_out or 'names another place'}"
        ) from error
