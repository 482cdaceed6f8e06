"""Opens each file and folder of the settings once, before the server listens.

One that cannot be used is a sentence with the setting that names another one.
"""

from __future__ import annotations

import errno
import os
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from reference_record.broken import UnusableRecord
from reference_record.formats.opened_seeds import load_opened_seeds
from reference_server.cells.act_log import ActLog
from reference_server.files.file_faults import describe_file_fault
from reference_server.files.seed_secret import SeedSecret
from reference_server.http.auth import BadTokens, Tokens
from reference_server.http.tokens.token_file import TokenFile
from reference_server.push.key_encryption import KeyEncryption
from reference_server.records.run_records import open_key
from reference_server.settings import Settings


class StartRefused(Exception):
    """Something that the settings name cannot be used; the text says what to do."""


@dataclass(frozen=True, slots=True)
class _KeptFile:
    """name: in sentences. option: names another one.

    open: uses it as the server does. is_made: by that, if it is not there.
    """

    name: str
    option: str
    path: Path
    open: Callable[[Path], object]
    is_made: bool = True


def open_kept_files(settings: Settings) -> list[Path]:
    """Open all; returns those that it made. Raises StartRefused."""
    made = []
    for file in _kept_files(settings):
        try:
            is_new = file.is_made and not file.path.exists()
            file.open(file.path)
        except (OSError, ValueError, UnusableRecord, BadTokens) as error:
            raise StartRefused(
                f"cannot use {file.name} in {file.path} "
                f"({describe_file_fault(error, file.path)}); choose another with "
                f"{file.option}"
            ) from error
        if is_new:
            made.append(file.path)
    return made


def _kept_files(settings: Settings) -> Iterator[_KeptFile]:
    key, seeds = settings.sealing_key_path, settings.seed_secret_path
    yield _KeptFile("the key", "--sealing-key", key, _open_sealing_key)
    yield _KeptFile("the secret of sealed seeds", "--seed-secret", seeds, _open_seeds)
    for path in settings.opened_seeds_paths:
        name, option = "the opened seeds", "--opened-seeds"
        yield _KeptFile(name, option, path, load_opened_seeds, is_made=False)
    tokens, acts = settings.tokens_file_path, settings.cell_acts_path
    name = "the acts at robot cells"
    yield _KeptFile("the tokens", "--tokens-file", tokens, _open_tokens, is_made=False)
    yield _KeptFile(name, "--database", acts, _open_acts, is_made=False)
    if settings.recordings == "off":
        return
    signing_key, folder = settings.signing_key_path, settings.records_path
    name = "the key that signs records"
    yield _KeptFile(name, "--signing-key", signing_key, open_key)
    yield _KeptFile("the folder of recordings", "--records-dir", folder, _open_folder)
    if settings.takes_records:
        name, folder = "the folder of imported records", settings.imports_path
        yield _KeptFile(name, "--records-dir", folder, _open_folder, is_made=False)


def _open_sealing_key(path: Path) -> None:
    KeyEncryption(path).open()


def _open_seeds(path: Path) -> None:
    SeedSecret(path).open()


def _open_tokens(path: Path) -> None:
    TokenFile(path, Tokens({})).read()


def _open_acts(path: Path) -> None:
    ActLog(path).open()


def _open_folder(path: Path) -> None:
    """Make it, and see whether files can be written."""
    if path.is_file():
        raise NotADirectoryError(errno.ENOTDIR, os.strerror(errno.ENOTDIR), str(path))
    path.mkdir(mode=0o700, parents=True, exist_ok=True)
    tempfile.TemporaryFile(dir=path).close()
