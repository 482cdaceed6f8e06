"""Computes the content of a run's page from documents of the API.

Nothing here is scored anew: the score is what `get_score` answered. Counts of a cell of
the table are counts of episodes as `list_episodes` lists them.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, Final

from reference_record.command_line.printed_commands import server_check, server_command
from reference_record.contents.drawable import has_camera
from reference_record.contents.score import ScoredLine, compute_score, wilson_interval
from reference_record.formats.names import record_file_name
from reference_record.generated.answers import ComputedScore, Interval
from reference_record.texts.left_reason import left_reason

Document = Mapping[str, Any]
# Failures stand first, because they need attention.
ORDER: Final = ("failure", "abandoned", "in_progress", "pending", "success")
# The pace is that of so many latest episodes: older ones may have been slower.
PACE_EPISODES: Final = 50
INTERVALS_MIN: Final = 2  # between results, before anything is estimated
# A run without a result for so long, and for so many times its pace, stands still.
STILL_MIN_S: Final = 10.0
STILL_FACTOR: Final = 5.0
LATEST: Final = 10
LEFT_REASONS: Final = 3
OPTIONS_CHARS_MAX: Final = 4000


@dataclass(slots=True)
class TaskCell:
    """Episodes of one task in one split: all, those with a result, successes."""

    total: int = 0
    scored: int = 0
    successes: int = 0

    @property
    def rate(self) -> float | None:
        return self.successes / self.scored if self.scored else None

    @property
    def interval(self) -> Interval:
        return wilson_interval(self.rate, self.scored)


@dataclass(frozen=True, slots=True)
class TaskTable:
    """Rows: task, its cell of each split, and that of all."""

    splits: list[str]
    rows: list[tuple[str, list[TaskCell | None], TaskCell]]

    @property
    def by_split(self) -> dict[str, TaskCell]:
        """The cell of each split, over its tasks."""
        columns = zip(*(cells for _, cells, _ in self.rows), strict=True)
        return {
            split: sum_cells([cell for cell in column if cell is not None])
            for split, column in zip(self.splits, columns, strict=True)
        }


@dataclass(frozen=True, slots=True)
class Quantiles:
    """The quantiles of `count` values."""

    count: int
    p50: float
    p95: float
    p99: float


@dataclass(slots=True)
class PolicyTimes:
    """How long the policy took for turns, and whether a robot had to wait for it.

    think_ms: the time of each turn. late: turns whose actions came after the previous
    ones had been executed at the control rate. followed: turns that had a previous one.
    """

    think_ms: list[float] = field(default_factory=list)
    late: int = 0
    followed: int = 0

    def add(self, other: PolicyTimes) -> None:
        self.think_ms += other.think_ms
        self.late += other.late
        self.followed += other.followed

    @property
    def quantiles(self) -> Quantiles | None:
        return quantiles(self.think_ms)


@dataclass(frozen=True, slots=True)
class RunFigures:
    """Figures over all episodes of a run, whichever of them its page lists.

    ordered: the episodes, failures first. episode_times: of those with results.
    """

    ordered: Sequence[Document]
    table: TaskTable
    episode_times: Quantiles | None
    totals: Mapping[str, int]
    players: Sequence[str]

    @classmethod
    def of(cls, episodes: Sequence[Document]) -> RunFigures:
        return cls(
            failures_first(episodes),
            task_table(episodes),
            think_seconds(episodes),
            totals(episodes),
            players(episodes),
        )


def status_of(episode: Document) -> str:
    """The outcome of the episode, or its status while it has none."""
    result = episode.get("result")
    return str(result["outcome"] if result else episode["status"])


def failures_first(episodes: Iterable[Document]) -> list[Document]:
    """The episodes by status, and of one status in the order of the manifest."""
    rank = {name: place for place, name in enumerate(ORDER)}
    return sorted(
        episodes,
        key=lambda episode: (rank.get(status_of(episode), 0), episode["index"]),
    )


def around(episodes: Sequence[Document], episode_id: str) -> list[Document | None]:
    """The episodes before and after one in a list; None where there is none."""
    ids = [episode["episode_id"] for episode in episodes]
    if episode_id not in ids:
        return [None, None]
    place = ids.index(episode_id)
    return [
        episodes[at] if 0 <= at < len(episodes) else None
        for at in (place - 1, place + 1)
    ]


def task_table(episodes: Iterable[Document]) -> TaskTable:
    cells: dict[tuple[str, str], TaskCell] = {}
    for episode in episodes:
        cell = cells.setdefault((episode["task"], episode["split"]), TaskCell())
        cell.total += 1
        if result := episode.get("result"):
            cell.scored += 1
            cell.successes += result["outcome"] == "success"
    splits = list(dict.fromkeys(split for _, split in cells))
    rows = []
    for task in dict.fromkeys(task for task, _ in cells):
        row = [cells.get((task, split)) for split in splits]
        rows.append((task, row, sum_cells([cell for cell in row if cell is not None])))
    return TaskTable(splits, rows)


def sum_cells(cells: Sequence[TaskCell]) -> TaskCell:
    return TaskCell(
        sum(cell.total for cell in cells),
        sum(cell.scored for cell in cells),
        sum(cell.successes for cell in cells),
    )


def quantiles(values: Sequence[float]) -> Quantiles | None:
    """Nearest ranks; None without a value."""
    if not values:
        return None
    ordered = sorted(values)
    picked = [ordered[math.ceil(q * len(ordered)) - 1] for q in (0.5, 0.95, 0.99)]
    return Quantiles(len(ordered), *picked)


def think_seconds(episodes: Iterable[Document]) -> Quantiles | None:
    """Time that the policy took in an episode, over those with a result."""
    results = [episode["result"] for episode in episodes if episode.get("result")]
    return quantiles([r["think_s"] for r in results if "think_s" in r])


@dataclass(frozen=True, slots=True)
class RunPace:
    """The seconds left at the pace of the last results, or since when there is none.

    left_s: None while no pace is known, and while the run stands still. still_s: the
    seconds since the last result, of a run that stands still.
    """

    left_s: float | None = None
    still_s: float | None = None


def pace_of(run: Document, episodes: Iterable[Document], now: datetime) -> RunPace:
    """now: with a time zone, of the clock that wrote the results."""
    if run["state"] not in ("running", "stopping"):
        return RunPace()
    ends_s = sorted(
        (datetime.fromisoformat(episode["result"]["finished_at"]) - now).total_seconds()
        for episode in episodes
        if episode.get("result")
    )
    progress = run["progress"]
    left = progress["episodes_total"] - progress["episodes_scored"]
    at_once = progress.get("episodes_in_progress", 1)
    return estimate_pace(ends_s, 0.0, left, at_once)


def estimate_pace(
    ends_s: Sequence[float], now_s: float, left: int, at_once: int = 1
) -> RunPace:
    """The only estimate of the time left, of pages and commands.

    ends_s: when episodes got their results, ascending. left: episodes without one.
    at_once: how many are played at a time. They begin together, and may end so: the
    pace is that of whole rounds of them, and one round alone says nothing.
    """
    if not ends_s:
        return RunPace()
    still_s = now_s - ends_s[-1]
    at_once = max(1, at_once)
    intervals = min(len(ends_s) - 1, max(PACE_EPISODES, at_once))
    intervals -= intervals % at_once
    if intervals < INTERVALS_MIN:
        return RunPace(still_s=still_s if still_s > STILL_MIN_S else None)
    pace_s = (ends_s[-1] - ends_s[-1 - intervals]) / intervals
    if still_s > max(STILL_MIN_S, STILL_FACTOR * pace_s * at_once):
        return RunPace(still_s=still_s)
    return RunPace(left_s=pace_s * left)


def snapshot(
    run: Document, episodes: Sequence[Document]
) -> tuple[Document, ComputedScore]:
    """The run and its score by one list of its episodes, so that all numbers agree.

    Run, score and episodes of a run that is played are answers of three moments.
    """
    results = [episode.get("result") for episode in episodes]
    score = compute_score(
        [
            ScoredLine(
                episode["task"],
                episode["split"],
                result["outcome"] if result else None,
                result["score"] if result else None,
            )
            for episode, result in zip(episodes, results, strict=True)
        ]
    )
    scored = sum(map(bool, results))
    progress = {"episodes_total": len(episodes), "episodes_scored": scored}
    return {**run, "progress": {**run["progress"], **progress}}, score


def latest_results(episodes: Iterable[Document]) -> list[Document]:
    """The last results of a run that is played, the newest first."""
    ended = [episode for episode in episodes if episode.get("result")]
    ended.sort(key=lambda e: (e["result"]["finished_at"], e["index"]), reverse=True)
    return ended[:LATEST]


def left_episodes(episodes: Iterable[Document]) -> list[tuple[str, list[str]]]:
    """The reasons why workers left episodes without a result of their own, and these.

    Those of most episodes come first.
    """
    of_reasons: dict[str, list[str]] = {}
    for episode in episodes:
        outcome = (episode.get("result") or {}).get("outcome", "abandoned")
        if outcome == "abandoned" and (reason := left_reason(episode)):
            of_reasons.setdefault(reason, []).append(episode["episode_id"])
    return sorted(of_reasons.items(), key=lambda row: -len(row[1]))[:LEFT_REASONS]


_SIMULATOR: Final = "faults of the simulator"
_POLICY: Final = "episodes with faults of the policy"


def unanswered(of: Mapping[str, int]) -> str:
    """A note on the policy time, by the `totals` of episodes; empty if it has none."""
    return "; calls that it did not answer are left out" if of[_POLICY] else ""


def totals(episodes: Iterable[Document]) -> dict[str, int]:
    """Attempts beyond the first, faults, clipped actions; over all episodes."""
    counts = {"more attempts": 0, _SIMULATOR: 0, _POLICY: 0, "clipped actions": 0}
    for episode in episodes:
        counts[_SIMULATOR] += episode["faults"]
        counts[_POLICY] += bool(episode.get("policy_fault"))
        counts["more attempts"] += episode["attempt"] - 1
        result = episode.get("result") or {}
        counts["clipped actions"] += result.get("clipped_actions") or 0
    return counts


def called_policy(run: Document) -> list[str]:
    """The policy of a push run, which has no client that could declare a player."""
    is_called = run.get("policy_server")
    return [f"{run['policy']['name']}, called by the server"] if is_called else []


def players(episodes: Iterable[Document]) -> list[str]:
    """The players of the episodes, as their clients declared them."""
    names: dict[str, None] = {}
    for episode in episodes:
        player = (episode.get("result") or {}).get("player")
        if player:
            names[player_text(player)] = None
    return list(names)


def player_text(player: Document) -> str:
    """Name, version and client, as far as they are known."""
    named = f"{player['name']} {player.get('version') or ''}".strip()
    client = player.get("client")
    return f"{named}, played with {client}" if client else named


def may_be_drawn(run: Document, described: Document | None) -> bool:
    """Whether a run has a record, its benchmark a camera, and no robot played it."""
    is_simulated = run["state"] == "completed" and not run.get("judged")
    return is_simulated and has_camera(str(run["benchmark_id"]), described)


def command_text(run: Document, *words: str) -> str:
    """A command to copy, which reaches the server of the run."""
    return server_command(_server_of(run), *words)


def _server_of(run: Document) -> str:
    """Its URL; empty where it is not known."""
    return str(run.get("endpoint") or "")


def video_command(
    run: Document, episode: Document, described: Document | None = None
) -> str:
    """The command that draws an episode; empty where it cannot be drawn."""
    if not may_be_drawn(run, described):
        return ""
    words = ("video", run["run_id"], "--episode", str(episode["index"]))
    return command_text(run, *words)


@dataclass(frozen=True, slots=True)
class RunFilms:
    """The films of a run: those that are drawn, and those that can be.

    states: by episode id, `none`, `waiting`, `drawing`, `drawn` or `failed`. failures:
    the ids of failures whose films can be drawn. places: how many more may wait now.
    sealed: how many other failures there are, whose seeds are the secret of the host.
    """

    states: Mapping[str, str] = field(default_factory=dict)
    failures: Sequence[str] = ()
    places: int = 0
    sealed: int = 0

    @classmethod
    def of(
        cls, states: Mapping[str, str], episodes: Iterable[Document], places: int
    ) -> RunFilms:
        ids = [one["episode_id"] for one in episodes if is_failure(one)]
        failures = [name for name in ids if name in states]
        return cls(states, failures, places, len(ids) - len(failures))

    @property
    def undrawn(self) -> list[str]:
        """The failures for which no film is drawn or waits."""
        return [n for n in self.failures if self.states[n] in ("none", "failed")]

    @property
    def missing(self) -> int:
        return len(self.undrawn)

    @property
    def drawable(self) -> int:
        return min(self.missing, self.places)

    @property
    def pending(self) -> int:
        """How many films of failures wait, or are being drawn."""
        states = [self.states[name] for name in self.failures]
        return states.count("waiting") + states.count("drawing")

    @property
    def said(self) -> str:
        """`5 drawn, 3 waiting, 8 not drawn`, without what is zero."""
        states = [self.states[name] for name in self.failures]
        counts = (states.count("drawn"), self.pending, self.missing)
        words = ("drawn", "waiting", "not drawn")
        said = zip(counts, words, strict=True)
        return ", ".join(f"{count} {word}" for count, word in said if count)

    def mark_of(self, episode: Document) -> str:
        """The words beside an episode in a list; empty without a film."""
        return _FILM_MARKS.get(self.states.get(episode["episode_id"], ""), "")


_FILM_MARKS: Final = {
    "drawn": "film",
    "waiting": "film waits",
    "drawing": "film is being drawn",
    "failed": "film failed",
}
NO_FILMS: Final = RunFilms()


def is_failure(episode: Document) -> bool:
    return status_of(episode) in ("failure", "abandoned")


def commands(
    run: Document, described: Document | None, *, has_failures: bool = False
) -> list[tuple[str, str]]:
    """Title and command: to repeat or continue the run, and to check a whole score.

    With failures also one that draws them all.

    described: the benchmark as it is without options; None: not known. The member
    `options` of the run is absent if its options are not known.
    """
    run_id = str(run["run_id"])
    title = "Evaluate a policy in the same way"
    if not run.get("options") and is_of_another_manifest(run, described):
        reason = "The benchmark has changed since this run"
        if "options" not in run:
            reason += ", or this run had options (--options), which are not known here"
        title += f". {reason}: the command names another manifest"
    lines = [(title, command_text(run, *_same_run(run, described)))]
    if run.get("state") in ("ready", "stopped") and not run.get("policy_server"):
        words = ("run", "--run-id", run_id, "--policy", "POLICY")
        lines.insert(0, ("Play what has no score yet", command_text(run, *words)))
    if run.get("retryable"):
        go_on = "Go on with what has no score yet"
        lines.insert(0, (go_on, command_text(run, "resume", run_id)))
    progress = run["progress"]
    if progress["episodes_scored"] == progress["episodes_total"]:
        file = record_file_name(run_id)
        export = command_text(run, "export", run_id)
        check = server_check(_server_of(run), file)
        lines.append(("Check the score", f"{export} && {check}"))
    if has_failures and may_be_drawn(run, described):
        draw = command_text(run, "video", run_id, "--failures")
        lines.append(("Draw a film of each episode that failed", draw))
    return lines


def is_of_another_manifest(run: Document, described: Document | None) -> bool:
    """Whether the run has options, or its benchmark was another one."""
    if run.get("select") or described is None:
        return False
    return bool(described.get("manifest_sha256") != run["manifest_sha256"])


def _same_run(run: Document, described: Document | None) -> Iterator[str]:
    """The command and its options for another run like this one."""
    policy, select = run["policy"], run.get("select") or {}
    server = run.get("policy_server")
    yield from (
        ("submit", "--push", server["url"]) if server else ("run", "--policy", "POLICY")
    )
    protocol = "openai_chat" if server and server.get("model") else "proctor"
    if server and server.get("protocol", protocol) != protocol:
        yield from ("--protocol", server["protocol"])
    if server and server.get("model"):
        yield from ("--model", server["model"])
    if server and server.get("generation"):
        yield from ("--generation", json.dumps(server["generation"]))
    yield from ("--benchmark", run["benchmark_id"], "--name", str(policy["name"]))
    if policy.get("version"):
        yield from ("--policy-version", str(policy["version"]))
    for member, option in (("tasks", "--tasks"), ("splits", "--split")):
        if select.get(member):
            yield from (option, ",".join(select[member]))
    if run.get("options"):
        text = json.dumps(run["options"])
        yield from ("--options", text if len(text) <= OPTIONS_CHARS_MAX else "JSON")
    images = pictures_of(run, described)
    if images and images != _default_images(described):
        yield from ("--images", "{codec}:{width}x{height}".format_map(images))
    if run.get("any_policy"):
        yield "--any-policy"


def goal_of(described: Document | None, task: str) -> str:
    """When the goal of a task holds, in words; empty where the benchmark is silent."""
    return str(((described or {}).get("task_goals") or {}).get(task, ""))


def pictures_of(run: Document, described: Document | None) -> Document | None:
    """The format of its pictures; None where its benchmark has no camera."""
    space = (described or {}).get("observation_space")
    if space is not None and not space.get("images"):
        return None
    images: Document | None = run.get("images")
    return images


def _default_images(described: Document | None) -> Document | None:
    """The pictures of a run that chose none."""
    if not described or not described.get("image_sizes"):
        return None
    return {"codec": described["image_codecs"][0], **described["image_sizes"][0]}
