"""`python -m reference_platform.images.unpack_program`: unpacks one hostile archive.

A process of its own, with limits of memory and time, so that a fault of a reader ends
nothing else. It ends when its standard input does: with the platform. It prints JSON:
an ImageProgram, or why the archive is refused.
"""

from __future__ import annotations

import os
import resource
import sys
import tempfile
import threading
from pathlib import Path

import msgspec

from reference_platform.images.bounded_archives import (
    Budget,
    InvalidArchive,
    archive_errors,
)
from reference_platform.images.code_archive import unpack_code
from reference_platform.images.oci_archive import (
    ImageProgram,
    read_program,
    unpack_image,
)

MEMORY_BYTES_MAX = 3 * 2**30
CPU_S_MAX = 1800
ENTRIES_MAX = 500_000


class Refusal(msgspec.Struct, frozen=True):
    """The archive is refused."""

    refused: str


def main(arguments: list[str]) -> int:
    """Arguments: what is done, the archive, the new folder, the most bytes.

    `image` and `code` are unpacked to the folder; `check` only reads of an image what
    it would start.
    """
    kind, archive, target, max_bytes = arguments
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES_MAX, MEMORY_BYTES_MAX))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_S_MAX, CPU_S_MAX))
    threading.Thread(target=_end_with_input, daemon=True).start()
    budget = Budget(int(max_bytes), ENTRIES_MAX)
    answer: ImageProgram | Refusal
    with tempfile.TemporaryDirectory(dir=Path(target).parent) as scratch:
        try:
            with archive_errors():
                if kind == "check":
                    answer = read_program(Path(archive))
                elif kind == "image":
                    answer = unpack_image(
                        Path(archive), Path(target), Path(scratch), budget
                    )
                else:
                    remarks = unpack_code(
                        Path(archive), Path(target), Path(scratch), budget
                    )
                    answer = ImageProgram([], {}, "/", remarks)
        except InvalidArchive as error:
            answer = Refusal(str(error))
        except MemoryError:
            answer = Refusal("It cannot be read with the memory that is given to it.")
    sys.stdout.write(msgspec.json.encode(answer).decode())
    return 0


def _end_with_input() -> None:
    sys.stdin.read()
    os._exit(1)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
