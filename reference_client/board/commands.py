"""The commands board, publish and withdraw.

`board BENCHMARK` prints a ranking; `board verify` checks the history of a server. Exit
codes: 0; 1 the history was rewritten, or the entries do not follow from it.
"""

from __future__ import annotations

import base64
import csv
import io
import sys
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

import msgspec
from proctor_client import BoardEntry, PublicKey, PublishEntry, RankedEntry, Ranking
from pydantic import ValidationError

from reference_client.board import history_check
from reference_client.board.board_client import BoardClient
from reference_client.board.history_check import RewrittenHistory
from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import DONE
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import Prose, TextTable, fact_table
from reference_client.command.records.record_commands import usable
from reference_client.command.runs import control
from reference_client.command.server_connection import connect, explaining_state
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_client.evaluation.parameters import fault_texts
from reference_client.printable_text import printable
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.record_client import fetch_keys
from reference_record.broken import BrokenRecord
from reference_record.command_line.click_commands import Options
from reference_record.command_line.written_output import writing
from reference_record.comparison.judge_agreement import agreement_text
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import MANIFEST
from reference_record.history.checkpoint import Checkpoint
from reference_record.history.drawn_seeds import (
    BrokenDraw,
    CheckedDraw,
    check_draw,
    seeds_drawn_of,
)
from reference_record.pages.spreadsheet_cells import as_cell
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure
from reference_record.texts.score_headline import (
    mix_of,
    notes_on,
    score_cell,
    score_headline,
)
from reference_record.verification import verify_signer

REWRITTEN = 1
VERIFY = "verify"
NO_CONTEST = (
    "Calibration judges servers and is no contest: entries here are of the conformance "
    "kit, or of a user who tries the leaderboard."
)
# Members of what an entry says of itself, beside its name → options of `publish`.
_DESCRIBED = {
    "model_type": "type",
    "organisation": "organisation",
    "homepage": "homepage",
    "code_url": "code-url",
    "notes": "notes",
}
LETTERS_SHOWN = 4  # so that a row fits in 80 columns
MANIFESTS_SHOWN = 5
TRIES = 3  # entries may be published while they are compared
CSV_COLUMNS = (
    *("rank_low", "rank_high", "letters", "model_name", "organisation", "score"),
    *("success_rate", "success_low", "success_high", "attempts", "level", "flag"),
    *("submitter", "homepage", "code_url", "published_at", "entry_id", "run_id"),
)


def publish(args: Options, printer: Printer) -> int:
    """`proctor publish`: the entry of a completed run."""
    run_id = _run_of(args)
    description = _description(args)
    with connect(args, printer) as (connection, retry_policy):
        if args.name is None:
            run = retry_policy.call(lambda: connection.control.get_run(run_id))
            description.model_name = run.policy.name
        client = BoardClient(connection, retry_policy)
        with explaining_state(args, connection, retry_policy, run_id):
            try:
                entry = client.publish(run_id, description)
            except ProctorError as error:
                raise _with_published_run(args, error, client) from error
        control_client = ControlClient(connection.control, retry_policy)
        page = control_client.page_of(f"entries/{entry.entry_id}")
    printer.answer(entry.to_dict(), _entry_facts(entry))
    if page is not None:
        printer.say(f"Page of the entry: {page}")
    command = command_text(args, "withdraw", run_id)
    printer.say(f"To take it off the leaderboard, for good:\n  {command}")
    return DONE


def _with_published_run(
    args: Options, error: ProctorError, client: BoardClient
) -> ProctorError:
    """BRD-022: the command that changes the entry which has the same result."""
    entry_id = error.problem.entry_id if error.problem else None
    if error.code != "result_published" or entry_id is None:
        return error
    entry = client.entry(entry_id)
    words = ["publish", entry.run_id]
    for option, said in _described(entry).items():
        words += [] if said is None else [f"--{option}", said]
    words += ["--name", "NAME"]
    reason = error.detail.partition(" Publish the run of")[0]
    text = f"{reason} To change its description: `{command_text(args, *words)}`."
    return ProctorError(error.code, text)


def withdraw(args: Options, printer: Printer) -> int:
    """`proctor withdraw`: for good."""
    run_id = _run_of(args)
    with connect(args, printer) as (connection, retry_policy):
        entry = BoardClient(connection, retry_policy).withdraw(run_id)
    printer.answer(entry.to_dict(), _entry_facts(entry))
    return DONE


