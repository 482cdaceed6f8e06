"""The secrets of sealed seeds that servers of this user keep on this machine.

A host may look at all that was played on its own server: with the secret, which only it
can read, episodes of sealed splits are simulated as any others. The commitment in a
record proves that a secret is the one that they were drawn with.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from reference_record.formats import local_servers
from reference_record.formats.private_file import read_private
from reference_sim.host_seeds import parse_secret

_BYTES_MAX = 4096


def local_secrets(named: Path | None = None) -> Iterator[tuple[Path, bytes]]:
    """Each file with its secret; files of other users or kinds are left out.

    named: the only one that is wanted; None looks where servers keep them.
    """
    for path in [named] if named else dict.fromkeys(_candidates()):
        with suppress(OSError, ValueError):
            yield path, parse_secret(read_private(path, _BYTES_MAX).decode("ascii"))


def _candidates() -> Iterator[Path]:
    """Where the settings of a server name one, and beside the tokens of servers."""
    if named := os.environ.get("PROCTOR_SEED_SECRET"):
        yield Path(named)
    yield Path(f"{os.environ.get('PROCTOR_DATABASE') or 'var/proctor.sqlite'}.seeds")
    with suppress(OSError, RuntimeError):  # no such folder, or no home
        for token in local_servers.token_files():  # DATABASE.token
            yield token.with_suffix(".seeds")
