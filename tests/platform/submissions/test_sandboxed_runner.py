"""A policy from upload to its end: what it is scored, and why it failed."""

from __future__ import annotations

import asyncio
import io
import tarfile
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from proctor_client import RunState

from reference_platform.images.python_preset import CannotMake, make_python_preset
from reference_platform.sandbox.sandbox_interface import (
    Limits,
    NotListening,
    Sandbox,
    SandboxSpec,
    WriteLine,
)
from reference_platform.submissions import sandboxed_runner
from reference_platform.submissions.interfaces import Outcome, Track
from reference_platform.submissions.lifecycle import Cause
from reference_platform.submissions.sandboxed_runner import PolicyTimes
from tests.support.platform.archives import digest_of, entry, gzipped, link, tar_of
from tests.support.platform.uploaded_policies import (
    ROOT_BYTES,
    SUPPORT,
    Hosting,
    go_image,
    hosting,
    python_code,
    submission_of,
)
from tests.support.waiting import wait_in_loop

pytestmark = pytest.mark.slow("starts a server and sandboxes")
TRACK = Track("track", "calibration", verification_episodes=1)


@pytest.fixture(scope="module")
def host() -> Iterator[Hosting]:
    times = PolicyTimes(listen_s=2.0, call_s=1.0, retries=0)
    with hosting(times) as host:
        yield host


def upload(host: Hosting, kind: str, behaviour: str = "") -> str:
    archive = host.folder / f"{kind}-{behaviour}"
    digest = go_image(archive) if kind == "image" else python_code(archive, behaviour)
    host.uploads.paths[digest] = archive
    return digest


@pytest.mark.parametrize("kind", ["image", "code"])
async def test_a_policy_is_verified_and_evaluated(host: Hosting, kind: str) -> None:
    """A static program in Go is an image by itself; Python runs on a preset."""
    name = f"good-{kind}"
    submission = submission_of(upload(host, kind), kind, name)
    outcome = await host.runner.verify(submission, TRACK)
    assert outcome.passed, host.logs.read(name)
    run_ids: list[str] = []
    outcome = await host.runner.evaluate(submission, TRACK, run_ids.append)
    assert (outcome.passed, outcome.run_id) == (True, run_ids[0])
    assert outcome.reason == "The score is 0.000 over 1 episode."
    assert outcome.seconds > 0
    with host.server.client("alice") as client:
        run = client.get(f"/v1/runs/{run_ids[0]}").json()
        assert (run["state"], run["mode"]) == ("completed", "push")
        # The verification belongs to the platform.
        assert len(client.get("/v1/runs").json()["runs"]) >= 1
    assert host.log("policy", name) == ["predict 0"] * 2
    platform = host.log("platform", name)
    assert platform[0] == "The verification begins."
    assert platform[-1].startswith("The evaluation has passed. The score is")
    assert_nothing_is_left(host)


async def test_a_policy_with_numpy_runs_on_a_preset_of_this_python(
    host: Hosting,
) -> None:
    """From the upload to the score, on what `proctor admin preset add` makes."""
    make_python_preset(host.folder / "presets", "numpy", ["numpy"])
    with pytest.raises(CannotMake, match="no-such-package is not installed"):
        make_python_preset(host.folder / "presets", "other", ["no-such-package"])
    submission = submission_of(upload(host, "code", "numpy"), "code", "numpy")
    submission = replace(submission, preset="numpy")
    outcome = await host.runner.verify(submission, TRACK)
    assert outcome.passed, host.logs.read("numpy")
    outcome = await host.runner.evaluate(submission, TRACK)
    assert outcome.passed, host.logs.read("numpy")
    assert f"numpy {np.__version__}" in host.log("policy", "numpy")
    assert_nothing_is_left(host)


BEHAVIOURS = {
    "crash": "The policy ended by itself, with exit code 3.",
    "silent": "The policy does not listen at /run/policy.sock after 2 s.",
    "unanswered": "did not answer completely within 1 s",
    "late": "did not answer completely within 1 s",
    "malformed": "The policy's answer to predict was refused",
    "memory": "memory limit was reached",
}


