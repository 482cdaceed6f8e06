"""`make add` with a uv that records how it is called, and with which settings."""

import os
import shutil
from pathlib import Path

from tests.support.paths import ROOT
from tests.support.processes import run_program

UV = """#!/bin/sh
echo "certs=${UV_SYSTEM_CERTS-} index=${UV_DEFAULT_INDEX-} $1 $2" >> "$RECORD"
case "$1 $2" in
"pip compile")
    for word; do
        [ "$last" = --output-file ] && echo "gymnasium==1" > "$word"
        last=$word
    done ;;
venv*) mkdir -p .venv-own/bin && echo "exit 0" > .venv-own/bin/python
    chmod +x .venv-own/bin/python ;;
esac
"""
FILES = (
    *("requirements/add.sh", "tools/debian_packages.sh"),
    *("tools/setup.sh", "tools/uv_settings.sh"),
)


def test_every_call_of_uv_has_the_settings_of_the_machine(tmp_path: Path) -> None:
    """A machine with an index and an authority of its own. Expect both in each call,
    as `make setup` has them."""
    for name in FILES:
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    uv = tmp_path / ".venv" / "bin" / "uv"
    uv.parent.mkdir(parents=True)
    uv.write_text(UV)
    uv.chmod(0o755)
    record = tmp_path / "record"
    settings = {
        "UV_SYSTEM_CERTS": "true",
        "PIP_INDEX_URL": "https://index.example",
        "RECORD": str(record),
        "PATH": os.environ["PATH"],
    }
    done = run_program(
        ["sh", "requirements/add.sh", "gymnasium"], cwd=tmp_path, env=settings
    )
    assert done.returncode == 0, done.stderr
    assert "gymnasium" in (tmp_path / "requirements" / "own.in").read_text()
    calls = record.read_text().splitlines()
    assert len(calls) == 4
    for call in calls:
        assert call.startswith("certs=true index=https://index.example "), call
