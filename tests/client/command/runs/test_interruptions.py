"""An interruption of `proctor run` costs nothing while the lease lasts."""

import re
import shlex
import signal
from pathlib import Path

import pytest

from reference_client.command.output.printer import scored_text
from reference_client.evaluation.status_board import Progress
from reference_record.command_line.closed_output import NOTICES
from tests.support.client.command import Proctor, options, start_proctor
from tests.support.client.direct_client import DirectClient
from tests.support.processes import descendants, hangups_taken, signal_all
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

pytestmark = pytest.mark.usefixtures("policy_folder")
RESUME = re.compile(r"^  proctor (run .*)$", re.MULTILINE)
# A process may execute one more action before it stops.
WAITS = re.compile(
    r"e0000 waits at step [34] until \d\d:\d\d:\d\d UTC; attempt 1 of 3\."
)
EPISODE = options("count", max_steps=10, max_attempts=3)


@pytest.mark.parametrize(
    "number",
    [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGUSR1, signal.SIGXCPU],
)
@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_an_interruption_costs_no_attempt(
    direct: DirectClient,
    proctor: Proctor,
    policy_folder: Path,
    processes: list[str],
    number: signal.Signals,
) -> None:
    """In the middle of an episode. Expect what waits and until when, and that the
    printed command continues it in the same attempt, at its step."""
    run = ["run", "--no-dry-turn", "--policy", "policies:HeldAtStepThree", *EPISODE]
    with (
        hangups_taken(),
        start_proctor(policy_folder, proctor.url, *run, *processes) as process,
    ):
        wait_until(lambda: any(policy_folder.glob("acting-*")), "the worker acts")
        run_id = direct.latest().run_id
        process.send_signal(number)
        said = policy_folder / "stderr"
        wait_until(lambda: "Stopping" in said.read_text(), "it is said")
        if number.name in NOTICES:  # a job has several processes, and each gets it
            signal_all([process.pid, *descendants(process.pid)], number)
        (policy_folder / "go").touch()
        out, _ = process.communicate(timeout=TIMEOUT_S)
        assert (process.returncode, out) == (128 + number, "")
    text = said.read_text()
    assert WAITS.search(text), text
    assert ": 0/1 episode scored" in text
    assert "Traceback" not in text
    assert direct.control.get_run(run_id).live_workers == 1
    by = "its user" if number == signal.SIGINT else f"the signal {number.name}"
    assert direct.reasons(run_id) == [f"Its evaluation was interrupted by {by}."]
    (command,) = RESUME.findall(text)
    assert command.endswith("--takeover")
    (policy_folder / "go_on").touch()
    assert proctor(*shlex.split(command)) == 0
    assert direct.attempts(run_id) == [1]
    assert direct.control.get_score(run_id).score == 1.0


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_an_interruption_before_a_run_speaks_of_none(
    proctor: Proctor, policy_folder: Path, processes: list[str]
) -> None:
    """In the dry turn, which the policy never ends."""
    run = ["run", "--policy", "policies:Held", *EPISODE]
    with start_proctor(policy_folder, proctor.url, *run, *processes) as process:
        wait_until(lambda: any(policy_folder.glob("acting-*")), "the policy acts")
        process.send_signal(signal.SIGINT)
        assert process.communicate(timeout=TIMEOUT_S)[0] == ""
        assert process.returncode == 130
    text = (policy_folder / "stderr").read_text()
    assert "Stopping. Press Ctrl-C again" in text
    assert "proctor: Interrupted. No run was submitted." in text
    assert "attempt" not in text
    assert "To continue" not in text


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_an_exception_of_the_policy_costs_no_attempt(
    direct: DirectClient, proctor: Proctor, processes: list[str]
) -> None:
    """It raises at step 3 and is corrected. Expect one attempt in all."""
    run = ["run", "--policy", "policies:BreaksAtStepThree", *EPISODE, *processes]
    printed = proctor.json(*run)
    assert (proctor.code, printed["error"]["code"]) == (1, "policy_failed")
    (waiting,) = printed["waiting"]
    [reason] = direct.reasons(printed["run_id"])
    assert (reason or "").startswith("The policy raised "), reason
    expected = {"episode_id": "e0000", "step": 3, "attempt": 1}
    assert waiting.items() >= expected.items()
    assert WAITS.search(proctor.err), proctor.err
    assert proctor("status", printed["run_id"]) == 0
    assert f"left by worker  {reason}. In 1 episode: e0000" in proctor.out
    Path("go").touch()
    assert proctor(*shlex.split(printed["resume"])[1:]) == 0
    assert direct.attempts(printed["run_id"]) == [1]


def test_an_abandoned_episode_is_not_called_a_kept_score() -> None:
    progress = Progress("run_1", 3, 2, 0.5, None)
    assert scored_text(progress) == "2/3 episodes scored; scores are kept."
    abandoned = Progress("run_1", 3, 2, 0.5, None, episodes_abandoned=1)
    assert "kept" not in scored_text(abandoned)
    assert "1 of them abandoned with score 0" in scored_text(abandoned)