@pytest.mark.parametrize("behaviour", BEHAVIOURS)
async def test_a_policy_that_fails_gets_the_reason(
    host: Hosting, behaviour: str
) -> None:
    name = f"bad-{behaviour}"
    submission = submission_of(upload(host, "code", behaviour), "code", name)
    outcome = await host.runner.verify(submission, TRACK)
    assert not outcome.passed
    assert outcome.cause == "policy", outcome
    assert BEHAVIOURS[behaviour] in outcome.reason
    assert "sandbox.invalid" not in outcome.reason
    assert outcome.reason in host.log("platform", name)[-1]
    late = [line for line in host.log("platform", name) if "gave the call up" in line]
    if behaviour != "memory":  # which may be late before it is killed
        assert not late or "answer completely" in outcome.reason
    if behaviour == "crash":
        assert "ValueError: the weights are missing" in host.log("policy", name)
    assert_nothing_is_left(host)


async def test_a_call_that_the_server_gave_up_is_in_the_log(host: Hosting) -> None:
    """The server leaves two calls at their limit, and one before it."""
    submission = submission_of("sha256:0", "code", "late-calls")
    play = sandboxed_runner._Play(submission, TRACK, "verification", lambda _: None)
    for waited_s in (0.95, 0.5, 1.0):
        host.runner._note_late(play, waited_s)
    first, second = host.log("platform", "late-calls")
    assert (
        "did not answer a call within 1 s, and the server gave the call up. It makes "
        "each call 1 time at most. Calls given up so far, of all turns: 1. The "
        "verification ends after 15 minutes at the latest."
    ) in first
    assert "of all turns: 2." in second


@pytest.mark.parametrize(
    ("failed_by", "cause"),
    [
        ("policy", "policy"),
        ("simulator", "platform"),
        ("server", "platform"),
        (None, "platform"),
    ],
)
async def test_who_made_the_run_fail_is_the_cause_in_any_words(
    host: Hosting, failed_by: str | None, cause: Cause
) -> None:
    """The reason holds text of the policy, which names the faults of others."""
    submission = submission_of("sha256:0", "code", "causes")
    play = sandboxed_runner._Play(submission, TRACK, "evaluation", lambda _: None)
    reason = "Internal server error. It did not answer completely within 1 s."
    progress = SimpleNamespace(episodes_scored=0)
    run: Any = SimpleNamespace(
        state=RunState.FAILED, reason=reason, failed_by=failed_by, progress=progress
    )

    async def wait() -> None:
        pass

    sandbox: Any = SimpleNamespace(end=None, wait=wait)
    server_run: Any = None
    outcome = await host.runner._outcome(play, server_run, sandbox, run)
    assert outcome == Outcome(False, reason, cause)
    assert host.log("platform", "causes") == []


@pytest.mark.parametrize("is_listening", [True, False])
async def test_only_a_policy_that_does_not_listen_is_waited_for_again(
    monkeypatch: pytest.MonkeyPatch, is_listening: bool
) -> None:
    """Its end is not known within the first wait, as on a busy host."""
    monkeypatch.setattr(sandboxed_runner, "_END_S", 0.0)
    waits = []

    async def wait() -> None:
        waits.append(1)
        if len(waits) == 1:
            await asyncio.Event().wait()

    def connect() -> io.BytesIO:
        if not is_listening:
            raise NotListening
        return io.BytesIO()

    sandbox: Any = SimpleNamespace(wait=wait, connect=connect)
    await sandboxed_runner._wait_for_end(sandbox)
    assert len(waits) == 2 - is_listening


async def test_what_is_no_image_is_refused(host: Hosting) -> None:
    archive = host.folder / "broken"
    archive.write_bytes(b"broken")
    digest = digest_of(b"broken")
    host.uploads.paths[digest] = archive
    outcome = await host.runner.verify(submission_of(digest, "image", "broken"), TRACK)
    assert (outcome.passed, outcome.cause) == (False, "policy")
    assert outcome.reason.startswith("The upload is refused.")


