"""Helpers for tests of the command `proctor`: policies in files, and the command.

It runs in this process where only its answer matters, and as a program of its own where
signals do.
"""

import contextlib
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from reference_client.command.command_line.chosen_server import SERVERLESS_COMMANDS
from reference_client.command.main import main
from tests.support.paths import ROOT

POLICIES = '''
import os, pathlib, signal, time

SIZES = {"vector": 8, "clipped": 2}
NAMES = ("score", "success", "end", "delay_s", "fault", "vector", "clipped")


def action(**values):
    return {name: [values.get(name, 0.0)] * SIZES.get(name, 1) for name in NAMES}


class Graded:
    """Ends each episode in its second turn, with a score of the episode's number."""

    def reset(self, instruction):
        self.instruction = instruction

    def act(self, observation):
        score = int(observation.episode_id[1:]) % 5 / 4
        return [action(score=score, success=1.0, end=float(observation.step > 0))]


class Held(Graded):
    """Says that it acts, and goes on when there is a file `go`."""

    def act(self, observation):
        pathlib.Path(f"acting-{id(self)}-{os.getpid()}").touch()
        while not pathlib.Path("go").exists():
            time.sleep(0.01)
        return super().act(observation)


class HeldAtStepThree:
    """Executes three actions, the fourth with a file `go`, the rest with `go_on`."""

    def reset(self, instruction):
        pass

    def act(self, observation):
        if observation.step >= 3:
            pathlib.Path(f"acting-{id(self)}-{os.getpid()}").touch()
            needed = "go" if observation.step == 3 else "go_on"
            while not pathlib.Path(needed).exists():
                time.sleep(0.01)
        return action(success=1.0, end=float(observation.step == 5))


class BreaksAtStepThree(Graded):
    """Raises once at step 3, while there is no file `go`."""

    def act(self, observation):
        if observation.step == 3 and not pathlib.Path("go").exists():
            raise RuntimeError("out of memory")
        return action(success=1.0, end=float(observation.step == 5))


class Dies(Graded):
    """Kills its process in episode 2, once."""

    def act(self, observation):
        if int(observation.episode_id[1:]) == 2 and observation.step == 1:
            if not pathlib.Path("died").exists():
                pathlib.Path("died").touch()
                os.kill(os.getpid(), signal.SIGKILL)
        return super().act(observation)


class Always:
    """Kills its process at every call."""

    def reset(self, instruction):
        pass

    def act(self, observation):
        os.kill(os.getpid(), signal.SIGKILL)


class Wrong(Graded):
    def act(self, observation):
        print("about to go wrong")
        return 1 / 0


class Unmakeable:
    def __init__(self):
        raise RuntimeError("no such weights")


class NoReset:
    def act(self, observation):
        return []


def best(observation):
    return action(score=1.0, success=1.0, end=1.0)


answer = 42
'''


class Proctor:
    """The command in this process: its exit code, and what it has printed."""

    def __init__(self, url: str, capsys: pytest.CaptureFixture[str]) -> None:
        self.url = url
        self._capsys = capsys
        self.out = self.err = ""

    def __call__(self, *arguments: str) -> int:
        self._capsys.readouterr()
        server = [] if arguments[0] in SERVERLESS_COMMANDS else ["--url", self.url]
        code = main([*arguments[:1], *server, *arguments[1:]])
        self.out, self.err = self._capsys.readouterr()
        return code

    def json(self, *arguments: str) -> Any:
        """The one value that a script would read."""
        self.code = self(*arguments, "--json")
        return json.loads(self.out)


def options(*tasks: str, **more: Any) -> list[str]:
    """Flags of a run of the benchmark calibration."""
    text = json.dumps({"tasks": list(tasks), **more})
    return ["--benchmark", "calibration", "--options", text]


@contextlib.contextmanager
def start_proctor(
    policy_folder: Path, url: str, *arguments: str
) -> Iterator[subprocess.Popen[str]]:
    """`proctor` as a program in `here`; killed at the end if it still runs."""
    with (
        (policy_folder / "stderr").open("w") as stderr,
        subprocess.Popen(
            [sys.executable, "-m", "reference_client.command", *arguments],
            cwd=policy_folder,
            env=os.environ | {"PROCTOR_URL": url, "PYTHONPATH": str(ROOT)},
            stdout=subprocess.PIPE,
            stderr=stderr,
            text=True,
        ) as process,
    ):
        try:
            yield process
        finally:
            process.kill()
