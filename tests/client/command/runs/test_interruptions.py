"""An interruption of `proctor run` costs nothing while the lease lasts."""

from __future__ import annotations

import re
import shlex
import signal
from pathlib import Path

import pytest

from reference_client.command.output.printer import scored_text
from reference_client.evaluation.status_board import Progress
from tests.support.client.command import ProctorCommand, options, start_proctor
from tests.support.client.direct_client import DirectClient
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until

pytestmark = pytest.mark.usefixtures("policy_folder")
RESUME = re.compile(r"^  proctor (run .*)$", re.MULTILINE)
# A process may execute one more action before it stops.
WAITS = re.compile(
    r"e0000 waits at step [34] until \d\d:\d\d:\d\d UTC; attempt 1 of 3\."
)
EPISODE = options("count", max_steps=10, max_attempts=3)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_an_interruption_costs_no_attempt(
    direct_client: DirectClient,
    proctor: ProctorCommand,
    policy_folder: Path,
    processes: list[str],
    number: signal.Signals,
) -> None:
    """In the middle of an episode. Expect what waits and until when, and that the
    printed command continues it in the same attempt, at its step."""
    run = ["run", "--no-dry-turn", "--policy", "policies:HeldAtStepThree", *EPISODE]
    with start_proctor(policy_folder, proctor.url, *run, *processes) as process:
        wait_until(lambda: any(policy_folder.glob("acting-*")), "the worker acts")
        run_id = direct_client.latest().run_id
        process.send_signal(number)
        said = policy_folder / "stderr"
        wait_until(lambda: "Stopping" in said.read_text(), "it is said")
        (policy_folder / "go").touch()
        out, _ = process.communicate(timeout=TIMEOUT_S)
        assert (process.returncode, out) == (128 + number, "")
    text = said.read_text()
    assert WAITS.search(text), text
    assert ": 0/1 episode scored" in text
    assert "Traceback" not in text
    assert direct_client.control.get_run(run_id).live_workers == 1
    (command,) = RESUME.findall(text)
    assert command.endswith("--takeover")
    (policy_folder / "go_on").touch()
    assert proctor(*shlex.split(command)) == 0
    assert direct_client.attempts(run_id) == [1]
    assert direct_client.control.get_score(run_id).score == 1.0


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_an_exception_of_the_policy_costs_no_attempt(
    direct_client: DirectClient, proctor: ProctorCommand, processes: list[str]
) -> None:
    """It raises at step 3 and is corrected. Expect one attempt in all."""
    run = ["run", "--policy", "policies:BreaksAtStepThree", *EPISODE, *processes]
    answer_json = proctor.json(*run)
    assert (proctor.code, answer_json["error"]["code"]) == (1, "policy_failed")
    (waiting,) = answer_json["waiting"]
    assert (waiting["episode_id"], waiting["step"], waiting["attempt"]) == (
        "e0000",
        3,
        1,
    )
    assert WAITS.search(proctor.err), proctor.err
    Path("go").touch()
    assert proctor(*shlex.split(answer_json["resume"])[1:]) == 0
    assert direct_client.attempts(answer_json["run_id"]) == [1]


def test_an_abandoned_episode_is_not_called_a_kept_score() -> None:
    progress = Progress("run_1", 3, 2, 0.5, None)
    assert scored_text(progress) == "2/3 episodes scored; scores are kept."
    abandoned = Progress("run_1", 3, 2, 0.5, None, episodes_abandoned=1)
    assert "kept" not in scored_text(abandoned)
    assert "1 of them abandoned with score 0" in scored_text(abandoned)
