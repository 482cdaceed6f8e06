"""Libraries for HTTP and encoding, so that the choices among them can be made again.

All libraries, including those that the project uses, run in the peers' environment.
Their input is a real request and answers of the reference server. Servers and clients
are measured on loopback, like the contenders of the round trips: every server is called
by the reference client's connection, every client calls uvicorn as the reference server
runs it. All else is measured in one process.
"""

import json
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from benchmarks import measuring
from benchmarks.libraries import samples
from benchmarks.libraries.http_process import CLIENTS
from benchmarks.round_trips.compared_turns import PEERS_PYTHON
from benchmarks.round_trips.interleaved_rounds import Contender, play, started

TITLE = "Libraries: HTTP and encoding"
ROUNDS, ROUNDS_TRIED = (100, 40), (3, 2)  # in one process, on loopback
WARM_UP, REQUESTS = 30, 30
OURS = "reference_client"
SERVERS: dict[str, Sequence[str]] = {
    "uvicorn: httptools, uvloop": ("uvicorn", "httptools", "uvloop"),
    "uvicorn: httptools, asyncio": ("uvicorn", "httptools", "asyncio"),
    "uvicorn: h11, asyncio": ("uvicorn", "h11", "asyncio"),
    "granian: uvloop": ("granian",),
}
CHOSEN_SERVER = next(iter(SERVERS))


def measure(*, trying: bool) -> str:
    """A row for each piece of work and library; the chosen one is the first."""
    in_process, on_loopback = ROUNDS_TRIED if trying else ROUNDS
    where = measuring.machine()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        samples.capture(folder)
        command = ["-m", "benchmarks.libraries.in_process", scratch, str(in_process)]
        done = subprocess.run(
            [str(PEERS_PYTHON), *command],
            cwd=measuring.ROOT,
            check=True,
            stdout=subprocess.PIPE,
        )
        rows: list[list[str]] = json.loads(done.stdout)
        servers = [contender(name, name, OURS, folder) for name in SERVERS]
        rows += loopback_rows("HTTP server, 670 bytes", servers, on_loopback)
        clients = [contender(name, CHOSEN_SERVER, name, folder) for name in CLIENTS]
        rows += loopback_rows("HTTP client, 670 bytes", clients, on_loopback)
    table = measuring.table(["piece", "library", "µs", "ratio"], rows)
    rounds = f"Medians of {in_process} rounds, of {on_loopback} on loopback."
    return f"{table}\n\n{rounds} {where}"


def contender(name: str, server: str, client: str, folder: Path) -> Contender:
    run = [str(PEERS_PYTHON), "-m", "benchmarks.libraries.http_process"]
    return Contender(
        name,
        [*run, "serve", *SERVERS[server]],
        [*run, "play", client, "{}", str(folder)],
        {samples.FOLDER: str(folder)},
    )


def loopback_rows(
    piece: str, contenders: Sequence[Contender], rounds: int
) -> list[list[str]]:
    """The chosen one is the first, and the reference."""
    with started(contenders) as pairs:
        for pair in pairs:
            pair.play(WARM_UP)
        played = play(pairs, rounds, {pair.name: REQUESTS for pair in pairs})
    p50_us = {name: 1e3 * times.percentile_ms(50) for name, times in played.items()}
    chosen_us = p50_us[contenders[0].name]
    return [
        [piece, name, measuring.digits(us), f"{us / chosen_us:.2f}"]
        for name, us in p50_us.items()
    ]
