"""Tokens in a file: what it says, how it changes, what a broken one does."""

import asyncio
import logging
import os
import threading
from pathlib import Path

import pytest

from reference_server.http.auth import BadTokens, Tokens, hash_of
from reference_server.http.tokens import admin_command as admin
from reference_server.http.tokens import token_file
from reference_server.http.tokens.token_file import TokenFile, edited_lines, parse
from reference_server.rules.refusal import Refused
from tests.support.waiting import wait_in_loop

ALICE = f"alice:read+run:sha256={hash_of('a')}"
BOB = f"bob:read:sha256={hash_of('b')}"


def account_of(tokens: Tokens, secret: str) -> str | None:
    try:
        return tokens.authenticate(f"Bearer {secret}", "read").account
    except Refused:
        return None


def test_tokens_come_and_go_with_the_file(tmp_path: Path) -> None:
    path, tokens = tmp_path / "tokens", Tokens.parse("carl:read:c")
    file = TokenFile(path, tokens)
    file.read()
    assert account_of(tokens, "a") is None
    path.write_text(f"# who may\n\n{ALICE}\n{BOB}\n")
    file.read()
    assert [account_of(tokens, one) for one in "abc"] == ["alice", "bob", "carl"]
    path.write_text(BOB)
    file.read()
    assert [account_of(tokens, one) for one in "abc"] == [None, "bob", "carl"]


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"alice:read", "line 1 .* no sha256"),
        (f"{ALICE}\nbob:read:secret".encode(), "line 2 .* stored as hashes"),
        (f"alice:write:sha256={hash_of('a')}".encode(), "line 1 .*scopes read"),
        (f"alice:read_all:sha256={hash_of('a')}".encode(), "line 1 .*scopes read"),
        (b"alice:read:sha256=12", "line 1 .* hexadecimal"),
        (f"a:read:zz:sha256={hash_of('a')}".encode(), "line 1 .* 64 digits"),
        (f"{ALICE}\n{ALICE}".encode(), "line 2 .* repeats"),
        (b"\xff", "UTF-8"),
    ],
)
def test_a_broken_file_keeps_the_old_tokens(
    tmp_path: Path, content: bytes, why: str
) -> None:
    path, tokens = tmp_path / "tokens", Tokens({})
    path.write_text(ALICE)
    file = TokenFile(path, tokens)
    file.read()
    path.write_bytes(content)
    for _ in range(2):
        with pytest.raises(BadTokens, match=why):
            file.read()
    assert account_of(tokens, "a") == "alice"


def test_a_file_that_is_gone_or_none_keeps_the_old_tokens(tmp_path: Path) -> None:
    path, tokens = tmp_path / "tokens", Tokens({})
    path.write_text(ALICE)
    file = TokenFile(path, tokens)
    file.read()
    path.unlink()
    with pytest.raises(FileNotFoundError):
        file.read()
    os.mkfifo(path)
    with pytest.raises(OSError, match="no regular file"):
        file.read()
    path.unlink()
    path.write_bytes(b"#" * (token_file.BYTES_MAX + 1))
    with pytest.raises(OSError, match="larger"):
        file.read()
    assert account_of(tokens, "a") == "alice"


@pytest.mark.parametrize("is_folder", [False, True])
async def test_the_server_follows_it_off_the_event_loop_and_complains_once(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    caplog: pytest.LogCaptureFixture,
    *,
    is_folder: bool,
) -> None:
    """Read a text that is no token, and the folder that a mount makes for no file."""
    monkeypatch.setattr(token_file, "LOOK_S", 0.01)
    caplog.set_level(logging.INFO, "proctor.tokens")
    path, tokens = tmp_path / "tokens", Tokens({})
    path.write_text(ALICE)
    readers: set[int] = set()
    right = token_file.read_bytes

    def read_bytes(path: Path) -> bytes:
        readers.add(threading.get_ident())
        return right(path)

    monkeypatch.setattr(token_file, "read_bytes", read_bytes)

    async def until(secret: str, account: str | None) -> None:
        await wait_in_loop(lambda: account_of(tokens, secret) == account)

    def put(text: str) -> None:
        """At once: a file that is written is empty for a moment."""
        new = path.with_name("new")
        new.write_text(text)
        new.replace(path)

    following = asyncio.create_task(TokenFile(path, tokens).follow())
    await until("a", "alice")
    if is_folder:
        path.unlink()
        path.mkdir()
    else:
        put("nonsense")
    await wait_in_loop(lambda: "cannot be used" in caplog.text)
    await asyncio.sleep(0.1)  # for complaints that must not come
    assert account_of(tokens, "a") == "alice"
    if is_folder:
        path.rmdir()
    put(BOB)
    await until("b", "bob")
    assert account_of(tokens, "a") is None
    complaints = [text for text in caplog.messages if "cannot be used" in text]
    # A folder may be replaced just then, when neither it nor the file is there.
    assert len(set(complaints)) == len(complaints) <= 1 + is_folder
    revoked = f"token {hash_of('a')[:12]} of alice revoked"
    await wait_in_loop(lambda: revoked in caplog.messages)
    following.cancel()
    assert threading.get_ident() not in readers


