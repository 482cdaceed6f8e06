"""Generators leave clean clients, and our own files beside them untouched.

That the committed files are what the generators write is `make generate-check`; that
the clients work is tests/interop.
"""

from pathlib import Path

import pytest

from tests.interop.builds import build_steps
from tests.interop.clients import LANGUAGES
from tools import generate

CLIENTS = generate.ROOT / generate.CLIENTS
LINES_MAX = 11_000  # of all clients, with what is written on top of them
NAMES = [config.stem for config in generate.CONFIGS]
REQUESTED = sorted(config.stem for config in generate.ON_REQUEST.glob("*.yaml"))
DEBRIS = [*("GIT_USER_ID", "GIT_REPO_ID", "repo1.maven"), "Build date"]
DEBRIS += ["openapitools.client"]


def test_every_configuration_has_its_client_and_its_readme() -> None:
    assert {path.name for path in CLIENTS.iterdir() if path.is_dir()} == set(NAMES)
    for name in NAMES:
        readme = (CLIENTS / name / "README.md").read_text()
        assert readme.startswith("# ")
        assert "```" in readme, "a first request"


def test_the_clients_are_lean() -> None:
    built = generate.NOT_GENERATED - {"example", "interop"}
    files = [p for p in CLIENTS.rglob("*") if p.is_file() and not built & set(p.parts)]
    assert sum(len(p.read_bytes().splitlines()) for p in files) < LINES_MAX


@pytest.mark.parametrize("name", NAMES)
def test_a_client_holds_no_debris(name: str) -> None:
    files = [p for p in generate.generated(generate.ROOT) if p.parts[1] == name]
    expect_no_debris([generate.ROOT / path for path in files])


def expect_no_debris(files: list[Path]) -> None:
    assert len(files) > 5
    assert not [p for p in files if p.name in (".travis.yml", "git_push.sh", "gradlew")]
    for path in files:
        assert not [word for word in DEBRIS if word in path.read_text()], path


@pytest.mark.release("whether clients that are not committed hold debris")
@pytest.mark.slow("runs the generator")
@pytest.mark.parametrize("language", REQUESTED)
def test_a_client_on_request_is_clean(language: str, tmp_path: Path) -> None:
    """Expect a README with a first request, and our own programs beside the client."""
    build_steps.write_client(language, tmp_path / "client")
    client, programs = tmp_path / "client", generate.PROGRAMS / language
    written = files_of(client)
    assert files_of(programs) <= written
    expect_no_debris([client / name for name in written - files_of(programs)])
    readme = (client / "README.md").read_text()
    assert readme.startswith("# ")
    assert "```" in readme


def files_of(folder: Path) -> set[Path]:
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def test_what_we_write_on_top_is_not_generated() -> None:
    found = generate.generated(generate.ROOT)
    assert Path("generated_clients/cpp/api/ControlApi.cpp") in found
    ours = ("example", "interop", "Cargo.lock", "package-lock.json")
    assert not [path for path in found if set(ours) & set(path.parts)]


def test_the_address_that_is_written_by_hand_is_that_of_the_specification() -> None:
    (server,) = generate.read_document()["servers"]
    for path in ("python/proctor_client/configuration.py", "typescript/src/runtime.ts"):
        assert server["url"] in (CLIENTS / path).read_text(), path


def test_a_patch_that_finds_nothing_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "a.rs").write_text("one two\n")
    patch = {"file": "*.rs", "find": "two", "replace": "three"}
    generate.tidy(tmp_path, [], [patch])
    assert (tmp_path / "a.rs").read_text() == "one three\n"
    with pytest.raises(generate.GenerationError, match="finds nothing"):
        generate.tidy(tmp_path, [], [patch])


def test_what_replaces_a_match_may_name_its_groups(tmp_path: Path) -> None:
    (tmp_path / "a.ts").write_text("read(Run)\nread(Turn)\n")
    patch = {"file": "*.ts", "pattern": r"read\((\w+)\)", "replace": r"check(\1)"}
    literal = {"file": "*.ts", "find": "check(Turn)", "replace": r"check(\1)"}
    generate.tidy(tmp_path, [], [patch, literal])
    assert (tmp_path / "a.ts").read_text() == "check(Run)\ncheck(\\1)\n"


def test_what_is_generated_refuses_no_member() -> None:
    closed = {"type": "object", "additionalProperties": False, "properties": {"a": {}}}
    opened = generate.with_open_messages({"schemas": [closed]})
    assert opened == {"schemas": [{"type": "object", "properties": {"a": {}}}]}
    kept = {"additionalProperties": {"type": "string"}}
    assert generate.with_open_messages(kept) == kept


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("", "name a language, such as LANGUAGE=go"),
        ("klingon", "no client in"),
        ("../swift", "no client in"),
    ],
)
def test_an_unknown_language_leaves_everything_as_it_was(
    name: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(generate, "REQUESTED", tmp_path)
    monkeypatch.setattr(generate, "run", lambda *_: "swift6,php\n")
    (tmp_path / "kept").touch()
    with pytest.raises(generate.GenerationError, match=said):
        generate.write_requested_client(name)
    assert [path.name for path in tmp_path.iterdir()] == ["kept"]


def test_a_folder_with_files_is_left_as_it_was(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(generate, "run", lambda *_: "php\n")
    (tmp_path / "kept").touch()
    with pytest.raises(generate.GenerationError, match="not an empty folder"):
        generate.write_requested_client("php", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["kept"]


def test_languages_on_request_are_not_committed() -> None:
    """Expect the proven ones among them to be generated for their build."""
    proven = {language.name for language in LANGUAGES if language.on_request}
    assert set(REQUESTED) == {"csharp", "swift"} | proven
    assert not set(REQUESTED) & set(NAMES)


def test_tidying_drops_files_and_makes_white_space_uniform(tmp_path: Path) -> None:
    (tmp_path / ".openapi-generator").mkdir()
    (tmp_path / "a.go").write_text("x  \n\n\n")
    (tmp_path / "go.sum").write_text("y")
    generate.tidy(tmp_path, ["go.sum"], [])
    assert [path.name for path in tmp_path.iterdir()] == ["a.go"]
    assert (tmp_path / "a.go").read_text() == "x\n"
