"""What the builds of Java and Kotlin download is what was checked."""

import re
from pathlib import Path

import pytest

from tests.interop.builds import maven_checksums
from tests.support.paths import ROOT

TEMPLATES = ROOT / "tools" / "generators" / "on_request"
POMS = {
    "java": TEMPLATES / "java" / "libraries" / "okhttp-gson" / "pom.mustache",
    "kotlin": TEMPLATES / "kotlin" / "pom.mustache",
}
OFFICIAL_PLUGINS = "org.apache.maven.plugins"
PIN = re.compile(
    r"<(?:dependency|plugin)>\s*(?:<groupId>([^<]+)</groupId>)?\s*"
    r"<artifactId>([^<]+)</artifactId>\s*<version>([^<]+)</version>"
)


SUMMARY = maven_checksums.read_summary(
    TEMPLATES.parent / "maven" / "checksums" / "checksums.sha256"
)


def pinned(language: str) -> list[str]:
    """Paths of the jars that the pom names with a version."""
    text = POMS[language].read_text()
    text = re.sub(r"\$\{([\w.]+)\}", lambda found: property_of(text, found[1]), text)
    paths = []
    for group, artifact, version in PIN.findall(text):
        folder = (group or OFFICIAL_PLUGINS).replace(".", "/")
        paths.append(f"{folder}/{artifact}/{version}/{artifact}-{version}.jar")
    return paths


def property_of(text: str, name: str) -> str:
    found = re.search(f"<{re.escape(name)}>([^<]+)<", text)
    assert found is not None, name
    return found[1]


@pytest.mark.parametrize("language", POMS)
def test_every_pinned_version_has_a_checksum(language: str) -> None:
    paths = pinned(language)
    assert len(paths) >= 7
    assert [path for path in paths if path not in SUMMARY] == []


def test_the_summary_is_what_sha256sum_writes() -> None:
    assert list(SUMMARY) == sorted(SUMMARY)
    assert all(re.fullmatch("[0-9a-f]{64}", digest) for digest in SUMMARY.values())
    assert all(re.fullmatch(r"[\w.+/-]+\.(jar|pom)", name) for name in SUMMARY)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    folder = tmp_path / "m2" / "org" / "a" / "1"
    folder.mkdir(parents=True)
    (folder / "_remote.repositories").write_text("# no origin\na-1.jar>central=\n")
    (folder / "a-1.jar").write_bytes(b"a")
    (folder / "a-1.jar.sha1").write_bytes(b"no download of interest")
    installed = tmp_path / "m2" / "mine"
    installed.mkdir()
    (installed / "_remote.repositories").write_text("mine-1.jar>=\n")
    (installed / "mine-1.jar").write_bytes(b"made here")
    return tmp_path / "m2"


def call(what: str, repository: Path) -> int:
    return maven_checksums.main([what, str(repository), str(summary_file(repository))])


def summary_file(repository: Path) -> Path:
    return repository.parent / "checksums.sha256"


def test_what_has_no_checksum_fails(
    repository: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("check", repository) == 1
    assert capsys.readouterr().err == "no checksum: org/a/1/a-1.jar\n"


def test_what_differs_fails_and_is_never_written_over(
    repository: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("write", repository) == 0
    assert call("check", repository) == 0
    before = summary_file(repository).read_text()
    assert before.endswith("  org/a/1/a-1.jar\n")
    (repository / "org" / "a" / "1" / "a-1.jar").write_bytes(b"b")
    assert call("write", repository) == 0
    assert summary_file(repository).read_text() == before
    assert call("check", repository) == 1
    assert "differs: org/a/1/a-1.jar" in capsys.readouterr().err


def test_an_empty_repository_is_right(tmp_path: Path) -> None:
    assert call("check", tmp_path / "none") == 0


def test_a_wrong_call_is_explained(capsys: pytest.CaptureFixture[str]) -> None:
    assert maven_checksums.main(["check"]) == 2
    assert "REPOSITORY" in capsys.readouterr().err
