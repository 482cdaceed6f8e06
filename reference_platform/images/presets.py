"""Presets: what a host offers to run code in.

A preset is a file NAME.toml in a folder of the host:

    command = ["python3", "main.py"]
    archive = "python-3.12.tar"     # an OCI archive beside it, as a root
    binds = ["/usr", "/lib"]        # or folders of the host, read-only
    files = "python-3.12"           # a folder beside it, which is at /preset
    environment = {PYTHONUNBUFFERED = "1"}

The code is at /policy, which is the working directory.
"""

from __future__ import annotations

import hashlib
from pathlib import Path

import msgspec

from reference_record.command_line.document_faults import describe_fault
from reference_record.command_line.toml_file import NotToml, read_toml_file

# Where the files of a preset are, in the sandbox.
FILES_PATH = "/preset"


class BadPreset(Exception):
    """The host's file is wrong; the message says what."""


class Preset(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """archive: a path beside the file, or absolute. binds: paths of the host."""

    command: list[str]
    archive: str = ""
    binds: list[str] = []
    files: str = ""
    environment: dict[str, str] = {}


class Presets:
    """Reads the presets of a folder whenever they are asked for."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def names(self) -> list[str]:
        return sorted(path.stem for path in self._folder.glob("*.toml"))

    def get(self, name: str) -> Preset:
        """Raises KeyError, BadPreset."""
        if name not in self.names():
            raise KeyError(name)
        path = self._folder / f"{name}.toml"
        try:
            preset = msgspec.convert(read_toml_file(path), Preset)
        except msgspec.ValidationError as error:
            raise BadPreset(f"{path}: {describe_fault(error, Preset)}") from error
        except NotToml as error:
            raise BadPreset(str(error)) from error
        if not preset.command or bool(preset.archive) == bool(preset.binds):
            raise BadPreset(f"{path}: it needs a command, and an archive or binds")
        return preset

    def binds_of(self, preset: Preset) -> dict[str, Path]:
        """Path in the sandbox → path of the host."""
        binds = {place: Path(place) for place in preset.binds}
        if preset.files:
            binds[FILES_PATH] = (self._folder / preset.files).absolute()
        return binds

    def archive_of(self, preset: Preset) -> tuple[str, Path]:
        """The digest and the path of the archive of a preset."""
        path = self._folder / preset.archive
        with path.open("rb") as file:
            return f"sha256:{hashlib.file_digest(file, 'sha256').hexdigest()}", path
