"""From `proctor submit` to a score, through the host, the server and a sandbox."""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import json
import os
import random
import re
import shlex
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import httpx
import pytest

from reference_platform.accounts.account_rules import Role
from reference_platform.accounts.organisations import Owner
from tests.support.pages.page_reader import commands_of
from tests.support.paths import ROOT
from tests.support.platform.approved_accounts import approved, quick_parts
from tests.support.platform.hosted_server import (
    HostedServer,
    mail_receiver,
    sign_in,
    track_file,
)
from tests.support.platform.sandboxes import open_folder
from tests.support.platform.uploaded_policies import SUPPORT, go_image, write_preset
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts a host and sandboxes")


@pytest.fixture(scope="module")
def host(tmp_path_factory: pytest.TempPathFactory) -> Iterator[HostedServer]:
    with open_folder() as folder, mail_receiver() as mail:
        (folder / "submissions").mkdir(mode=0o711)
        write_preset(folder / "submissions" / "presets")
        directory = tmp_path_factory.mktemp("host")
        with HostedServer(directory, mail.url, folder / "submissions") as host:
            host.put_track(track_file("letters", "per_day = 2"))
            yield host


def key_of(
    host: HostedServer, name: str, *scopes: str, track_id: str = "letters"
) -> str:
    """The key of a new approved account that has entered the track."""
    parts = quick_parts(host.database)
    role: Role = "administrator" if "host" in scopes else "participant"
    account = asyncio.run(approved(parts, name, role))
    parts.tracks.enter(track_id, Owner(account))
    key = parts.keys.make(account, "", scopes or ("read", "run"), 3600, time.time())[1]
    parts.database.close()
    return key


def run(host: HostedServer, key: str, *words: str) -> tuple[int, str]:
    """The exit code and the output of `proctor`."""
    done = subprocess.run(
        [sys.executable, "-m", "reference_client.command", *words],
        capture_output=True, text=True, timeout=120, check=False, cwd=ROOT,
        env=os.environ | {"PROCTOR_TOKEN": key, "PROCTOR_URL": host.url},
    )  # fmt: skip
    return done.returncode, done.stdout + done.stderr


def submit(host: HostedServer, key: str, *words: str) -> tuple[int, str]:
    return run(host, key, "submit", *words)


def proctor(host: HostedServer, key: str, *words: str) -> str:
    return run(host, key, *words)[1]


def signed_in(host: HostedServer, name: str) -> httpx.Client:
    """A browser of an account."""
    browser = host.client(follow_redirects=True)
    sign_in(browser, name, "correct horse")
    return browser


def figures_of(host: HostedServer, track_id: str) -> Mapping[str, Any]:
    """The figures of the best result of a track, as they are stored."""
    parts = quick_parts(host.database)
    track = parts.tracks.get(track_id)
    (best,) = parts.results.ranking(track, track.phases[0], ["ada"]).leading
    parts.database.close()
    assert best.figures is not None
    return best.figures


def policy_folder(path: Path, behaviour: str = "") -> Path:
    path.mkdir()
    (path / "main.py").write_bytes((SUPPORT / "policy_program.py").read_bytes())
    (path / "behaviour").write_text(behaviour)
    return path


