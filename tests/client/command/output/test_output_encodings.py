"""Printing never ends a run: encodings that lack a character, disks that are full."""

import io
import json
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from reference_client.command.output.printer import Printer, ProgressDisplay
from reference_client.errors import ProctorError
from reference_client.evaluation.evaluate import _say_all
from reference_client.evaluation.status_board import (
    Progress,
    ProgressLine,
    terminal_progress_line,
)
from reference_client.evaluation.uncaught_errors import _print_text
from reference_client.printable_text import LenientStream, prepare_output
from tests.support.client.command import options
from tests.support.paths import ROOT
from tests.support.servers import TOKENS, ReferenceServer

TEXT = "B\u00fccher \u2013 \u65e5\u672c \u2026"


@pytest.mark.parametrize(
    ("encoding", "written"),
    [
        ("ascii", "B\\xfccher - \\u65e5\\u672c ..."),
        ("latin-1", "B\u00fccher - \\u65e5\\u672c ..."),
        ("cp1252", "B\u00fccher \u2013 \\u65e5\\u672c \u2026"),
        ("cp437", "B\u00fccher - \\u65e5\\u672c ..."),
        ("utf-16", TEXT),
        ("utf-8", TEXT),
    ],
)
def test_characters_that_an_encoding_lacks_are_written_otherwise(
    encoding: str, written: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    stream = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    monkeypatch.setattr(sys, "stdout", stream)
    prepare_output()
    print(TEXT, end="", flush=True)  # noqa: T201 - it is what is tested
    assert stream.buffer.getvalue().decode(encoding) == written


def test_a_stream_that_was_closed_is_written_to_nowhere(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    prepare_output()
    sys.stderr.write(TEXT)
    sys.stderr.close()
    assert LenientStream(sys.stderr).write(TEXT) == len(TEXT)


class WriteAlone:
    """A stream of a program of its own, as one that writes to two places."""

    def __init__(self) -> None:
        self.written = ""

    def write(self, text: str) -> None:
        self.written += text


class Broken:
    """A stream whose other end is away, and which asks it everything."""

    def _fail(self, *_: object) -> Any:
        raise OSError(TEXT)

    write = flush = isatty = fileno = _fail


class TerminalWithoutFile(WriteAlone):
    """A terminal as a window of a notebook shows it."""

    encoding, fileno = None, None

    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("stream", "is_terminal"),
    [
        (None, False),
        (WriteAlone(), False),
        (Broken(), False),
        (TerminalWithoutFile(), True),
    ],
    ids=lambda value: type(value).__name__,
)
def test_of_a_replaced_stream_write_alone_is_expected(
    stream: Any, is_terminal: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", stream)
    assert (terminal_progress_line() is not None) == is_terminal
    line = ProgressLine(stream)
    line(Progress("run_1", 20, 7, 0.5, None))
    line.end()
    _say_all(["from evaluate"])
    _print_text(ProctorError, ProctorError("not_found", "an error"), None)
    printer = Printer(as_json=False)
    printer.say("from the command")
    assert printer.err.is_terminal == is_terminal
    with ProgressDisplay(printer) as display:
        display(Progress("run_1", 20, 8, 0.5, None))
    if isinstance(stream, WriteAlone):
        assert re.search("(?s)7/20.*evaluate.*error.*command", stream.written)


@pytest.mark.slow("starts programs")
@pytest.mark.parametrize(
    ("redirection", "code", "says"),
    [
        ("", 0, "Run run_"),
        ("2>/dev/full", 0, ""),
        ("2>&-", 0, ""),
        ("--processes 2>&-", 0, ""),
        (">&-", 0, "Run run_"),
        (
            ">/dev/full",
            2,
            "(No space left on device); `proctor results run_",
        ),
    ],
)
def test_a_run_is_played_to_its_end(
    redirection: str, code: int, says: str, server: ReferenceServer, policy_folder: Path
) -> None:
    """Its policy prints, too. Expect its score on the disk."""
    (policy_folder / "talking.py").write_text(
        "from policies import Graded\n"
        "class Talking(Graded):\n"
        "    def act(self, observation):\n"
        f"        print({TEXT!r}, flush=True)\n"
        "        return super().act(observation)\n",
        encoding="utf-8",
    )
    flags = ["--url", server.url, "--policy", "talking:Talking", *options("count")]
    command = [sys.executable, "-m", "reference_client.command", "run", *flags]
    line = shlex.join([*command, "--save", "out", "--policy-version", TEXT])
    encodings = {"PYTHONIOENCODING": "ascii", "LC_ALL": "C.UTF-8"}
    done = subprocess.run(
        ["bash", "-c", f"{line} {redirection}"],
        env=os.environ | encodings | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        check=False,
    )
    assert (done.returncode, "Traceback" in done.stderr.decode()) == (code, False)
    assert says in done.stderr.decode("ascii")
    saved = json.loads((policy_folder / "out" / "result.json").read_text("utf-8"))
    assert saved["score"]["counts"]["unscored"] == 0


CLIENT = "reference_client.command"


@pytest.mark.slow("starts many programs")
@pytest.mark.parametrize(
    ("module", "arguments"),
    [
        (CLIENT, "benchmarks --url URL"),
        (CLIENT, "benchmarks --url URL --json"),
        (CLIENT, "status --url URL --format latex"),
        (CLIENT, "status --url URL"),
        (CLIENT, "--help"),
        (CLIENT, "run --help"),
        (CLIENT, "completion bash"),
        (CLIENT, "admin token list --file TOKENS"),
        (CLIENT, "serve --help"),
        ("reference_sim.gymnasium", "check gymnasium:CartPole-v1"),
        ("conformance", "--list"),
    ],
)
def test_a_program_whose_output_is_read_no_more_ends_without_a_word(
    module: str, arguments: str, server: ReferenceServer, tmp_path: Path
) -> None:
    """As `head` leaves it. Expect 0 if nothing was lost, else the code of SIGPIPE."""
    (tmp_path / "tokens").write_text("")
    for name, value in {"URL": server.url, "TOKENS": f"{tmp_path}/tokens"}.items():
        arguments = arguments.replace(name, value)
    reading, writing = os.pipe()
    os.close(reading)
    try:
        done = subprocess.run(
            [sys.executable, "-m", module, *arguments.split()],
            env=os.environ
            | {"PYTHONPATH": str(ROOT), "PROCTOR_TOKEN": TOKENS["alice"]},
            stdout=writing,
            stderr=subprocess.PIPE,
            check=False,
        )
    finally:
        os.close(writing)
    assert (done.returncode, done.stderr) in [(0, b""), (141, b"")]


@pytest.mark.slow("starts a program")
def test_the_end_of_a_pipe_does_not_end_the_kit(
    server: ReferenceServer, policy_folder: Path
) -> None:
    kit = f"{sys.executable} -m conformance --url {server.url} --only SVC-001".split()
    line = f"{shlex.join(kit)} | head -1; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(
        ["bash", "-c", line],
        env=os.environ | {"PYTHONPATH": str(ROOT)},
        capture_output=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert (policy_folder / "report" / "report.json").exists()
