"""`make false-alarms`: how often the kit calls a right server wrong.

Runs the kit again and again, each time with another seed, against every server of this
repository; every second time all processors are kept busy meanwhile. With `--load
halted` the kit and its servers are stopped together instead, again and again, as a
machine does that waits for its disk: checks that rely on the clock then fail.
Options of the kit, behind `--`, are measured for themselves: `-- --quick`. Whatever is
violated, inconclusive, a kit error, or unverified without need is a false alarm.

Prints a line for each run and adds it to var/false-alarms/runs.jsonl. Runs in it are
not repeated until the kit, the text or a server changes, so that an interrupted
measurement goes on. The output of the kit and the server in a run with a false alarm
is kept beside it. The figures go to build/false-alarms.md. Exit code 1 after a false
alarm. Knows no rule and no server but by its command.
"""

import contextlib
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from random import Random
from typing import Any

import psutil

from tools.built_pages import write_page
from tools.example_servers import GO, START_SERVER_JS, build_server_go
from tools.measurements.git_commit import read_commit

ROOT = Path(__file__).resolve().parents[2]
ALARMED = ROOT / "var" / "false-alarms"  # reports of the runs with an alarm
RESULTS = ALARMED / "runs.jsonl"
# The paths that a run depends on: results hold for the last commit that changed them.
JUDGED = (
    *("spec", "conformance", "reference_server", "reference_sim", "reference_record"),
    *("generated_clients/python", "examples/server_go", "examples/server_js"),
    "requirements",
)
FIRST_SEED = 1000
QUIET, BUSY, HALTED = "quiet", "busy", "halted"
# How long all processes of a halted run stand still, and how long they go on, mostly.
_LONGEST_HALT_S, _BETWEEN_HALTS_S = 6.0, 4.0
_ALARM_CHARACTERS = 600  # of the text of an alarm: its end says what was wrong
HEAD = """# False alarms

How often the kit called a right server wrong, or could not decide. Written by `make
false-alarms`; kit and servers as they are since commit {commit} of {date}, on
{processors} processors, another seed in each run. `whole`: the kit without options;
otherwise those that it had. `quiet`: beside whatever the machine ran; `busy`: beside a
process more per processor that computes without end; `halted`: kit and servers stopped
together, every {between_s:g} s or so, for up to {longest_s:g} s.
"""
RunKey = tuple[str, int, str]  # server, seed, load
WHOLE = "whole"  # a kit without further options
RIGHT = ("passed", "not_applicable")
# Among alarms, in the place of a rule's id: the kit could not judge at all.
REPORT = "-"


def start_commands(directory: Path) -> dict[str, str]:
    """Give the command of every server that can be started here, by name."""
    commands = {
        "reference": shlex.join([sys.executable, "-m", "reference_server"]),
        "JavaScript": START_SERVER_JS,
    }
    if GO:
        commands["Go"] = str(build_server_go(directory))
    return commands


@contextlib.contextmanager
def keep_processors_busy() -> Iterator[None]:
    """Run one process per processor that computes, at most as long as this one."""
    program = f"import os\nwhile os.getppid() == {os.getpid()}: pass"
    endless = [sys.executable, "-S", "-c", program]
    processes = [subprocess.Popen(endless) for _ in range(os.cpu_count() or 1)]
    try:
        yield
    finally:
        for process in processes:
            process.kill()
            process.wait()


def halt_until_end(process: subprocess.Popen[bytes], seed: int) -> None:
    """Stop a process and all that it has started, again and again, until it ends."""
    random = Random(seed)
    while True:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(random.expovariate(1 / _BETWEEN_HALTS_S))
            return
        with contextlib.suppress(psutil.NoSuchProcess), contextlib.ExitStack() as halts:
            started = psutil.Process(process.pid)
            for one in (started, *started.children(recursive=True)):
                halts.enter_context(halted(one))
            time.sleep(random.uniform(0, _LONGEST_HALT_S))


@contextlib.contextmanager
def halted(process: psutil.Process) -> Iterator[None]:
    """Let a process, which may have ended, stand still."""
    with contextlib.suppress(psutil.NoSuchProcess):
        process.suspend()
    try:
        yield
    finally:
        with contextlib.suppress(psutil.NoSuchProcess):
            process.resume()


def read_report(
    report: Path,
    seed: int,
    options: Sequence[str],
    tokens: Mapping[str, str] | None = None,
    *,
    is_halted: bool = False,
) -> dict[str, Any]:
    """Run the kit with these options; give its report, which is also in a folder.

    tokens: variables of its environment. is_halted: again and again.
    """
    command = [sys.executable, "-m", "conformance", "--report", str(report)]
    with subprocess.Popen(
        [*command, "--seed", str(seed), *options],
        cwd=ROOT,
        env=os.environ | dict(tokens or {}),
        stdout=subprocess.DEVNULL,
    ) as kit:
        if is_halted:
            halt_until_end(kit, seed)
    found: dict[str, Any] = json.loads((report / "report.json").read_text())
    return found


