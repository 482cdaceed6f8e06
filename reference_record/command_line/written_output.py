"""An output that cannot be written, of every command: its sentence, and its remains."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from reference_record.command_line.click_commands import WrongUsage


@contextmanager
def whole_or_gone(folder: Path) -> Iterator[None]:
    """Remove what was written if anything is raised, unless others had files there.

    A folder that was there before stays as it is, and so does what was raised.
    """
    is_new = not folder.exists()
    is_empty = folder.is_dir() and not any(folder.iterdir())
    try:
        yield
    except BaseException:
        if is_new:
            shutil.rmtree(folder, ignore_errors=True)
        elif is_empty:
            _empty(folder)
        raise


def _empty(folder: Path) -> None:
    """Remove what is in the folder, as far as that can be done."""
    with suppress(OSError):
        for path in list(folder.iterdir()):
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
                continue
            with suppress(OSError):
                path.unlink()


@contextmanager
def writing(path: Path, option: str, way_out: str = "") -> Iterator[None]:
    """Raise WrongUsage for an OSError: it names the place and how to choose another.

    option: it chooses the place. way_out: what to do where it does something else. An
    error of a file elsewhere, which was to be read, is raised as it is.
    """
    try:
        yield
    except BrokenPipeError:  # of the standard output
        raise
    except OSError as error:
        if error.filename is not None and _is_elsewhere(Path(error.filename), path):
            raise
        raise WrongUsage(
            f"{path.absolute()} cannot be written ({error.strerror or error}); "
            f"{option} {way_out or 'names another place'}"
        ) from error


def _is_elsewhere(file: Path, place: Path) -> bool:
    """Whether a file is neither in the place nor a folder on the way to it."""
    file, place = file.absolute(), place.absolute()
    return not (file.is_relative_to(place.parent) or place.is_relative_to(file))
