"""Films of episodes, drawn from their records when a reader asks for one.

A film is drawn by `reference_sim.exports`, in a process of its own and one at a time:
the simulator plays the recorded actions again. Accounts take turns, and share the
places of films that wait as runs share theirs. Films are files of a temporary folder;
the oldest make room. Who may see one is decided by the caller.
"""

from __future__ import annotations

import asyncio
import atexit
import contextvars
import logging
import shutil
import sys
import tempfile
from collections import Counter, OrderedDict
from collections.abc import AsyncGenerator, Awaitable, Callable, Mapping, Sequence
from contextlib import aclosing
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, Final

import msgspec

from reference_record.pages.run_page import Document
from reference_record.this_machine import temporary_folder
from reference_server.http.pages.api_documents import Problem
from reference_server.process.child_environment import child_environment
from reference_server.rules.capacity import Shares, WaitingRun, share_places

log = logging.getLogger("proctor.pages")

FILMS_MAX: Final = 32
WAITING_MAX: Final = 8
DRAW_S_MAX: Final = 300.0
# The longer side of a picture, in pixels.
SIDE: Final = 480
_BUSY: Final = "Many films are waiting to be drawn. Try it again in a minute."
_GAVE_WAY: Final = "films of other accounts went first"

Key = tuple[str, str]  # run and episode
Draw = Callable[[], Awaitable[None]]


@dataclass(slots=True)
class Film:
    """state: waiting, drawing, drawn or failed. files: camera → its video.

    account: who asked for it first; all who may read the run see it.
    """

    account: str
    state: str = "waiting"
    reason: str = ""
    files: Sequence[tuple[str, Path]] = ()

    @property
    def kept(self) -> str:
        return f"The server keeps the latest {FILMS_MAX} films, until it restarts."

    @property
    def is_pending(self) -> bool:
        return self.state in ("waiting", "drawing")


@dataclass(frozen=True, slots=True)
class FilmSettings:
    """benchmarks, opened_seeds: as the server has them, for its own simulator.

    seed_secret: path of the secret with which episodes of sealed splits are drawn;
    empty as long as their films are not for who reads the pages.
    """

    benchmarks: str = ""
    opened_seeds: str = ""
    seed_secret: Callable[[], str] = str


