"""Who played is declared, recorded and shown; a run is finished by its policy."""

import csv
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from proctor_client import Run, Service, SubmitRun

from reference_client.errors import ProctorError
from reference_client.evaluation.declared_policy import (
    DeclaredPolicy,
    check_offered,
    declare_player,
)
from reference_client.evaluation.parameters import submission
from tests.support.client.command import Proctor, options

pytestmark = pytest.mark.usefixtures("policy_folder")
GRADED = ["run", "--policy", "policies.py:Graded"]
BEST = ["run", "--policy", "policies.py:best"]
THREE = options(*["score"] * 3)


def begin(proctor: Proctor, *flags: str) -> str:
    """The id of a run of which Graded has scored one episode of three."""
    run_id: str = proctor.json(*GRADED, *THREE, "--episodes", "1", *flags)["run_id"]
    return run_id


@pytest.mark.parametrize("processes", [[], ["--processes"]])
def test_no_other_policy_ends_a_run(proctor: Proctor, processes: list[str]) -> None:
    """Expect a refusal that says what to do, before the run has changed."""
    run_id = begin(proctor)
    assert proctor(*BEST, "--run-id", run_id, *processes) == 2
    assert f"Run {run_id} is of policy Graded, not of best" in proctor.err
    assert "`--name 'Graded'`" in proctor.err
    assert "--any-policy" in proctor.err
    assert proctor.json("status", run_id)["progress"]["episodes_scored"] == 1
    named = ["--name", "Graded", "--run-id", run_id]
    assert proctor(*BEST, *named, *processes) == 0
    assert "Graded with proctor-eval/0.1.0 (best): 2 episodes" in proctor.out
    assert "Graded with proctor-eval/0.1.0 (Graded): 1 episode" in proctor.out


def test_another_version_cannot_finish_a_run(proctor: Proctor) -> None:
    run_id = begin(proctor, "--policy-version", "1")
    rest = [*GRADED, "--run-id", run_id]
    assert proctor(*rest, "--policy-version", "2") == 2
    assert "is of policy Graded 1, not of Graded 2" in proctor.err
    assert proctor(*rest) == 0
    assert "Graded 1 with proctor-eval/0.1.0 (Graded): 3 episodes" in proctor.out


def test_a_run_that_was_submitted_gives_its_name(proctor: Proctor) -> None:
    submitted = proctor.json("submit", *THREE, "--name", "mine", "--wait")["run_id"]
    assert proctor(*GRADED, "--run-id", submitted) == 0
    assert "mine with proctor-eval/0.1.0 (Graded): 3 episodes" in proctor.out


def test_a_run_may_be_of_several_policies(proctor: Proctor) -> None:
    """Expect each result under the name of the policy that played it, everywhere."""
    run_id = begin(proctor, "--any-policy", "--save", "part")
    assert proctor(*BEST, "--run-id", run_id, "--save", "out") == 0
    found = proctor.json("results", run_id)["players"]
    seen = [(one["player"]["name"], one["episodes"]) for one in found]
    assert seen == [("best", 2), ("Graded", 1)]
    assert proctor.json("status", run_id)["players"] == found
    assert proctor.json("compare", run_id, run_id)["players"] == {run_id: found}
    assert proctor("compare", run_id, run_id) == 0
    assert "baseline played by" in proctor.out
    assert proctor("status", run_id) == 0
    assert "Graded; others may play, too" in proctor.out
    assert proctor("results", run_id, "--episodes") == 0
    assert proctor.out.count("best with proctor-eval/0.1.0 (best)") == 3
    with Path("out/episodes.csv").open() as file:
        rows = [*csv.DictReader(file)]
    assert [row["player_name"] for row in rows] == ["Graded", "best", "best"]
    assert {row["clipped_actions"] for row in rows} == {"0"}


def test_the_return_is_shown_where_it_is_not_the_score(proctor: Proctor) -> None:
    """Two steps with the reward of the last one each: the return is twice the score."""
    assert proctor(*GRADED, *THREE) == 0
    assert "mean 0.5000, standard deviation 0.5000, over 3 episodes" in proctor.out
    assert proctor(*BEST, *THREE) == 0
    assert "return" not in proctor.out


