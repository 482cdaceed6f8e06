"""The set-up says in its last line why packages were not fetched."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support.paths import ROOT

AWAY = "error sending request for url"
NO_NAME = "cause: failed to lookup address information: Temporary failure"
NO_WHEEL = "No solution found when resolving dependencies: lz4 has no usable wheels"
PROXY = {"https_proxy": "http://ada:secret@proxy.example:3128"}


@pytest.mark.parametrize(
    ("said", "variables", "last_line"),
    [
        (AWAY, {}, "the package index cannot be reached without a proxy"),
        (AWAY, PROXY, "through the proxy http://proxy.example:3128, which https_proxy"),
        (NO_NAME, {}, "the package index cannot be reached without a proxy"),
        (NO_WHEEL, {}, "the packages were not installed, for the reason"),
        ("hash mismatch", PROXY, "the packages were not installed, for the reason"),
    ],
)
def test_the_last_line_names_the_cause(
    tmp_path: Path, said: str, variables: dict[str, str], last_line: str
) -> None:
    """The installer fails with a text. Expect its cause, and no secret of a proxy."""
    shutil.copytree(ROOT / "tools", tmp_path / "tools")
    (tmp_path / "requirements").mkdir()
    (tmp_path / "requirements" / "own.txt").write_text("package==1\n")
    installer = tmp_path / ".venv" / "bin" / "uv"
    installer.parent.mkdir(parents=True)
    installer.write_text(
        f'#!/bin/sh\n[ "$1" = venv ] || {{ echo "{said}" >&2; exit 2; }}\n'
    )
    installer.chmod(0o755)
    done = subprocess.run(
        ["sh", "tools/setup.sh", "own"],
        cwd=tmp_path, env={"PATH": "/usr/bin:/bin", **variables},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert last_line in done.stderr.splitlines()[-1]
    assert "secret" not in done.stderr
    assert (said in done.stderr) == (said not in {AWAY, NO_NAME})


@pytest.mark.parametrize(
    ("version", "is_used"), [("3.10", 0), ("3.14", 1), ("3.15", 0)]
)
def test_a_python_without_wheels_is_not_taken(
    tmp_path: Path, version: str, is_used: bool
) -> None:
    """A later Python than the locks have wheels for fails in the middle of a set-up."""
    shutil.copytree(ROOT / "tools", tmp_path / "tools")
    python = tmp_path / "python"
    numbers = version.replace(".", ", ")
    python.write_text(
        f'#!/bin/sh\n[ "$1" = -c ] || {{ echo made >&2; exit 3; }}\n'
        f'exec {sys.executable} -c "import sys; sys.version_info = ({numbers}); $2"\n'
    )
    python.chmod(0o755)
    done = subprocess.run(
        ["sh", "tools/setup.sh", "dev"],
        cwd=tmp_path, env={"PATH": "/usr/bin:/bin", "PYTHON": str(python)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    last_line = done.stderr.splitlines()[-1]
    assert (last_line == "made") == is_used
    assert ("no Python 3.11 to 3.14" in last_line) != is_used
