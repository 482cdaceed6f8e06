"""The commands results and compare: the scores of runs, of a server or of records.

A record has what its host signed, and needs no server: it is verified, and compared as
spec/scoring.md defines it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

from proctor_client import Comparison, Episode, Run, Score

from reference_client.command.exit_codes import (
    DONE,
    NOT_COMPLETE,
    NOT_RELEASED,
)
from reference_client.command.output import answer_tables
from reference_client.command.output.episode_facts import (
    compare_while_played,
    evidence_of,
    played_by,
    players_of,
    split_means,
)
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import TextTable
from reference_client.command.records.named_records import is_record, read_record
from reference_client.command.records.record_commands import BROKEN, fault_of
from reference_client.command.runs import saving
from reference_client.command.runs.control import check_run_id, required_run_id
from reference_client.command.server_connection import open_control_client
from reference_client.command.usage_error import UsageError
from reference_client.protocol.control_client import ControlClient
from reference_record.broken import BrokenRecord
from reference_record.command_line.click_commands import Options
from reference_record.comparison.release import TOLERANCE, may_release
from reference_record.pages.comparison_page import comparison_document
from reference_record.pages.run_page import Document
from reference_record.pages.static_pages import ReportedRun

# The models of the client require members that no record has; none is shown.
_OF_SERVERS = {"retryable": None, "max_workers": 1, "idle_timeout_s": 1.0}
_OF_RUN = {**_OF_SERVERS, "endpoint": "", "queue_position": None}
_NO_IMAGES = {"codec": "raw", "width": 64, "height": 64}
_OF_PROGRESS = {"episodes_pending": 0, "episodes_in_progress": 0}
_OF_RESULT = {"terminated": False, "truncated": False, "faults": 0, "think_s": 0.0}


@dataclass(frozen=True, slots=True)
class _PlayedRun:
    """A run with its episodes. record: the one that they were read from, if any."""

    run: Run
    episodes: list[Episode]
    record: ReportedRun | None = None

    @classmethod
    def of_server(cls, client: ControlClient, run_id: str) -> _PlayedRun:
        episodes = client.episodes(run_id)
        return cls(client.read(run_id), episodes)

    @classmethod
    def of_record(cls, name: str, printer: Printer) -> _PlayedRun:
        """Raises BrokenRecord, UsageError."""
        record = read_record(name, {})
        printer.say(f"{name}: {record.level}")
        said = record.run
        parts = {
            "progress": {**_OF_PROGRESS, **said["progress"]},
            "images": said["images"] or _NO_IMAGES,
        }
        run = Run.from_dict({**said, **_OF_RUN, **parts})
        assert run is not None
        return cls(run, [_episode(one, said) for one in record.episodes], record)

    def documents(self) -> dict[str, Any]:
        """`run` and `episodes`, as the server or the record says them."""
        if self.record is not None:
            return {"run": self.record.run, "episodes": self.record.episodes}
        episodes = [episode.to_dict() for episode in self.episodes]
        return {"run": self.run.to_dict(), "episodes": episodes}


def _episode(episode: Document, run: Document) -> Episode:
    shown = dict(episode)
    if result := episode.get("result"):
        places = {name: episode[name] for name in ("episode_id", "index", "task")}
        more = {"split": episode["split"], "finished_at": run["updated_at"]}
        shown["result"] = {**_OF_RESULT, **places, **more, **result}
    made = Episode.from_dict(shown)
    assert made is not None
    return made


def results(args: Options, printer: Printer) -> int:
    """`proctor results RUN|FILE`."""
    try:
        played, score = _read_scored(args, printer)
    except BrokenRecord as broken:
        printer.say(f"proctor: {args.run}: {fault_of(broken)}")
        return BROKEN
    documents = played.documents()
    if args.save is not None:
        value = {"run": documents["run"], "score": score.to_dict(), **documents}
        printer.say(saving.save_result(value, args.save))
    episodes, run = played.episodes, played.run
    value = score.to_dict() | {"players": players_of(episodes)}
    if run.runs_played_before is not None:
        value["runs_played_before"] = run.runs_played_before
    is_of_record = played.record is not None
    tables = answer_tables.score_tables(score, episodes, run, is_record=is_of_record)
    if args.episodes:
        value["episodes"] = documents["episodes"]
        tables.append(answer_tables.episode_list(episodes, run))
    printer.answer(value, *tables)
    return DONE if score.complete else NOT_COMPLETE


def _read_scored(args: Options, printer: Printer) -> tuple[_PlayedRun, Score]:
    if args.run is not None and is_record(args.run):
        played = _PlayedRun.of_record(args.run, printer)
        assert played.record is not None
        score = Score.from_dict(dict(played.record.score))
        assert score is not None
        return played, score
    run_id = required_run_id(args)
    with open_control_client(args, printer) as client:
        score = client.score(run_id)
        return _PlayedRun.of_server(client, run_id), score


def compare(args: Options, printer: Printer) -> int:
    """`proctor compare BASELINE RUN…`, each an id or the file of a record."""
    names = [args.baseline, *args.runs]
    try:
        played, comparison = _read_compared(names, args, printer)
    except BrokenRecord as broken:
        printer.say(f"proctor: {fault_of(broken)}")
        return BROKEN
    baseline, *others = played
    by_id = {one.run.run_id: one for one in played}
    watched = [compare_while_played(baseline.episodes, one.episodes) for one in others]
    evidence = [evidence_of(baseline.episodes, one.episodes) for one in others]
    earlier = {run_id: one.run.runs_played_before for run_id, one in by_id.items()}
    players = {
        run_id: played_by(one.episodes, one.run) for run_id, one in by_id.items()
    }
    tables: list[TextTable | str] = [
        table
        for run, one, seen, shown in zip(
            comparison.runs, others, watched, evidence, strict=True
        )
        for table in answer_tables.comparison_tables(
            comparison,
            run,
            players,
            seen,
            evidence=shown,
            earlier=earlier,
            part=answer_tables.part_of(baseline.run),
            by_split=split_means(baseline.episodes, one.episodes),
        )
    ]
    if args.format != "text":
        tables = _paper(played)
    ids = [run.run_id for run in comparison.runs]
    more = {
        "players": {i: players_of(one.episodes) for i, one in by_id.items()},
        "runs_played_before": earlier,
        "select": baseline.documents()["run"].get("select"),
        "sequential": dict(zip(ids, map(asdict, watched), strict=True)),
        "evidence": dict(zip(ids, map(asdict, evidence), strict=True)),
    }
    printer.answer(comparison.to_dict() | more, *tables)
    released = all(may_release(run, comparison.tolerance) for run in comparison.runs)
    return DONE if released else NOT_RELEASED


def _read_compared(
    names: Sequence[str], args: Options, printer: Printer
) -> tuple[list[_PlayedRun], Comparison]:
    """The baseline and the runs; the server compares what it has itself."""
    ids = [name for name in names if not is_record(name)]
    for run_id in ids:
        check_run_id(run_id)
    if not ids:
        played = [_PlayedRun.of_record(name, printer) for name in names]
        return played, _compare_here(names, played, args.tolerance)
    with open_control_client(args, printer) as client:
        if ids == names:
            comparison = client.compare(args.baseline, args.runs, args.tolerance)
            return [_PlayedRun.of_server(client, name) for name in names], comparison
        played = [
            _PlayedRun.of_record(name, printer)
            if is_record(name)
            else _PlayedRun.of_server(client, name)
            for name in names
        ]
    return played, _compare_here(names, played, args.tolerance)


def _compare_here(
    names: Sequence[str], played: Sequence[_PlayedRun], tolerance: float | None
) -> Comparison:
    """Compare runs as a server does. Raises UsageError."""
    first = played[0].run
    for name, one in zip(names, played, strict=True):
        if one.run.manifest_sha256 != first.manifest_sha256:  # CMP-009
            raise UsageError(
                f"{name} cannot be compared with {names[0]}: it has another manifest, "
                "so other episodes (benchmark, its version and options, tasks, splits);"
                " `proctor results` shows the scores of each"
            )
    documents = [one.documents() for one in played]
    document = comparison_document(
        [(one["run"], one["episodes"]) for one in documents],
        TOLERANCE if tolerance is None else tolerance,
    )
    comparison = Comparison.from_dict(document)
    assert comparison is not None
    return comparison


def _paper(played: Sequence[_PlayedRun]) -> list[TextTable | str]:
    """A table for a publication, and the note that explains it."""
    runs = [one.run for one in played]
    episodes = [one.episodes for one in played]
    splits = {episode.split for episode in episodes[0]}
    note = answer_tables.paper_note(runs, splits)
    labels = [_policy_label(runs, run) for run in runs]
    return [answer_tables.paper_table(labels, episodes), note]


def _policy_label(runs: Sequence[Run], run: Run) -> str:
    """The name of its policy; with the run, if others have the same name."""
    names = [one.policy.name for one in runs]
    name = run.policy.name
    return name if names.count(name) == 1 else f"{name} ({run.run_id})"
