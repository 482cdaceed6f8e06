"""The architecture page: its pictures are generated, and what it names exists."""

from __future__ import annotations

import ast
import re

import pytest

from tests.support.paths import ROOT
from tools import diagrams

PAGE = diagrams.PAGE.read_text()
STEPS = re.findall(r"^\| \d+ \| `([\w/.]+)` \| `([\w.]+)` \|", PAGE, re.MULTILINE)


def test_the_pictures_are_up_to_date() -> None:
    """`make docs` writes them."""
    assert diagrams.page(PAGE) == PAGE


def test_a_turn_takes_many_steps() -> None:
    assert len(STEPS) > 10


@pytest.mark.parametrize(("file", "name"), STEPS)
def test_a_step_of_the_turn_exists(file: str, name: str) -> None:
    body: list[ast.stmt] = ast.parse((ROOT / file).read_text()).body
    for part in name.split("."):
        found = [node for node in body if getattr(node, "name", None) == part]
        assert len(found) == 1, f"{file} has no {name}"
        body = getattr(found[0], "body", [])


def test_the_folders_of_the_server_are_listed() -> None:
    folders = {path.parent.name for path in diagrams.SERVER.glob("*/__init__.py")}
    assert folders == set(re.findall(r"^\| `(\w+)/` \| ", PAGE, re.MULTILINE)) - {
        path.name for path in ROOT.iterdir()
    }


def test_the_picture_shows_every_change_of_state() -> None:
    lifecycle = {
        "initial": "a",
        "states": ["a", "b", "c"],
        "transitions": [
            {"from": "a", "event": "go", "to": "b"},
            {"from": "a", "event": "stay", "to": "a"},
            {"from": "b", "event": "go", "to": "refused"},
            {"from": "b", "event": "back", "to": "a", "when": "retryable"},
            {"from": "a", "event": "stop_abort", "to": "c"},
        ],
    }
    assert diagrams.lifecycle_diagram(lifecycle).splitlines() == [
        "stateDiagram-v2",
        "    [*] --> a",
        "    a --> b: go",
        "    b --> a: back (retryable)",
        "    a --> c: stop_run abort",
        "    c --> [*]",
    ]


def test_imports_for_types_alone_are_not_drawn() -> None:
    source = (
        "import a\nif TYPE_CHECKING:\n    import b\ndef f():\n    from c import d\n"
    )
    assert diagrams.imports_of(source) == {"a", "c.d"}