def test_code_goes_from_upload_to_a_score(host: HostedServer) -> None:
    """The policy that the documents offer for copying."""
    key = key_of(host, "ada")
    words = ["--track", "letters", "--code", "examples/hosted_policy"]
    code, output = submit(host, key, *words, "--preset", "python")
    assert code == 0, output
    printed = "policy   | episode 0: Calibration task"
    for text in ("The verification has passed", printed, "completed"):
        assert text in output
    # The command of the operator finds the folder of the host that runs.
    assert host.admin("preset", "list") == "python"
    with host.client(key) as client:
        # Nothing of an upload is kept when its last submission has ended.
        assert host.submissions is not None
        folders = [host.submissions / name for name in ("uploads/ada", "roots")]
        wait_until(lambda: not any(list(f.iterdir()) for f in folders), "no files")
        (run,) = client.get("/v1/runs").json()["runs"]
        assert (run["state"], run["policy"]["name"]) == ("completed", "hosted_policy")
        # Its figures were stored before a page asked for them.
        score = client.get(f"/v1/runs/{run['run_id']}/score").json()
        figures = figures_of(host, "letters")
        assert figures["counts"]["total"] > 0
        for name in ("score", "success_rate", "success_interval", "counts"):
            assert figures[name] == score[name]
        assert figures["by_split"].keys() == score["by_split"].keys()
        # The verification used nothing of the quota.
        track = client.get("/v1/hosting/tracks/letters").json()
        assert track["phases"][0]["limits"][0]["used"] == 1
        # The same command line again uses nothing, unless one more is wanted.
        code, output = submit(host, key, *words, "--preset", "python")
        assert code == 0, output
        text = "has the same policy in the phase main of the track letters and is"
        assert f"{text} completed" in output
        last = ("--preset", "python", "--another", "--verify-only")
        assert "waits for its upload" in submit(host, key, *words, *last)[1]
        assert len(client.get("/v1/hosting/submissions").json()["submissions"]) == 2


def test_an_interrupted_upload_goes_on_by_the_printed_command(
    host: HostedServer, tmp_path: Path
) -> None:
    """Ctrl-C comes early. Expect that following it is refused with the way on."""
    key = key_of(host, "uma")
    folder = policy_folder(tmp_path / "policy")
    (folder / "weights").write_bytes(random.Random(0).randbytes(48 * 2**20))
    words = ["--track", "letters", "--code", str(folder), "--preset", "python"]
    command = [sys.executable, "-m", "reference_client.command", "submit", *words]
    command += ["--verify-only", "--url", host.url]
    with subprocess.Popen(
        command, cwd=ROOT, env=os.environ | {"PROCTOR_TOKEN": key},
        stderr=subprocess.PIPE, text=True,
    ) as interrupted:  # fmt: skip
        assert interrupted.stderr is not None
        for line in interrupted.stderr:
            if line.startswith("packed 0.0 of 48.0 MiB"):
                break
        interrupted.send_signal(signal.SIGINT)
        rest = interrupted.stderr.read()
    assert interrupted.returncode == 130, rest
    printed = re.search(r"waits for its upload until .*; `proctor (.*)` contin", rest)
    assert printed is not None, rest
    continuing = shlex.split(printed[1])
    assert continuing[3:] == ["--code", str(folder), "--url", host.url]
    code, output = run(host, key, *continuing[:3])
    assert code == 2, output
    assert f"`proctor {shlex.join(continuing[:4])} FOLDER`" in output, output
    page = signed_in(host, "uma").get(f"/hosting/submissions/{continuing[2]}").text
    shown = f"proctor {shlex.join(continuing[:4])} FOLDER --url {host.url}"
    assert shown in commands_of(page)
    code, output = run(host, key, *continuing)
    assert code == 0, output
    assert "uploaded 48.0 of 48.0 MiB" in output
    with host.client(key) as client:
        (row,) = client.get("/v1/hosting/submissions").json()["submissions"]
        assert (row["submission_id"], row["state"]) == (continuing[2], "verified")


CHOOSY = """
class Choosy:
    def reset(self, instruction):
        raise KeyError(instruction)

    def act(self, observation):
        return []
"""


