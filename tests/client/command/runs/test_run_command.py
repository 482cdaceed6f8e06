"""`proctor run`: workers in processes, and how an evaluation ends, as a program.

Signals, deaths and restarts happen while a policy is held, so nothing depends on time.
"""

import importlib.util
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from typing import NoReturn

import pytest

from reference_client.command.main import main
from reference_client.commands_to_copy import command_to_copy
from reference_client.evaluation import failures
from tests.support.client.command import Proctor, options, start_proctor
from tests.support.client.direct_client import DirectClient
from tests.support.paths import ROOT
from tests.support.processes import descendants, wait_until_ended
from tests.support.servers import TIMEOUT_S, ReferenceServer
from tests.support.waiting import wait_until

pytestmark = pytest.mark.usefixtures("policy_folder")
RUN_BLOCKING_POLICY = ["run", "--no-dry-turn", "--policy", "policies:Held"]


def acting_policies(policy_folder: Path) -> int:
    return len(list(policy_folder.glob("acting-*")))


def stderr_text(policy_folder: Path) -> str:
    return (policy_folder / "stderr").read_text()


def wait_for_exit(process: subprocess.Popen[str]) -> tuple[int, str]:
    out, _ = process.communicate(timeout=TIMEOUT_S)
    return process.returncode, out


def test_processes_score_as_threads_do(proctor: Proctor) -> None:
    """The same policy and episodes, in a process each. Expect the same score."""
    run = ["run", "--policy", "policies.py:Graded", *options(*["score"] * 6)]
    threads = proctor.json(*run, "--workers", "2")
    processes = proctor.json(*run, "--workers", "2", "--processes")
    assert processes["score"] == threads["score"] == pytest.approx(2.5 / 6)
    assert proctor.code == 0


@pytest.mark.slow("plays episodes of physics")
@pytest.mark.parametrize(
    ("part", "is_host", "says"),
    [
        ("val_train", False, "the 2 episodes"),
        ("val_train,test", False, "the 2 episodes"),  # the others are sealed
        ("val_train,test", True, "the 6 episodes"),
        ("test", False, ""),
        ("val_train --episodes 1", True, ""),
    ],
)
def test_a_run_ends_with_its_page_and_the_command_that_draws_its_failures(
    proctor: Proctor,
    monkeypatch: pytest.MonkeyPatch,
    part: str,
    is_host: bool,
    says: str,
) -> None:
    Path("still.py").write_text(
        "def still(observation):\n"
        "    return [{'joint_position': observation.state['joint_position'],"
        " 'gripper': [1.0]}] * 64\n"
    )
    monkeypatch.setattr(failures, "token_file", lambda _: "file" if is_host else None)
    flags = ["--benchmark", "tabletop_state", "--tasks", "push", "--split"]
    assert proctor("run", "--policy", "still.py:still", *flags, *part.split()) == 0
    run_id = proctor.out.split()[1]
    first, *before, page = proctor.err.splitlines()
    address = f"{proctor.url}/pages/runs/{run_id}"
    assert first == f"Run {run_id}: still on tabletop_state; page: {address}"
    assert page == f"Page of the run: {address}"
    command = f"  proctor video {run_id} --failures --url {proctor.url}"
    drawing = before[-2:] if command in before else []
    expected = [f"To draw {says} that failed:", command] if says else []
    assert drawing == expected


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_request_to_a_policy_that_is_sent_again_is_said_once(
    proctor: Proctor, processes: list[str]
) -> None:
    """Its answers break off three times, in two turns. Expect a run with a score."""
    Path("served.py").write_text(
        "from policies import Graded\n"
        "from reference_client.policies.servers import server_transport\n"
        "FAULTS = iter([True, True, False, True])\n"
        "class Served(Graded):\n"
        "    def act(self, observation):\n"
        "        def attempt():\n"
        "            if next(FAULTS, False):\n"
        "                raise server_transport.Unreached('broke off its answer')\n"
        "            return Graded.act(self, observation)\n"
        "        return server_transport.repeat_until_reached(\n"
        "            attempt, 'http://h:1', 60.0)\n"
    )
    run = ["run", "--policy", "served.py:Served", "--no-dry-turn", *options("count")]
    assert proctor(*run, *processes) == 0
    fault = "The policy server at http://h:1 broke off its answer."
    assert proctor.err.count(f"warning: {fault} The same request is sent again") == 1


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_policy_error_is_one_line(proctor: Proctor, processes: list[str]) -> None:
    """Expect its file and line, how it goes on, and no traceback."""
    run = ["run", "--policy", "policies:Wrong", *options("count"), *processes]
    printed = proctor.json(*run)
    assert proctor.code == 1
    assert f"on calibration; page: {proctor.url}/pages/runs/run_" in proctor.err
    where = r"ZeroDivisionError: division by zero \(policies.py:\d+\)"
    assert re.search(where, printed["error"]["detail"])
    assert "Traceback" not in proctor.err
    continued = f"proctor run --run-id {printed['run_id']} --policy"
    assert printed["resume"].startswith(continued)


