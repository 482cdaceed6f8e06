"""Registers a benchmark: reads its file, checks it in a process, defines it.

Imports neither Gymnasium nor an environment: those are imported only in the check
process and in simulator processes, which they may crash.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import IO, Any

from reference_record.command_line.installation import in_checkout, make_here
from reference_sim.definition import BenchmarkDefinition, Json, definition_of_plan
from reference_sim.external import described_benchmark
from reference_sim.gymnasium import BadBenchmark
from reference_sim.gymnasium.benchmark_file import (
    BUNDLED_BENCHMARKS,
    SEED_MAX,
    Benchmark,
    benchmark_files,
    read,
)
from reference_sim.gymnasium.own_sources import DeclaredFiles, sha256_of
from reference_sim.interface import Simulator
from reference_sim.mujoco import rendering

SILENCE_S_MAX = 120.0  # importing some simulators takes a minute
_SLOW_S = 3.0  # before the first progress message, and between messages
_REPEAT_S = 10.0  # between equal messages
_EXIT_TIMEOUT_S = 5.0
_COMMAND = "python -m reference_sim.gymnasium check"
_CHECK = "reference_sim.gymnasium.check"

Say = Callable[[str], None]


def benchmarks(reference: str, say: Say) -> Iterator[tuple[str, BenchmarkDefinition]]:
    """Every benchmark that a reference names, by id, checked.

    say: called with progress messages. Raises BadBenchmark.
    """
    is_folder = reference not in BUNDLED_BENCHMARKS and Path(reference).is_dir()
    files = map(str, benchmark_files(reference) if is_folder else ())
    for one in [*files] or [reference]:  # `read` says what an empty folder lacks
        yield from _of_one(one, say)


def _of_one(reference: str, say: Say) -> Iterator[tuple[str, BenchmarkDefinition]]:
    """The benchmarks of a TOML file, or of a reference to none."""
    own_file: Json = {}
    with suppress(OSError):  # `read` says why
        own_file = {path.name: sha256_of(path) for path in benchmark_files(reference)}
    for benchmark, folder in read(reference):
        if benchmark.simulator is not None:
            name, definition = described_benchmark.definition(benchmark, folder, say)
            yield name, _watched(definition, folder, own_file)
            continue
        report = examine(benchmark, folder, say)
        if report["faults"]:
            others = len(report["faults"]) - 1
            said = [f"and {others} more"] * bool(others)
            said += ["its traceback"] * bool(report.get("tracebacks"))
            more = f" ({', '.join(said)}: {_COMMAND} {reference})" if said else ""
            name = f"{benchmark.benchmark_id} ({reference})"
            has_make = reference in BUNDLED_BENCHMARKS and in_checkout()
            cure = (
                f"; try: {make_here()} serve BENCHMARK={reference}" if has_make else ""
            )
            raise BadBenchmark(f"{name}: {report['faults'][0]}{more}{cure}")
        for warning in report["warnings"]:
            say(f"{benchmark.benchmark_id}: {warning}")
        definition = _definition(report)
        yield benchmark.benchmark_id, _watched(definition, folder, own_file)


def _definition(report: Json) -> BenchmarkDefinition:
    """The definition that follows from a report without faults."""
    return definition_of_plan(
        "gymnasium",
        report["plan"],
        report["manifest"],
        make,
        seed_max=SEED_MAX,
        success_scored=report["plan"]["score"] == "success",
        ray_resources=report["ray_resources"],
    )


def _watched(
    definition: BenchmarkDefinition, folder: Path, own_file: Mapping[str, str]
) -> BenchmarkDefinition:
    """The definition, which notices a change of its sources and of its own file."""
    sources = definition.describe({}, 1)["simulator"]["sources"]
    present = DeclaredFiles.present(folder, {**sources, **own_file})
    return replace(definition, changed_files=present.changed)


def make(settings: Mapping[str, Any]) -> Simulator:
    """The simulator, in the process that runs it."""
    from reference_sim.gymnasium import simulator

    return simulator.make(settings)


# The check process


def examine(benchmark: Benchmark, folder: Path, say: Say) -> Json:
    """The result of BenchmarkCheck.run; a process that dies or hangs is a fault."""
    if benchmark.camera is not False:
        with suppress(rendering.RenderingUnavailable):
            rendering.find_backend()  # MuJoCo reads it while it is imported
    # The model refuses a key of another kind of benchmark only where it is stated.
    stated = benchmark.model_dump(mode="json", exclude_unset=True)
    request = {"benchmark": stated, "folder": str(folder)}
    with tempfile.TemporaryFile() as stderr:
        process = _start(stderr)
        doing = "starting"
        try:
            assert process.stdin is not None
            with suppress(BrokenPipeError), process.stdin:
                process.stdin.write(json.dumps(request).encode())
            for message in _messages(process, benchmark.benchmark_id, say):
                if "found" in message:
                    report: Json = message["found"]
                    return report
                doing = message["doing"]
            with suppress(subprocess.TimeoutExpired):
                process.wait(_EXIT_TIMEOUT_S)
        finally:
            _end(process)
        code = process.returncode
        why = _last_line(stderr) if code >= 0 else signal.Signals(-code).name
    return {"faults": [f"{doing}: its process ended: {why}"], "warnings": []}


def _start(stderr: IO[bytes]) -> subprocess.Popen[bytes]:
    root = str(Path(__file__).parents[2])
    paths = [root, *filter(None, [os.environ.get("PYTHONPATH")])]
    return subprocess.Popen(
        [sys.executable, "-P", "-m", _CHECK],
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join(paths),
            "OPENBLAS_NUM_THREADS": "1",
        },
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=stderr,
        process_group=0,  # what it starts ends with it
    )


def _messages(
    process: subprocess.Popen[bytes], benchmark_id: str, say: Say
) -> Iterator[Json]:
    """Messages until the process ends; no output for SILENCE_S_MAX is a fault."""
    assert process.stdout is not None
    lines: SimpleQueue[bytes] = SimpleQueue()
    threading.Thread(target=_listen, args=(process.stdout, lines), daemon=True).start()
    heard_at = said_at = time.monotonic()
    doing, said = "starting", ""
    while True:
        try:
            line = lines.get(timeout=_SLOW_S)
        except Empty:
            line = None
        if line == b"":
            return
        now = time.monotonic()
        if line is not None:
            message: Json = json.loads(line)
            heard_at, doing = now, message.get("doing", doing)
            yield message
        elif now - heard_at > SILENCE_S_MAX:
            text = f"{doing}: no output for {SILENCE_S_MAX:.0f} s"
            yield {"found": {"faults": [text], "warnings": []}}
        if now - said_at > (_SLOW_S if doing != said else _REPEAT_S):
            said_at, said = now, doing
            say(f"{benchmark_id}: checking, {doing}")


def _listen(output: IO[bytes], lines: SimpleQueue[bytes]) -> None:
    with output:
        for line in output:
            lines.put(line)
    lines.put(b"")


def _end(process: subprocess.Popen[bytes]) -> None:
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.wait()


def _last_line(stderr: IO[bytes]) -> str:
    stderr.seek(0)
    lines = stderr.read().decode(errors="replace").strip().splitlines()
    return lines[-1][:200] if lines else "no error output"