async def test_a_token_is_valid_at_once_and_wrong_ones_read_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect one reading for each change, however many wrong tokens are sent."""
    path, tokens = tmp_path / "tokens", Tokens({})
    path.write_text("")
    file, reads = TokenFile(path, tokens), list[Path]()
    file.read()
    right = token_file.read_bytes

    def read_bytes(path: Path) -> bytes:
        reads.append(path)
        return right(path)

    monkeypatch.setattr(token_file, "read_bytes", read_bytes)

    async def send(secret: str) -> str:
        try:
            return (await tokens.authenticate_again(f"Bearer {secret}", "read")).account
        except Refused:
            return ""

    assert set(await asyncio.gather(*map(send, ["x"] * 50))) == {""}
    assert reads == []
    for content, expected in [(ALICE, ["alice", ""]), (f"{BOB}\n", ["", "bob"])]:
        path.write_text(content)
        answers = await asyncio.gather(*map(send, ["a", "b", *["x"] * 50]))
        assert answers == [*expected, *[""] * 50]
    path.write_text("nonsense")
    assert await send("b") == await send("b") == "bob"
    path.unlink()
    assert await send("b") == "bob"
    assert len(reads) == 3


def test_a_reader_of_all_runs_is_no_account_to_the_views() -> None:
    tokens = Tokens.parse("host:read+read_all:h, alice:read:a")
    assert tokens.authenticate("Bearer h", "read").reader is None
    assert tokens.authenticate("Bearer a", "read").reader == "alice"
    with pytest.raises(Refused):
        tokens.authenticate("Bearer h", "run")


# --- the command ---


def test_a_token_is_added_listed_and_revoked(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "var" / "tokens"
    assert admin.main(["token", "list", "--file", str(path)]) == 0
    assert not capsys.readouterr().out
    assert admin.main(["token", "add", "alice", "--file", str(path)]) == 0
    printed = capsys.readouterr()
    secret = printed.out.strip()
    assert " of alice with the scopes read+run, shown this once" in printed.err
    assert "draw no film of a sealed episode" in printed.err
    assert path.stat().st_mode & 0o777 == 0o600
    assert secret not in path.read_text()
    tokens = Tokens({})
    TokenFile(path, tokens).read()
    assert account_of(tokens, secret) == "alice"
    scopes = ["--scopes", "read+read_all"]
    assert admin.main(["token", "add", "host", *scopes, "--file", str(path)]) == 0
    assert "film" not in capsys.readouterr().err, "the first token has changed it"
    assert admin.main(["token", "list", "--file", str(path)]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert [row[1:] for row in rows] == [
        ["read+run", "alice"],
        ["read+read_all", "host"],
    ]
    assert rows[0][0] == hash_of(secret)[:12]
    assert admin.main(["token", "revoke", rows[0][0], "--file", str(path)]) == 0
    TokenFile(path, tokens).read()
    assert account_of(tokens, secret) is None
    assert "host" in path.read_text()
    assert admin.main(["token", "revoke", "host", "--file", str(path)]) == 0
    assert "sha256=" not in path.read_text().partition("\n")[2]


@pytest.mark.parametrize(
    ("words", "why"),
    [
        (["token", "add", "a:b"], "cannot be an account"),
        (["token", "add", "alice", "--scopes", "write"], "write: expected read"),
        (["token", "add", "alice", "--scopes", "read_all"], "_all: expected read"),
        (["token", "add", "alice", "--scopes", "read:zz"], "read:zz: expected read"),
        (["token", "revoke", "unknown"], "no token has the id"),
    ],
)
def test_a_mistake_is_one_line_and_changes_nothing(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], words: list[str], why: str
) -> None:
    path = tmp_path / "tokens"
    path.write_text(ALICE + "\n")
    assert admin.main([*words, "--file", str(path)]) == 2
    error = capsys.readouterr().err
    assert why in error
    assert error.count("\n") == 1
    assert path.read_text() == ALICE + "\n"


def test_two_who_edit_at_once_lose_nothing(tmp_path: Path) -> None:
    path = tmp_path / "tokens"

    def add(number: int) -> None:
        with edited_lines(path) as lines:
            lines.append(f"a{number}:read:sha256={hash_of(str(number))}")

    threads = [threading.Thread(target=add, args=(n,)) for n in range(16)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(parse(path.read_bytes(), path)) == 16


def test_settings_that_are_wrong_are_one_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("PROCTOR_PORT", "x")
    assert admin.main(["token", "list"]) == 2
    error = capsys.readouterr().err
    assert error.startswith("proctor: bad settings: port: ")
    assert error.count("\n") == 1


# --- whose file it is ---


def test_a_file_is_restricted_to_its_owner_before_it_is_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, tokens = tmp_path / "tokens", Tokens({})
    path.write_text(ALICE)
    path.chmod(0o666)
    with monkeypatch.context() as patched:
        patched.setattr(token_file, "restrict", lambda _: None)  # of another owner
        with pytest.raises(BadTokens, match="can be written by others"):
            TokenFile(path, tokens).read()
    assert account_of(tokens, "a") is None
    TokenFile(path, tokens).read()
    assert path.stat().st_mode & 0o777 == 0o600
    assert account_of(tokens, "a") == "alice"


def test_an_edited_file_stays_where_it_is_with_its_mode(tmp_path: Path) -> None:
    path, link = tmp_path / "there" / "tokens", tmp_path / "tokens"
    path.parent.mkdir()
    path.write_text(ALICE)
    path.chmod(0o740)
    link.symlink_to(path)
    with edited_lines(link) as lines:
        lines.append(BOB)
    assert link.is_symlink()
    assert path.read_text() == f"{ALICE}\n{BOB}\n"
    assert path.stat().st_mode & 0o777 == 0o700


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_root_leaves_the_file_to_the_user_of_the_server(tmp_path: Path) -> None:
    user = 12345
    folder, path = tmp_path / "var", tmp_path / "var" / "tokens"
    folder.mkdir()
    os.chown(folder, user, user)
    assert admin.main(["token", "add", "alice", "--file", str(path)]) == 0
    lock = path.with_name("tokens.lock")
    assert [one.stat().st_uid for one in (path, lock)] == [user, user]
    os.chown(path, user + 1, user + 1)
    assert admin.main(["token", "revoke", "alice", "--file", str(path)]) == 0
    assert (path.stat().st_uid, path.stat().st_mode & 0o777) == (user + 1, 0o600)


@pytest.mark.parametrize(
    "words",
    [
        *(["token", "add", "alice"], ["token", "list"], ["token", "revoke", "alice"]),
        *(["keys", "list"], ["page"], ["db", "check"], ["db", "upgrade"]),
        *(["db", "backup", "copy"], ["backup", "copies"]),
    ],
    ids=" ".join,
)
def test_in_a_folder_of_no_server_nothing_is_made_or_listed(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    words: list[str],
) -> None:
    """A token that is made there is one that no server knows."""
    monkeypatch.chdir(tmp_path)
    assert admin.main(words) == 2
    printed = capsys.readouterr()
    assert not printed.out
    assert printed.err.startswith("proctor: there is no ")
    made = [path.suffix for path in tmp_path.rglob("*") if path.is_file()]
    assert set(made) <= {".lock"}


def test_a_token_of_no_server_is_refused_with_where_it_was_looked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert admin.main(["token", "add", "alice"]) == 2
    said = capsys.readouterr().err
    assert f"there is no {tmp_path / 'var' / 'proctor.sqlite'}, which" in said
    assert "with --file" in said
    monkeypatch.setenv("PROCTOR_TOKENS_FILE", str(tmp_path / "own"))
    assert admin.main(["token", "add", "alice"]) == 0
    assert "alice:" in (tmp_path / "own").read_text()
