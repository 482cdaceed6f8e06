"""The pages of a server: how fast large ones open, what open live ones cost.

A run of 10,000 episodes is stored and a leaderboard of 500 entries of 1,000 episodes. A
server is started on them, and their pages are fetched whole, over HTTP, each the first
time after a start and again. Then 200 pages follow a run live, beside the same play
without pages. CPU is that of the server's process.
"""

import asyncio
import contextlib
import random
import socket
import statistics
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from benchmarks import measuring
from benchmarks.growth.filled_databases import DatabaseCase, build_run, fill
from benchmarks.measured_server import TOKEN, ServerProcess, TimedRun, running_server
from reference_record.history.merkle_tree import leaf_hash
from reference_server.rules.board import entry_changes
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.board.ranking import Contender, rank
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.storage.board_store import BoardStore
from reference_server.storage.runs.run_store import Store
from tests.support.pages.page_reader import PageReader
from tests.support.sim.calibration_action import calibration_action

TITLE = "Pages"
SEED = 1
LONG_RUN = DatabaseCase("one long run", 1, 10_000)
ENTRIES, EPISODES_OF_AN_ENTRY = 500, 1000
RANKED = 200
OPENED = 5
LIVE_PAGES, EPISODES_A_SECOND = 200, 10
LIVE_S, LIVE_S_TRIED = 30.0, 2.0
OPEN_S, LIVE_SHARE, RANKING_S = 1.0, 0.05, 2.0  # what is promised


def measure(*, trying: bool) -> str:
    """Open pages, rank, and follow a run."""
    where = measuring.machine()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / LONG_RUN.file
        fill(path, LONG_RUN)
        manifest = asyncio.run(store_entries(path))
        with running_server(path) as server:
            rows = opening_rows(server, manifest)
            live = live_row(server, LIVE_S_TRIED if trying else LIVE_S)
    rows += [ranking_row(), live]
    head = ["", "the first time, s (CPU)", "again, s (CPU)", "promised", "kept"]
    return f"{measuring.table(head, rows)}\n\n{where}"


# --- what is stored ---


def stored_entries() -> Iterator[BoardEntry]:
    """Entries of one manifest, as runs of very different policies make them."""
    randomness = random.Random(SEED)
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
            successes="".join(str(int(success)) for success in successes),
            result_sha256=str(number),
        )


async def store_entries(path: Path) -> str:
    """Returns the manifest of the entries."""
    store = Store(f"sqlite:///{path}")
    await store.open()
    board = BoardStore(store, leaf_hash)
    described = {"model_name": "a policy", "is_public": True, "organisation": "a lab"}
    for entry in stored_entries():
        change = entry_changes.publish(entry, None, described)
        assert isinstance(change, Change)
        await board.change(entry.run_id, lambda _, change=change: change)  # type: ignore[misc]
    await store.close()
    return entry.manifest_sha256


# --- opening ---


def opening_rows(server: ServerProcess, manifest: str) -> list[list[str]]:
    """Seconds until the last byte of each page: the first time, and the median."""
    reader = signed_in(server)
    board = f"/pages/benchmarks/calibration/leaderboard?manifest={manifest}"
    ranking = f"/v1/benchmarks/calibration/ranking?manifest_sha256={manifest}"
    pages: dict[str, Callable[[], object]] = {
        "run of 10,000 episodes": lambda: reader.text("/pages/runs/completed_0"),
        "leaderboard of 500 entries": lambda: reader.text(board),
        "ranking of 500 entries, JSON": lambda: server.ask("GET", ranking),
    }
    return [_opening_row(server, *page) for page in pages.items()]


def _opening_row(
    server: ServerProcess, name: str, open_page: Callable[[], object]
) -> list[str]:
    """Seconds by the clock and of the server's CPU; a busy machine changes CPU less."""
    seconds, cpu = [], []
    for _ in range(1 + OPENED):
        before = server.cpu_s()
        seconds.append(measuring.seconds_of(open_page))
        cpu.append(server.cpu_s() - before)
    again_s, again_cpu_s = statistics.median(seconds[1:]), statistics.median(cpu[1:])
    return [
        name,
        f"{seconds[0]:.2f} ({cpu[0]:.2f})",
        f"{again_s:.2f} ({again_cpu_s:.2f})",
        f"< {OPEN_S:g} s",
        measuring.verdict(is_met=max(seconds[0], again_s) < OPEN_S),
    ]


def ranking_row() -> list[str]:
    """One ranking of 200 entries of 1,000 episodes, computed anew."""
    contenders = [
        Contender(entry.entry_id, number, entry.score["score"], int(entry.successes, 2))
        for number, entry in enumerate(stored_entries())
        if number * RANKED // ENTRIES != (number - 1) * RANKED // ENTRIES
    ]
    assert len(contenders) == RANKED
    taken_s = measuring.seconds_of(lambda: rank(contenders, EPISODES_OF_AN_ENTRY))
    name = f"{RANKED} entries of {EPISODES_OF_AN_ENTRY:,} episodes, ranked anew"
    kept = measuring.verdict(is_met=taken_s < RANKING_S)
    return [name, f"{taken_s:.2f}", "–", f"< {RANKING_S:g} s", kept]


def signed_in(server: ServerProcess) -> PageReader:
    reader = PageReader(f"http://{server.netloc}")
    answer = reader.sign_in(TOKEN)
    assert answer.status_code == 303, answer.text
    return reader


# --- live pages ---


def live_row(server: ServerProcess, seconds: float) -> list[str]:
    """Share of a core while a run is played, without pages and with them."""
    played = TimedRun(server, "ready_0", calibration_action())
    alone = share_while(server, played, seconds)
    with live_pages(signed_in(server), server, "ready_0") as received:
        watched = share_while(server, played, seconds)
    assert min(received) > 1000, "each page was sent changes"
    cost = watched - alone
    return [
        f"{LIVE_PAGES} live pages, {EPISODES_A_SECOND} episodes a second",
        f"{cost:.1%} of a core",
        f"{alone:.1%} without them",
        f"< {LIVE_SHARE:.0%}",
        measuring.verdict(is_met=cost < LIVE_SHARE),
    ]


def share_while(server: ServerProcess, played: TimedRun, seconds: float) -> float:
    play_slowly(played, 2.0)  # what happens once
    before, began_at = server.cpu_s(), time.monotonic()
    play_slowly(played, seconds)
    return (server.cpu_s() - before) / (time.monotonic() - began_at)


def play_slowly(played: TimedRun, seconds: float) -> None:
    """End EPISODES_A_SECOND episodes of a run, one in each turn."""
    began_at = time.monotonic()
    for number in range(int(seconds * EPISODES_A_SECOND)):
        played.play(end=1)
        next_at = began_at + (number + 1) / EPISODES_A_SECOND
        time.sleep(max(0.0, next_at - time.monotonic()))


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