def board(args: Options, printer: Printer) -> int:
    """`proctor board`."""
    for name in ("state", "record"):
        if getattr(args, name) and args.benchmark != VERIFY:
            raise UsageError(f"--{name} is an option of board verify only")
    with connect(args, printer) as (connection, retry_policy):
        client = BoardClient(connection, retry_policy)
        if args.benchmark == VERIFY:
            keys = fetch_keys(connection, retry_policy)
            path = Path(args.state) if args.state else None
            path = path or history_check.state_file(connection.url)
            record = Path(args.record) if args.record else None
            return _verify(client, keys, path, record, printer)
        try:
            ranking = client.ranking(args.benchmark, args.manifest)
        except ProctorError as error:
            if error.code == "not_found":  # named better, if it is the benchmark
                ControlClient(connection.control, retry_policy).benchmark(
                    args.benchmark
                )
            raise
        is_read = args.manifest is None and not (args.csv or args.json)
        others = _other_manifests(client, ranking) if is_read else []
    if args.csv:
        sys.stdout.write(csv_of(ranking))
    else:
        printer.answer(ranking.to_dict(), *ranking_tables(ranking), *others)
        if ranking.benchmark_id == "calibration":
            printer.say(NO_CONTEST)
    return DONE


def _other_manifests(client: BoardClient, ranking: Ranking) -> list[str]:
    """Lines on other manifests of the benchmark, which have rankings of their own."""
    counted = client.manifests(ranking.benchmark_id)
    counted.pop(ranking.manifest_sha256, None)
    if not counted:
        return []
    lines = ["Other manifests (other versions, options, files) have rankings, too:"]
    for manifest, many in counted.most_common(MANIFESTS_SHOWN):
        noun = "entry" if many == 1 else "entries"
        lines.append(f"  --manifest {manifest}  {many} {noun}")
    if len(counted) > MANIFESTS_SHOWN:
        lines.append(f"  and {len(counted) - MANIFESTS_SHOWN} more")
    return ["\n".join(lines)]


def _run_of(args: Options) -> str:
    run_id = args.run or args.run_id
    if run_id is None:
        raise UsageError(f"{args.command} needs the id of a completed run")
    control.check_run_id(run_id)
    return str(run_id)


def _described(entry: BoardEntry) -> dict[str, str | None]:
    return {option: getattr(entry, member) for member, option in _DESCRIBED.items()}


def _description(args: Options) -> PublishEntry:
    members: dict[str, Any] = {
        "model_name": args.name or "unnamed",
        "is_public": not args.private,
    }
    for member, option in _DESCRIBED.items():
        members[member] = getattr(args, option.replace("-", "_"))
    given = {name: value for name, value in members.items() if value is not None}
    try:
        return PublishEntry(**given)
    except ValidationError as error:
        flag = _DESCRIBED | {"model_name": "name"}
        member, _, wrong = fault_texts(error).partition(" ")
        raise UsageError(f"--{flag.get(member, member)} {wrong}") from error


def _entry_facts(entry: BoardEntry) -> TextTable:
    state = entry.state if entry.state != "published" else None
    readers = "this account alone; published again without --private, everyone"
    if entry.is_public:
        readers = "every reader of the leaderboard; with --private this account alone"
    if state is not None and entry.is_public:  # a private one has no leaves
        readers = "readers of the history"
    return fact_table(
        {
            "entry": entry.entry_id,
            "run": entry.run_id,
            "state": state,
            "model": entry.model_name,
            **_described(entry),
            "benchmark": entry.benchmark_id,
            "manifest": entry.manifest_sha256,
            "score": score_headline(entry.score.to_dict()),
            "seen by": readers,
            "runs": f"{entry.attempts} of this benchmark by the account "
            f"{entry.submitter}",
        }
    )


# --- the ranking ---


def ranking_tables(ranking: Ranking) -> list[TextTable | str]:
    """The ranking for people; ranks are intervals."""
    table = TextTable(
        (
            *("model", ">rank", "letters", ">score", ">success", "judged by"),
            *(">runs", "level", "by"),
        ),
        dispensable=("level", "by", "runs"),
        breaks_first=True,
    )
    for row in ranking.rows:
        table.add(*_cells(row))
    if all(row.entry.score.judged_by is None for row in ranking.rows):
        table = table.without("judged by")
    if not ranking.rows:
        return [f"{ranking.benchmark_id} has no public entry of this manifest."]
    return [table, _notes(ranking)]


