"""docs/evaluate/command.md is a promise: its lines run as pasted, its flags are all."""

import re
import shlex
from pathlib import Path

import click
import pytest

from reference_client.command.command_line import aliases
from reference_client.command.command_line.arguments import build_command
from tests.support.client.command import Proctor
from tests.support.client.direct_client import DirectClient
from tests.support.paths import ROOT
from tests.support.servers import ReferenceServer

PAGE = (ROOT / "docs" / "evaluate" / "command.md").read_text()
LINES = [
    line
    for block in re.findall(r"```console\n(.*?)```", PAGE, re.DOTALL)
    for line in block.splitlines()
]
# Calibration is played in no time; the page shows what people evaluate on.
HOLD = """
import policies

def hold(observation):
    assert observation.state
    return policies.action(score=1.0, success=1.0, end=1.0)
"""


def flags_of(command: click.Command) -> set[str]:
    options = [p for p in command.params if isinstance(p, click.Option)]
    return {name for p in options for name in p.opts if name.startswith("--")}


def test_every_command_and_flag_is_on_the_page() -> None:
    """Expect each by its full name; and no other flag than gmp's on the page."""
    program = build_command()
    flags = {"--help", *flags_of(program)}
    for name, command in program.commands.items():
        assert any(line.startswith(f"proctor {name}") for line in LINES), name
        flags |= flags_of(command)
    mentioned = set(re.findall(r"--[a-z][a-z_-]*", PAGE))
    assert flags - mentioned - {"--help"} == set()
    undocumented = {flag.replace("_", "-") for flag in mentioned} - flags
    assert undocumented == (aliases.FLAGS.keys() | aliases.IGNORED_FLAGS.keys())


def test_gmp_commands_are_on_the_page() -> None:
    for there, here_ in aliases.FLAGS.items():
        row = f"| `{there.replace('-', '_').replace('__', '--', 1)}` | `{here_}` |"
        assert row in PAGE
    for words, command in aliases.COMMANDS.items():
        assert f"| `gmp {' '.join(words)}` | `proctor {' '.join(command)}` |" in PAGE


def test_the_exit_codes_are_on_the_page() -> None:
    codes = re.findall(r"^\| ([0-9, ]+) \|", PAGE, re.MULTILINE)
    assert codes == ["0", "1", "2", "130, 143", "141"]


def test_every_command_of_the_page_runs(
    server: ReferenceServer, policy_folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """In the order of the page; RUN is a run that the page has submitted. Expect exit
    codes as the page has them: 1 from a partial score alone."""
    (policy_folder / "hold.py").write_text(HOLD)
    proctor = Proctor(server.url, capsys)
    run_id = ""
    codes: list[int] = []
    for line in LINES:
        words = shlex.split(line)[1:]
        if words[0] in (*aliases.PASS_THROUGH_COMMANDS, "login"):
            # Programs of their own, started in test_proctor_command_run; and a login,
            # which a person confirms in tests/platform/test_journey_in_browser.
            continue
        if words[0] == "video" or (words[0] == "export" and "--to" in words):
            continue  # the same, started in test_export_commands
        if "--watch" in words:
            # Stopped by draining, so over: but not completed.
            assert proctor(*_replace_names(words, run_id)) == 1
            continue
        if "RUN" in words and not run_id:
            run_id = _submit_run(server)
        if words[0] == "export":  # of a run that the page has played to its end
            run_id = proctor.json("status", "--state", "completed")[0]["run_id"]
        if words[0] == "submit":
            run_id = proctor.json(*_replace_names(words, run_id))["run_id"]
            assert proctor.code == 0
            continue
        if "BEST" in words:  # a run that the page has played to its end
            best = proctor.json("status", "--state", "completed")[0]["run_id"]
            words = [best if word == "BEST" else word for word in words]
        words = [server.url if word == "URL" else word for word in words]
        codes.append(proctor(*_replace_names(words, run_id)))
        if codes[-1] != 0:
            # The run is not complete: no whole score, and nothing to release.
            assert words[0] in ("results", "compare"), (line, proctor.err)
    assert codes.count(1) == 4
    assert len(codes) >= 12


def _replace_names(words: list[str], run_id: str) -> list[str]:
    exchanged = {"tabletop_state": "calibration", "RUN": run_id}
    exchanged |= {"val_train": "even", "lift_cube": "score"}
    rate = '{"control_rate_hz": 20}'
    exchanged[rate] = '{"control_rate_hz": 10}'
    return [exchanged.get(word, word) for word in words]


def _submit_run(server: ReferenceServer) -> str:
    with DirectClient(server.url) as direct:
        return direct.submit("score", "score").run_id
