"""Policies in files of Python: what a file that cannot be loaded is refused with."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from reference_client.policies import policy_loader
from reference_client.policies.error_origin import describe_policy_error


@pytest.mark.parametrize(
    ("folder", "file", "named"),
    [
        (".", "lab/arm.py", "--policy lab.arm:NAME."),
        ("lab", "arm.py", "--policy lab.arm:NAME in the folder {}."),
        ("elsewhere", "../lab/arm.py", "--policy lab.arm:NAME in the folder {}."),
    ],
)
def test_a_file_of_a_package_is_named_as_a_module(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, folder: str, file: str, named: str
) -> None:
    for made in ("lab", "elsewhere"):
        (tmp_path / made).mkdir()
    (tmp_path / "lab" / "arm.py").write_text("from .weights import LOADED\n")
    monkeypatch.setattr(sys, "path", [*sys.path])
    monkeypatch.chdir(tmp_path / folder)
    with pytest.raises(ImportError) as raised:
        policy_loader.load(f"{file}:Arm")
    assert describe_policy_error(raised.value) == (
        "The policy raised ImportError: attempted relative import with no known parent "
        "package (arm.py:1). A file that imports from its own package is named as a "
        f"module of it: {named.format(tmp_path)}"
    )
