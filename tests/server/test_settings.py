"""Settings: what each means, where it may come from, and docs/host/settings.md.

`python -m tests.server.test_settings` writes the page anew.
"""

import os
import re
import sys
import typing
from pathlib import Path
from typing import Any

import pytest
from annotated_types import Ge, Gt, Le
from pydantic import ValidationError
from pydantic.fields import FieldInfo

from reference_record.command_line.click_commands import WrongUsage
from reference_server.http.auth import BadTokens, Tokens, new_secret
from reference_server.rules.refusal import Refused
from reference_server.settings import Settings, describe_faults
from reference_server.settings.setting_options import (
    misspelled_variables,
    read_settings,
)
from tests.support.paths import ROOT

PAGE = ROOT / "docs" / "host" / "settings.md"
HEAD = """# Settings of the reference server

Each is a flag of `python -m reference_server` and a variable of its environment; where
both are given, the flag wins. Written by `python -m tests.server.test_settings` from
`reference_server/settings/`.

| name | flag | environment | default | values | meaning |
|---|---|---|---|---|---|
"""

# Of at least 64 KiB.
SIZES = (
    *("max_body_bytes", "max_control_body_bytes"),
    *("max_record_bytes", "max_imported_bytes"),
)


@pytest.mark.parametrize(
    ("flag", "unit"), [("--records-keep-days", "DAYS"), ("--turn-timeout-s", "SECONDS")]
)
def test_the_help_names_the_unit(
    flag: str, unit: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit):
        settings("--help")
    assert f"  {flag} {unit} " in capsys.readouterr().out


