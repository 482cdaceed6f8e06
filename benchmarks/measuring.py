"""Helpers of every measurement: clocks of processes, medians, tables, and the page.

build/performance.md has a section for each part of the benchmarks. A part replaces its
own section. docs/host/performance.md says what is measured and how.
"""

import contextlib
import importlib.metadata
import os
import platform
import re
import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TypeVar

from tools.built_pages import BUILD

T = TypeVar("T")

ROOT = Path(__file__).resolve().parents[1]
FILE = BUILD / "performance.md"
HEAD = """# Performance, measured here

[What is measured, and how](../docs/host/performance.md).
"""
_CLOCK_OF_PROCESS = 2  # CPUCLOCK_SCHED, see clock_getcpuclockid(3)
BUSY = 0.25  # load of each core above which absolute figures are unreliable


def say(text: str) -> None:
    """Print a line at once."""
    print(text, flush=True)


# --- clocks ---


def cpu_s(pid: int) -> float:
    """Seconds that a process has computed; 0 if it has gone. Linux only."""
    try:
        return time.clock_gettime((~pid << 3) | _CLOCK_OF_PROCESS)
    except OSError:
        return 0.0


def process_tree(pid: int) -> list[int]:
    """Give a process and its descendants."""
    tree = [pid]
    for parent in tree:
        for children in Path(f"/proc/{parent}/task").glob("*/children"):
            with contextlib.suppress(OSError):
                tree += map(int, children.read_text().split())
    return tree


def tree_cpu_s(pid: int) -> float:
    """Seconds that a process and its descendants have computed."""
    return sum(map(cpu_s, process_tree(pid)))


def seconds_of(work: Callable[[], object]) -> float:
    """Do the work once; give the seconds of the clock that it took."""
    began_at = time.perf_counter()
    work()
    return time.perf_counter() - began_at


# --- rounds ---


def in_turn(things: Sequence[T], rounds: int) -> Iterator[T]:
    """Give everything once in each round; each round begins with the next thing."""
    for number in range(rounds):
        first = number % len(things)
        yield from (*things[first:], *things[:first])


def percentile(values: Sequence[float], percent: int) -> float:
    """The percentile of two values or more."""
    return statistics.quantiles(values, n=100, method="inclusive")[percent - 1]


# --- the page ---


def machine(packages: Sequence[str] = ()) -> str:
    """Say where and when, and versions: take it before measuring, for the load."""
    loads = os.getloadavg()
    if loads[0] > BUSY * (os.cpu_count() or 1):
        say(f"load {loads[0]:.1f}: absolute figures are unreliable")
    date = time.strftime("%Y-%m-%d", time.gmtime())
    versions = [f"{name} {importlib.metadata.version(name)}" for name in packages]
    return (
        f"Measured on {date}: {os.cpu_count()} cores ({_processor()}), Python "
        f"{platform.python_version()}, load before "
        f"{' '.join(f'{load:.2f}' for load in loads)}. {', '.join(versions)}"
    ).rstrip()


def _processor() -> str:
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    return platform.processor() or platform.machine()


def put(part: str, title: str, text: str, file: Path = FILE) -> None:
    """Write a section, or replace it where the page has it already."""
    page = file.read_text() if file.exists() else HEAD
    marks = f"<!-- {part} -->", f"<!-- /{part} -->"
    section = f"{marks[0]}\n\n## {title}\n\n{text}\n\n{marks[1]}\n"
    written = re.compile(f"{marks[0]}\n.*?{marks[1]}\n", re.DOTALL)
    page, count = written.subn(lambda _: section, page)
    file.parent.mkdir(exist_ok=True)
    file.write_text(page if count else f"{page}\n{section}")


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Markdown; every column but the first is of numbers."""
    ruler = ["---", *(["--:"] * (len(head) - 1))]
    return "\n".join(f"| {' | '.join(row)} |" for row in (head, ruler, *rows))


def digits(value: float) -> str:
    """Show a value with three digits."""
    if value >= 100:
        return f"{value:.0f}"
    return f"{value:.3f}" if value < 1 else f"{value:#.3g}"


def verdict(*, is_met: bool) -> str:
    """Say whether a promise was kept."""
    return "yes" if is_met else "**no**"
