"""The server, the clients and the kit are whole where the platform was deleted."""

from __future__ import annotations

import subprocess
import sys

from reference_record.command_line.installation import install_command
from tests.support.paths import ROOT

# Imports fail as if the folder were not there.
DELETED = """
import importlib, sys

class Deleted:
    def __init__(self, finder):
        self.finder = finder

    def __getattr__(self, name):
        return getattr(self.finder, name)

    def find_spec(self, name, *more):
        if name.partition(".")[0] in ("reference_platform", "argon2", "joserfc"):
            return None
        return self.finder.find_spec(name, *more)

sys.meta_path[:] = map(Deleted, sys.meta_path)
for module in sys.argv[1:]:
    importlib.import_module(module)
from reference_record.command_line.installation import install_command
from reference_client.command.main import main
sys.exit(main(["admin", "account", "list"]))
"""


def test_programs_are_whole_without_it() -> None:
    """Every program is imported, and `proctor admin account` names what is missing."""
    modules = ("app", "__main__", "http.tokens.admin_command")
    names = [f"reference_server.{module}" for module in modules]
    names += ["conformance.__main__", "reference_sim.replay.__main__"]
    done = subprocess.run(
        [sys.executable, "-c", DELETED, *names],
        cwd=ROOT, capture_output=True, text=True, check=False, timeout=60,
    )  # fmt: skip
    assert done.returncode == 2, done.stderr
    assert install_command("platform") in done.stderr
