"""`proctor admin page`: all accounts and runs of a server, in a file."""

from __future__ import annotations

from pathlib import Path

import pytest

from reference_client.command.main import main as proctor
from reference_server.http.tokens import admin_command as admin
from tests.support.pages.page_reader import elements_of, inline_code_of
from tests.support.pages.played_runs import submit_and_play
from tests.support.server.http_runs import submit
from tests.support.servers import TOKENS, ReferenceServer


@pytest.mark.slow("a server is started")
def test_a_host_sees_all_accounts_and_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """While the server runs, and with markup in every text of a run."""
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    with ReferenceServer(tmp_path) as server, server.client("bob") as bob:
        played, waiting = submit_and_play(server, successes={1}), submit(bob, "score")
        assert admin.main(["token", "add", "carol", "--scopes", "read"]) == 0
        secret = capsys.readouterr().out.strip()
        expect_reads_of_all_runs(server, played, capsys)
        monkeypatch.setenv("PROCTOR_MAX_DISK_BYTES", "123456789")
        assert admin.main(["page", "--runs", "1"]) == 0
        said = capsys.readouterr()
        newest = Path(said.out.strip().removeprefix("file://"))
        assert "its links lead to http://127.0.0.1:8460; PROCTOR_PUBLIC_" in said.err
        assert waiting in newest.read_text()
        assert played not in newest.read_text()
        (tmp_path / "proctor.sqlite.token").write_text("t" * 40)
        assert admin.main(["page", "-o", str(tmp_path / "o.html")]) == 0
    assert newest == tmp_path / "proctor.sqlite.operator.html"
    path = tmp_path / "o.html"
    assert path.stat().st_mode & 0o077 == 0
    page = path.read_text()
    for text in (
        *("alice", "bob", "carol", "local"),
        played,
        waiting,
        "1 completed",
        "1 ready",
    ):
        assert text in page
    for text in ("max_disk_bytes", "123,456,789", "free on the disk"):
        assert text in page
    assert inline_code_of(page) == ["style"]
    assert "<script>alert" not in page
    assert not [text for text in (secret, *TOKENS.values()) if text in page]
    links = [one["href"] for name, one in elements_of(page) if name == "a"]
    assert links == [f"http://127.0.0.1:8460/pages/runs/{i}" for i in (waiting, played)]


def expect_reads_of_all_runs(
    server: ReferenceServer, run_id: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """OPT-061: every GET of a run of another account, with a token that reads all."""
    words = ["token", "add", "host", "--scopes", "read+read_all"]
    assert admin.main(words) == 0
    token = {"Authorization": f"Bearer {capsys.readouterr().out.strip()}"}
    run = f"/v1/runs/{run_id}"
    reads = ["", "/episodes", "/score", "/record", "/episodes/e0000/recording"]
    reads.append(f"/v1/comparisons?baseline={run_id}&runs={run_id}")
    with server.client("bob") as client:
        for at in reads:
            path = at if at.startswith("/v1") else run + at
            assert client.get(path).status_code == 404, path
            assert client.get(path, headers=token).status_code == 200, path


@pytest.mark.slow("a server is started")
def test_a_host_lists_and_stops_the_runs_of_all(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """OPT-083: with both scopes; with one, the run of another account is not found."""
    monkeypatch.setenv("PROCTOR_DATABASE", str(tmp_path / "proctor.sqlite"))
    with ReferenceServer(tmp_path) as server, server.client("bob") as bob:
        mine, run_id = (
            submit(server.client(name), "score") for name in ("alice", "bob")
        )
        for scopes, is_stopped in (
            ("read+run+host", False),
            ("read+run+read_all", False),
            ("read+run+read_all+host", True),
        ):
            assert admin.main(["token", "add", "host", "--scopes", scopes]) == 0
            token = capsys.readouterr().out.strip()
            where = ["--url", server.url, "--token", token]
            stop = ["stop", run_id, "--reason", "It held the robot.", *where]
            assert (proctor(stop) == 0) == is_stopped, scopes
            stopped = bob.get(f"/v1/runs/{run_id}").json()
            assert (stopped["state"] == "stopped") == is_stopped, scopes
        by_host = "Stopped by the host of this server: It held the robot."
        assert stopped["reason"] == by_host
        capsys.readouterr()
        assert proctor(["status", *where]) == 0
    listed = capsys.readouterr().out
    rows = {line.split()[0]: line.split()[1:4] for line in listed.splitlines() if line}
    assert rows["run"] == ["state", "account", "live"]
    assert rows[mine] == ["ready", "alice", "0"]
    assert rows[run_id] == ["stopped", "bob", "0"]