def _cells(row: RankedEntry) -> tuple[str, ...]:
    entry, score = row.entry, row.entry.score
    rate, low, high = (
        figure(share, 2)
        for share in (
            score.success_rate,
            score.success_interval.low,
            score.success_interval.high,
        )
    )
    more = " …" if len(row.letters) > LETTERS_SHOWN else ""
    return (
        entry.model_name,
        _rank(row),
        " ".join(row.letters[:LETTERS_SHOWN]) + more,
        score_cell(score.to_dict()),
        f"{rate} [{low}, {high}]",
        f"{score.judged_by} of this host" if score.judged_by else "",
        str(entry.attempts),
        entry.level,
        entry.organisation or entry.submitter,
    )


def _rank(row: RankedEntry) -> str:
    if row.rank is None:
        return "flagged" if row.entry.flag else "–"
    low, high = row.rank.low, row.rank.high
    return str(low) if low == high else f"{low}–{high}"


_OF_A_MIX = (
    "Rows stand in the order of the score over all splits, and ranks are of all "
    "episodes; runs of one split (proctor run --split) have a ranking of their own."
)


def _notes(ranking: Ranking) -> Prose:
    of = f"{ranking.benchmark_id}, manifest {ranking.manifest_sha256[:12]}"
    episodes = ranking.episodes_total or 0  # known where there are rows
    noun = "entry" if ranking.ranked == 1 else "entries"
    lines = [f"{of}: {ranking.ranked} ranked {noun} of {counted(episodes, 'episode')}."]
    if ranking.ranked > 1:
        lines.append(
            "A rank is an interval: entries with a letter in common cannot be "
            "distinguished "
            f"(exact McNemar with Holm's correction, pairs: {ranking.comparisons}, "
            f"alpha {ranking.alpha:g})."
        )
    if ranking.differing_min is None:
        lines.append("It has too few episodes to distinguish any two entries.")
    else:
        enough = ranking.differing_enough
        lines.append(
            f"Entries that differ on fewer than {ranking.differing_min} episodes are "
            "never distinguished"
            + (f"; {enough} that all favour one are enough." if enough else ".")
        )
    for row in ranking.rows:
        if (second := row.entry.score.second_judge) is not None:
            text = agreement_text(second.model_dump())
            lines.append(f"{row.entry.model_name}: {text}")
    notes = notes_on(score_cell(row.entry.score.to_dict()) for row in ranking.rows)
    if any(mix_of(row.entry.score.to_dict()) for row in ranking.rows):
        lines.append(_OF_A_MIX)
    lines += [notes] if notes else []
    flags = [row.entry for row in ranking.rows if row.entry.flag]
    lines += [
        f"{entry.model_name}: {entry.flag.reason}" for entry in flags if entry.flag
    ]
    return Prose("\n".join(lines))