def test_the_documented_evaluation_is_counted_and_a_wrong_policy_is_not(
    host: HostedServer, tmp_path: Path
) -> None:
    page = (ROOT / "docs/evaluate/challenge.md").read_text()
    shown = re.search(r"( +import numpy.*?)\n +proctor (run .*?)\n", page, re.DOTALL)
    assert shown is not None
    (tmp_path / "letters.py").write_text(textwrap.dedent(shown[1]))
    (tmp_path / "choosy.py").write_text(CHOOSY)
    key, command = key_of(host, "vic"), shown[2].replace("letters.py", "{policy}")
    command = command.replace("https://eval.example.org", host.url)
    wrong = command.format(policy=tmp_path / "choosy.py").replace("letters", "Choosy")
    for words, code, text in (
        (wrong, 2, "so no run was submitted"),
        (f"{wrong} --no-dry-turn", 1, "To end it:\n  proctor stop run_"),
        (command.format(policy=tmp_path / "letters.py"), 0, "score         1.0000"),
    ):
        ended, output = run(host, key, *words.split())
        assert (ended, text in output) == (code, True), output
    with host.client(key) as client:
        states = [run["state"] for run in client.get("/v1/runs").json()["runs"]]
        assert states == ["completed", "ready"]


def test_a_policy_that_crashes_fails_before_it_counts(
    host: HostedServer, tmp_path: Path
) -> None:
    key = key_of(host, "bea")
    folder = policy_folder(tmp_path / "policy", "crash")
    words = ["--track", "letters", "--code", str(folder), "--preset", "python"]
    code, output = submit(host, key, *words)
    assert code == 1, output
    assert "ValueError: the weights are missing" in output
    assert re.search("ended by +your policy\nnext +Change the policy", output), output
    browser = signed_in(host, "bea")
    listed = browser.get("/hosting/submissions").text
    name = re.findall(r"sub_[0-9a-f]+", listed)[0]
    shown = browser.get(f"/hosting/submissions/{name}").text
    assert "ValueError: the weights are missing" in shown
    assert "The policy ended by itself, with exit code 3." in shown
    raised = "The last traceback in its log ends with: ValueError: the weights"
    assert raised in " ".join(output.split()), output  # the line may be wrapped
    assert "<dt>Ended by</dt><dd>your policy</dd>" in shown
    key_of(host, "ivy")
    other = signed_in(host, "ivy").get(f"/hosting/submissions/{name}")
    assert other.status_code == 404
    assert "The policy ended by itself, with exit code 3." in output
    with host.client(key) as client:
        track = client.get("/v1/hosting/tracks/letters").json()
        assert track["phases"][0]["limits"][0]["used"] == 0


def test_what_is_no_image_is_refused_before_its_review(
    host: HostedServer, tmp_path: Path
) -> None:
    """The next command with a right file goes on with the same submission."""
    key, image = key_of(host, "fay"), tmp_path / "policy.tar"
    image.write_text("hello")
    code, output = submit(host, key, "--track", "letters", "--image", str(image))
    assert code == 2
    assert "The upload is refused. It is no tar file" in output
    assert host.admin("image", "list") == ""
    with host.client(key) as client:
        (made,) = client.get("/v1/hosting/submissions").json()["submissions"]
        assert made["state"] == "created"


def test_an_image_waits_for_its_review(host: HostedServer, tmp_path: Path) -> None:
    key = key_of(host, "cyd")
    image = tmp_path / "policy.tar"
    digest = go_image(image)
    (tmp_path / "Dockerfile").write_text("FROM scratch")
    command = [sys.executable, "-m", "reference_client.command", "submit"]
    command += ["--track", "letters", "--image", str(image), "--url", host.url]
    command += ["--dockerfile", str(tmp_path / "Dockerfile")]
    with (
        subprocess.Popen(
            command,
            cwd=ROOT,
            env=os.environ | {"PROCTOR_TOKEN": key},
            stderr=subprocess.PIPE,
            text=True,
        ) as following,
        contextlib.ExitStack() as ended,
    ):
        ended.callback(following.kill)
        assert following.stderr is not None
        for line in following.stderr:
            if "reviews an image before its first use" in line:
                break
        with host.client(key) as client:
            refused = client.get("/v1/hosting/images")
            assert refused.status_code == 403
        assert f"{digest} waiting   cyd" in host.admin("image", "list")
        assert host.admin("image", "show", digest) == "FROM scratch"
        assert "uploaded" in host.admin("submission", "list")
        page = signed_in(host, "cyd")
        assert "Submissions" in page.get("/hosting/submissions").text
        assert page.get("/hosting/images").status_code == 404
        reviewer_key = key_of(host, "gil", "read", "host")
        shown = signed_in(host, "gil").get("/hosting/images").text
        assert digest in shown
        assert "FROM scratch" in shown
        with host.client(reviewer_key) as client:
            (waiting,) = client.get("/v1/hosting/images").json()["images"]
            assert (waiting["digest"], waiting["account"]) == (digest, "cyd")
            assert waiting["dockerfile"] == "FROM scratch"
            path = f"/v1/hosting/images/{digest}/decisions"
            assert client.post(path, json={"decision": "approve"}).status_code == 200
        rest = following.stderr.read()
    assert following.returncode == 0, rest
    assert "The evaluation has passed" in rest


