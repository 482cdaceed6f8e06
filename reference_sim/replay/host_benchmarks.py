"""The benchmarks of their own that servers of this user offer on this machine.

A server that made its own token leaves its references beside the entry with it, so that
`proctor video RUN` and `proctor replay` find an environment without `--benchmarks`.
Each of them names code that is executed: a file that another user could have written is
not read.
"""

from __future__ import annotations

import contextlib
import json
import os
import socket
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import msgspec

from reference_record.command_line.written_output import writing
from reference_record.formats.private_file import read_private
from reference_record.formats.user_folders import state_folder
from reference_sim import benchmark_registry

_BYTES_MAX = 1 << 20


class _Offered(msgspec.Struct):
    """folder: where the server was started. references: by the id of the benchmark."""

    folder: str
    references: dict[str, str]


def publish(port: int, references: Mapping[str, str]) -> None:
    """Keep the references of the server at `port`, or remove those of an earlier one.

    Raises WrongUsage where they cannot be kept.
    """
    path = _folder() / f"{socket.gethostname()}-{port}"
    with writing(path, "--benchmarks", "of replay and video names the benchmarks too"):
        path.unlink(missing_ok=True)
        if references:
            path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            new = os.open(path, os.O_CREAT | os.O_EXCL | os.O_WRONLY, 0o600)
            with os.fdopen(new, "w") as file:
                json.dump({"folder": str(Path.cwd()), "references": references}, file)


def add(benchmark_id: str, references: str, say: Callable[[str], None]) -> None:
    """Add the references and, if none is the benchmark, the one of a local server.

    Raises BadBenchmark as benchmark_registry.add.
    """
    benchmark_registry.add(references, say)
    if benchmark_id in benchmark_registry.benchmark_ids():
        return
    for offered in _offered():
        reference = offered.references.get(benchmark_id)
        if reference is not None and Path(offered.folder).is_dir():
            say(f"{benchmark_id}: {reference}, as a server of yours here offers it")
            with contextlib.chdir(offered.folder):
                benchmark_registry.add(reference, say)
            return


def _offered() -> Iterator[_Offered]:
    """The files of this user's servers, the newest first."""
    paths: list[tuple[float, Path]] = []
    with contextlib.suppress(OSError, RuntimeError):
        paths = [(path.stat().st_mtime, path) for path in _folder().iterdir()]
    for _, path in sorted(paths, reverse=True):
        with contextlib.suppress(OSError, msgspec.DecodeError):
            yield msgspec.json.decode(read_private(path, _BYTES_MAX), type=_Offered)


def _folder() -> Path:
    return state_folder() / "benchmarks"
