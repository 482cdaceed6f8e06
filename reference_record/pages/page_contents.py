"""Each page as HTML, from documents of the API and recordings.

A server and a report give the same documents and differ in their links, and in how many
rows a page has: a server selects rows, a report has them all and its script selects.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any, Final
from urllib.parse import urlencode

from reference_record.comparison.release import TOLERANCE
from reference_record.comparison.sequential_comparison import THRESHOLD, describe
from reference_record.pages import run_page
from reference_record.pages.comparison_page import (
    KINDS,
    Pair,
    compare_pairs,
    compare_several,
    compare_while_played,
    count_kinds,
    differences_by,
    release_of,
)
from reference_record.pages.episode_plots import fold_constants, plot_data
from reference_record.pages.page_templates import (
    Links,
    duration,
    moment,
    render_page,
)
from reference_record.pages.recorded_episode import (
    RecordedEpisode,
    first_divergence,
)
from reference_record.pages.run_page import (
    NO_FILMS,
    Document,
    PolicyTimes,
    RunFigures,
    RunFilms,
)
from reference_record.recordings.recording import Turn
from reference_record.texts.benchmark_part import part_text
from reference_record.texts.counted_text import counted
from reference_record.texts.left_reason import left_reason

_NOT_PROVEN: Final = (
    "No level proves that the actions came from the policy that is named."
)
# Who can draw an episode whose seed is sealed, and how.
SEALED: Final = (
    "The seed of this episode is the secret of the host. So only the user who runs the "
    "server can draw its film: with the command below, on the machine of the server, "
    "or here as long as no other account uses the server. Others can draw it with "
    "--seeds FILE when the host has opened the seeds."
)
# The cause that ended the session of an attempt (play.md) → in words.
_ENDS: Final = {
    "lease_ended": "its lease ended",
    "detached": "its worker detached",
    "run_stopped": "the run was stopped",
    "run_failed": "the run failed",
}
# The words of the leaderboard for the same run.
LEVELS: Final = {
    "reported": f"Level: reported by this host. {_NOT_PROVEN}",
    "signed": "Level: signed by this host, whose record of the run proctor verify "
    f"checks. {_NOT_PROVEN}",
    "sealed": "Level: re-run on sealed seeds by this host, which drew them after it "
    f"was committed to the policy; proctor verify checks that. {_NOT_PROVEN}",
}


# (attempt, what happened, why)
AttemptEvents = Sequence[tuple[int, str, str]]


@dataclass(frozen=True, slots=True)
class Window:
    """Rows of a list that one page shows.

    pages: number and address of each page. whole: all rows are here, and the script of
    the page selects some. selected: by which values a server has selected.
    """

    rows: Sequence[Any]
    total: int
    page: int = 1
    pages: Sequence[tuple[int, str]] = ()
    whole: bool = False
    selected: Mapping[str, str] = field(default_factory=dict)

    @property
    def text(self) -> str:
        return f"{len(self.rows)} of {self.total}"

    @property
    def query(self) -> str:
        """The selection, for the address of a page that walks through these rows."""
        chosen = {name: value for name, value in self.selected.items() if value}
        return f"?{urlencode(chosen)}" if chosen else ""


@dataclass(frozen=True, slots=True)
class Neighbours:
    """Pages of the episodes before and after one: address and text; empty: none."""

    before: tuple[str, str] = ("", "")
    after: tuple[str, str] = ("", "")

    @classmethod
    def of(
        cls,
        episodes: Sequence[Document | None],
        address: Callable[[Document], str],
    ) -> Neighbours:
        """episodes: as run_page.around has them."""
        before, after = (
            ("", "")
            if one is None
            else (
                address(one),
                f"{one['episode_id']}, {run_page.status_of(one).replace('_', ' ')}",
            )
            for one in episodes
        )
        return cls(before, after)


@dataclass(frozen=True, slots=True)
class ShownVideo:
    """A video of an episode. note: where it leaves the recording; empty: nowhere."""

    camera: str
    address: str
    note: str = ""


@dataclass(frozen=True, slots=True)
class PlayedView:
    """A recorded episode with the addresses of its pictures and its videos, if any.

    cameras: name → (step, address) of its pictures.
    """

    turns: Sequence[Turn]
    events: AttemptEvents
    data: Mapping[str, Any]
    cameras: Mapping[str, Sequence[tuple[int, str]]]
    videos: Sequence[ShownVideo] = ()


@dataclass(frozen=True, slots=True)
class Side:
    """One of two plays of an episode that are shown side by side.

    film: as that of episode_html.
    """

    run: Document
    episode: Document
    recorded: RecordedEpisode
    played: PlayedView
    film: Any = None


def summary_html(
    links: Links,
    run: Document,
    score: Document,
    table: run_page.TaskTable,
    *,
    pace: run_page.RunPace,
    latest: Sequence[Document],
    changed: Sequence[Document],
    left: Sequence[tuple[str, Sequence[str]]],
) -> str:
    """The part of a run's page that changes while it is played.

    changed: episodes whose rows in the list of the page are replaced. left: as
    run_page.left_episodes gives it.
    """
    return render_page(
        "parts/summary", links, run=run, score=score, table=table, pace=pace,
        latest=latest, changed=changed, left=left,
    )  # fmt: skip


def run_html(
    links: Links,
    run: Document,
    score: Document,
    figures: RunFigures,
    window: Window,
    *,
    level: str = LEVELS["reported"],
    live: str = "",
    turn_times: PolicyTimes | None = None,
    others: Sequence[Document] = (),
    several: str = "",
    described: Document | None = None,
    may_publish: bool = False,
    entry: Document | None = None,
    films: RunFilms = NO_FILMS,
    csrf: str = "",
) -> str:
    """The page of a run. live: where its changes are streamed; empty for none.

    described: the benchmark as it is without options of the run, if that is known.
    several: where all runs of its episodes are compared; empty: nowhere.
    may_publish: it may have an entry on the leaderboard. entry: the one that it has.
    films: those that this server has drawn, or can draw.
    """
    return render_page(
        "run",
        links,
        csrf=csrf,
        run=run,
        score=score,
        table=figures.table,
        pace=run_page.pace_of(run, figures.ordered, datetime.now(UTC)),
        latest=run_page.latest_results(figures.ordered) if live else (),
        left=run_page.left_episodes(figures.ordered),
        live=live,
        level=level,
        rows=window.rows,
        shown_text=window.text,
        page=window.page,
        pages=window.pages,
        is_whole=window.whole,
        query=window.query,
        filters={
            "outcome": run_page.ORDER,
            "task": [task for task, _, _ in figures.table.rows],
            "split": figures.table.splits,
        },
        selected={"outcome": "", "task": "", "split": "", **window.selected},
        episode_times=figures.episode_times,
        turn_times=turn_times,
        totals=figures.totals,
        unanswered=run_page.unanswered(figures.totals),
        players=run_page.called_policy(run) or figures.players,
        facts=_run_facts(run, described),
        commands=run_page.commands(
            run, described, has_failures=any(map(run_page.is_failure, figures.ordered))
        ),
        others=others,
        several=several,
        may_publish=may_publish,
        entry=entry,
        films=films,
    )


def _run_facts(run: Document, described: Document | None) -> dict[str, Any]:
    images = run_page.pictures_of(run, described)
    server = run.get("policy_server") or {}
    return {
        "Submitter": run["policy"].get("submitter"),
        "Number of this run": _number_of_run(run),
        "Earlier runs": _earlier_runs(run),
        "Part of the benchmark": part_text(run.get("select")),
        "Mode": run["mode"],
        "Policy server": server.get("url"),
        "Pictures": images and "{codec}, {width}×{height}".format_map(images),
        "Lease": duration(run["idle_timeout_s"]) if run["idle_timeout_s"] else None,
        "Manifest": run["manifest_sha256"],
        "Created": moment(run["created_at"]),
        "Last change": moment(run["updated_at"]),
    }


def _earlier_runs(run: Document) -> str | None:
    """Who tries often may quote the best try; a record does not say it."""
    number = run.get("runs_played_before")
    if number is None:
        return None
    played = "run" if number == 1 else "runs"
    return f"{number} {played} of this benchmark played by its account before this one"


def _number_of_run(run: Document) -> str | None:
    number = run.get("attempts_by_submitter")
    return f"{number} of this benchmark by its account" if number else None


def played_view(
    recorded: RecordedEpisode,
    addresses: Sequence[str] = (),
    videos: Sequence[ShownVideo] = (),
    *,
    benchmark: Document | None = None,
) -> PlayedView:
    """addresses: of the pictures, in their order.

    benchmark: names and units of the actions, and the control rate; None: not known.
    """
    cameras: dict[str, list[tuple[int, str]]] = {}
    for picture, address in zip(recorded.pictures, addresses, strict=False):
        cameras.setdefault(picture.camera, []).append((picture.step, address))
    known = benchmark or {}
    data = plot_data(
        recorded, known.get("action_space"), known.get("control_rate_hz")
    ) | {"pictures": cameras}
    return PlayedView(recorded.turns, recorded.events, data, cameras, videos)


def episode_html(
    links: Links,
    run: Document,
    episode: Document,
    recorded: RecordedEpisode | None,
    played: PlayedView | None,
    *,
    control_rate_hz: float | None = None,
    described: Document | None = None,
    problem: str = "",
    film: Any = None,
    neighbours: Neighbours = Neighbours(),
    query: str = "",
    csrf: str = "",
) -> str:
    """The page of an episode. problem: why there is no recording to show.

    described: the benchmark as it is without options; None: not known.
    film: its state and, where it failed, the reason; None where none can be drawn.
    query: which episodes of the run the reader walks through.
    """
    known = recorded or RecordedEpisode()
    attempts = _attempts(episode, played.events if played else ())
    return render_page(
        "episode",
        links,
        csrf=csrf,
        run=run,
        episode=episode,
        played=played,
        constants=fold_constants([played.data]) if played else [],
        times=known.times(control_rate_hz),
        instruction=known.instruction,
        stages=known.stages_reached,
        why=_reason(episode),
        goal=run_page.goal_of(described, episode["task"]),
        command=run_page.video_command(run, episode, described),
        sealed=SEALED if film is None and _is_sealed(run, episode) else "",
        facts=_episode_facts(episode, attempts),
        attempts=attempts,
        problem=problem,
        film=film,
        neighbours=neighbours,
        query=query,
    )


def _sealed_text(side: Side) -> str:
    is_sealed = side.film is None and _is_sealed(side.run, side.episode)
    return SEALED if is_sealed else ""


def _is_sealed(run: Document, episode: Document) -> bool:
    """Whether there is a record of the episode, and its seed is not shown."""
    result = episode.get("result") or {"seed": None}
    return run["state"] == "completed" and "seed" not in result


def _reason(episode: Document) -> str:
    """Why it ended so, in words."""
    result = episode.get("result")
    if not result:
        return ""
    if result["outcome"] == "abandoned":
        return (
            f"Abandoned: {counted(result['attempt'], 'attempt')} ended without a "
            "result, and the benchmark allows no more."
        )
    if result["outcome"] == "success":
        return "The goal held, by the success rule of the benchmark."
    if result.get("truncated"):
        return "The limit of steps was reached, and the goal did not hold."
    if result.get("terminated"):
        return "The simulator ended the episode, and the goal did not hold."
    return "The goal did not hold."


def _attempts(episode: Document, events: AttemptEvents) -> AttemptEvents:
    """(attempt, what happened, why) of a recording, in words.

    The end of an attempt that its worker left has the reason that the worker gave.
    """
    left, reason = episode.get("last_left"), left_reason(episode)
    shown = []
    for attempt, what, why in events:
        in_words = _ENDS.get(why, why)
        if what == "ended" and left and reason and attempt == left["attempt"]:
            in_words = f"{reason} ({in_words})"
        shown.append((attempt, what, in_words))
    return shown


def _episode_facts(episode: Document, attempts: AttemptEvents) -> dict[str, Any]:
    result = episode.get("result") or {}
    player, left = result.get("player"), episode.get("last_left")
    if left and any(left["reason"] in why for _, _, why in attempts):
        left = None  # one line is enough
    finished = result.get("finished_at")
    unanswered = run_page.unanswered(run_page.totals([episode]))
    return {
        "Task": episode["task"],
        "Split": episode["split"],
        "Seed": result.get("seed", "sealed, or not shown" if result else None),
        "Index": episode["index"],
        "Attempt": episode["attempt"],
        "Faults of the simulator": episode["faults"],
        "Fault of the policy": episode.get("policy_fault"),
        "Left by a worker": left and f"in attempt {left['attempt']}: {left['reason']}",
        "Clipped actions": result.get("clipped_actions"),
        "Return": result.get("total_reward"),
        "Policy time": f"{duration(result.get('think_s'))}{unanswered}"
        if result
        else None,
        "Played by": run_page.player_text(player) if player else None,
        "Finished": moment(finished) if finished else None,
    }


def comparison_html(
    links: Links,
    baseline: Document,
    run: Document,
    pairs: Sequence[Pair],
    window: Window,
    *,
    numbers: Mapping[str, Any] | None = None,
    csrf: str = "",
) -> str:
    """numbers: schema ComparedRun; computed from the pairs where there is none."""
    watched = compare_while_played(pairs)
    return render_page(
        "compare/comparison",
        links,
        csrf=csrf,
        baseline=baseline,
        run=run,
        numbers=numbers or compare_pairs(pairs),
        may_stop=describe(watched),
        release=release_of(pairs, watched),
        threshold=round(THRESHOLD),
        tolerance=TOLERANCE,
        splits=differences_by("split", pairs),
        tasks=differences_by("task", pairs),
        kinds=KINDS,
        counts=count_kinds(pairs),
        pairs=window.rows,
        selected=window.selected.get("kind", ""),
        query=f"&kind={kind}" if (kind := window.selected.get("kind", "")) else "",
        page=window.page,
        pages=window.pages,
        is_whole=window.whole,
        hidden={"baseline": baseline["run_id"], "run": run["run_id"]}
        if links.is_live
        else {},
    )


def several_html(
    links: Links,
    runs: Sequence[tuple[Document, Sequence[Document]]],
    *,
    csrf: str = "",
) -> str:
    """Several runs of one manifest, each with its episodes."""
    compared = compare_several(runs)
    tasks = list(dict.fromkeys(task for one in compared for task in one.tasks))
    splits = list(dict.fromkeys(split for one in compared for split in one.splits))
    return render_page(
        "compare/several", links, csrf=csrf, compared=compared, tasks=tasks,
        splits=splits,
    )  # fmt: skip


def pair_html(
    links: Links,
    sides: Sequence[Side],
    *,
    problem: str = "",
    neighbours: Neighbours = Neighbours(),
    drawing: str = "",
    csrf: str = "",
) -> str:
    """Two plays of one episode; problem: why one of them cannot be shown.

    drawing: where the films of both are ordered; empty: nowhere.
    """
    baseline, compared = sides
    return render_page(
        "compare/pair",
        links,
        csrf=csrf,
        baseline=baseline.run,
        run=compared.run,
        episode=compared.episode,
        sides=sides,
        constants=fold_constants([side.played.data for side in sides]),
        divergence=first_divergence(baseline.recorded, compared.recorded),
        instruction=compared.recorded.instruction,
        problem=problem,
        neighbours=neighbours,
        drawing=drawing,
        sealed=next((text for side in sides if (text := _sealed_text(side))), ""),
    )


def signed_level(levels: Sequence[str]) -> str:
    """The sentence that must stand beside a score that a record gives (REC-031)."""
    return (
        f"Level: {', '.join(levels)}. No level proves that the actions came from the "
        "policy that is named: only evaluating it again shows that."
    )