def run_kit(server: str, seed: int, load: str, options: list[str]) -> dict[str, Any]:
    """Judge a server; give the exit code, the time, and each row that is an alarm."""
    busy = keep_processors_busy if load == BUSY else contextlib.nullcontext
    with tempfile.TemporaryDirectory() as report, busy():
        judged = ["--start-cmd", server, *options]
        found = read_report(Path(report), seed, judged, is_halted=load == HALTED)
        alarms = alarms_of(found)
        if alarms:  # to find the cause
            kept = f"{Path(shlex.split(server)[-1]).name}-{seed}"
            shutil.copytree(report, ALARMED / kept, dirs_exist_ok=True)
    elapsed_s = round(found["elapsed_s"], 1)
    return {"exit_code": found["exit_code"], "elapsed_s": elapsed_s, "alarms": alarms}


def alarms_of(found: dict[str, Any]) -> dict[str, str]:
    """Give the text of each row of a report that is wrong of a right server, by id."""
    alarms = {
        row["requirement_id"]: f"{row['outcome']}: "
        + " ".join(
            f"{row['reason']} {row['expected']} {row['observed']}".split()
        ).replace(f"{ROOT}/", "")[-_ALARM_CHARACTERS:]
        for row in found["rows"]
        if row["outcome"] not in RIGHT and not row["allowed"]
    }
    if found["problem"] is not None:
        alarms[REPORT] = found["problem"]
    return alarms


def read_results() -> list[dict[str, Any]]:
    """Read what was measured on this machine: of this commit, and of earlier ones."""
    if not RESULTS.exists():
        return []
    return list(map(json.loads, RESULTS.read_text().splitlines()))


def results_of(results: list[dict[str, Any]], commit: str) -> list[dict[str, Any]]:
    """Give what was measured of a commit."""
    return [line for line in results if line["commit"] == commit]


def kit_of(line: dict[str, Any]) -> str:
    """Name the kit of a run by its options."""
    return " ".join(line["options"]) or WHOLE


def measure(
    runs: int, at_once: int, load: str | None, options: list[str], commit: str
) -> None:
    """Make the runs that are missing of a commit, so many at once."""
    made = {
        (r["server"], r["seed"], r["load"])
        for r in results_of(read_results(), commit)
        if r["options"] == options
    }
    with (
        tempfile.TemporaryDirectory() as directory,
        ThreadPoolExecutor(at_once) as executor,
    ):
        commands = start_commands(Path(directory))
        planned = planned_runs(runs, load, list(commands))
        missing = [key for key in planned if key not in made]

        def run(key: RunKey) -> None:
            server, seed, under = key
            result = run_kit(commands[server], seed, under, options)
            line = {"server": server, "seed": seed, "load": under}
            line |= {"commit": commit, "options": options, **result}
            RESULTS.parent.mkdir(parents=True, exist_ok=True)
            with RESULTS.open("a") as file:
                file.write(json.dumps(line) + "\n")
            show(line)

        list(executor.map(run, missing))


def planned_runs(
    runs: int, load: str | None, servers: Sequence[str]
) -> Iterator[RunKey]:
    """Give the runs: two of each server in turn, each with a seed of its own."""
    for number in range(runs):
        server = servers[number // 2 % len(servers)]
        yield server, FIRST_SEED + number, load or (QUIET, BUSY)[number % 2]


def show(line: dict[str, Any]) -> None:
    """Print a run, and what was wrong in it."""
    print(
        f"{line['server']:<10} seed {line['seed']} {line['load']:<6} "
        f"{line['elapsed_s']:6.1f} s  exit code {line['exit_code']}  "
        f"{len(line['alarms'])} false alarms",
        flush=True,
    )
    for id_, text in line["alarms"].items():
        print(f"    {id_}  {text}", flush=True)


def summarize(results: list[dict[str, Any]]) -> list[str]:
    """Give a row of the table for each server, kit and load."""
    lines = [
        "| server | kit | processors | runs | with an alarm | rules | longest run |",
        "|---|---|---|---|---|---|---|",
    ]
    groups: dict[tuple[str, str, str], list[dict[str, Any]]] = {}
    for result in results:
        key = result["server"], kit_of(result), result["load"]
        groups.setdefault(key, []).append(result)
    for (server, kit, load), group in sorted(groups.items()):
        alarmed = [result for result in group if result["alarms"]]
        rules = sorted({id_ for result in alarmed for id_ in result["alarms"]})
        longest_s = max(result["elapsed_s"] for result in group)
        lines.append(
            f"| {server} | {kit} | {load} | {len(group)} | {len(alarmed)} "
            f"| {' '.join(rules) or '–'} | {longest_s:.0f} s |"
        )
    return lines


def page(results: list[dict[str, Any]], commit: str, date: str) -> str:
    """Write the page about the runs of a commit."""
    alarms = [
        f"- {line['server']}, {kit_of(line)}, seed {line['seed']}, {line['load']}: "
        f"{id_}: {text}"
        for line in results
        for id_, text in line["alarms"].items()
    ]
    head = HEAD.format(
        commit=commit,
        date=date,
        processors=os.cpu_count(),
        between_s=_BETWEEN_HALTS_S,
        longest_s=_LONGEST_HALT_S,
    )
    return "\n".join([head, *summarize(results), "", *alarms]) + "\n"


def main(*, runs: int, jobs: int, load: str | None, kit: list[str]) -> int:
    """Returns 1 when any run of this commit has a false alarm."""
    commit, date = read_commit(*JUDGED)
    measure(runs, jobs, load, kit, commit)
    results = results_of(read_results(), commit)
    print("\n".join(summarize(results)))
    write_page("false-alarms.md", page(results, commit, date))
    return int(any(one["alarms"] for one in results))
