"""The server under attack: many accounts, and a command that may limit its resources.

Accounts: `watcher` plays the runs that are watched, `attacker` attacks, and
`attacker0` … are further attacking accounts.
"""

from __future__ import annotations

import resource
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from tests.support.processes import descendants
from tests.support.servers import ReferenceServer

WATCHER, ATTACKER = "watcher-token", "attacker-token"
WATCHER_READS = "watcher-reads-token"  # with the scope `read` alone
OTHERS = [f"attacker{number}-token" for number in range(8)]
# Loopback addresses: watchers do not share the one of the attacker.
WATCHER_ADDRESS = "127.0.0.2"


def _tokens() -> str:
    tokens = [WATCHER, ATTACKER, *OTHERS]
    whole = [f"{token.removesuffix('-token')}:read+run:{token}" for token in tokens]
    return ",".join([*whole, f"watcher:read:{WATCHER_READS}"])


class CampaignServer(ReferenceServer):
    """program: module with the `main` of the server. prefix: see `Attack`.

    python: of the environment that it runs in.
    """

    def __init__(
        self,
        directory: Path,
        settings: Mapping[str, str],
        prefix: Sequence[str] = (),
        program: str = "reference_server",
        python: str = sys.executable,
    ) -> None:
        self.directory = directory
        self.command = (*prefix, python, "-m", program)
        common = {"PROCTOR_TOKENS": _tokens(), "PROCTOR_PROFILES": "ebench,flageval"}
        super().__init__(directory, **common | dict(settings))

    @property
    def database(self) -> Path:
        return self.directory / "proctor.sqlite"

    def simulators(self) -> list[int]:
        """Process ids of those that simulate, which the server's fork server started.

        That one is the only child with children.
        """
        pid = self.process.pid
        children = {child: descendants(child) for child in descendants(pid)}
        return sorted(set().union(*children.values()))

    def limit_file_size(self, size: int | None) -> None:
        """Let writes beyond a size fail, as on a full disk; None: no longer."""
        _, hard = resource.prlimit(self.process.pid, resource.RLIMIT_FSIZE)
        soft = hard if size is None else size
        resource.prlimit(self.process.pid, resource.RLIMIT_FSIZE, (soft, hard))