def csv_of(ranking: Ranking) -> str:
    """A row for each entry, and a line of names above them.

    Texts that a spreadsheet would execute get a quote before them.
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    groups = list(_group_rates(ranking.rows))
    columns = dict.fromkeys(name for rates in groups for name in rates)
    writer.writerow([*CSV_COLUMNS, *map(_plain, columns)])
    for row, rates in zip(ranking.rows, groups, strict=True):
        entry, interval = row.entry, row.entry.score.success_interval
        flag = entry.flag.reason if entry.flag else None
        ranks = (row.rank.low, row.rank.high) if row.rank else (None, None)
        values: list[Any] = [*ranks, " ".join(row.letters), entry.model_name]
        values += [entry.organisation, entry.score.score, entry.score.success_rate]
        values += [interval.low, interval.high, entry.attempts, entry.level, flag]
        values += [entry.submitter, entry.homepage, entry.code_url]
        values += [entry.published_at.isoformat(), entry.entry_id, entry.run_id]
        values += [rates.get(name) for name in columns]
        writer.writerow([_plain(value) for value in values])
    return text.getvalue()


def _group_rates(rows: Iterable[RankedEntry]) -> Iterator[dict[str, float | None]]:
    """For each row, name of the column → success rate, of each task and each split."""
    for row in rows:
        score = row.entry.score
        groups = (("task", score.by_task), ("split", score.by_split))
        yield {
            f"success_rate {kind} {name}": group.success_rate
            for kind, some in groups
            for name, group in (some or {}).items()
        }


def _plain(value: Any) -> Any:
    if not isinstance(value, str):
        return value
    return as_cell(printable(value))


# --- the history ---


def _verify(
    client: BoardClient,
    keys: Mapping[str, PublicKey],
    path: Path,
    record: Path | None,
    printer: Printer,
) -> int:
    """record: whose seeds were drawn, too; None for the history alone."""
    with usable(path):
        kept = history_check.load_kept(path)
    try:
        checkpoint, entries, public_key = _check(client, keys, kept)
        draw = None if record is None else _draw_of(client, keys, checkpoint, record)
    except (RewrittenHistory, BrokenDraw, BrokenRecord) as error:
        printer.say(f"proctor: do not trust this leaderboard: {error} ({path})")
        if printer.as_json:
            printer.answer({"is_whole": False, "detail": str(error)})
        return REWRITTEN
    with writing(path, "--state"):
        history_check.keep(path, checkpoint, public_key)
    before = 0 if kept is None else kept.tree_size
    is_rotated = history_check.has_another_key(kept, public_key)
    value = {
        "is_whole": True,
        "origin": checkpoint.origin,
        "tree_size": checkpoint.tree_size,
        "root_sha256": checkpoint.root.hex(),
        "entries": entries,
        "seen_before": before,
        "key_changed": is_rotated,
        **({} if draw is None else {"draw": asdict(draw)}),
    }
    facts = {
        "history": f"whole: {counted(checkpoint.tree_size, 'leaf', 'leaves')}, "
        f"signed by {checkpoint.origin}",
        "entries": f"{counted(entries, 'public one')}, each as the history has it",
        "seen before": "nothing; from now on every change shows"
        if kept is None
        else f"{counted(before, 'leaf', 'leaves')}, unchanged since",
        "key": "another one than before, which the host has retired and still publishes"
        if is_rotated
        else None,
        "root": checkpoint.root.hex(),
        "kept in": str(path),
        **({} if draw is None else _draw_facts(draw, record)),
    }
    printer.answer(value, fact_table(facts))
    return DONE


def _draw_of(
    client: BoardClient,
    keys: Mapping[str, PublicKey],
    checkpoint: Checkpoint,
    path: Path,
) -> CheckedDraw:
    """Raises BrokenDraw, BrokenRecord and UsageError."""
    with usable(path):
        bundle = open_bundle(path)
        report = verify_signer(bundle, dict.fromkeys(keys, "the host"))
        manifest = msgspec.json.decode(bundle.read(MANIFEST))
    drawn = seeds_drawn_of(manifest)
    if drawn is None:
        raise UsageError(f"{path}: its seeds were not drawn for it; see proctor verify")
    leaves = [item.leaf for item in client.leaves()]
    version = report.evaluation.policy.version
    return check_draw(leaves[: checkpoint.tree_size], drawn, version)


def _draw_facts(draw: CheckedDraw, record: Path | None) -> Mapping[str, str]:
    opened = "not opened yet: it is after the last run of the phase"
    if draw.key is not None:
        opened = "proctor replay computes the seeds again with the key that was opened:"
        opened += f" proctor replay {record} --seeds {draw.key}"
    return {
        "record": f"re-run on sealed seeds: leaf {draw.committed_at} commits the host "
        f"to its policy, leaf {draw.drawn_at} draws the seeds of {draw.draw_id}",
        "seeds": opened,
    }


def _check(
    client: BoardClient,
    keys: Mapping[str, PublicKey],
    kept: history_check.KeptCheckpoint | None,
) -> tuple[Checkpoint, int, bytes]:
    """The checkpoint, how many entries are public, and the key.

    Raises RewrittenHistory.
    """
    differing: list[str] = []
    retired = [item.public_key for item in keys.values() if item.retired_at is not None]
    for _ in range(TRIES):
        shown = [item.to_dict() for item in client.entries() if item.is_public]
        signed = client.checkpoint()
        if signed.keyid not in keys:
            raise RewrittenHistory("its key is none that the host publishes")
        public_key = base64.b64decode(keys[signed.keyid].public_key)
        checkpoint = history_check.read_signed(signed.note, public_key, kept, retired)
        if kept is not None and kept.tree_size:
            _compare(client, kept, checkpoint)
        leaves = [item.leaf for item in client.leaves()]
        history_check.check_leaves(checkpoint, leaves)
        recorded = history_check.entries_of(leaves[: checkpoint.tree_size])
        differing = history_check.differences(recorded, shown)
        if not differing:
            return checkpoint, len(shown), public_key
    raise RewrittenHistory("; ".join(differing[:3]))


def _compare(
    client: BoardClient, kept: history_check.KeptCheckpoint, checkpoint: Checkpoint
) -> None:
    try:
        proof = client.consistency(kept.tree_size, checkpoint.tree_size)
    except ProctorError as error:
        if error.code != "invalid_request":
            raise
        raise RewrittenHistory("it gives no proof that it only grew") from error
    history_check.check_consistency(kept, checkpoint, proof)
