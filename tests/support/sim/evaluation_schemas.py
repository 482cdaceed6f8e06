"""The schemas of Every Eval Ever, read from its wheel.

The wheel is fetched once and not installed: it needs another Python and many packages,
and its schemas are data. requirements/every-eval-ever.txt has its version and hash.
"""

import functools
import json
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path
from typing import Any

from tests.support.paths import ROOT

PINNED = ROOT / "requirements" / "every-eval-ever.txt"
WHEEL = ROOT / ".venv" / "every_eval_ever.whl"
# pip accepts the wheel for the Python that it asks for, which need not run here.
DOWNLOAD = (
    *(sys.executable, "-m", "pip", "download", "--quiet", "--require-hashes"),
    *("--disable-pip-version-check", "--no-deps", "--only-binary=:all:"),
    *("--python-version=3.13", f"--requirement={PINNED}"),
)


@functools.cache
def read_schema(name: str) -> Any:
    """The JSON schema with this name, `eval` or `instance_level_eval`."""
    if not WHEEL.is_file():
        with tempfile.TemporaryDirectory(dir=WHEEL.parent) as folder:
            subprocess.run([*DOWNLOAD, f"--dest={folder}"], check=True)
            (fetched,) = Path(folder).iterdir()
            # Other processes read the file meanwhile: it is whole or not there.
            fetched.replace(WHEEL)
    with zipfile.ZipFile(WHEEL) as wheel:
        return json.loads(wheel.read(f"every_eval_ever/schemas/{name}.schema.json"))