@pytest.mark.parametrize("columns", [40, 80])
def test_the_help_fits_the_terminal(
    columns: int, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    with pytest.raises(SystemExit):
        settings("--help")
    assert max(map(len, capsys.readouterr().out.splitlines())) <= columns


def values_of(field: FieldInfo) -> str:
    """What a setting may be, in words."""
    if typing.get_origin(field.annotation) is typing.Literal:
        return ", ".join(f"`{choice}`" for choice in typing.get_args(field.annotation))
    if field.annotation is str:
        return "text"
    words = ["whole number" if field.annotation is int else "number"]
    for bound in field.metadata:
        match bound:
            case Ge(ge=least):
                words.append(f"≥ {least}")
            case Gt(gt=least):
                words.append(f"> {least}")
            case Le(le=most):
                words.append(f"≤ {most}")
    return ", ".join(words)


def page() -> str:
    rows = []
    for name, field in Settings.model_fields.items():
        assert field.description, f"{name} has no description"
        cells = [
            f"`{name}`",
            f"`--{name.replace('_', '-')}`",
            f"`PROCTOR_{name.upper()}`",
            "–" if field.default == "" else f"`{field.default}`",
            values_of(field),
            field.description.replace("|", "\\|").replace("<", "\\<"),
        ]
        rows.append(f"| {' | '.join(cells)} |\n")
    return HEAD + "".join(rows)


def test_the_page_is_up_to_date() -> None:
    assert PAGE.read_text() == page(), (
        "python -m tests.server.test_settings writes it anew"
    )


@pytest.fixture(autouse=True)
def _empty_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in list(os.environ):
        if name.upper().startswith("PROCTOR_"):
            monkeypatch.delenv(name)


def settings(*flags: str) -> Settings:
    return read_settings(flags)


def test_words_are_benchmarks(monkeypatch: pytest.MonkeyPatch) -> None:
    """They are added to those of the flag, and replace those of the environment."""
    monkeypatch.setenv("PROCTOR_BENCHMARKS", "old.toml")
    assert settings().benchmarks == "old.toml"
    assert settings("a.py:A", "b.toml").benchmarks == "a.py:A,b.toml"
    assert settings("--benchmarks", "c.toml", "a.py:A").benchmarks == "c.toml,a.py:A"


@pytest.mark.parametrize(
    ("flags", "says"),
    [
        (["--profiles", "foo"], "profiles: unknown profile foo; there is ebench, flag"),
        (["--profiles", "flagevl"], "flagevl; did you mean flageval? There is ebench"),
        (["--profiles", "ebench,"], "profiles: unknown profile ; there is ebench"),
        (["--log-level", "debgu"], "log_level: unknown value debgu; did you mean "),
        (["--cluster", "maybe"], "cluster: unknown value maybe; there is off, on"),
        (["--prot", "1"], "unknown option --prot; did you mean --port?"),
        (["--port", "x"], "port: 'x' must be a valid integer"),
        (["--port"], "'--port' requires an argument; see proctor-server --help"),
    ],
)
def test_a_wrong_name_is_answered_with_those_that_there_are(
    flags: list[str], says: str
) -> None:
    with pytest.raises(WrongUsage, match=re.escape(says)):
        settings(*flags)


@pytest.mark.parametrize(
    ("others", "is_one"),
    [
        ({}, True),
        ({"host": "::1"}, True),
        ({"host": "0.0.0.0"}, False),  # noqa: S104
        ({"public_url": "https://eval.example.org"}, False),
        ({"tokens": "a:read:secret-of-alice"}, False),
        ({"tokens_file": "empty"}, True),
        ({"tokens_file": "tokens"}, False),
    ],
)
def test_a_server_for_one_person_has_made_the_only_token(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    others: dict[str, str],
    is_one: bool,
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("empty").touch()
    Path("tokens").write_text("a:read:sha256=00\n")
    assert Settings.model_validate(others).is_for_one_person is is_one


@pytest.mark.parametrize("name", Settings.model_fields)
def test_each_is_a_flag_and_a_variable_as_the_page_says(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    field = Settings.model_fields[name]
    examples: dict[str, tuple[str, str]] = {
        "public_url": ("http://a", "https://b"),
        "allowed_hosts": ("a.example", "*.b.example,c.example"),
        "trusted_proxies": ("10.0.0.1", "10.0.0.0/8,::1"),
        "log_level": ("info", "debug"),
        "log_format": ("json", "text"),
        "access_log": ("on", "off"),
        "public_board": ("on", "off"),
        "delete_played_runs": ("on", "off"),
        "allow_private_policies": ("127.0.0.1", "10.0.0.0/8,fd00::/8"),
        "profiles": ("ebench", "flageval,ebench"),
        "flageval_modes": ("NLP:Qnext=quiz", "MM:*=quiz,NLP:XLC_train=calibration"),
        "ebench_prefixes": ("/a", "/a,/b/c"),
        "pages": ("off", "off"),
        "films": ("off", "off"),
        "metrics": ("on", "on"),
        "traces_ratio": ("0.5", "1"),
        "traces_parent": ("all", "nodes"),
        "cluster": ("off", "off"),
        "simulators": ("local", "local"),
        "ray_resources": ("CPU=0.5", "CPU=1,GPU=0.25"),
        "records_storage": ("s3://bucket/a", "file:///tmp/b"),
        "node_url": ("http://10.0.0.1:8460", "http://b"),
        "recordings": ("off", "pictures"),
        "record_promise": ("exact", "exact"),
        "ebench_equal_steps": ("answer", "answer_chunks"),
        "record_imports": ("off", "off"),
        "failover": ("end", "end"),
        "known_keys": (f"A=SHA256:{'0' * 64}", f"B c=SHA256:{'a' * 64}"),
    }
    numbers = ("5", "6") if field.annotation in (int, float) else ("some", "other")
    by_variable, by_flag = examples.get(name, numbers)
    flag, variable = f"--{name.replace('_', '-')}", f"PROCTOR_{name.upper()}"
    if name in SIZES:
        by_variable, by_flag = "70000", "80000"
    if name == "max_connections":
        by_variable, by_flag = "50", "60"
    assert getattr(settings(), name) == field.default
    monkeypatch.setenv(variable, by_variable)
    assert str(getattr(settings(), name)).removesuffix(".0") == by_variable
    assert str(getattr(settings(flag, by_flag), name)).removesuffix(".0") == by_flag


# Empty they mean "none".
MAY_BE_EMPTY = {"trusted_proxies", "ebench_prefixes"}


@pytest.mark.parametrize("name", Settings.model_fields)
def test_an_empty_variable_never_means_something_else_than_the_default(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a file of settings has it whose own variable is not set."""
    monkeypatch.setenv(f"PROCTOR_{name.upper()}", "")
    if Settings.model_fields[name].default == "" or name in MAY_BE_EMPTY:
        assert getattr(settings(), name) == ""
    else:
        with pytest.raises(WrongUsage, match=f"{name}: "):
            settings()


@pytest.mark.parametrize("name", Settings.model_fields)
def test_characters_that_are_not_seen_are_refused_and_named(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By a variable and by a flag, whatever the setting; the value is not repeated."""
    value = "\x1bsesame"
    with pytest.raises(WrongUsage) as refused:
        settings(f"--{name.replace('_', '-')}={value}")
    monkeypatch.setenv(f"PROCTOR_{name.upper()}", value)
    with pytest.raises(WrongUsage) as refused_too:
        settings()
    assert str(refused_too.value) == str(refused.value)
    assert f"{name}: it has '\\x1b', which means nothing here" in str(refused.value)
    assert "sesame" not in str(refused.value)


@pytest.mark.parametrize("written", ["{}\r", "{}\r\n", " {}\n", "{} "])
def test_blanks_and_line_ends_around_a_value_are_not_part_of_it(
    written: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As files of settings, of another system too, and mounted secrets have them."""
    for name, value in (("database", "here.db"), ("port", 8461), ("metrics", "on")):
        monkeypatch.setenv(f"PROCTOR_{name.upper()}", written.format(value))
        assert getattr(settings(), name) == value


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("PROCTOR_METRIC", "metrics"),
        ("PROCTOR_MAX_SIMULATOR", "max_simulators"),
        ("PROCTOR_RECORD_KEEP_DAYS", "records_keep_days"),
        ("PROCTOR_SEALING", "sealing_key"),
        ("proctor_databse", "database"),
    ],
)
def test_a_mistyped_variable_is_named(name: str, meant: str) -> None:
    others = "PATH", f"PROCTOR_{meant.upper()}", "PROCTOR_UNLIKE_ANY"
    (said,) = misspelled_variables([name, *others])
    assert said.startswith(f"{name.upper()} has no effect: there is no setting ")
    assert said.endswith(f"did you mean {meant}?")


def test_the_variables_of_other_programs_are_not_mistyped() -> None:
    folders = ("reference_*", "generated_clients/python", "conformance", "examples")
    files = [file for name in folders for file in ROOT.glob(f"{name}/**/*.py")]
    text = "".join(file.read_text() for file in files)
    assert list(misspelled_variables(re.findall("PROCTOR_[A-Z_]+[A-Z]", text))) == []


@pytest.mark.parametrize(
    ("name", "bad"),
    [
        ("port", -1),
        ("port", 65536),
        ("max_workers", 0),
        ("max_workers", 1025),
        ("max_active_runs", 0),
        ("max_simulators", 0),
        ("spare_simulators", -1),
        ("simulators", "ray://head"),
        ("simulators", "kubernetes"),
        ("ray_resources", ""),
        ("ray_resources", "CPU"),
        ("ray_resources", "CPU=-1"),
        ("ray_resources", "CPU=nan"),
        ("ray_resources", "CPU=1.5"),
        ("turn_timeout_s", 0),
        ("turn_timeout_s", float("inf")),
        ("idle_timeout_s_max", 0.9),
        ("idle_timeout_s_max", float("inf")),
        ("idle_timeout_s_max", float("nan")),
        ("wait_s_max", 601),
        ("max_body_bytes", 65535),
        ("max_control_body_bytes", 65535),
        ("max_idempotency_keys", 0),
        ("max_stored_bytes", 0),
        ("max_chunk", 3),
        ("max_chunk", 4097),
        ("ebench_prefixes", "eval"),
        ("ebench_prefixes", "/eval/"),
        ("ebench_max_chunk", 0),
        ("ebench_max_attempts", -1),
        ("ebench_equal_steps", "repeat"),
        ("traces_ratio", 1.1),
        ("traces_ratio", -0.1),
        ("traces_ratio", float("nan")),
        ("log_level", "nonsense"),
        ("public_url", "example.org"),
        ("allow_private_policies", "10.0.0.1/8"),
        ("profiles", "ebench,"),
        ("flageval_modes", "Qnext=quiz"),
        ("flageval_modes", "Audio:Qnext=quiz"),
        ("flageval_modes", "NLP:Qnext=Quiz"),
        ("flageval_modes", "NLP:Qnext=quiz,NLP:Qnext=other"),
        ("flageval_account", "a b"),
    ],
)
def test_a_setting_has_bounds(name: str, bad: Any) -> None:
    with pytest.raises(ValidationError) as caught:
        Settings(**{name: bad})
    assert [fault["loc"] for fault in caught.value.errors()] == [(name,)]


@pytest.mark.parametrize(
    ("chosen", "sentence"),
    [
        ({"port": "x"}, "port: 'x' must be a valid integer"),
        ({"port": -1}, "port: -1 must be greater than or equal to 0"),
        ({"log_level": "x"}, "log_level: unknown value x; there is critical, "),
        ({"public_url": "example.org"}, "public_url: 'example.org' does not fit; it "),
        ({"profiles": "foo"}, "profiles: unknown profile foo; there is ebench"),
        ({"ray_resources": "CPU"}, "ray_resources: 'CPU' is not NAME=AMOUNT"),
        ({"known_keys": "k" * 999}, "…"),
        (
            {"database": ""},
            "database: it is set and empty; leave it out for the default, var/proctor.",
        ),
        ({"database": "mysql://a:secret@b/c"}, "database: mysql://… is neither the "),
        ({"database": "sqlite:///x"}, "an SQLite file nor postgresql://…"),
        *(
            ({"recordings": "off", name: "on"}, f"{name} on needs recordings, which")
            for name in ("record_imports", "public_board")
        ),
        ({"max_control_body_bytes": 2**24}, "max_control_body_bytes (16777216) cannot"),
        (
            {"failover": "replay", "recordings": "off"},
            "failover replay needs recordings",
        ),
        ({"database": ":memory:"}, "a database in memory keeps nothing: name a file"),
        (
            {"flageval_account": "a", "public_url": "http://a"},
            "flageval_account needs a loopback host and no public_url",
        ),
    ],
)
def test_settings_that_are_wrong_or_contradict_are_sentences(
    chosen: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(ValidationError) as caught:
        Settings(**chosen)
    text = describe_faults(caught.value)
    assert sentence in text
    assert not re.search(r"Value error|Input should|\n|^:|\^\(", text), text
    assert len(text) < 400


def test_on_ray_there_are_spares_only_if_they_were_wanted() -> None:
    assert settings().spares == 2
    assert settings("--simulators", "ray", "--recordings", "off").spares == 0
    wanted = settings("--simulators=ray", "--recordings=off", "--spare-simulators=2")
    assert wanted.spares == 2


@pytest.mark.parametrize(
    "other",
    [{"host": "0.0.0.0"}, {"host": "eval.example"}, {"public_url": "http://a"}],  # noqa: S104
)
def test_an_account_without_token_is_for_this_machine_alone(
    other: dict[str, str],
) -> None:
    for host in ("127.0.0.1", "::1", "localhost"):
        assert Settings(host=host, flageval_account="local").flageval_account
    with pytest.raises(ValidationError, match="needs a loopback host"):
        Settings(flageval_account="local", **other)  # type: ignore[arg-type]


def test_nodes_that_record_share_a_folder_and_a_key() -> None:
    """Beside an SQLite file both are found by themselves; elsewhere they are named."""
    assert Settings(cluster="on").recordings == "actions"
    cluster: dict[str, Any] = {"cluster": "on", "database": "postgresql://host/name"}
    cluster |= {"tokens": "a:run:t", "sealing_key": "key", "seed_secret": "seeds"}
    shared: dict[str, Any] = {"records_dir": "/shared", "signing_key": "signing-key"}
    assert Settings(**cluster, **shared).records_dir
    assert Settings(**cluster, recordings="off").records_dir == ""
    for name, value in shared.items():
        with pytest.raises(ValidationError, match="needs records_dir, a folder that"):
            Settings(**cluster, **{name: value})


@pytest.mark.parametrize("host", ["0.0.0.0", "::"])  # noqa: S104
def test_a_node_on_every_address_is_given_the_url_of_one(host: str) -> None:
    cluster: dict[str, Any] = {"cluster": "on"}
    assert Settings(**cluster).cluster == "on"
    given = Settings(**cluster, host=host, node_url="http://10.0.0.1:8460")
    assert given.node_url is not None
    with pytest.raises(ValidationError, match="needs node_url: set it to"):
        Settings(**cluster, host=host)


@pytest.mark.parametrize(
    ("database", "url"),
    [
        ("var/x.sqlite", "sqlite:///var/x.sqlite"),
        ("/tmp/x.sqlite", "sqlite:////tmp/x.sqlite"),  # noqa: S108
        ("postgresql+asyncpg://host/name", "postgresql+asyncpg://host/name"),
    ],
)
def test_a_database_is_a_path_or_a_url(database: str, url: str) -> None:
    assert Settings(database=database).database_url == url


def test_keys_of_a_server_with_postgresql_are_files() -> None:
    settings = Settings(database="postgresql://host/name")
    files = (
        *(settings.token_path, settings.tokens_file_path, settings.sealing_key_path),
        *(settings.seed_secret_path, settings.signing_key_path),
    )
    endings = ("token", "tokens", "key", "seeds", "signing-key")
    assert files == tuple(Path(f"var/postgresql.{one}") for one in endings)
    assert settings.records_path == Path("var/records")


# --- tokens ---


def caller(tokens: Tokens, header: str | None, scope: str = "read") -> str:
    """The account that a header stands for, or the code of the refusal."""
    try:
        return tokens.authenticate(header, scope).account
    except Refused as refused:
        return refused.code


def test_tokens_have_accounts_and_scopes() -> None:
    tokens = Tokens.parse("alice:read+run:a:b, bob:read:c,")
    assert caller(tokens, "Bearer a:b", "run") == "alice"
    assert caller(tokens, "bearer  c") == "bob"
    assert caller(tokens, "Bearer c", "run") == "forbidden"


@pytest.mark.parametrize(
    "header", [None, "", "Bearer", "Bearer ", "Bearer x", "Basic c", "c", "Bearer c c"]
)
def test_other_credentials_are_refused(header: str | None) -> None:
    tokens = Tokens.parse("bob:read:c")
    assert caller(tokens, header) == "unauthenticated"


def test_a_token_may_be_given_as_its_hash() -> None:
    # Of the secret "c", by sha256sum.
    hashed = "2e7d2c03a9507ae265ecf5b5356885a53393a2029d241394997265a1a25aefc6"
    for form in (hashed, hashed.upper()):
        tokens = Tokens.parse(f"bob:read:sha256={form}")
        assert caller(tokens, "Bearer c") == "bob"
        assert caller(tokens, f"Bearer {form}") == "unauthenticated"
        assert caller(tokens, f"Bearer sha256={form}") == "unauthenticated"


def test_a_fresh_token_can_do_everything_and_is_new_each_time() -> None:
    secret = new_secret()
    tokens = Tokens.of_local_account(secret)
    assert caller(tokens, f"Bearer {secret}", "run") == "local"
    assert new_secret() != secret


def test_secrets_are_not_kept() -> None:
    tokens = Tokens.parse("alice:read:the-secret")
    assert "the-secret" not in repr(vars(tokens))


@pytest.mark.parametrize(
    "text",
    [
        *(",", "alice", "alice:read", "alice:read:", ":read:x", "alice::x"),
        *("alice:all:x", "alice:read+:x", "alice:read:x, :"),
        *("alice:read:sha256=12", "alice:read:sha256="),
    ],
)
def test_invalid_tokens_are_an_error(text: str) -> None:
    with pytest.raises(BadTokens, match="tokens"):
        Tokens.parse(text)


if __name__ == "__main__":
    PAGE.write_text(page())
    sys.exit()
