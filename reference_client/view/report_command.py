"""The command report: pages about runs as files that open without a server.

A run is named by its id, and read from a server, or by the file of its record, which is
verified first. The pages are those of a server.
"""

from __future__ import annotations

import hashlib
import io
from pathlib import Path

from proctor_client import Benchmark
from pydantic import BaseModel

from reference_client.command.exit_codes import DONE
from reference_client.command.output.printer import Printer
from reference_client.command.records.named_records import is_record, read_record
from reference_client.command.records.record_commands import (
    fault_of,
    keys_of,
    names_of_host,
)
from reference_client.command.runs import control
from reference_client.command.server_connection import connect
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.record_client import fetch_recording
from reference_client.protocol.retry_policy import RetryPolicy
from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.command_line.click_commands import Options
from reference_record.command_line.replaced_file import check_writable
from reference_record.command_line.written_output import whole_or_gone, writing
from reference_record.pages.recorded_episode import (
    RecordedEpisode,
    read_recorded_episode,
)
from reference_record.pages.report_videos import ReportVideos
from reference_record.pages.run_page import Document
from reference_record.pages.static_pages import ReportedRun, StaticReport
from reference_record.texts.counted_text import counted

BROKEN = 1
# In one report: each is compared with each.
RUNS_MAX = 20


def report(args: Options, printer: Printer) -> int:
    """`proctor report RUN|FILE… -o DIR`."""
    folder = _folder(args)
    for name in args.videos or ():
        if not Path(name).is_dir():
            raise UsageError(f"{name} is no folder")
    if len(args.runs) > RUNS_MAX:
        raise UsageError(f"at most {RUNS_MAX} runs fit into a report")
    files = [name for name in args.runs if is_record(name)]
    try:
        if len(files) == len(args.runs):
            runs = [read_record(name, keys_of(args.key or [])) for name in files]
            return _write(folder, runs, args, printer)
        with connect(args, printer) as connected:
            return _write(folder, _all(args, connected), args, printer)
    except BrokenRecord as broken:
        printer.say(f"proctor: {fault_of(broken)}")
        return BROKEN


def _folder(args: Options) -> Path:
    folder = Path(args.output)
    if folder.exists() and not folder.is_dir():
        raise UsageError(f"{folder} is no folder")
    if folder.is_dir() and any(folder.iterdir()) and not args.force:
        raise UsageError(f"{folder} is not empty; --force writes into it")
    # Before records are read and verified, which may take minutes.
    places = (folder.absolute(), *folder.absolute().parents)
    with writing(folder, "-o"):
        check_writable(next(filter(Path.exists, places)) / "index.html")
    return folder


def _write(
    folder: Path, runs: list[ReportedRun], args: Options, printer: Printer
) -> int:
    run_ids = {run.run_id for run in runs}
    if len(run_ids) < len(runs):
        raise UsageError("a run is named twice")
    try:
        videos = ReportVideos.of_folders(map(Path, args.videos or ()), run_ids)
        with writing(folder, "-o"), whole_or_gone(folder):
            report = StaticReport(folder, runs, videos)
            pages = report.write()
    except UnusableRecord as unusable:
        raise UsageError(str(unusable)) from unusable
    except OSError as error:
        name = error.filename or folder
        raise UsageError(f"{name}: {error.strerror or error}") from error
    left_out = videos.left_out(run_ids)
    for line in (*left_out, *report.why_not_compared()):
        printer.say(f"proctor: {line}")
    index, what = folder / "index.html", counted(pages, "page")
    if args.videos:
        what += f", {counted(videos.placed, 'video')}"
    answer = {"index": str(index), "pages": pages, "videos": videos.placed}
    printer.answer(answer | {"left_out": left_out}, f"{index}  ({what})")
    return DONE


def _all(
    args: Options,
    connected: tuple[Connection, RetryPolicy],
) -> list[ReportedRun]:
    keys = names_of_host(*connected) | keys_of(args.key or [])
    return [
        read_record(name, keys) if is_record(name) else _of_server(name, *connected)
        for name in args.runs
    ]


def _of_server(
    run_id: str, connection: Connection, retry_policy: RetryPolicy
) -> ReportedRun:
    control.check_run_id(run_id)
    client = ControlClient(connection.control, retry_policy)
    run = client.read(run_id)
    score, episodes = client.score(run_id), client.episodes(run_id)

    def read(episode: Document) -> RecordedEpisode | None:
        try:
            data = fetch_recording(
                connection, retry_policy, run_id, episode["episode_id"]
            )
        except ProctorError as error:
            if error.code != "not_found":
                raise
            return None
        name = episode["episode_id"]
        recorded = read_recorded_episode(io.BytesIO(data), len(data), name)
        recorded.sha256 = hashlib.sha256(data).hexdigest()
        return recorded

    return ReportedRun(
        run=_document(run),
        score=_document(score),
        episodes=[_document(episode) for episode in episodes],
        benchmark=_benchmark(client, run.benchmark_id, run.benchmark_version),
        level=f"Level: reported by {connection.url}.",
        read=read,
    )


def _benchmark(
    client: ControlClient, benchmark_id: str, version: str
) -> Document | None:
    """None if the server no longer offers it, or offers another version."""
    try:
        benchmark: Benchmark = client.benchmark(benchmark_id)
    except ProctorError as error:
        if error.code != "not_found":
            raise
        return None
    return _document(benchmark) if benchmark.version == version else None


def _document(model: BaseModel) -> dict[str, object]:
    """As the server sent it: the models of the client hold texts and numbers."""
    return model.model_dump(mode="json", by_alias=True, exclude_unset=True)