def zip_of(name: str, content: bytes) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(name, content)
    return buffer.getvalue()


LARGE = bytes(ROOT_BYTES + 1)
PROGRAM = entry("main.py", (SUPPORT / "policy_program.py").read_bytes())
# Kind → the upload, and what the log has of it; what is left out does no harm.
HOSTILE_UPLOADS: dict[str, tuple[Callable[[], bytes], str]] = {
    "tar bomb": (lambda: gzipped(tar_of([entry("x", LARGE)])), "refused. "),
    "zip bomb": (lambda: zip_of("x", LARGE), "refused. "),
    "path of a tar": (lambda: tar_of([entry("../x")]), "leaves its folder"),
    "path of a zip": (lambda: zip_of("../x", b""), "leaves its folder"),
    "link": (lambda: tar_of([link("a", "b"), link("b", "a"), entry("a/x")]), "loop"),
    "hard link": (
        lambda: tar_of([link("x", "../../etc/passwd", is_hard=True)]),
        "leaves its folder",
    ),
    "device": (
        lambda: tar_of([PROGRAM, entry("disk", type=tarfile.BLKTYPE, devmajor=8)]),
        "Devices and pipes were left out: 1.",
    ),
    "setuid": (lambda: tar_of([PROGRAM, entry("root", mode=0o4755)]), "setuid"),
}


@pytest.mark.parametrize("kind", HOSTILE_UPLOADS)
async def test_the_log_says_what_is_refused_of_an_upload(
    host: Hosting, kind: str
) -> None:
    make, text = HOSTILE_UPLOADS[kind]
    archive, name = host.folder / "hostile", f"hostile-{kind}"
    archive.write_bytes(make())
    digest = digest_of(archive.read_bytes())
    host.uploads.paths[digest] = archive
    outcome = await host.runner.verify(submission_of(digest, "code", name), TRACK)
    assert any(text in line for line in host.log("platform", name)), outcome
    assert outcome.passed == (kind in ("device", "setuid"))
    assert outcome.cause in ("policy", "")
    assert_nothing_is_left(host)


async def test_a_missing_upload_is_the_fault_of_the_platform(host: Hosting) -> None:
    digest = f"sha256:{'0' * 64}"
    outcome = await host.runner.verify(submission_of(digest, "image", "gone"), TRACK)
    assert (outcome.passed, outcome.cause) == (False, "platform")


async def test_a_stop_ends_it(host: Hosting) -> None:
    submission = submission_of(upload(host, "code", "silent"), "code", "stopped")
    playing = asyncio.create_task(host.runner.verify(submission, TRACK))
    await wait_in_loop(lambda: host.log("platform", "stopped"))
    await host.runner.stop("stopped")
    assert (await playing).cause == "owner"
    assert_nothing_is_left(host)


class FullCluster:
    """A maker of sandboxes that has no place."""

    def enforcement(self, limits: Limits) -> str:
        return ""

    async def start(self, spec: SandboxSpec, write: WriteLine) -> Sandbox:
        write("platform", "It waits for a place.")
        await asyncio.Event().wait()
        raise AssertionError


async def test_a_stop_ends_the_wait_for_a_place(
    host: Hosting, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(host.runner, "_maker", FullCluster())
    submission = submission_of(upload(host, "code"), "code", "waiting")
    playing = asyncio.create_task(host.runner.verify(submission, TRACK))
    text = "It waits for a place."
    await wait_in_loop(lambda: text in host.log("platform", "waiting"))
    await host.runner.stop("waiting")
    assert (await playing).cause == "owner"


def assert_nothing_is_left(host: Hosting) -> None:
    assert list((host.folder / "sockets").iterdir()) == []
    root = str(host.folder).encode()
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            assert root not in path.read_bytes() or b"bwrap" not in path.read_bytes()
        except (FileNotFoundError, ProcessLookupError):
            continue
