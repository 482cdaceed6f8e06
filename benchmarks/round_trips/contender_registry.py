"""The contenders by name: the commands of server and client.

Peers run with their real packages in their own virtual environment, `.venv-bench`; ours
is the reference server with the benchmark `still_life`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from benchmarks.round_trips.contenders.ours_client import TOKEN
from benchmarks.round_trips.interleaved_rounds import ROOT, Contender

PEERS_PYTHON = ROOT / ".venv-bench" / "bin" / "python"
_MODULES = "benchmarks.round_trips.contenders"
_OUR_SERVER = "benchmarks.round_trips.still_life.still_life_server"
PEERS = ("grpc", "openpi", "ebench", "openenv")
# name → media type and codec of the small client; none: the reference client's session
OURS: dict[str, tuple[str, ...]] = {
    "ours msgpack": (),
    "ours msgpack small": ("msgpack", "raw"),
    "ours json": ("json", "raw"),
    "ours json jpeg": ("json", "jpeg"),
    "ours json jpeg files": ("json", "jpeg-files"),
}


def contender(name: str, scenario: str, scratch: Path) -> Contender:
    """scratch: a folder for the databases of our servers."""
    if name in OURS:
        return _ours(name, scenario, scratch)
    python = str(PEERS_PYTHON if name in PEERS else sys.executable)
    return Contender(
        name,
        [python, "-m", f"{_MODULES}.{name}_server", scenario],
        [python, "-m", f"{_MODULES}.{name}_client"],
        [scenario],
    )


def _ours(name: str, scenario: str, scratch: Path) -> Contender:
    client = "ours_client" if OURS[name] else "session_client"
    database = scratch / f"{name.replace(' ', '_')}_{scenario}.sqlite"
    return Contender(
        name,
        [
            *(sys.executable, "-m", _OUR_SERVER),
            *("--port", "0", "--database", str(database)),
        ],
        [sys.executable, "-m", f"{_MODULES}.{client}"],
        [scenario, *OURS[name]],
        {"PROCTOR_TOKENS": f"bench:read+run:{TOKEN}"},
    )
