"""`proctor run`: workers in processes, and how an evaluation ends, as a program.

Signals, deaths and restarts happen while a policy is held, so nothing depends on time.
"""

from __future__ import annotations

import importlib.util
import json
import re
import shlex
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NoReturn

import pytest

from reference_client.command.main import main
from tests.conftest import descendants, until_none_lives
from tests.proctor_scenes import (
    PATIENCE_S,
    Proctor,
    here,
    options,
    server,
    started,
    until,
)
from tests.test_reference_client_scenes import House, ServerProcess

__all__ = ["here", "server"]
pytestmark = pytest.mark.usefixtures("here")
RESUME = re.compile(r"^  (proctor run .*)$", re.MULTILINE)
HELD = ["run", "--policy", "policies:Held"]


@pytest.fixture
def proctor(server: ServerProcess, capsys: pytest.CaptureFixture[str]) -> Proctor:
    return Proctor(server.url, capsys)


@pytest.fixture
def house(server: ServerProcess) -> Iterator[House]:
    with House(server.url) as house:
        yield house


def acting(here: Path) -> int:
    return len(list(here.glob("acting-*")))


def said(here: Path) -> str:
    return (here / "stderr").read_text()


def ended(process: subprocess.Popen[str]) -> tuple[int, str]:
    out, _ = process.communicate(timeout=PATIENCE_S)
    return process.returncode, out


def test_processes_score_as_threads_do(proctor: Proctor) -> None:
    """The same policy and episodes, in a process each. Expect the same score."""
    run = ["run", "--policy", "policies.py:Graded", *options(*["score"] * 6)]
    threads = proctor.json(*run, "--workers", "2")
    processes = proctor.json(*run, "--workers", "2", "--processes")
    assert processes["score"] == threads["score"] == pytest.approx(2.5 / 6)
    assert proctor.code == 0


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_policy_that_raises_is_told_in_one_line(
    proctor: Proctor, processes: list[str]
) -> None:
    """Expect its file and line, how it goes on, and no traceback."""
    run = ["run", "--policy", "policies:Wrong", *options("count"), *processes]
    told = proctor.json(*run)
    assert proctor.code == 1
    where = r"ZeroDivisionError: division by zero \(policies.py:\d+\)"
    assert re.search(where, told["error"]["detail"])
    assert "Traceback" not in proctor.err
    assert told["resume"].startswith(f"proctor run --run-id {told['run_id']} --policy")


def test_debug_shows_where_a_policy_raises(proctor: Proctor) -> None:
    proctor("run", "--policy", "policies:Wrong", *options("count"), "--debug")
    assert "return 1 / 0" in proctor.err


def test_ctrl_c_detaches_and_says_how_to_go_on(
    server: ServerProcess, house: House, here: Path
) -> None:
    """Both workers think when it comes. Expect 130, no session left, and that the
    command which is printed completes the run."""
    tasks = options(*["count"] * 3)
    flags = ["--workers", "2", "--processes"]
    with started(here, server.url, *HELD, *tasks, *flags) as process:
        until(lambda: acting(here) == 2, "both workers act")
        run_id = house.latest().run_id
        process.send_signal(signal.SIGINT)
        until(lambda: "Leaving" in said(here), "it is said")
        (here / "go").touch()
        assert ended(process) == (130, "")
    assert house.control.get_run(run_id).live_workers == 0
    assert "Traceback" not in said(here)
    assert "keeps its scores: 0/3" in said(here)
    (command,) = RESUME.findall(said(here))
    assert f"--run-id {run_id}" in command
    with started(here, server.url, *shlex.split(command)[1:], "--json") as process:
        code, out = ended(process)
    assert (code, json.loads(out)["score"]) == (0, 1.0)


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_second_ctrl_c_ends_at_once(
    server: ServerProcess, here: Path, processes: list[str]
) -> None:
    """The policy never comes back. Expect the end of every process all the same."""
    with started(here, server.url, *HELD, *options("count"), *processes) as process:
        until(lambda: acting(here) == 1, "the worker acts")
        children = descendants(process.pid)
        process.send_signal(signal.SIGINT)
        until(lambda: "Leaving" in said(here), "it is said")
        process.send_signal(signal.SIGINT)
        assert ended(process) == (130, "")
    assert "ended at once" in said(here)
    until_none_lives(children)


