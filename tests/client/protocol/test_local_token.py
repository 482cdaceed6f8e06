"""Which token is sent: the one given, the environment's, or that of a local server."""

from pathlib import Path

import pytest

from reference_client.protocol.local_token import find_token

URL = "http://127.0.0.1:8460"


@pytest.fixture
def link(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where a server at port 8460 names the file of its token."""
    monkeypatch.delenv("PROCTOR_TOKEN", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    link = tmp_path / "proctor" / "tokens" / "8460"
    link.parent.mkdir(parents=True)
    return link


def write_token(path: Path, mode: int = 0o600) -> None:
    path.touch(mode)
    path.chmod(mode)
    path.write_text("proctor_sesame\n")


def test_what_is_given_comes_first(link: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_token(link)
    assert find_token(URL) == "proctor_sesame"
    monkeypatch.setenv("PROCTOR_TOKEN", "of-the-environment")
    assert find_token(URL) == "of-the-environment"
    assert find_token(URL, "given") == "given"


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1", "127.0.0.9", "[::1]"])
def test_a_server_on_this_machine_is_known_by_its_port(link: Path, host: str) -> None:
    write_token(link.parent / "elsewhere")
    link.symlink_to(link.parent / "elsewhere")
    assert find_token(f"http://{host}:8460/") == "proctor_sesame"
    assert find_token(f"http://{host}:8461") is None


@pytest.mark.parametrize(
    "url",
    [
        "http://example.org:8460",
        "http://10.0.0.1:8460",
        "https://127.0.0.1:8460",
        "http://127.0.0.1:x",
        "http://",
        "8460",
    ],
)
def test_no_other_server_is_sent_the_token(link: Path, url: str) -> None:
    write_token(link)
    assert find_token(url) is None


@pytest.mark.parametrize("mode", [0o644, 0o620])
def test_a_file_that_others_can_use_holds_no_token(link: Path, mode: int) -> None:
    write_token(link, mode)
    assert find_token(URL) is None


def test_a_link_to_nothing_is_no_token(link: Path) -> None:
    link.symlink_to(link.parent / "nowhere")
    assert find_token(URL) is None
