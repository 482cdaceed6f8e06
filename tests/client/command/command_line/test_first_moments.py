"""Output before a program has begun: at Ctrl-C, and where packages are missing."""

import importlib.metadata
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from reference_record.command_line import installation
from tests.support.paths import ROOT
from tests.support.processes import run_program

# Every program imports one of these; no start is timed.
LIBRARIES = "pydantic msgspec click hypothesis"
OF_COMMAND = "reference_client.command status"
INTERRUPTS = """
import os
import signal
import sys


class Interrupted:
    def find_spec(self, name, path=None, target=None):
        if name in os.environ["INTERRUPTED_AT"].split():
            number = int(os.environ.get("INTERRUPTED_BY", signal.SIGINT))
            signal.raise_signal(number)


sys.meta_path.insert(0, Interrupted())
"""


@pytest.mark.parametrize(
    ("words", "at"),
    [
        (OF_COMMAND, LIBRARIES),
        (OF_COMMAND, "reference_client.printable_text"),
        (OF_COMMAND, "reference_record.command_line.closed_output"),
        ("reference_platform", LIBRARIES),
        pytest.param(
            "conformance", LIBRARIES, marks=pytest.mark.slow("starts the kit")
        ),
    ],
)
def test_an_interruption_of_the_imports_is_one_line(
    words: str, at: str, tmp_path: Path
) -> None:
    (tmp_path / "sitecustomize.py").write_text(INTERRUPTS)
    path = os.pathsep.join([str(tmp_path), str(ROOT)])
    done = run_program(
        [sys.executable, "-m", *words.split()],
        env=os.environ | {"PYTHONPATH": path, "INTERRUPTED_AT": at},
        cwd=tmp_path,
        timeout=60,
    )
    assert (done.returncode, done.stderr) == (130, "\nInterrupted.\n")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGUSR1])
@pytest.mark.parametrize("at", [LIBRARIES, "reference_client.printable_text"])
def test_a_script_reads_of_a_signal_at_the_start(
    at: str, number: signal.Signals, tmp_path: Path
) -> None:
    (tmp_path / "sitecustomize.py").write_text(INTERRUPTS)
    path = os.pathsep.join([str(tmp_path), str(ROOT)])
    given = {"PYTHONPATH": path, "INTERRUPTED_AT": at, "INTERRUPTED_BY": str(number)}
    done = run_program(
        [sys.executable, "-m", *OF_COMMAND.split(), "--json"],
        env=os.environ | given,
        cwd=tmp_path,
        timeout=60,
    )
    assert (done.returncode, done.stderr) == (128 + number, "\nInterrupted.\n")
    error = {"code": "interrupted", "detail": "Interrupted."}
    assert json.loads(done.stdout) == {"error": error}


@pytest.mark.slow("starts programs")
@pytest.mark.parametrize(
    "words",
    [
        "-m reference_client.command --help",
        "-m reference_client.command --version",
        "-um reference_client.command run --help",
        "-m conformance --list",
        "-m conformance.policy --help",
        "-m conformance.simulator true",
    ],
)
def test_a_full_disk_is_one_sentence(words: str, tmp_path: Path) -> None:
    """Help, lists and verdicts. Expect the reason, and that the code says so, too."""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(ROOT), *sys.path])}
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(
            [sys.executable, *words.split()],
            check=False,
            stdout=full,
            stderr=subprocess.PIPE,
            env=environment,
            cwd=tmp_path,
            text=True,
            timeout=60,
        )
    assert done.returncode == 2
    assert done.stderr.count("\n") == 1
    assert "The standard output cannot be written (No space left on" in done.stderr


@pytest.mark.parametrize(
    ("direct_url", "command"),
    [
        (None, "pip install 'proctor-eval[server,video]'"),
        (
            '{"url": "file:///a%20b/proctor"}',
            "pip install '/a b/proctor[server,video]'",
        ),
        ('{"url": "https://h/x.whl"}', "pip install 'proctor-eval[server,video]'"),
    ],
)
def test_packages_come_from_where_the_program_came_from(
    direct_url: str | None, command: str, tmp_path: Path, monkeypatch: Any
) -> None:
    """In a clone, installed from one, and installed from an index."""
    shown = installation.install_command("server,video")
    assert shown == f"pip install '{ROOT}[server,video]'"
    monkeypatch.setattr(installation, "_ROOT", tmp_path)
    of_wheel = SimpleNamespace(read_text=lambda _: direct_url)
    monkeypatch.setattr(importlib.metadata, "distribution", lambda _: of_wheel)
    assert installation.install_command("server,video") == command


def test_a_program_that_is_not_installed_names_the_package(
    tmp_path: Path, monkeypatch: Any
) -> None:
    def missing(_: str) -> None:
        raise importlib.metadata.PackageNotFoundError

    monkeypatch.setattr(installation, "_ROOT", tmp_path)
    monkeypatch.setattr(importlib.metadata, "distribution", missing)
    assert installation.install_command("kit") == "pip install 'proctor-eval[kit]'"


PROGRAMS = [
    *("reference_client.command", "reference_server", "reference_platform"),
    *("reference_sim.replay", "reference_sim.gymnasium"),
    *("conformance.policy", "reference_server.http.tokens.admin_command"),
]


@pytest.mark.parametrize("module", PROGRAMS)
@pytest.mark.parametrize("closed", [">&-", "<&- >&- 2>&-"])
def test_a_program_starts_without_standard_streams(module: str, closed: str) -> None:
    """A batch system starts it so. Expect its help, which is written to nowhere."""
    script = f'exec "$0" -m {module} --help {closed}'
    done = run_program(
        ["sh", "-c", script, sys.executable],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        timeout=60,
    )
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("module", PROGRAMS)
def test_a_working_folder_that_is_gone_is_said(module: str, tmp_path: Path) -> None:
    folder = tmp_path / "gone"
    folder.mkdir()
    script = f'rmdir "{folder}"; exec "$0" -m {module}'
    done = run_program(
        ["sh", "-c", script, sys.executable],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        cwd=folder,
        timeout=60,
    )
    said = "The working folder cannot be used (No such file or directory): cd to"
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == f"{said} another.\n"


REPEATED_NOTICE = """
import signal
from reference_record.command_line.closed_output import interrupted_by_signals

for _ in range(2):
    try:
        with interrupted_by_signals(), interrupted_by_signals():
            signal.raise_signal(signal.SIGUSR1)
            print("goes on")
    except KeyboardInterrupt as interruption:
        print(interruption)
    signal.raise_signal(signal.SIGUSR1)
print("ends in order")
"""


def test_a_repeated_notice_does_not_interrupt_the_end(tmp_path: Path) -> None:
    """Batch systems repeat it, also while the result is written."""
    done = run_program(
        [sys.executable, "-c", REPEATED_NOTICE],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        cwd=tmp_path,
        timeout=60,
    )
    lines = ["SIGUSR1", "goes on", "ends in order"]
    assert (done.returncode, done.stdout.splitlines()) == (0, lines)
