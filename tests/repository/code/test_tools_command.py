"""The commands of `python -m tools`: each calls the `main` of its module."""

import importlib
import inspect

import pytest

from tools.__main__ import make_parser

COMMANDS = {
    "generate": [],
    "traceability": ["--release-ids"],
    "diagrams": [],
    "vectors": [],
    "site": [],
    "lock": ["--upgrade"],
    "dist": ["--clients", "folder"],
    "interop": [],
    "false-alarms": ["-j", "2", "--", "--quick"],
    "both-ways": ["push_t"],
    "experts": ["tabletop", "--draw"],
    "cluster": ["--nodes", "3"],
}


@pytest.mark.parametrize("command", COMMANDS)
def test_the_options_are_what_the_command_takes(command: str) -> None:
    chosen = vars(make_parser().parse_args([command, *COMMANDS[command]]))
    module = importlib.import_module(chosen.pop("module"))
    inspect.signature(module.main).bind(**chosen)


def test_every_command_is_listed(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        make_parser().parse_args(["--help"])
    listed = capsys.readouterr().out
    assert all(f"    {command}" in listed for command in COMMANDS)
