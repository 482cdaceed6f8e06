"""`python -m tests.mutants.serve_host [NAME]`: a host, with one thing wrong.

The tokens that a kit gives to a server are keys here, of accounts that have entered a
track on calibration. That of the second account is a token of the server, too, and
flags entries. Without a name nothing is wrong.
"""

from __future__ import annotations

import asyncio
import os
import sys
import time
from pathlib import Path

from reference_platform.accounts.account_keys import Key
from reference_platform.accounts.account_rules import SignUp
from reference_platform.accounts.organisations import Owner
from reference_platform.command_line import host_command
from reference_platform.parts import Parts
from reference_platform.tracks.track_rules import Phase, Track
from reference_server.http.auth import hash_of
from tests.mutants import load
from tests.support.platform.sandboxes import open_folder

YEAR_S = 366 * 86_400.0


def phases(now: float) -> tuple[Phase, ...]:
    """One for every run, one whose results others do not see, one that is held out."""
    opened_at, closes_at = now - 60, now + YEAR_S
    options = {"tasks": ["score", "score", "score"], "max_steps": 7}
    return (
        Phase("main", "calibration", opened_at, closes_at, total=10_000),
        Phase(
            "quiet", "calibration", opened_at, closes_at - 60, options=options,
            total=10_000, score="after_close", record="at_once",
        ),
        Phase("test", "calibration", opened_at, closes_at, seeds="held_out"),
    )  # fmt: skip


def prepare(database: Path, tokens: str) -> None:
    """Make the accounts, their keys and the track."""
    parts, now = Parts.of(database), time.time()
    parts.tracks.put(Track("kit", "For the kit", phases(now)), "the kit")
    entries = [entry.split(":") for entry in tokens.split(",")]
    for name in dict.fromkeys(account for account, _, _ in entries):
        filled = SignUp(
            account=name, full_name="Kit", organisation="Kit", agrees=True,
            email=f"{name}@example.org", password="a password for kits",
        )  # fmt: skip
        asyncio.run(parts.accounts.register(filled))
        account = parts.accounts.decide(name, "approve", "", "the kit")
        parts.tracks.enter("kit", Owner(account.account))
    for account_name, scopes, token in entries:
        names = scopes.replace("+", " ") + (" account" if "run" in scopes else "")
        key = Key(
            f"key_{hash_of(token)[:16]}", hash_of(token), account_name, "kit", names,
            now, now + YEAR_S, None, None, "",
        )  # fmt: skip
        parts.database.insert("keys", key)
    parts.database.close()


def main() -> int:
    options = sys.argv[1:]
    if options and not options[0].startswith("-"):
        name = options.pop(0)
        load()[name].patch()
        host_command.SERVER_WORDS = ("-m", "tests.mutants.serve", name)
    database = Path(os.environ["PROCTOR_DATABASE"]).with_name("hosting.sqlite")
    tokens = os.environ["PROCTOR_TOKENS"]
    (second,) = [entry for entry in tokens.split(",") if entry.startswith("bob:")]
    os.environ["PROCTOR_TOKENS"] = second.replace("read+run", "read+run+host")
    if not database.exists():
        prepare(database, tokens)
    with open_folder() as folder:
        words = ["--database", str(database), "--submissions", str(folder)]
        sys.argv = ["proctor-host", *words, "--", *options]
        return host_command.start()


if __name__ == "__main__":
    sys.exit(main())
