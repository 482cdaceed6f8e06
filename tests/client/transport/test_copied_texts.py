"""Tokens and addresses as files, shells and clipboards hand them on."""

from collections.abc import Callable

import pytest
from proctor_client import ApiClient, Configuration
from proctor_client.transport.copied_text import BadToken, read_token
from proctor_client.transport.proxy_route import find_route
from proctor_client.transport.server_address import (
    check_base_url,
    url_of_host,
    without_user,
)
from proctor_client.transport.tls_trust import client_context

from reference_client.command.main import main
from reference_client.errors import ProctorError
from reference_client.gymnasium_env.remote_env import RemoteEnv
from reference_client.policies.serve_command import main as serve_policy
from reference_client.policies.servers.server_faults import key_of
from reference_client.protocol.credentials import find_credential

HERE = "http://robots.example"
TOKEN = "proctor_s3cret+/=="
AROUND = [
    *("{}\n", "{}\r\n", "  {}\t", "\ufeff{}", "{}\u200b", "\u2060{}\u00a0", '"{}"'),
    *("'{}'\n", "\u201c{}\u201d", "`{}`", '"{}\r\n"', "\x00{}", "\u202a{}\u202c"),
    *("Bearer {}", "bearer  {}\n", "Authorization: Bearer {}", "\u00ad{}", "{}\x1b"),
]


