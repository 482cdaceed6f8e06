"""The versions of the protocol and of the software stand in one place each."""

import re
import tomllib

import pytest
import yaml

from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_server.http.handlers import SOFTWARE_VERSION
from tests.support.paths import ROOT, SPEC
from tests.support.repository.specification import DOCUMENT

VERSION = DOCUMENT["info"]["version"]


@pytest.mark.parametrize(
    "document",
    ["policy.yaml", *(f"profiles/{p.name}" for p in SPEC.glob("profiles/*.yaml"))],
)
def test_all_documents_have_one_version(document: str) -> None:
    assert yaml.safe_load((SPEC / document).read_text())["info"]["version"] == VERSION


def test_server_and_client_speak_the_version_of_the_specification() -> None:
    assert VERSION.rpartition(".")[0] == PROTOCOL_VERSION


def test_the_server_has_the_version_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert project["version"] == SOFTWARE_VERSION


def test_no_generator_has_a_version_of_its_own() -> None:
    found = [
        str(path.relative_to(ROOT))
        for path in (ROOT / "tools" / "generators").rglob("*.yaml")
        if re.search(r"(package|artifact|npm)Version:", path.read_text())
    ]
    assert found == []
