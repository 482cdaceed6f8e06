"""The same pages as files that a browser opens without a server.

Names of files are numbers: nothing that a record or a server says becomes a part of a
path. The files are written into a new or empty folder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

from reference_record.command_line.replaced_file import replace_file
from reference_record.pages import page_contents
from reference_record.pages.comparison_page import LETTERS, pair_episodes
from reference_record.pages.page_contents import (
    Neighbours,
    ShownVideo,
    Side,
    Window,
    played_view,
)
from reference_record.pages.page_templates import ASSETS, read_asset, render_page
from reference_record.pages.recorded_episode import RecordedEpisode
from reference_record.pages.report_videos import ReportVideos
from reference_record.pages.run_page import (
    Document,
    PolicyTimes,
    RunFigures,
    around,
    failures_first,
)

ROWS_MAX = 1000


@dataclass(slots=True)
class ReportedRun:
    """One run of a report.

    run, score, episodes, benchmark: documents of the API; benchmark None if it is not
    known. level: what may be said of the score. read: gives the recording of an episode
    with a result, None without one; raises BrokenRecord.
    """

    run: Document
    score: Document
    episodes: Sequence[Document]
    benchmark: Document | None
    level: str
    read: Callable[[Document], RecordedEpisode | None]
    times: PolicyTimes = field(default_factory=PolicyTimes)

    @property
    def run_id(self) -> str:
        return str(self.run["run_id"])


@dataclass(frozen=True, slots=True)
class FileLinks:
    """Links between files. root: from the page to the folder of the report.

    benchmarks: SHA-256 of a manifest → the number of the page that describes it.
    server_url: of the one server that has all runs; empty if there are several.
    """

    root: str
    runs_by_id: Mapping[str, int]
    benchmarks: Mapping[str, int]
    is_live: bool = False
    server_url: str = ""

    def index(self) -> str:
        return f"{self.root}index.html"

    def runs(self) -> str:
        return ""

    def tracks(self) -> str:
        return ""

    def record(self, run_id: str) -> str:
        return ""

    def asset(self, name: str) -> str:
        return f"{self.root}static/{name}"

    def benchmark(self, benchmark_id: str, manifest_sha256: str = "") -> str:
        number = self.benchmarks.get(manifest_sha256)
        return f"{self.root}benchmarks/{number}.html" if number else ""

    def leaderboard(self, benchmark_id: str) -> str:
        return ""

    def run(self, run_id: str) -> str:
        return f"{self.root}runs/{self.runs_by_id[run_id]}/index.html"

    def episode(self, run_id: str, episode: Mapping[str, Any]) -> str:
        number = self.runs_by_id[run_id]
        return f"{self.root}runs/{number}/episodes/{episode['index']:05d}.html"

    def _compared(self, baseline: str, run_id: str) -> str:
        first, second = self.runs_by_id[baseline], self.runs_by_id[run_id]
        return f"{self.root}comparisons/{first}-{second}"

    def comparison(self, baseline: str, run_id: str) -> str:
        return f"{self._compared(baseline, run_id)}/index.html"

    def pair(self, baseline: str, run_id: str, episode: Mapping[str, Any]) -> str:
        return f"{self._compared(baseline, run_id)}/{episode['index']:05d}.html"


# What alone differs where servers with secrets of their own offer one benchmark.
_OF_SEEDS = {"seeds_sha256", "manifest_sha256", "unavailable_reason"}


class StaticReport:
    """Writes pages of some runs into a folder. Raises OSError, BrokenRecord."""

    def __init__(
        self,
        folder: Path,
        runs: Sequence[ReportedRun],
        videos: ReportVideos | None = None,
    ) -> None:
        self._folder = folder
        self._runs = runs
        self._videos = videos or ReportVideos()
        self._runs_by_id = {one.run_id: n for n, one in enumerate(runs, start=1)}
        # Two runs of one benchmark may be of two versions of it: what describes one of
        # them says nothing of the other.
        described = [one.benchmark for one in runs if one.benchmark is not None]
        by_manifest = {one["manifest_sha256"]: one for one in described}
        self._benchmarks = list(by_manifest.values())
        # The folder may have files of an earlier report: they are never taken for ours.
        self._written: set[Path] = set()

    def write(self) -> int:
        """All pages; returns their number."""
        for name in ASSETS:
            target = self._folder / "static" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            replace_file(target, read_asset(name))
        return sum(1 for _ in self._write_pages())

    def _write_pages(self) -> Iterator[str]:
        for reported in self._runs:
            yield from self._write_episodes(reported)
            yield from self._write_run(reported)
        for baseline in self._runs:
            for compared in self._others(baseline):
                yield from self._write_comparison(baseline, compared)
        for number, group in enumerate(self._of_one_manifest(), start=1):
            text = page_contents.several_html(
                self._links("../"), [(one.run, one.episodes) for one in group]
            )
            yield self._save(f"comparisons/several-{number}.html", text)
        for number, benchmark in enumerate(self._benchmarks, start=1):
            yield self._save(
                f"benchmarks/{number}.html",
                render_page(
                    "benchmark",
                    self._links("../"),
                    benchmark=benchmark,
                    has_leaderboard=False,
                ),
            )
        yield self._save(
            "index.html",
            render_page(
                "index",
                self._links(""),
                title="Report",
                runs=[reported.run for reported in self._runs],
                scores={one.run_id: one.score for one in self._runs},
                benchmarks=self._benchmarks,
                more=self._comparisons(),
                notes=self.why_not_compared(),
            ),
        )

    def _comparisons(self) -> dict[str, str]:
        """Title → address of each page on which runs are compared."""
        links, pages = self._links(""), {}
        for number, group in enumerate(self._of_one_manifest(), start=1):
            title = f"{len(group)} runs of {group[0].run['benchmark_id']} compared"
            pages[title] = f"comparisons/several-{number}.html"
        for baseline in self._runs:
            for run in self._others(baseline):
                names = (one.run["policy"]["name"] for one in (baseline, run))
                ids = (one.run_id for one in (baseline, run))
                title = "{} and {} compared".format(*map("{} ({})".format, names, ids))
                pages[title] = links.comparison(baseline.run_id, run.run_id)
        return pages

    def why_not_compared(self) -> list[str]:
        """For each benchmark with runs of several manifests, in a sentence."""
        groups: dict[str, list[ReportedRun]] = {}
        for one in self._runs:
            groups.setdefault(one.run["benchmark_id"], []).append(one)
        return [
            f"Not all runs of {benchmark_id} are compared with each other: "
            f"{_difference(group)}."
            for benchmark_id, group in groups.items()
            if len({one.run["manifest_sha256"] for one in group}) > 1
        ]

    def _links(self, root: str) -> FileLinks:
        numbers = {
            one["manifest_sha256"]: number
            for number, one in enumerate(self._benchmarks, start=1)
        }
        # A server describes a benchmark without the options of the run.
        for one in self._runs:
            if one.benchmark is not None:
                number = numbers[one.benchmark["manifest_sha256"]]
                numbers.setdefault(one.run["manifest_sha256"], number)
        urls = {str(one.run.get("endpoint") or "") for one in self._runs}
        url = urls.pop() if len(urls) == 1 else ""
        return FileLinks(root, self._runs_by_id, numbers, server_url=url)

    def _others(self, baseline: ReportedRun) -> list[ReportedRun]:
        """The runs behind it that can be compared with it."""
        at = self._runs_by_id[baseline.run_id]
        sha256 = baseline.run["manifest_sha256"]
        return [o for o in self._runs[at:] if o.run["manifest_sha256"] == sha256]

    def _of_one_manifest(self) -> list[list[ReportedRun]]:
        """Groups of more than two runs that can be compared, as many as are shown."""
        groups: dict[str, list[ReportedRun]] = {}
        for one in self._runs:
            groups.setdefault(one.run["manifest_sha256"], []).append(one)
        return [group[: len(LETTERS)] for group in groups.values() if len(group) > 2]

    def _several(self, reported: ReportedRun) -> str:
        """From the page of a run to the one that compares it with several others."""
        for number, group in enumerate(self._of_one_manifest(), start=1):
            if reported in group:
                return f"../../comparisons/several-{number}.html"
        return ""

    def _write_run(self, reported: ReportedRun) -> Iterator[str]:
        links, number = self._links("../../"), self._runs_by_id[reported.run_id]
        figures = RunFigures.of(reported.episodes)
        rows = figures.ordered
        starts = range(0, max(1, len(rows)), ROWS_MAX)
        names = ["index.html", *(f"page-{n}.html" for n in range(2, len(starts) + 1))]
        pages = list(enumerate(names, start=1))
        compared = [
            earlier.run
            for earlier in self._runs[: number - 1]
            if reported in self._others(earlier)
        ]
        for (page, name), start in zip(pages, starts, strict=True):
            part = rows[start : start + ROWS_MAX]
            window = Window(part, len(rows), page, pages, whole=True)
            text = page_contents.run_html(
                links, reported.run, reported.score, figures, window,
                level=reported.level, turn_times=reported.times, others=compared,
                several=self._several(reported), described=reported.benchmark,
            )  # fmt: skip
            yield self._save(f"runs/{number}/{name}", text)

    def _write_episodes(self, reported: ReportedRun) -> Iterator[str]:
        links, number = self._links("../../../"), self._runs_by_id[reported.run_id]
        played = [episode for episode in reported.episodes if episode.get("result")]
        rate = reported.benchmark["control_rate_hz"] if reported.benchmark else None
        walked = failures_first(played)
        for episode in played:
            recorded = reported.read(episode)
            if recorded is not None:
                reported.times.add(recorded.times(rate))
            neighbours = Neighbours.of(
                around(walked, episode["episode_id"]),
                lambda one: f"{one['index']:05d}.html",
            )
            text = page_contents.episode_html(
                links, reported.run, episode, recorded,
                None
                if recorded is None
                else self._view(reported, episode, recorded, ""),
                control_rate_hz=rate, neighbours=neighbours,
                described=reported.benchmark,
                problem="" if recorded else "There is no recording of this episode.",
            )  # fmt: skip
            name = f"runs/{number}/episodes/{episode['index']:05d}.html"
            yield self._save(name, text)

    def _view(
        self,
        reported: ReportedRun,
        episode: Document,
        recorded: RecordedEpisode,
        base: str,
    ) -> page_contents.PlayedView:
        """base: from the page to the folder of the run's episodes."""
        folder = f"runs/{self._runs_by_id[reported.run_id]}/episodes"
        index, addresses = episode["index"], []
        for number, picture in enumerate(recorded.pictures):
            name = f"{index:05d}/{number:05d}.{picture.extension}"
            self._write_once(f"{folder}/{name}", partial(bytes, picture.data))
            addresses.append(base + name)
        videos = []
        drawn = self._videos.of_recording(recorded.sha256)
        for number, video in enumerate(drawn, start=1):
            name = f"{index:05d}-{number}.mp4"
            self._write_once(f"{folder}/{name}", video.path.read_bytes)
            videos.append(ShownVideo(video.origin.camera, base + name, video.note))
        return played_view(recorded, addresses, videos, benchmark=reported.benchmark)

    def _write_once(self, name: str, read: Callable[[], bytes]) -> None:
        """An episode has a page of its own, and stands in comparisons."""
        target = self._folder / name
        if target not in self._written:
            target.parent.mkdir(parents=True, exist_ok=True)
            replace_file(target, read())
            self._written.add(target)

    def _write_comparison(
        self, baseline: ReportedRun, compared: ReportedRun
    ) -> Iterator[str]:
        links = self._links("../../")
        pairs = pair_episodes(baseline.episodes, compared.episodes)
        folder = links.comparison(baseline.run_id, compared.run_id).removeprefix(
            "../../"
        )
        text = page_contents.comparison_html(
            links, baseline.run, compared.run, pairs,
            Window(pairs, len(pairs), whole=True),
        )  # fmt: skip
        yield self._save(folder, text)
        closed = [pair for pair in pairs if pair.kind != "open"]
        walked = [pair.run for pair in closed]
        for pair in closed:
            sides = []
            for reported, episode in ((baseline, pair.baseline), (compared, pair.run)):
                recorded = reported.read(episode)
                if recorded is None:
                    break
                base = f"../../runs/{self._runs_by_id[reported.run_id]}/episodes/"
                view = self._view(reported, episode, recorded, base)
                sides.append(Side(reported.run, episode, recorded, view))
            if len(sides) == 2:
                name = links.pair(baseline.run_id, compared.run_id, pair.run)
                neighbours = Neighbours.of(
                    around(walked, pair.run["episode_id"]),
                    lambda one: f"{one['index']:05d}.html",
                )
                text = page_contents.pair_html(links, sides, neighbours=neighbours)
                yield self._save(name.removeprefix("../../"), text)

    def _save(self, name: str, text: str) -> str:
        target = self._folder / name
        target.parent.mkdir(parents=True, exist_ok=True)
        replace_file(target, text)
        return name


def _difference(runs: Sequence[ReportedRun]) -> str:
    """Why runs of one benchmark have several manifests."""
    benchmarks = [one.benchmark or {} for one in runs]
    commitments = {one.get("seeds_sha256") for one in benchmarks}
    rest = [{k: v for k, v in one.items() if k not in _OF_SEEDS} for one in benchmarks]
    options = [one.run.get("options") for one in runs]
    if None in commitments or len(commitments) == 1:
        return "their benchmarks or their choices of episodes differ"
    if any(one != rest[0] for one in rest) or any(one != options[0] for one in options):
        return "their benchmarks or choices of episodes differ, and so do their seeds"
    splits = " and ".join(benchmarks[0]["sealed_splits"])
    return (
        f"their episodes of {splits} have other seeds, for their servers have secrets "
        "of their own; servers with the same `seed_secret` give the same episodes"
    )
