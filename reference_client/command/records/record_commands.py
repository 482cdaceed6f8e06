"""The commands export, verify and video: fetch a record, check it, convert it.

`verify` reads a file alone; it asks a server only for the keys of its host. A
record is converted by reference_sim.exports, a program of its own.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import msgspec

from reference_client.command import programs
from reference_client.command.exit_codes import DONE
from reference_client.command.output.printer import Printer
from reference_client.command.output.text_tables import TextTable, fact_table
from reference_client.command.runs.control import check_run_id
from reference_client.command.server_connection import connect, explaining_state
from reference_client.command.usage_error import UsageError
from reference_client.protocol.connection import Connection
from reference_client.protocol.record_client import fetch_keys, fetch_record
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.broken import BrokenRecord
from reference_record.command_line.click_commands import Options
from reference_record.command_line.written_output import writing
from reference_record.contents.replay_verdict import ReplayVerdict
from reference_record.formats.bundle import open_bundle
from reference_record.formats.names import STATEMENT, record_file_name
from reference_record.keys import own_keyid
from reference_record.texts.benchmark_part import part_text
from reference_record.texts.counted_text import counted
from reference_record.texts.figures import figure
from reference_record.texts.score_headline import score_headline
from reference_record.unsigned_record import save_blocks
from reference_record.verification import Report, read_statement, verify_signer

BROKEN = 1
SUFFIX = ".proctor"
SIMULATION_OPTIONS = (
    *("episode", "failures", "camera", "size", "benchmarks", "seeds", "anyway"),
)
_KEY = re.compile(r"(?:(?P<name>[^=]{1,64})=)?(?P<keyid>SHA256:[0-9a-f]{64})")
NOT_SHOWN = (
    "whether the actions came from this policy: only evaluating it again shows that"
)


def export(args: Options, printer: Printer) -> int:
    """`proctor export`: the record itself, or with --to what is made of it."""
    if args.to is not None:
        if args.to != "lerobot":
            _refuse_simulation_options(args)
        if args.force:
            raise UsageError("--to writes a new directory: --force replaces nothing")
        return _convert(f"export --to {args.to}", args.to, args, printer)
    _refuse_simulation_options(args)
    run_id = args.run or args.run_id
    if run_id is None:
        raise UsageError("export needs the id of a run: proctor export RUN")
    path = Path(args.output or record_file_name(run_id))
    if path.exists() and not args.force:
        if _run_of(path) != run_id:
            raise UsageError(f"{path} exists; --force replaces it")
        printer.say(f"proctor: {path} is saved already; --force fetches it again")
        with connect(args, printer) as connected:
            return _verify(path, names_of_host(*connected), printer)
    keys = _fetch(run_id, path, args, printer)
    return _verify(path, keys, printer)


def video(args: Options, printer: Printer) -> int:
    """`proctor video`."""
    if args.episode is None and not args.failures:
        raise UsageError("video needs --episode N, or --failures")
    return _convert("video", "video", args, printer)


def _convert(command: str, kind: str, args: Options, printer: Printer) -> int:
    """Becomes the program that makes the export."""
    programs.require(command)
    job = {
        "kind": kind,
        "record": str(_record_of(args, printer)),
        "output": args.output,
        "episodes": args.episode,
        "failures": args.failures,
        "cameras": args.camera,
        "size": args.size,
        "anyway": args.anyway,
        "force": args.force,
        "benchmarks": args.benchmarks,
        "seeds": args.seeds,
        "json": args.json,
    }
    return programs.start(command, [msgspec.json.encode(job).decode()])


def _record_of(args: Options, printer: Printer) -> Path:
    """The record that is named by its file or its run; fetched if it is not here."""
    source = args.run or args.run_id
    if source is None:
        raise UsageError("name a run, or the file of its record")
    if Path(source).exists():
        return Path(source)
    if source.endswith(SUFFIX) or "/" in source:
        raise UsageError(f"{source}: no such file")
    path = Path(record_file_name(source))
    if args.output and not path.exists():  # this folder may be read-only
        path = Path(args.output).parent / path
        with writing(path.parent, "-o"):
            path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists():
        _fetch(source, path, args, printer)
        printer.say(f"proctor: saved the record as {path}")
    elif (run_id := _run_of(path)) not in (None, source):
        raise UsageError(
            f"{path} is the record of the run {run_id}, not of {source}: give it "
            "another name, or name the file instead of the run"
        )
    return path


def _run_of(path: Path) -> str | None:
    """The id of the run that a record is of; None if the file cannot be read as one."""
    with usable(path), suppress(BrokenRecord):
        statement, _ = read_statement(open_bundle(path).read(STATEMENT))
        return statement.predicate.run.run_id
    return None


def _fetch(
    run_id: str, path: Path, args: Options, printer: Printer
) -> Mapping[str, str]:
    """Save the record of a run; returns the keys of its host, keyid → name."""
    check_run_id(run_id)
    with connect(args, printer) as (connection, retry_policy):
        explaining = explaining_state(args, connection, retry_policy, run_id)
        with writing(path, "-o"), explaining:
            save_blocks(path, fetch_record(connection, retry_policy, run_id))
        if (sent := _run_of(path)) not in (None, run_id):
            raise UsageError(
                f"the server sent the record of the run {sent} instead of {run_id}: "
                f"it is in {path}"
            )
        return names_of_host(connection, retry_policy)


def _refuse_simulation_options(args: Options) -> None:
    given = [name for name in SIMULATION_OPTIONS if getattr(args, name)]
    if given:
        raise UsageError(f"--{given[0]} is an option of video and --to lerobot only")


def check(args: Options, printer: Printer) -> int:
    """`proctor verify`."""
    keys = keys_of(args.key or [])
    if args.server is not None:
        with connect(args, printer, anonymous_at=args.server) as connected:
            keys = {**names_of_host(*connected), **keys}
    return _verify(Path(args.file), keys, printer)


def _verify(path: Path, keys: Mapping[str, str], printer: Printer) -> int:
    try:
        with usable(path):
            report = verify_signer(open_bundle(path), keys)
    except BrokenRecord as broken:
        return _print_broken(path, broken, printer)
    printer.answer(_as_json(report), _facts(path, report))
    return DONE


def _print_broken(path: Path, broken: BrokenRecord, printer: Printer) -> int:
    printer.say(f"proctor: {path}: {fault_of(broken)}")
    if printer.as_json:
        printer.answer(
            {
                "levels": [],
                "file": broken.file,
                "rule": broken.rule,
                "detail": broken.detail,
                **({"way_out": broken.way_out} if broken.way_out else {}),
            }
        )
    return BROKEN


def fault_of(broken: BrokenRecord) -> str:
    """The sentence on a fault: the content cannot be trusted, or only the container."""
    if broken.way_out:
        return (
            "this is not how a host packs a record, and its content was not judged: "
            f"{broken}. {broken.way_out}"
        )
    return f"do not trust it: {broken}"


def _facts(path: Path, report: Report) -> TextTable:
    said = report.evaluation
    counts = said.score["counts"]
    scored = counts["total"] - counts["unscored"]
    interval = said.score["success_interval"]
    version = f", version {said.policy.version}" if said.policy.version else ""
    return fact_table(
        {
            "file": str(path),
            "level": _level_text(report),
            "score": score_headline(said.score),
            "success": f"{counts['success']} of {scored} scored, 95 % Wilson interval "
            f"{figure(interval['low'], 4)} to {figure(interval['high'], 4)}",
            "policy": f"{said.policy.name}{version}",
            "benchmark": f"{said.benchmark.benchmark_id}, "
            f"version {said.benchmark.version}",
            "part": part_text(said.score.get("select")),
            "manifest": said.manifest_sha256,
            "run": said.run.run_id,
            "runs": f"{said.attempts_by_submitter} of this benchmark by its account, "
            "this one included, when the record was signed",
            "finished": said.finished_at,
            "checked": f"signature, {counted(report.episodes, 'episode')}, "
            f"{counted(report.recordings, 'recording')} with "
            f"{counted(report.turns, 'turn')}, the score",
            "sealed": _sealed_text(report),
            "promise": _PROMISES.get(said.promise),
            "replays": "; ".join(map(_verdict_text, report.replayed_by)) or "none",
            "not shown": NOT_SHOWN,
        }
    )


_PROMISES = {"none": "no replay, because its simulator is not deterministic"}


def _sealed_text(report: Report) -> str | None:
    if not report.sealed:
        return None
    whole = counted(report.episodes, "episode")
    return (
        f"{report.sealed} of {whole}: their seeds are the secret of the host; with the "
        "file in which it opens them, see proctor replay --seeds"
    )


def _level_text(report: Report) -> str:
    """REC-031: the level, and what it rests on."""
    if report.signer is None:
        return (
            f"reported: the owner of the key {report.keyid} is not known here; "
            "--server URL and --key name owners"
        )
    return f"{', '.join(report.levels)}; key {report.keyid}"


def _verdict_text(named: tuple[str | None, ReplayVerdict]) -> str:
    who, verdict = named
    replay = verdict.replay
    if who is None:
        is_own = verdict.keyid == own_keyid()
        who = "you" if is_own else f"unknown key {verdict.keyid}"
    text = f"{who}: {replay.result}, "
    text += f"{counted(replay.episodes, 'episode')}, {verdict.created_at}"
    if where := replay.first_divergence:
        text += (
            f"; diverged at episode {where.episode_index}, attempt {where.attempt}, "
            f"step {where.step}"
        )
    return text


def _as_json(report: Report) -> dict[str, Any]:
    return {
        "levels": report.levels,
        "keyid": report.keyid,
        "statement_sha256": report.statement_sha256,
        "episodes": report.episodes,
        "recordings": report.recordings,
        "turns": report.turns,
        "sealed_episodes": report.sealed,
        "replays": [
            {"by": who, "keyid": verdict.keyid, **msgspec.to_builtins(verdict.replay)}
            for who, verdict in report.replayed_by
        ],
        "statement": msgspec.to_builtins(report.evaluation),
    }


def keys_of(texts: list[str]) -> dict[str, str]:
    """keyid → name, of the keys given as --key."""
    keys = {}
    for text in texts:
        match = _KEY.fullmatch(text)
        if match is None:
            raise UsageError(
                f"--key {text}: expected SHA256:… with 64 hexadecimal digits, "
                "or NAME=SHA256:…"
            )
        keys[match["keyid"]] = match["name"] or f"the owner of {match['keyid'][:15]}…"
    return keys


def names_of_host(connection: Connection, retry_policy: RetryPolicy) -> dict[str, str]:
    """keyid → the URL of the host, by the keys that it publishes."""
    return dict.fromkeys(fetch_keys(connection, retry_policy), connection.url)


@contextmanager
def usable(path: Path) -> Iterator[None]:
    """Raises UsageError, with the name of the file, for an OSError."""
    try:
        yield
    except OSError as error:
        raise UsageError(f"{path}: {error.strerror or error}") from error
