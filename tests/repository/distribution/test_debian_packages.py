"""Debian's packages are installed as root alone, with lists that may be missing."""

import os
from pathlib import Path

import pytest

from tests.support.paths import ROOT
from tests.support.processes import run_program

APT = """#!/bin/sh
echo "$@" >> "$CALLS"
case "$*" in *install*) [ "$(grep -c install "$CALLS")" -gt "$FAILURES" ];; esac
"""


@pytest.mark.parametrize(
    ("user", "failures", "calls", "code"),
    [
        ("0", "0", ["install"], 0),
        ("0", "1", ["install", "update", "install"], 0),
        ("0", "2", ["install", "update", "install"], 1),
        ("1000", "0", [], 1),
    ],
    ids=["the lists are there", "old lists", "no such package", "not root"],
)
def test_packages_are_installed_by_root(
    tmp_path: Path, user: str, failures: str, calls: list[str], code: int
) -> None:
    log = tmp_path / "calls"
    log.touch()
    for name, text in (("apt-get", APT), ("id", f"#!/bin/sh\necho {user}\n")):
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    path = f"{tmp_path}{os.pathsep}{os.environ['PATH']}"
    done = run_program(
        ["sh", "tools/debian_packages.sh", "for a test", "libone", "libtwo"],
        cwd=ROOT,
        env=os.environ | {"PATH": path, "CALLS": str(log), "FAILURES": failures},
    )
    lines = log.read_text().splitlines()
    words = [{"install", "update"} & set(line.split()) for line in lines]
    assert [word for (word,) in words] == calls
    assert done.returncode == code, done.stderr
    said = "set-up: installing libone libtwo for a test" if calls else ""
    assert done.stdout.strip() == said