@dataclass(slots=True)
class Films:
    """The films of one server."""

    settings: FilmSettings
    _films: OrderedDict[Key, Film] = field(default_factory=OrderedDict)
    # Account → its films that wait, and what draws each; the next account is the first.
    _queues: OrderedDict[str, list[tuple[Film, Draw]]] = field(
        default_factory=OrderedDict
    )
    _drawing: asyncio.Task[None] | None = None
    _folder: str = ""

    def find(self, key: Key) -> Film | None:
        """The film; None also where a cleaner of temporary files has removed it."""
        film = self._films.get(key)
        if film is not None and not all(path.exists() for _, path in film.files):
            del self._films[key]
            return None
        return film

    def places_of(self, account: str) -> int:
        """How many more films of the account may wait now."""
        return len(self._share(account, WAITING_MAX).admitted)

    def _share(self, account: str, films: int) -> Shares:
        """Which of as many films of the account get a place, and who gives one back."""
        pending = [film for film in self._films.values() if film.is_pending]
        waiting = {account: len(queue) for account, queue in self._queues.items()}
        return share_places(
            [WaitingRun("", 0, account, queue_until_wall=0.0)] * films,
            places=Counter(film.account for film in pending),
            unplayed=waiting,
            free=WAITING_MAX - len(pending),
            now_wall=0.0,
        )

    def start(
        self,
        key: Key,
        account: str,
        record: AsyncGenerator[bytes, None],
        index: int,
        benchmark: Document | None,
    ) -> None:
        """Draw the film unless it is drawn or waits. Raises Problem if many wait.

        If another account has more films that wait, its last one gives way.
        """
        film = self.find(key)
        if film is not None and film.state != "failed":
            return
        shares = self._share(account, 1)
        if not shares.admitted:
            raise Problem(503, "unavailable", _BUSY)
        for giver in shares.given_back:
            last, _ = self._queues[giver].pop()
            last.state, last.reason = "failed", _GAVE_WAY
        film = self._films[key] = Film(account)
        self._films.move_to_end(key)
        draw = partial(self._draw, film, record, index, benchmark)
        self._queues.setdefault(account, []).append((film, draw))
        if self._drawing is None:
            self._drawing = asyncio.create_task(
                self._draw_in_turn(), context=contextvars.Context()
            )
        self._make_room()

    async def _draw_in_turn(self) -> None:
        while self._queues:
            account, queue = next(iter(self._queues.items()))
            _, draw = queue.pop(0)
            await draw()
            self._queues.move_to_end(account)
            if not queue:
                del self._queues[account]
        self._drawing = None

    async def _draw(
        self,
        film: Film,
        record: AsyncGenerator[bytes, None],
        index: int,
        benchmark: Document | None,
    ) -> None:
        try:
            async with asyncio.timeout(DRAW_S_MAX):
                film.state = "drawing"
                folder = Path(tempfile.mkdtemp(dir=self._root()))
                with tempfile.TemporaryDirectory(dir=self._root()) as received:
                    path = Path(received) / "episode.proctor"
                    await _save(record, path)
                    said = await _export(self._job(path, folder, index, benchmark))
                film.files = [(file["camera"], Path(file["path"])) for file in said]
                film.state = "drawn"
        except TimeoutError:
            film.reason = f"it took more than {DRAW_S_MAX:g} s"
        except (Problem, FilmFailed, OSError) as error:
            film.reason = str(error)
        except Exception:
            log.exception("a film could not be drawn")
            film.reason = "the server has a defect"
        finally:
            if film.state != "drawn":
                film.state = "failed"

    def _job(
        self,
        record: Path,
        folder: Path,
        index: int,
        benchmark: Document | None,
    ) -> dict[str, Any]:
        return {
            "kind": "video",
            "record": str(record),
            "output": str(folder),
            "episodes": [index],
            "size": _size(benchmark),
            "benchmarks": self.settings.benchmarks,
            "seeds": self.settings.opened_seeds,
            "secret": self.settings.seed_secret(),
            "json": True,
        }

    def _root(self) -> str:
        """The folder of all films; a new one where a cleaner has removed it."""
        if not (self._folder and Path(self._folder).is_dir()):
            self._folder = tempfile.mkdtemp("", "proctor-films-", temporary_folder())
            atexit.register(shutil.rmtree, self._folder, ignore_errors=True)
        return self._folder

    def _make_room(self) -> None:
        while len(self._films) > FILMS_MAX:
            _, oldest = self._films.popitem(last=False)
            for _, path in oldest.files:
                path.unlink(missing_ok=True)


class FilmFailed(Exception):
    """Why there is no film, for people."""


def _size(benchmark: Document | None) -> tuple[int, int] | None:
    """The shape of the benchmark's own pictures, larger; a video has even sides."""
    sizes = (benchmark or {}).get("image_sizes")
    if not sizes:
        return None
    width, height = sizes[0]["width"], sizes[0]["height"]
    scale = max(1.0, SIDE / max(width, height))
    return int(width * scale / 2) * 2, int(height * scale / 2) * 2


async def _save(record: AsyncGenerator[bytes, None], path: Path) -> None:
    async with aclosing(record):
        with path.open("wb") as file:
            async for part in record:
                await asyncio.to_thread(file.write, part)


async def _export(job: Mapping[str, Any]) -> list[dict[str, Any]]:
    """The files that the export names. Raises FilmFailed."""
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "reference_sim.exports"),
        msgspec.json.encode(job).decode(),
        stdin=asyncio.subprocess.DEVNULL,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        env=child_environment(),
        start_new_session=True,  # a terminal's Ctrl-C is the server's to handle
    )
    try:
        output, errors = await process.communicate()
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    try:
        said = msgspec.json.decode(output, type=dict[str, Any])
    except msgspec.DecodeError as error:
        text = f"the process that draws it ended with {process.returncode}"
        log.warning("%s: %s", text, errors.decode(errors="replace")[-2000:])
        raise FilmFailed(f"{text}; the log of the server says why") from error
    if said.get("refused"):
        raise FilmFailed("the replay came to another result than the recorded episode")
    if "error" in said:
        raise FilmFailed(str(said["error"]["detail"]))
    return list(said["files"])
