"""README is a promise: its program runs as pasted, its commands and places exist."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from conformance.specification.ledger import OF_OTHER_PROGRAMS, load_ledger
from tests.support.paths import ROOT
from tests.support.processes import run_program
from tests.support.servers import TOKENS, ReferenceServer

Done = subprocess.CompletedProcess[str]

pytestmark = pytest.mark.slow("starts servers")

README = (ROOT / "README.md").read_text()


def test_commands_stand_in_the_first_25_lines() -> None:
    """A new reader sees what to type before anything else."""
    beginning = "\n".join(README.splitlines()[:25])
    for target in ("conformance", "serve", "test"):
        assert f"make {target}" in beginning


def run_example(
    folder: Path, *arguments: str, added: str = "", **environment: str
) -> Done:
    """added: an argument of `evaluate` that the program does not have."""
    (program,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    program = program.replace("workers=2", f"workers=2{added}")
    assert len([line for line in program.splitlines() if line.strip()]) <= 20
    file = folder / "evaluate.py"
    file.write_text(program)
    return run_program(
        [sys.executable, file, *arguments],
        cwd=folder,
        env=os.environ | {"XDG_STATE_HOME": str(folder)} | environment,
        timeout=120,
    )


def test_program_says_what_it_needs(server: ReferenceServer, tmp_path: Path) -> None:
    """Neither the environment nor this machine has a token. Expect one line."""
    done = run_example(tmp_path, server.url)
    assert done.returncode == 1
    assert "Traceback" not in done.stderr
    assert "PROCTOR_TOKEN" in done.stderr


SOLVED = (
    "score val_train 1.0000, val_unseen 1.0000, test 1.0000; all splits mixed 1.0000\n"
)


@pytest.mark.parametrize(
    ("added", "says"),
    [
        ("", SOLVED),
        (
            ", episodes=3",
            "score partial, 3 of 64 episodes with mean val_train 1.0000, val_unseen –",
        ),
    ],
)
def test_program_evaluates_a_policy(
    server: ReferenceServer, tmp_path: Path, added: str, says: str
) -> None:
    """The program, copied, against a server. Expect the expert's score: 1 of 1."""
    done = run_example(tmp_path, server.url, added=added, PROCTOR_TOKEN=TOKENS["alice"])
    assert done.returncode == 0, done.stderr
    assert says in done.stdout


def test_the_sample_verdict_has_the_number_of_rules() -> None:
    """The rules that the kit judges servers by, without those of other programs."""
    (sample,) = re.findall(r"^\d+ MUST: .*$", README, re.MULTILINE)
    total, *outcomes = (int(number) for number in re.findall(r"\d+", sample))
    assert total == sum(
        rule.profile not in OF_OTHER_PROGRAMS for rule in load_ledger().values()
    )
    assert sum(outcomes) == total


def test_the_example_rule_stands_in_all_four_places() -> None:
    """`git grep PRED-002`, as README says it."""
    found = run_program(
        ["git", "grep", "--name-only", "PRED-002"], cwd=ROOT, check=True
    ).stdout.split()
    for place in ("spec/", "reference_server/", "conformance/", "tests/mutants/"):
        assert any(name.startswith(place) for name in found), place


def test_program_is_a_policy_file_too(server: ReferenceServer, tmp_path: Path) -> None:
    """The same file behind `--policy`, as README says. Expect one episode, solved."""
    (program,) = re.findall(r"```python\n(.*?)```", README, re.DOTALL)
    (tmp_path / "evaluate.py").write_text(program)
    assert "proctor run --policy evaluate.py:MyPolicy" in README
    flags = ["--benchmark", "tabletop_state", "--episodes", "1", "--json"]
    done = run_program(
        [
            *(sys.executable, "-m", "reference_client.command", "run"),
            *("--policy", "evaluate.py:MyPolicy", "--url", server.url, *flags),
        ],
        cwd=tmp_path,
        env=os.environ | {"PROCTOR_TOKEN": TOKENS["alice"], "PYTHONPATH": str(ROOT)},
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["counts"]["success"] == 1
