"""Films of episodes, drawn from their records when a reader asks for one.

A film is drawn by `reference_sim.exports`, in a process of its own and one at a time:
the simulator plays the recorded actions again. Films are files of a temporary folder;
the oldest make room. Who may see one is decided by the caller.
"""

from __future__ import annotations

import asyncio
import atexit
import logging
import shutil
import sys
import tempfile
from collections import OrderedDict
from collections.abc import AsyncGenerator, Callable, Mapping, Sequence
from contextlib import aclosing
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import msgspec

from reference_record.pages.run_page import Document
from reference_server.http.pages.api_documents import Problem
from reference_server.process.child_environment import child_environment

log = logging.getLogger("proctor.pages")

FILMS_MAX: Final = 32
WAITING_MAX: Final = 8
DRAW_S_MAX: Final = 300.0
# The longer side of a picture, in pixels.
SIDE: Final = 480
_BUSY: Final = "Many films are waiting to be drawn. Try it again in a minute."

Key = tuple[str, str]  # run and episode


@dataclass(slots=True)
class Film:
    """state: waiting, drawing, drawn or failed. files: camera → its video."""

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
    _tasks: set[asyncio.Task[None]] = field(default_factory=set)
    _turn: asyncio.Lock = field(default_factory=asyncio.Lock)
    _folder: str = ""

    def find(self, key: Key) -> Film | None:
        return self._films.get(key)

    @property
    def places(self) -> int:
        """How many more films may wait now."""
        return WAITING_MAX - sum(film.is_pending for film in self._films.values())

    def start(
        self,
        key: Key,
        record: AsyncGenerator[bytes, None],
        index: int,
        benchmark: Document | None,
    ) -> None:
        """Draw the film unless it is drawn or waits. Raises Problem if many wait."""
        film = self._films.get(key)
        if film is not None and film.state != "failed":
            return
        if not self.places:
            raise Problem(503, "unavailable", _BUSY)
        film = self._films[key] = Film()
        self._films.move_to_end(key)
        task = asyncio.create_task(self._draw(film, record, index, benchmark))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        self._make_room()

    async def _draw(
        self,
        film: Film,
        record: AsyncGenerator[bytes, None],
        index: int,
        benchmark: Document | None,
    ) -> None:
        try:
            async with self._turn, asyncio.timeout(DRAW_S_MAX):
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
        if not self._folder:
            self._folder = tempfile.mkdtemp(prefix="proctor-films-")
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