def test_sigterm_detaches_too(server: ServerProcess, house: House, here: Path) -> None:
    """A batch system ends the job. Expect 143, and no session left."""
    with started(here, server.url, *HELD, *options("count")) as process:
        until(lambda: acting(here) == 1, "the worker acts")
        run_id = house.latest().run_id
        process.terminate()
        until(lambda: "Leaving" in said(here), "it is said")
        (here / "go").touch()
        assert ended(process) == (143, "")
    assert RESUME.search(said(here))
    assert house.control.get_run(run_id).live_workers == 0


def test_processes_leave_when_their_parent_is_killed(
    server: ServerProcess, house: House, here: Path
) -> None:
    """Expect no process left, and no session."""
    run = [*HELD, *options("count"), "--processes"]
    with started(here, server.url, *run) as process:
        until(lambda: acting(here) == 1, "the worker acts")
        children = descendants(process.pid)
        assert children
        run_id = house.latest().run_id
        process.kill()
        process.wait()
    (here / "go").touch()
    until_none_lives(children)
    assert house.control.get_run(run_id).live_workers == 0


def test_a_process_that_dies_is_told_and_its_episode_played(
    proctor: Proctor, house: House
) -> None:
    """One of two is killed in episode 2. Expect a second attempt, elsewhere."""
    run = ["run", "--policy", "policies:Dies", *options(*["score"] * 5)]
    score = proctor.json(*run, "--workers", "2", "--processes")
    assert (proctor.code, score["complete"]) == (0, True)
    assert re.search(r"The process of worker-\d has died \(SIGKILL\)", proctor.err)
    assert house.attempts(score["run_id"]) == [1, 1, 2, 1, 1]


def test_when_every_process_dies_the_run_is_not_complete(proctor: Proctor) -> None:
    run = ["run", "--policy", "policies:Always", *options("score")]
    told = proctor.json(*run, "--processes")
    assert (proctor.code, told["error"]["code"]) == (1, "worker_died")
    assert "--processes" in told["resume"]


def test_a_server_that_restarts_is_waited_for(
    here: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """It is killed while both workers think. Expect the whole score all the same."""
    tasks = options(*["count"] * 3)
    with ServerProcess(tmp_path_factory.mktemp("own")) as own:
        run = [*HELD, *tasks, "--workers", "2", "--json", "--processes"]
        with started(here, own.url, *run) as process:
            until(lambda: acting(here) == 2, "both workers act")
            own.end(signal.SIGKILL)
            (here / "go").touch()
            until(lambda: "does not answer" in said(here), "it is missed")
            own.start()
            code, out = ended(process)
    assert (code, json.loads(out)["score"]) == (0, 1.0)


def test_a_run_that_fails_says_whether_it_goes_on(proctor: Proctor) -> None:
    """The policy breaks the simulator. Expect 1, and no command that cannot help."""
    Path("fatal.py").write_text(
        "from policies import action\n"
        "def fatal(observation):\n    return action(fault=2.0)\n"
    )
    told: Any = proctor.json("run", "--policy", "fatal:fatal", *options("fault"))
    assert (proctor.code, told["error"]["code"]) == (1, "run_failed")
    assert "resume" not in told


@pytest.mark.parametrize(
    ("command", "module"),
    [("serve", "reference_server"), ("conformance", "conformance")],
)
def test_the_server_and_the_kit_are_programs_of_their_own(
    monkeypatch: pytest.MonkeyPatch, command: str, module: str
) -> None:
    """Started as modules that exist, with their flags as they were typed."""
    started: list[list[str]] = []

    def become(_program: str, arguments: list[str]) -> NoReturn:
        started.append(arguments)
        raise SystemExit(0)

    monkeypatch.setattr("os.execv", become)
    with pytest.raises(SystemExit):
        main([command, "--is_public", "3"])
    assert started == [[sys.executable, "-m", module, "--is_public", "3"]]
    assert importlib.util.find_spec(f"{module}.__main__") is not None


@pytest.mark.parametrize("command", ["serve", "conformance"])
def test_a_program_that_is_not_installed_is_named(
    command: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda _name: None)
    assert main([command]) == 2
    assert "pip install 'proctor-eval[" in capsys.readouterr().err