def test_a_followed_log_ends_with_its_submission(host: HostedServer) -> None:
    with host.client(key_of(host, "eve")) as client:
        body = {"track_id": "letters", "kind": "code", "preset": "python"}
        made = client.post("/v1/hosting/submissions", json=body).json()
        base = f"/v1/hosting/submissions/{made['submission_id']}"
        wait_until(lambda: client.get(f"{base}/log").json()["lines"], "a line")
        assert client.post(f"{base}/stop").json()["state"] == "stopped"
        # The stream ends with the reason.
        events = client.get(f"{base}/log", headers={"Accept": "text/event-stream"})
        assert "State stopped: Its owner stopped it." in events.text
        assert events.text.endswith("event: end\ndata: {}\n\n")
        lines = client.get(f"{base}/log").json()
        assert lines["is_ended"]
        assert lines["lines"][-1]["text"] == "State stopped: Its owner stopped it."


def test_an_evaluation_goes_on_after_the_host_was_killed(
    host: HostedServer, tmp_path: Path
) -> None:
    """The policy is slow. Expect the same run, completed, and nothing left over."""
    key = key_of(host, "hal")
    folder = policy_folder(tmp_path / "policy", "late")
    words = ["--code", str(folder), "--preset", "python", "--verify-only"]
    code, output = submit(host, key, "--track", "letters", *words)
    assert code == 0, output
    with host.client(key) as client:
        (row,) = client.get("/v1/hosting/submissions").json()["submissions"]
        base = f"/v1/hosting/submissions/{row['submission_id']}"
        assert client.post(f"{base}/start").json()["state"] == "queued"
        wait_until(lambda: client.get(base).json()["run_id"], "its run has begun")
        run_id = client.get(base).json()["run_id"]
    killed = host.process.pid
    host.end(signal.SIGKILL)
    host.start()
    with host.client(key) as client:
        states = ("queued", "running")
        wait_until(lambda: client.get(base).status_code == 200, "the host is back")
        wait_until(lambda: client.get(base).json()["state"] not in states, "it ends")
        ended = client.get(base).json()
        assert (ended["state"], ended["run_id"]) == ("completed", run_id), ended
        assert client.get(f"/v1/runs/{run_id}").json()["state"] == "completed"
        texts = [line["text"] for line in client.get(f"{base}/log").json()["lines"]]
        assert "The platform was restarted." in texts
        track = client.get("/v1/hosting/tracks/letters").json()
        assert track["phases"][0]["limits"][0]["used"] == 1
    assert not list(Path("/sys/fs/cgroup").glob(f"*/**/proctor-sandbox-{killed}-*"))


HELD_OUT = """
track_id = "sealed"
title = "Held out"
[[phases]]
phase_id = "test"
benchmark_id = "calibration"
opens_at = 2020-01-01T00:00:00Z
closes_at = {closes_at}
splits = ["odd"]
options = {{tasks = ["score", "score", "score", "score"]}}
seeds = "held_out"
total = 1
score = "after_close"
log = "after_close"
record = "after_close"
"""


