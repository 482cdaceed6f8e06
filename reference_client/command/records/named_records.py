"""A record that is named where a run is: it is read and verified, without a server."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from reference_client.command.usage_error import UsageError
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import STATEMENT
from reference_record.pages.record_documents import read_reported_run
from reference_record.pages.static_pages import ReportedRun


def is_record(name: str) -> bool:
    """Whether it is the file or the folder of a record, and not the id of a run."""
    path = Path(name)
    return "/" in name or "." in name or path.is_file() or (path / STATEMENT).exists()


def read_record(name: str, keys: Mapping[str, str]) -> ReportedRun:
    """keys: keyid → whose key it is. Raises BrokenRecord, UsageError."""
    try:
        return read_reported_run(open_bundle(Path(name)), keys)
    except FileNotFoundError as error:
        raise UsageError(
            f"{name!r} is no id of a run; `proctor status` lists them; there is no "
            "record of this name either"
        ) from error
    except OSError as error:
        raise UsageError(f"{name}: {error.strerror or error}") from error
