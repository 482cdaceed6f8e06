"""Measures the pages of a server: how fast large ones open, what open live ones cost.

`python -m benchmarks.page_speed` stores a run of 10,000 episodes and a leaderboard of
500 entries of 1,000 episodes, starts a server on them and fetches their pages whole,
over HTTP, each the first time after a start and again. Then 200 pages follow a run
live, beside the same play without pages. CPU is that of the server's process.

It writes the section `pages` of build/benchmarks.json and of build/performance.md.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import random
import socket
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from benchmarks import performance_page, results
from benchmarks.filled_databases import (
    DatabaseCase,
    ServerProcess,
    build_run,
    fill,
    running_server,
)
from benchmarks.round_trips.contenders.ours_client import TOKEN
from reference_record.formats.merkle_tree import leaf_hash
from reference_server.rules.board import entry_changes
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.board.ranking import Contender, rank
from reference_server.rules.lifecycle import Refuse
from reference_server.storage.board_store import BoardStore
from reference_server.storage.store import Store
from tests.support.pages.page_reader import PageReader
from tests.support.server.http_runs import predict_body

LONG_RUN = DatabaseCase("one long run", 1, 10_000)
ENTRIES, EPISODES_OF_AN_ENTRY = 500, 1000
RANKED = 200
OPENED = 5
LIVE_PAGES, EPISODES_A_SECOND = 200, 10
OPEN_S, LIVE_SHARE, RANKING_S = 1.0, 0.05, 2.0  # what is promised


# --- what is stored ---


def stored_entries(seed: int) -> Iterator[BoardEntry]:
    """Entries of one manifest, as runs of very different policies make them."""
    randomness = random.Random(seed)
    run = build_run(EPISODES_OF_AN_ENTRY, "completed")
    first = entry_changes.new_entry("", run, run.episodes, 1.7e9)
    assert not isinstance(first, Refuse)
    for number in range(ENTRIES):
        rate = 0.05 + 0.9 * number / ENTRIES
        successes = [randomness.random() < rate for _ in range(EPISODES_OF_AN_ENTRY)]
        mean = sum(successes) / len(successes)
        yield replace(
            first,
            entry_id=f"entry_{number}",
            run_id=f"published_{number}",
            account=f"lab{number % 40}",
            score={**first.score, "score": mean, "success_rate": mean},
            successes="".join(str(int(one)) for one in successes),
        )


async def store_entries(path: Path, seed: int) -> str:
    """Returns the manifest of the entries."""
    store = Store(f"sqlite+aiosqlite:///{path}")
    await store.open()
    board = BoardStore(store, leaf_hash)
    described = {"model_name": "a policy", "is_public": True, "organisation": "a lab"}
    for entry in stored_entries(seed):
        change = entry_changes.publish(entry, None, described)
        assert isinstance(change, Change)
        await board.change(entry.run_id, lambda _, change=change: change)  # type: ignore[misc]
    await store.close()
    return entry.manifest_sha256


# --- opening ---


def measure_opening(server: ServerProcess, manifest: str) -> dict[str, Any]:
    """Seconds until the last byte of each page: the first time, and the median."""
    reader = signed_in(server)
    board = f"/pages/benchmarks/calibration/leaderboard?manifest={manifest}"
    ranking = f"/v1/benchmarks/calibration/ranking?manifest_sha256={manifest}"
    pages: dict[str, Callable[[], object]] = {
        "run of 10,000 episodes": lambda: reader.text("/pages/runs/completed_0"),
        "leaderboard of 500 entries": lambda: reader.text(board),
        "ranking of 500 entries, JSON": lambda: server.ask("GET", ranking),
    }
    return {name: seconds_of(server, open_page) for name, open_page in pages.items()}


def seconds_of(server: ServerProcess, call: Callable[[], object]) -> dict[str, float]:
    """Of the clock, and of CPU in the server: a busy machine changes these less."""
    seconds, cpu = [], []
    for _ in range(1 + OPENED):
        began_at, before = time.perf_counter(), server.cpu_s()
        call()
        seconds.append(time.perf_counter() - began_at)
        cpu.append(server.cpu_s() - before)
    return {
        "first_s": seconds[0],
        "first_cpu_s": cpu[0],
        "again_s": statistics.median(seconds[1:]),
        "again_cpu_s": statistics.median(cpu[1:]),
    }


def measure_ranking(seed: int) -> float:
    """Seconds of one ranking of 200 entries of 1,000 episodes, computed anew."""
    contenders = [
        Contender(one.entry_id, number, one.score["score"], int(one.successes, 2))
        for number, one in enumerate(stored_entries(seed))
        if number * RANKED // ENTRIES != (number - 1) * RANKED // ENTRIES
    ]
    assert len(contenders) == RANKED
    began_at = time.perf_counter()
    rank(contenders, EPISODES_OF_AN_ENTRY)
    return time.perf_counter() - began_at


def signed_in(server: ServerProcess) -> PageReader:
    reader = PageReader(f"http://{server.netloc}")
    answer = reader.sign_in(TOKEN)
    assert answer.status_code == 303, answer.text
    return reader


# --- live pages ---


def measure_live(server: ServerProcess, seconds: float) -> dict[str, float]:
    """Share of a core while a run is played, without pages and with them."""
    player = Player(server, "ready_0")
    alone = share_while(server, player, seconds)
    with live_pages(signed_in(server), server, "ready_0") as received:
        watched = share_while(server, player, seconds)
    assert min(received) > 1000, "each page was sent changes"
    return {"alone": alone, "watched": watched, "cost": watched - alone}


class Player:
    """Ends EPISODES_A_SECOND episodes of a run, one in each turn."""

    def __init__(self, server: ServerProcess, run_id: str) -> None:
        self._ask = server.ask
        self._worker = f"/v1/runs/{run_id}/workers/w"
        self._turn = server.ask("PUT", self._worker, {"attach_key": "k"})

    def play(self, seconds: float) -> None:
        began_at = time.monotonic()
        for number in range(int(seconds * EPISODES_A_SECOND)):
            body = predict_body(self._turn, end=1)
            self._turn = self._ask("POST", f"{self._worker}/predict", body)
            next_at = began_at + (number + 1) / EPISODES_A_SECOND
            time.sleep(max(0.0, next_at - time.monotonic()))


def share_while(server: ServerProcess, player: Player, seconds: float) -> float:
    player.play(2.0)  # what happens once
    before, began_at = server.cpu_s(), time.monotonic()
    player.play(seconds)
    return (server.cpu_s() - before) / (time.monotonic() - began_at)


@contextlib.contextmanager
def live_pages(
    reader: PageReader, server: ServerProcess, run_id: str
) -> Iterator[list[int]]:
    """Open pages that read what they are sent; gives how many bytes each has."""
    kept = reader.client.cookies.items()
    cookies = "; ".join(f"{name}={value}" for name, value in kept)
    head = (
        f"GET /pages/runs/{run_id}/live HTTP/1.1\r\nHost: {server.netloc}\r\n"
        f"Accept: text/event-stream\r\nCookie: {cookies}\r\n\r\n"
    )
    host, _, port = server.netloc.rpartition(":")
    received = [0] * LIVE_PAGES
    with contextlib.ExitStack() as opened:
        connections = []
        for _ in range(LIVE_PAGES):
            connection = socket.create_connection((host, int(port)), 60)
            connections.append(opened.enter_context(connection))
            connection.sendall(head.encode())

        def read(number: int) -> None:
            with contextlib.suppress(OSError):
                while part := connections[number].recv(2**16):
                    received[number] += len(part)

        threads = [
            threading.Thread(target=read, args=[number], daemon=True)
            for number in range(LIVE_PAGES)
        ]
        for thread in threads:
            thread.start()
        yield received


# --- the report ---


def report(body: dict[str, Any]) -> str:
    """Its section of build/performance.md."""
    rows = [
        [
            name,
            f"{one['first_s']:.2f} ({one['first_cpu_s']:.2f})",
            f"{one['again_s']:.2f} ({one['again_cpu_s']:.2f})",
            f"< {OPEN_S:g}",
            _verdict(first=one["first_s"] < OPEN_S, again=one["again_s"] < OPEN_S),
        ]
        for name, one in sorted(body["opening"].items())  # as they are stored
    ]
    ranking = f"{RANKED} entries of {EPISODES_OF_AN_ENTRY:,} episodes, ranked anew"
    anew = body["ranking_s"]
    promise = [f"< {RANKING_S:g}", _verdict(first=anew < RANKING_S)]
    rows.append([ranking, f"{anew:.2f}", "–", *promise])
    head = ["", "the first time, s (CPU)", "again, s (CPU)", "promised, s", "kept"]
    live, machine = body["live"], body["measured_on"]
    load = " ".join(map(str, machine["load_before"]))
    cost = (
        f"{LIVE_PAGES} live pages of a run that ends {EPISODES_A_SECOND} episodes in a "
        f"second: {live['cost']:.1%} of a core (promised: less than {LIVE_SHARE:.0%}; "
        f"{_verdict(watched=live['cost'] < LIVE_SHARE)}); "
        f"the play itself takes {live['alone']:.1%}."
    )
    when = (
        f"Measured on {machine['date']}: {machine['cores']} cores, load before {load}."
    )
    return "\n".join([performance_page.table(head, rows), "", cost, "", when])


def _verdict(**is_kept: bool) -> str:
    """The names are of what was measured; one alone needs none."""
    missed = [name for name, kept in is_kept.items() if not kept]
    if not missed:
        return "kept"
    return "**missed**" if len(is_kept) == 1 else f"**missed**: {', '.join(missed)}"


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--seconds", type=float, default=30.0, help="of live pages")
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--try", action="store_true", dest="try_", help="only print")
    options = arguments.parse_args()
    machine = results.machine()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / LONG_RUN.file
        fill(path, LONG_RUN)
        manifest = asyncio.run(store_entries(path, options.seed))
        with running_server(path) as server:
            opening = measure_opening(server, manifest)
            live = measure_live(server, options.seconds)
    body = {
        "measured_on": machine,
        "opening": opening,
        "ranking_s": measure_ranking(options.seed),
        "live": live,
    }
    text = report(body)
    print(text)
    if not options.try_:
        results.update("pages", body)
        performance_page.put("pages", "Pages", text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