def history_of(client: httpx.Client, draw_id: str) -> list[dict[str, Any]]:
    """The leaves of a draw, oldest first."""
    page = client.get("/v1/history", params={"limit": 1000}).json()
    leaves = [json.loads(row["leaf"]) for row in page["leaves"]]
    return [leaf for leaf in leaves if leaf.get("draw_id") == draw_id]


def test_held_out_seeds_are_drawn_after_the_policy_was_committed_to(
    host: HostedServer, tmp_path: Path
) -> None:
    """A phase closes while a policy waits. Expect commit, draw, its run, then open."""
    host.put_track(HELD_OUT.format(closes_at="2120-01-01T00:00:00Z"))
    key = key_of(host, "jan", track_id="sealed")
    folder = policy_folder(tmp_path / "policy")
    words = ["--track", "sealed", "--code", str(folder), "--preset", "python"]
    # The command does not wait for a date.
    code, output = submit(host, key, *words)
    assert code == 0, output
    assert re.search(r"to follow it +proctor submit --submission sub_", output), output
    with host.client(key) as client:
        (row,) = client.get("/v1/hosting/submissions").json()["submissions"]
        base = f"/v1/hosting/submissions/{row['submission_id']}"
        started = client.get(base).json()
        assert started["continues_at"] == "2120-01-01T00:00:00.000Z"
        assert "drawn when the phase closes, at 2120-01-01" in started["reason"]
        wait_until(lambda: client.get(base).json()["commit_index"] is not None, "leaf")
        assert client.get(base).json()["state"] == "queued"
        host.put_track(HELD_OUT.format(closes_at="2021-01-01T00:00:00Z"))
        wait_until(lambda: client.get(base).json()["state"] == "completed", "its end")
        wait_until(lambda: history_of(client, "sealed/test")[-1]["kind"] == "open", "")
        seal, commit, draw, opened = history_of(client, "sealed/test")
        assert [leaf["kind"] for leaf in (seal, commit, draw)] == [
            *("seal", "commit", "draw")
        ]
        assert commit["digest"] == row["digest"]
        assert (
            hashlib.sha256(bytes.fromhex(opened["key"])).hexdigest()
            == (seal["key_sha256"])
        )
        run_id = client.get(base).json()["run_id"]
        run = client.get(f"/v1/runs/{run_id}").json()
        assert run["policy"]["version"] == row["digest"]
        body = {"model_name": "mine", "is_public": True}
        entry = client.put(f"/v1/runs/{run_id}/entry", json=body).json()
        assert entry["level"] == "sealed", entry
        record = tmp_path / "run.proctor"
        record.write_bytes(client.get(f"/v1/runs/{run_id}/record").content)
        with host.client(key_of(host, "kim")) as others:
            assert others.get(f"/v1/runs/{run_id}").status_code == 404
            path = f"/v1/hosting/results/{row['submission_id']}/record"
            assert others.get(path).content == record.read_bytes()
            lines = others.get(f"{base}/log").json()["lines"]
            assert lines[-1]["text"].startswith("State completed: ")
        again = client.post("/v1/hosting/submissions", json={"track_id": "sealed"})
        assert again.status_code == 403
    # A third person, with the file of the record and nothing of the host's.
    words = ["board", "verify", "--record", str(record), "--state", str(tmp_path / "s")]
    checked = proctor(host, key, *words)
    assert "re-run on sealed seeds: leaf" in checked, checked
    assert f"--seeds {opened['key']}" in " ".join(checked.split())
    words = ["replay", str(record), "--no-verdict", "--seeds"]
    assert "exact: 2 of 2 episodes" in proctor(host, key, *words, opened["key"])
    assert "not those to which the record" in proctor(host, key, *words, "0" * 64)
