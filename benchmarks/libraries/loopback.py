"""HTTP servers and HTTP clients on loopback, measured alternately.

Every server is called by the reference client's connection; every client calls uvicorn
as the reference server runs it. Started, commanded, timed and ended like the contenders
of the round trips (interleaved_rounds.py).
"""

from __future__ import annotations

import contextlib
import os
import statistics
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from benchmarks.libraries.interleaved_timing import UNITS_NS
from benchmarks.libraries.samples import CAMERAS, COPIES, FOLDER, STATE
from benchmarks.round_trips import contender_registry, interleaved_rounds

_WARM_UP = 30
OURS = "reference_client"
# It goes through a view of memory byte by byte, 50 ms for the pictures.
GRANIAN = "granian: uvloop, given copies"
SERVERS: dict[str, Sequence[str]] = {
    "uvicorn: httptools, uvloop": ("uvicorn", "httptools", "uvloop"),
    "uvicorn: httptools, asyncio": ("uvicorn", "httptools", "asyncio"),
    "uvicorn: h11, asyncio": ("uvicorn", "h11", "asyncio"),
    GRANIAN: ("granian",),
    "hypercorn: h11, uvloop": ("hypercorn",),
}
CHOSEN_SERVER = next(iter(SERVERS))
CLIENTS = (OURS, "http.client", "urllib3", "requests", "httpx", "aiohttp")
TURNS = {STATE: 30, CAMERAS: 5}  # of each in a round

Figures = dict[str, dict[str, float]]


def servers(folder: Path, count: int, say: Callable[[str], None]) -> Figures:
    """By column and server. folder: of the samples. count: rounds."""
    figures: Figures = {}
    for sample, unit in ((STATE, "us"), (CAMERAS, "ms")):
        say(f"libraries: servers, {sample}")
        took = turn_times(
            [contender(name, name, OURS, folder, sample) for name in SERVERS],
            count,
            TURNS[sample],
        )
        suffix = "" if sample == STATE else "_pictures"
        figures[f"p50{suffix}_{unit}"] = _p50(took, unit)
        figures[f"server_cpu{suffix}_{unit}"] = {
            name: _each(one.server_cpu_s, one, unit) for name, one in took.items()
        }
    return figures


def clients(folder: Path, count: int, say: Callable[[str], None]) -> Figures:
    """By column and client."""
    say("libraries: clients")
    took = turn_times(
        [contender(name, CHOSEN_SERVER, name, folder, STATE) for name in CLIENTS],
        count,
        TURNS[STATE],
    )
    computed = {name: _each(one.client_cpu_s, one, "us") for name, one in took.items()}
    return {"p50_us": _p50(took, "us"), "client_cpu_us": computed}


def contender(
    name: str, server: str, client: str, folder: Path, sample: str
) -> interleaved_rounds.Contender:
    python = str(contender_registry.PEERS_PYTHON)
    copies = {COPIES: "1"} if server == GRANIAN else {}
    return interleaved_rounds.Contender(
        name,
        [python, "-m", "benchmarks.libraries.asgi_servers", *SERVERS[server]],
        [python, "-m", "benchmarks.libraries.http_clients"],
        [client, str(folder), sample],
        {FOLDER: str(folder), **copies},
    )


def turn_times(
    contenders: Sequence[interleaved_rounds.Contender], count: int, turns: int
) -> dict[str, interleaved_rounds.TurnTimes]:
    with contextlib.ExitStack() as standing:
        pairs = [interleaved_rounds.ContenderPair(one) for one in contenders]
        for pair in pairs:
            standing.callback(pair.close)
        with ThreadPoolExecutor(os.cpu_count()) as threads:  # they take a second each
            list(threads.map(interleaved_rounds.ContenderPair.__enter__, pairs))
        for pair in pairs:
            pair.play(_WARM_UP)
        return interleaved_rounds.play(
            pairs, count, {pair.name: turns for pair in pairs}
        )


def _p50(
    turn_times: dict[str, interleaved_rounds.TurnTimes], unit: str
) -> dict[str, float]:
    scale = UNITS_NS[unit]
    return {
        name: round(statistics.median(one.ns) / scale, 4)
        for name, one in turn_times.items()
    }


def _each(cpu_s: float, one: interleaved_rounds.TurnTimes, unit: str) -> float:
    """CPU of one request."""
    return round(cpu_s * 1e9 / len(one.ns) / UNITS_NS[unit], 4)