def test_a_command_to_type_is_named_as_it_was_called(
    proctor: Proctor, policy_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As `.venv/bin/proctor`. Expect that name, and `proctor` once a shell finds it."""
    program = policy_folder / "bin" / "proctor"
    program.parent.mkdir()
    program.touch(0o755)
    monkeypatch.setattr("sys.argv", ["bin/proctor"])
    run = ["run", "--policy", "policies:Wrong", *options("count")]
    assert proctor.json(*run)["resume"].startswith("bin/proctor run --run-id ")
    monkeypatch.setenv("PATH", str(program.parent), prepend=os.pathsep)
    assert proctor.json(*run)["resume"].startswith("proctor run --run-id ")


def test_a_program_of_another_name_prints_a_command_that_a_shell_finds(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As a script that evaluates. Expect the command beside its Python."""
    (tmp_path / "proctor").touch(0o755)
    monkeypatch.setattr("sys.argv", ["my_script.py"])
    monkeypatch.setattr("sys.executable", f"{tmp_path}/python3")
    assert command_to_copy("stop", "a b") == f"{tmp_path}/proctor stop 'a b'"
    monkeypatch.setenv("PATH", str(tmp_path))
    assert command_to_copy("stop", "a b") == "proctor stop 'a b'"
    (tmp_path / "proctor").unlink()
    assert command_to_copy("stop", "a b") == "proctor stop 'a b'"


def test_debug_shows_where_a_policy_raises(proctor: Proctor) -> None:
    proctor("run", "--policy", "policies:Wrong", *options("count"), "--debug")
    assert "return 1 / 0" in proctor.err


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_a_second_ctrl_c_ends_at_once(
    server: ReferenceServer, policy_folder: Path, processes: list[str]
) -> None:
    """The policy never comes back. Expect the end of every process all the same."""
    with start_proctor(
        policy_folder, server.url, *RUN_BLOCKING_POLICY, *options("count"), *processes
    ) as process:
        wait_until(lambda: acting_policies(policy_folder) == 1, "the worker acts")
        children = descendants(process.pid)
        process.send_signal(signal.SIGINT)
        wait_until(lambda: "Stopping" in stderr_text(policy_folder), "it is said")
        process.send_signal(signal.SIGINT)
        assert wait_for_exit(process) == (130, "")
    said = stderr_text(policy_folder)
    assert "proctor: terminated" in said
    assert re.search(r"To continue:\n  .* run --run-id run_\w+ .*--takeover", said)
    wait_until_ended(children)


def test_processes_leave_when_their_parent_is_killed(
    server: ReferenceServer, direct: DirectClient, policy_folder: Path
) -> None:
    """While the policy thinks for ever. Expect no process left, and no session."""
    run = [*RUN_BLOCKING_POLICY, *options("count"), "--processes"]
    with start_proctor(policy_folder, server.url, *run) as process:
        wait_until(lambda: acting_policies(policy_folder) == 1, "the worker acts")
        children = descendants(process.pid)
        assert children
        run_id = direct.latest().run_id
        process.kill()
        process.wait()
    wait_until_ended(children)
    assert direct.control.get_run(run_id).live_workers == 0


def test_a_dead_process_is_reported_and_its_episode_replayed(
    proctor: Proctor, direct: DirectClient
) -> None:
    """One of two is killed in episode 2. Expect a second attempt, elsewhere."""
    run = ["run", "--policy", "policies:Dies", *options(*["score"] * 5)]
    score = proctor.json(*run, "--workers", "2", "--processes")
    assert (proctor.code, score["complete"]) == (0, True)
    assert re.search(r"Worker process worker-\d exited \(SIGKILL\)", proctor.err)
    assert direct.attempts(score["run_id"]) == [1, 1, 2, 1, 1]
    reason = "Its worker process exited (SIGKILL)."
    assert direct.reasons(score["run_id"]) == [None, None, reason, None, None]


def test_when_every_process_dies_the_run_is_not_complete(proctor: Proctor) -> None:
    run = ["run", "--policy", "policies:Always", "--no-dry-turn", *options("score")]
    printed = proctor.json(*run, "--processes")
    assert (proctor.code, printed["error"]["code"]) == (1, "worker_died")
    assert "--processes" in printed["resume"]


@pytest.mark.slow("starts a server with an environment of its own")
def test_a_run_on_an_environment_that_was_edited_is_refused_with_the_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """After a run with the old file. Expect the file and what to do, and no score."""
    source = (ROOT / "examples" / "benchmarks" / "corridor.py").read_text()
    (tmp_path / "mine.py").write_text(source)
    text = 'made_by = "mine.py:Corridor"\nmax_faults = 1\n'
    (tmp_path / "mine.toml").write_text(text)
    Path("walk.py").write_text("def walk(observation):\n    return {'action': [1.0]}\n")
    benchmark = {"PROCTOR_BENCHMARKS": str(tmp_path / "mine.toml")}
    with ReferenceServer(tmp_path, **benchmark) as server:
        proctor = Proctor(server.url, capsys)
        run = ["run", "--policy", "walk.py:walk", "--benchmark", "mine"]
        assert "error" not in proctor.json(*run, "--episodes", "1")
        (tmp_path / "mine.py").write_text(source.replace("0.2", "0.3"))
        printed = proctor.json(*run, "--episodes", "1")
    assert (proctor.code, printed["error"]["code"]) == (2, "benchmark_unavailable")
    assert "mine.py has changed since the server started: restart" in proctor.err


@pytest.mark.parametrize(
    ("command", "module"),
    [("serve", "reference_server"), ("conformance", "conformance")],
)
def test_the_server_and_the_kit_are_programs_of_their_own(
    monkeypatch: pytest.MonkeyPatch, command: str, module: str
) -> None:
    """Started as modules that exist, with their flags as they were typed."""
    commands: list[list[str]] = []

    def become(_program: str, arguments: list[str]) -> NoReturn:
        commands.append(arguments)
        raise SystemExit(0)

    monkeypatch.setattr("os.execv", become)
    with pytest.raises(SystemExit):
        main([command, "--is_public", "3"])
    assert commands == [[sys.executable, "-m", module, "--is_public", "3"]]
    assert importlib.util.find_spec(f"{module}.__main__") is not None


@pytest.mark.parametrize("pool", [[], ["--processes"]], ids=["threads", "processes"])
@pytest.mark.parametrize("error", ["ValueError", "TypeError", "KeyError", "OSError"])
def test_whatever_a_policy_raises_in_the_dry_turn_is_said_to_be_its_error(
    proctor: Proctor, policy_folder: Path, error: str, pool: list[str]
) -> None:
    """A ValueError of a policy is none of the command line."""
    text = f"def act(observation):\n    raise {error}('no such shape')\n"
    (policy_folder / "raising.py").write_text(text)
    run = ["run", "--policy", "raising.py:act", *pool, *options("score")]
    assert proctor(*run) == 2
    (line,) = proctor.err.splitlines()
    assert line.startswith(f"proctor: The policy raised {error}: ")
    assert "no such shape" in line
    assert line.endswith(
        "(raising.py:2). This was a dry turn; no run was submitted. [policy_failed]"
    )


@pytest.mark.slow("starts a program, which waits for a thread")
def test_a_thread_that_a_policy_leaves_is_named(
    server: ReferenceServer, policy_folder: Path
) -> None:
    """It never ends. Expect its name after the score, and the end by one Ctrl-C."""
    (policy_folder / "leaving.py").write_text(
        "import threading\n"
        "from policies import Graded\n"
        "threading.Thread(target=threading.Event().wait, name='left over').start()\n"
    )
    policy = ["run", "--policy", "leaving:Graded", *options("count")]
    with start_proctor(policy_folder, server.url, *policy) as process:
        said = "proctor: waits for the end of left over, which"
        wait_until(lambda: said in stderr_text(policy_folder), "the thread is named")
        process.send_signal(signal.SIGINT)
        code, _ = wait_for_exit(process)
    assert code == -signal.SIGINT
    assert "Traceback" not in stderr_text(policy_folder)