@pytest.mark.parametrize("around", AROUND)
def test_what_is_added_to_a_token_is_dropped(around: str) -> None:
    assert find_credential(HERE, around.format(TOKEN)).token == TOKEN
    configuration = Configuration(access_token=around.format(TOKEN))
    assert ApiClient(configuration).configuration.access_token == TOKEN


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("s3cret s3cret", "a space at position 7 of 13"),
        ("s3cret\ns3cret", r"an invisible character \(U\+000A\) at position 7"),
        ("s3cret\u200bs3cret", r"an invisible character \(U\+200B\) at position 7"),
        ("s3cr\u00e9t", "a character that is not ASCII at position 5 of 6"),
        ("\udcff\udcfes3cret", "a byte that is not UTF-8 at position 1"),
        ("\u2026", "a character that is not ASCII"),
    ],
)
def test_any_other_character_is_refused_and_no_token_shown(
    text: str, fault: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(BadToken, match=f"token of --token has {fault}"):
        read_token(text, "--token")
    assert main(["status", "--token", text, "--url", "http://127.0.0.1:1"]) == 2
    written = capsys.readouterr().err
    assert written.startswith("proctor: the token of ")
    assert (written.count("\n"), "s3cr" in written) == (1, False)


@pytest.mark.parametrize("text", ["", " ", '""', "\ufeff\r\n"])
def test_an_empty_token_is_none(text: str) -> None:
    assert read_token(text, "PROCTOR_TOKEN") is None


@pytest.mark.parametrize(
    ("given", "used"),
    [
        ("http://h:1/", "http://h:1"),
        (" 'https://h/base//'\r\n", "https://h/base"),
        ("http://[::1]:8460", "http://[::1]:8460"),
        ("http://b\u00fccher.example", "http://b\u00fccher.example"),
        ("HTTP://h", "HTTP://h"),
    ],
)
def test_an_address_is_taken_as_people_write_it(given: str, used: str) -> None:
    assert check_base_url(given) == used


@pytest.mark.parametrize(
    ("given", "fault"),
    [
        ("h:8460", "url must be like http://"),
        ("user:s3cret@h", "url must be like http://"),
        ("ftp://user:s3cret@h", "url must be like http://"),
        ("http://user:s3cret@h:1", "must not have a user and a password"),
        ("http://user:s3cret", "has an invalid port"),
        ("http://::1:8460", "without brackets: write http://"),
        ("http://[fe80::1%25eth0]:1", "names a network interface"),
        ("http://[fe80::1%eth0]:1", "names a network interface"),
        ("http://[fe80::1]:8731", "has a link-local address"),
        ("http://[h]:1", "invalid IPv6 address"),
        ("http://h:99999", "has an invalid port"),
        ("http://h:1 /x", "has an invalid port"),
        ("http://h/?token=s3cret", "ends with a query"),
        ("http:///x", "not a name or an address"),
        (f"http://{'a' * 70}\u00fc.example", "not a name or an address"),
        ("http://h/a b", "a space or an invisible character"),
    ],
)
def test_any_other_address_is_refused_in_a_sentence(given: str, fault: str) -> None:
    with pytest.raises(ValueError, match=fault) as refusal:
        check_base_url(given)
    text = str(refusal.value)
    assert ("\n" in text, "s3cret" in text) == (False, False)


@pytest.mark.parametrize(
    ("host", "port", "url"),
    [
        (None, 9000, "http://127.0.0.1:9000"),
        ("::1", None, "http://[::1]:8460"),
        ("[::1]", 1, "http://[::1]:1"),
        ("h\n", None, "http://h:8460"),
    ],
)
def test_a_host_and_a_port_make_an_address(
    host: str | None, port: int | None, url: str
) -> None:
    assert url_of_host(host, port) == url


@pytest.mark.parametrize(
    ("reference", "shown"),
    [
        ("openpi:ws://user:s3cret@h:1", "openpi:ws://h:1"),
        ("proctor:http://h/a@b", "proctor:http://h/a@b"),
        ("lerobot:folder@v1", "lerobot:folder@v1"),
    ],
)
def test_an_address_is_shown_without_its_user(reference: str, shown: str) -> None:
    assert without_user(reference) == shown


@pytest.mark.parametrize("empty", ["", " ", "\n", '""'])
@pytest.mark.parametrize(
    ("variable", "use"),
    [
        ("PROCTOR_TOKEN", lambda: find_credential(HERE)),
        ("PROCTOR_CA", client_context),
        ("PROCTOR_PROXY", lambda: find_route(HERE)),
        ("PROCTOR_POLICY_KEY", lambda: key_of("PROCTOR_POLICY_KEY")),
        ("PROCTOR_URL", lambda: RemoteEnv(benchmark="calibration")),
    ],
)
def test_a_variable_that_is_set_and_empty_is_refused(
    monkeypatch: pytest.MonkeyPatch,
    variable: str,
    use: Callable[[], object],
    empty: str,
) -> None:
    """$(cat FILE) is empty where the file is not there yet."""
    monkeypatch.setenv(variable, empty)
    expected = f"{variable} is set and empty: .*`unset {variable}`"
    with pytest.raises((ValueError, ProctorError), match=expected):
        use()


@pytest.mark.parametrize(
    ("line", "variable"),
    [
        ("status", "PROCTOR_URL"),
        ("status", "PROCTOR_TOKEN"),
        ("status --url https://robots.example", "PROCTOR_CA"),
        ("status", "PROCTOR_PROXY"),
        ("--policy p", "PROCTOR_POLICY_SOCKET"),
    ],
)
def test_no_command_goes_on_without_it(
    line: str,
    variable: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setenv(variable, "")
    program = main if line.startswith("status") else serve_policy
    assert program(line.split()) == 2
    assert capsys.readouterr().err == (
        f"proctor: {variable} is set and empty: give it a value, or `unset {variable}`"
        "\n"
    )


@pytest.mark.parametrize(
    "line",
    [
        "run --benchmark b --policy p --name=",
        "run --benchmark b --policy p --save=",
        "submit --benchmark b --name=",
        "results run_1 --save=",
        "export run_1 -o ",
        "status --url=",
        "status --token=",
    ],
)
def test_an_option_that_is_given_and_empty_is_refused(
    line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """As `--name "$MODEL"` gives it, where the variable is not set."""
    *before, last = line.split(" ")
    words = [*before, last] if last else [*before, ""]
    assert main(words) == 2
    flag = last.rstrip("=") or before[-1]
    said = capsys.readouterr().err
    assert f"{flag}: it is empty: give it a value, or leave it out" in said