def test_a_part_of_a_benchmark_is_played(proctor: Proctor) -> None:
    """Expect the episodes of the part alone, and a result that says so."""
    tasks = options("score", "count", "score", "count", "score")
    assert proctor(*BEST, *tasks, "--tasks", "count, score", "--split", "even") == 0
    assert "1.0000 of a part of the benchmark" in proctor.out
    assert "tasks count, score; splits even, and nothing else" in proctor.out
    found = proctor.json(*BEST, *tasks, "--tasks", "count")
    assert (found["counts"]["total"], found["complete"]) == (2, True)
    assert found["select"] == {"tasks": ["count"]}
    assert proctor("status", found["run_id"]) == 0
    assert "tasks count, and nothing else" in proctor.out
    assert proctor("status", "--limit", "1") == 0
    assert "calibration (a part)" in proctor.out
    assert proctor(*BEST, *tasks, "--tasks", "juggle") == 2
    assert "'juggle': there is score, count" in proctor.err


def test_the_headline_is_for_each_split(proctor: Proctor) -> None:
    assert proctor(*GRADED, *THREE) == 0
    assert "even 0.2500, odd 0.2500; all splits mixed 0.2500" in proctor.out
    assert proctor("status") == 0
    assert "mix 0.250" in proctor.out
    assert "A mix is the mean over several splits" in proctor.out


def test_scores_of_repetitions_outlive_one_that_ends(proctor: Proctor) -> None:
    """The third repetition fails. Expect the scores before it, and its exit code."""
    Path("third.py").write_text(
        "import pathlib\nimport policies\n\n\ndef act(observation):\n"
        "    with pathlib.Path('calls').open('a') as file:\n"
        "        file.write('x')\n"
        "    if len(pathlib.Path('calls').read_text()) > 2:\n"
        "        raise RuntimeError('out of memory')\n"
        "    return policies.best(observation)\n"
    )
    run = ["run", "--no-dry-turn", "--policy", "third.py:act", *options("score")]
    assert proctor(*run, "--repeat", "4") == 1
    assert "2 of 4 repetitions have a score." in proctor.err
    assert "1.0000 over 2 runs" in proctor.out
    Path("calls").unlink()
    found = proctor.json(*run, "--repeat", "4")
    assert (found["mean"], len(found["runs"])) == (1.0, 2)
    assert "out of memory" in found["error"]["detail"]


def test_a_score_outlives_a_folder_that_is_gone(proctor: Proctor) -> None:
    """The policy replaces the folder. Expect the score, the reason, and exit code 2."""
    Path("remove.py").write_text(
        "import pathlib\nimport policies\n\n\ndef act(observation):\n"
        "    folder = pathlib.Path('out')\n"
        "    if folder.is_dir():\n"
        "        folder.rmdir()\n"
        "        folder.write_text('')\n"
        "    return policies.best(observation)\n"
    )
    run = ["run", "--no-dry-turn", "--policy", "remove.py:act", *options("score")]
    assert proctor(*run, "--save", "out") == 2
    assert "/out cannot be written (File exists); --save names" in proctor.err
    assert "1.0000" in proctor.out


# --- servers without the profiles ---


def test_nothing_is_sent_to_a_server_that_does_not_read_it() -> None:
    service = cast(Service, SimpleNamespace(profiles=["core"]))
    run = cast(Run, SimpleNamespace())
    declared = declare_player(DeclaredPolicy("p"), run, service, cast(Any, None))
    assert declared is None
    body = submission("calibration", DeclaredPolicy("p").info).to_dict()
    assert body.keys() == {"benchmark_id", "policy"}


@pytest.mark.parametrize(
    "members", [{"any_policy": True}, {"tasks": ["score"]}, {"splits": ["even"]}]
)
def test_what_a_server_does_not_offer_is_refused_before_the_run(
    members: dict[str, Any],
) -> None:
    wanted: SubmitRun = submission("calibration", DeclaredPolicy("p").info, **members)
    service = cast(Service, SimpleNamespace(profiles=["core"]))
    with pytest.raises(ProctorError, match="does not announce the profile"):
        check_offered(wanted, service)
    both = cast(Service, SimpleNamespace(profiles=["attribution", "subsets"]))
    check_offered(wanted, both)
