"""Policies as people upload them, and a runner that plays them."""

from __future__ import annotations

import os
import subprocess
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from reference_platform.images.presets import Presets
from reference_platform.images.unpacked_roots import UnpackedRoots
from reference_platform.sandbox.bubblewrap import BubblewrapMaker
from reference_platform.sandbox.sandbox_interface import Limits, SandboxMaker
from reference_platform.submissions.lifecycle import Submission
from reference_platform.submissions.policy_specs import PolicySpecs
from reference_platform.submissions.sandboxed_runner import PolicyTimes, SandboxedRunner
from reference_platform.submissions.submission_logs import FileLogs
from tests.support.paths import ROOT
from tests.support.platform.archives import (
    digest_of,
    entry,
    gzipped,
    tar_of,
    write_image,
)
from tests.support.platform.sandboxes import (
    SMALL,
    open_folder,
    python_command,
    system_binds,
)
from tests.support.servers import TOKENS, ReferenceServer

ROOT_BYTES = 64 * 2**20  # the most that an upload may unpack to
SUPPORT = ROOT / "tests" / "support" / "platform"


def python_code(path: Path, behaviour: str = "") -> str:
    """Write an archive of code; its digest."""
    program = (SUPPORT / "policy_program.py").read_bytes()
    files = {"main.py": program, "behaviour": behaviour.encode()}
    path.write_bytes(gzipped(tar_of(entry(n, text) for n, text in files.items())))
    return digest_of(path.read_bytes())


def go_image(path: Path) -> str:
    """Write an OCI archive with one static program; its digest."""
    program = path.with_suffix(".program")
    environment = os.environ | {"CGO_ENABLED": "0", "GOTOOLCHAIN": "local"}
    subprocess.run(
        ["go", "build", "-C", str(SUPPORT / "go_policy"), "-o", str(program), "."],
        check=True,
        env=environment,
    )
    layer = tar_of([entry("policy-server", program.read_bytes(), mode=0o755)])
    write_image(path, gzipped(layer), command=["/policy-server"])
    return digest_of(path.read_bytes())


def write_preset(folder: Path) -> None:
    """The preset `python` runs the Python of this machine."""
    folder.mkdir()
    binds = ", ".join(f'"{name}"' for name in system_binds())
    text = f'command = ["{python_command()}", "main.py"]\nbinds = [{binds}]\n'
    (folder / "python.toml").write_text(text)


def submission_of(digest: str, kind: str, submission_id: str = "sub1") -> Submission:
    return Submission(
        submission_id=submission_id,
        account="alice",
        track_id="track",
        kind="image" if kind == "image" else "code",
        state="uploaded",
        entered_at=time.time(),
        created_at=time.time(),
        deadline_at=None,
        reason="",
        digest=digest,
        preset="" if kind == "image" else "python",
        policy_name="a policy",
    )


class UploadedFiles:
    """Implements Uploads for files of a test."""

    def __init__(self) -> None:
        self.paths: dict[str, Path] = {}

    def path_of(self, account: str, digest: str) -> Path:
        return self.paths[digest]

    def remove(self, account: str, digest: str, before: float) -> None:
        del self.paths[digest]


class StaticTokens:
    """Implements AccountTokens with the tokens of the server's settings."""

    def make_token(self, account: str, lifetime_s: float) -> str:
        return TOKENS["bob" if account == "platform" else account]

    def revoke_token(self, token: str) -> None: ...


@dataclass
class Hosting:
    """A runner, and what it uses."""

    runner: SandboxedRunner
    uploads: UploadedFiles
    logs: FileLogs
    server: ReferenceServer
    folder: Path

    def log(self, source: str, submission_id: str = "sub1") -> list[str]:
        lines = self.logs.read(submission_id)
        return [line.text for line in lines if line.source == source]


@contextmanager
def hosting(
    times: PolicyTimes,
    maker: SandboxMaker | None = None,
    limits: Limits = SMALL,
    **settings: str,
) -> Iterator[Hosting]:
    """A server and a runner for it. settings: of the server."""
    with open_folder() as folder:
        write_preset(folder / "presets")
        (folder / "server").mkdir()
        sockets = folder / "sockets"
        settings["PROCTOR_POLICY_SOCKETS"] = str(sockets)
        uploads = UploadedFiles()
        logs = FileLogs(folder / "logs", lambda _: True)
        with ReferenceServer(folder / "server", **settings) as server:
            runner = SandboxedRunner(
                maker=maker or BubblewrapMaker(),
                specs=PolicySpecs(
                    uploads,
                    UnpackedRoots(folder / "roots", max_bytes=ROOT_BYTES),
                    Presets(folder / "presets"),
                    limits,
                ),
                tokens=StaticTokens(),
                logs=logs,
                server_url=server.url,
                sockets=sockets,
                times=times,
            )
            yield Hosting(runner, uploads, logs, server, folder)
