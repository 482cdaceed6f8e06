"""`python -m reference_sim.exports JOB`: makes one export of one record.

JOB is the JSON of `job.Job`, as `proctor export --to` and `proctor video` write it.
Exit codes: 0 done; 1 the record is broken, or a replay left it; 2 it cannot be done
here, 128 + N ended by signal N, 141 its output was closed: what it made is removed.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

import msgspec

from reference_record.broken import BrokenRecord, UnusableRecord
from reference_record.command_line.click_commands import WrongUsage
from reference_record.command_line.closed_output import (
    READ_NO_MORE,
    code_of_interruption,
    discard_standard_output,
    interrupted_by_signals,
    run_program,
)
from reference_record.command_line.written_output import whole_or_gone, writing
from reference_sim.exports.job import Job, printable
from reference_sim.exports.source import Source, new_folder, open_source

DONE, BROKEN, IMPOSSIBLE = 0, 1, 2
Export = Mapping[str, Any]


def main(arguments: list[str] | None = None) -> int:
    (text,) = sys.argv[1:] if arguments is None else arguments
    try:
        with interrupted_by_signals():
            return _export(msgspec.json.decode(text, type=Job))
    except KeyboardInterrupt as interruption:
        return code_of_interruption(interruption)
    except BrokenPipeError:  # `proctor export --to parquet RUN | head -0`
        discard_standard_output()
        return READ_NO_MORE


def _export(job: Job) -> int:
    try:
        source = open_source(Path(job.record))
        with whole_or_gone(_folder(job)):
            with writing(_folder(job), "-o"):
                said = EXPORTS[job.kind](source, job)
            _print(said, job)
    except BrokenRecord as broken:
        text = f"{job.record}: do not trust it: {broken}"
        return _refuse(job, BROKEN, "broken_record", text)
    except (UnusableRecord, WrongUsage) as refusal:
        return _refuse(job, IMPOSSIBLE, "usage", str(refusal))
    except BrokenPipeError:
        raise
    except OSError as error:
        text = ": ".join(filter(None, (error.filename, error.strerror or str(error))))
        return _refuse(job, IMPOSSIBLE, "usage", text)
    return BROKEN if said.get("refused") else DONE


def _parquet(source: Source, job: Job) -> Export:
    from reference_sim.exports.parquet_tables import write_tables

    with new_folder(_folder(job)) as folder:
        return {"files": _files(job, folder, write_tables(source, folder))}


def _every_eval_ever(source: Source, job: Job) -> Export:
    from reference_sim.exports.every_eval_ever import write_evaluation

    with new_folder(_folder(job)) as folder:
        return {"files": _files(job, folder, write_evaluation(source, folder))}


def _lerobot(source: Source, job: Job) -> Export:
    from reference_sim.exports.lerobot_dataset import write_dataset

    with new_folder(_folder(job)) as folder:
        said = write_dataset(source, folder, job)
        size = sum(file["bytes"] for file in _files(job, folder, folder.rglob("*.*")))
    return {"files": [{"path": str(_folder(job)), "bytes": size}], **said}


def _video(source: Source, job: Job) -> Export:
    from reference_sim.exports.episode_videos import write_videos

    return write_videos(source, job)


EXPORTS: Mapping[str, Callable[[Source, Job], Export]] = {
    "parquet": _parquet,
    "every-eval-ever": _every_eval_ever,
    "lerobot": _lerobot,
    "video": _video,
}


def _folder(job: Job) -> Path:
    name = "videos" if job.kind == "video" else job.kind
    return Path(job.output or f"{job.stem}-{name}")


def _files(job: Job, folder: Path, paths: Iterable[Path]) -> list[dict[str, Any]]:
    """Size of each file, under the path that it has once the folder is renamed."""
    return [
        {
            "path": str(_folder(job) / path.relative_to(folder)),
            "bytes": path.stat().st_size,
        }
        for path in paths
    ]


def _print(said: Export, job: Job) -> None:
    if job.json:
        sys.stdout.write(json.dumps(said, indent=2) + "\n")
    else:
        for file in said["files"]:
            sys.stdout.write(f"{printable(file['path'])}  {file['bytes']:,} bytes\n")
    sys.stdout.flush()  # here a closed pipe is noticed


def _refuse(job: Job, exit_code: int, code: str, text: str) -> int:
    sys.stderr.write(f"proctor: {printable(text)}\n")
    if job.json:
        sys.stdout.write(json.dumps({"error": {"code": code, "detail": text}}) + "\n")
    return exit_code


if __name__ == "__main__":
    sys.exit(run_program(main))
