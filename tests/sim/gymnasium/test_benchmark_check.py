"""Faults of an environment are reported before it is offered, in one line each."""

import importlib.metadata
import re
import sys
from pathlib import Path
from typing import Any

import pytest

from reference_sim.definition import Json
from reference_sim.external import LIBRARIES
from reference_sim.gymnasium import BadBenchmark, check, registration
from reference_sim.gymnasium.__main__ import main
from reference_sim.gymnasium.benchmark_file import Benchmark
from reference_sim.gymnasium.check import BenchmarkCheck
from tests.support.paths import ROOT
from tests.support.processes import run_program

ENVS = ROOT / "tests" / "support" / "sim"
WORLDS = "gymnasium_envs.py"


def benchmark(world: str, **members: Any) -> Benchmark:
    content = {"benchmark_id": "mine", "made_by": f"{WORLDS}:{world}"} | members
    return Benchmark.model_validate(content)


def look(world: str, **members: Any) -> Json:
    """Checks in this process; what hangs or dies is examined in one of its own."""
    return BenchmarkCheck(benchmark(world, **members), ENVS, print).run()


def two_tasks(first: Any, second: Any) -> list[Json]:
    return [
        {"name": name, "instruction": "Do.", "kwargs": {"amount": amount}}
        for name, amount in [("a", first), ("b", second)]
    ]


def test_a_valid_environment_has_no_faults() -> None:
    found = look("ValidEnv")
    assert found["faults"] == found["warnings"] == []
    assert found["notes"][:2] == [
        "no control rate is stated: a step counts as a second",
        "success is info['success']",
    ]
    assert found["plan"]["max_steps"] == 20
    manifest = found["manifest"]
    assert manifest["tasks"] == ["mine"]
    assert (manifest["max_steps"], manifest["success_rule"]) == (20, "any_step")
    (task,) = found["plan"]["tasks"]
    assert task["instruction"] == "Make the number larger than one."


@pytest.mark.parametrize(
    ("world", "fault"),
    [
        ("IgnoresSeed", "reset(seed=20) is not deterministic (the observation "),
        ("Leaks", "state leaks between episodes (the observation "),
        ("WrongShape", "the observation 'observation' has shape (2,), its space"),
        ("WrongDtype", "the observation 'observation' is of float32, its space of"),
        ("IsNotFinite", "the observation 'observation' is not finite: [nan]"),
        ("RewardIsNotFinite", "reward is inf (float), and must be a finite number"),
        ("ConstructorRaises", "the robot is not plugged in (gymnasium_envs.py:"),
        ("ExitsByPython", "SystemExit: no licence found (gymnasium_envs.py:"),
        ("HasText", "'action' is a Text, which has no vector"),
        ("Missing", "gymnasium_envs.py has no class or function Missing; it has "),
        ("IgnoreSeed", "no class or function IgnoreSeed; did you mean IgnoresSeed?"),
        ("RaisesLater", None),
    ],
)
def test_a_fault_is_found_and_named(world: str, fault: str | None) -> None:
    found = look(world)
    if fault is None:  # longer than a check looks
        assert found["faults"] == []
        return
    (line,) = found["faults"]
    assert fault in line
    assert "\n" not in line
    assert "plan" not in found
    # The author sees the whole traceback of the environment on the own machine.
    assert len(found["tracebacks"]) == ("Error" in line or "Exit" in line)


@pytest.mark.parametrize(
    ("members", "fault"),
    [
        ({"kwargs": {"success": "no"}}, "info['success'] is 'no' (str), and must be "),
        ({"kwargs": {"success": 0.3}}, "info['success'] is 0.3 (float), and must be"),
        ({"kwargs": {"success": [False]}}, "info['success'] is [False] (list), and"),
        ({"kwargs": {"success": {"goal": False}}}, "is {'goal': False} (dict), and"),
        ({"kwargs": {"success": None}}, "info['success'] is None (NoneType), and"),
        ({"kwargs": {"terminated": "False"}}, "terminated is 'False' (str), and"),
        ({"kwargs": {"truncated": 2}}, "truncated is 2 (int), and must be true or"),
        ({"kwargs": {"reward": "1.0"}}, "reward is '1.0' (str), and must be a finite"),
        ({"success": {"function": f"{WORLDS}:a_share"}}, f"{WORLDS}:a_share is 0.3 ("),
    ],
)
def test_a_value_that_decides_a_score_by_chance_is_a_fault(
    members: Json, fault: str
) -> None:
    (line,) = look("Reports", **members)["faults"]
    assert fault in line
    right = {"success": 1, "reward": True, "terminated": 0, "truncated": 0.0}
    assert look("Reports", kwargs=right)["faults"] == []


@pytest.mark.parametrize(
    ("world", "warning"),
    [
        ("AlwaysTheSame", "task mine: every seed gives the same episode"),
        (
            "ObservationOutOfBounds",
            "the observation 'observation'[0] is 2.56015, outside its bounds -1 … 1;",
        ),
        ("ExitsWhenItDraws", "no camera: SystemExit: no display"),
        ("RendersNone", "no camera: ValueError: render gave NoneType, not uint8 ("),
    ],
)
def test_minor_faults_are_warnings(world: str, warning: str) -> None:
    found = look(world)
    assert found["faults"] == []
    (line,) = found["warnings"]
    assert line.startswith(warning)


def test_violated_bounds_are_not_published() -> None:
    space = look("ObservationOutOfBounds")["manifest"]["observation_space"]["state"]
    assert "minimum" not in space["observation"]
    sound = look("ValidEnv")["manifest"]["observation_space"]["state"]
    assert sound["observation"]["minimum"] == [-20.0]


def test_an_environment_that_leaks_state_can_be_rebuilt_for_every_episode() -> None:
    assert look("Leaks", rebuild_every_episode=True)["faults"] == []


# --- resources on Ray ---


@pytest.mark.parametrize(
    ("world", "members", "declared"),
    [
        ("ValidEnv", {}, {}),
        ("ValidEnv", {"ray_resources": {"CPU": 1}}, {"CPU": 1}),
        ("TakesAGpu", {}, {"CPU": 0.5, "GPU": 0.25}),
        ("TakesAGpu", {"ray_resources": {"CPU": 1}}, {"CPU": 1}),
    ],
)
def test_a_file_or_its_class_declares_resources(
    world: str, members: Json, declared: Json
) -> None:
    found = look(world, **members)
    assert found["faults"] == []
    assert found["ray_resources"] == declared
    assert registration._definition(found).ray_resources == declared


def test_resources_are_no_part_of_the_manifest() -> None:
    """Nor of what a simulator is built from: they decide where, and not what."""
    without, having = (
        registration._definition(look("ValidEnv", ray_resources=declared))
        for declared in (None, {"GPU": 1})
    )
    assert without.describe({}, 8) == having.describe({}, 8)
    assert without.settings({}) == having.settings({})


def test_bad_resources_of_a_class_are_a_fault() -> None:
    (line,) = look("TakesNothing")["faults"]
    assert line.endswith(
        "ray_resources: CPU: the amount has to be a number from 0.0001 to 2^50"
    )
    assert line.startswith("ray_resources: ")


# --- faults ---


@pytest.mark.parametrize(
    ("world", "members", "declared"),
    [
        ("ValidEnv", {}, 3),
        ("ValidEnv", {"max_faults": 20}, 20),
        ("TakesAGpu", {}, 10),
        ("TakesAGpu", {"max_faults": 1}, 1),
    ],
)
def test_a_file_or_its_class_says_how_often_an_episode_may_fault(
    world: str, members: Json, declared: int
) -> None:
    assert look(world, **members)["manifest"]["max_faults"] == declared


def test_a_bad_number_of_a_class_is_a_fault() -> None:
    (line,) = look("FaultsForEver")["faults"]
    assert line == "max_faults: must be a whole number from 1 to 1000"


# --- success and score ---


def test_a_success_key_missing_from_info_is_a_fault() -> None:
    (line,) = look("NoSuccessInfo", success={"info": "is_success"})["faults"]
    said = "task mine: info has no key 'is_success' after a step; it has distance"
    assert line == said


def test_without_a_success_criterion_there_is_a_warning_or_a_return() -> None:
    (warning,) = look("NoSuccessInfo")["warnings"]
    assert warning.startswith("no success condition is declared, so every score is 0")
    scored = look("NoSuccessInfo", score={"return_from": 0.0, "return_to": 1.0})
    assert scored["warnings"] == []
    assert not scored["plan"]["ends_on_success"]


@pytest.mark.parametrize(
    ("success", "rule"),
    [
        ({"info": "success"}, "any_step"),
        ({"reward_at_least": 1.0}, "any_step"),
        ({"terminated": True}, "any_step"),
        ({"function": "gymnasium_envs:number_is_large"}, "any_step"),
        ({"return_at_least": 2.0}, "last_step"),
    ],
)
def test_the_success_rule_follows_from_the_criterion(success: Json, rule: str) -> None:
    found = look("ValidEnv", success=success)
    assert found["manifest"]["success_rule"] == rule
    assert found["plan"]["ends_on_success"] == (rule == "any_step")
    assert found["manifest"]["simulator"]["success"] == success


def test_the_default_return_criterion_requires_last_step() -> None:
    members = {"benchmark_id": "c", "environment": "CartPole-v1"}
    cartpole = Benchmark.model_validate(members | {"success_rule": "any_step"})
    (line,) = BenchmarkCheck(cartpole, ENVS, print).run()["faults"]
    assert "known at the end: last_step" in line


# --- what the file and the environment must agree in ---

ARM = {"arm": {"unit": "m"}}
NINE = {"action": {"parts": {"a": {"size": 9}}}}


@pytest.mark.parametrize(
    ("world", "members", "fault"),
    [
        (
            "ValidEnv",
            {"action": ARM},
            "action.arm: unknown name; the environment has action",
        ),
        (
            "ValidEnv",
            {"state": ARM},
            "state.arm: unknown name; the environment has observation",
        ),
        (
            "ValidEnv",
            {"action": NINE},
            "action.action: its parts have 9 numbers, the vector has ",
        ),
        ("IsNotFinite", {"camera": {"name": "c"}}, "is not finite"),
        ("RendersNone", {"camera": {"name": "c"}}, "render gave NoneType"),
        ("HasAllSpaces", {"camera": {"name": "front"}}, "'front' is in the"),
        ("ValidEnv", {"modules": ["no_such_module"]}, "cannot import no_such_module"),
    ],
)
def test_a_mismatch_between_file_and_environment_is_a_fault(
    world: str, members: Json, fault: str
) -> None:
    (line,) = look(world, **members)["faults"]
    assert fault in line


def test_an_unavailable_camera_is_a_fault() -> None:
    (line,) = look("NoRenderMode", camera={"name": "c"})["faults"]
    assert line == "camera: the environment does not draw (rgb_array)"
    (line,) = look("ValidEnv", made_by="nowhere.py:Sound")["faults"]
    assert line.startswith("there is no file ")


def test_declared_conventions_override_the_space() -> None:
    said = {"unit": "rad", "frame": "joint", "meaning": "A joint."}
    manifest = look("ValidEnv", action={"action": said})["manifest"]
    space = manifest["action_space"]["action"]
    assert space["description"] == "A joint."
    (part,) = space["parts"].values()
    assert part == {
        "start": 0,
        "size": space["size"],
        "unit": "rad",
        "frame": "joint",
        **dict.fromkeys(("quantity", "rotation", "relative_to"), "unspecified"),
    }


def test_a_fault_of_many_tasks_is_one_line() -> None:
    tasks = two_tasks(0.0, 0.0) + two_tasks("x", "y")
    for number, task in enumerate(tasks):
        task["name"] = f"t{number}"
    (line,) = look("ValidEnv", tasks=tasks)["faults"]
    assert line.startswith("task t2 (and 1 more): TypeError")


def test_what_changes_the_score_changes_the_manifest() -> None:
    def simulator(**members: Any) -> Json:
        found: Json = look("ValidEnv", **members)["manifest"]["simulator"]
        return found

    plain = simulator()
    assert len(plain["sources"]["gymnasium_envs.py"]) == 64
    assert {"gymnasium", "numpy"} <= plain["packages"].keys()
    assert plain == simulator()
    for change in (
        {"kwargs": {"amount": 1.0}},
        {"tasks": two_tasks(0.0, 1.0)},
        {"ends_on_success": False},
        {"success": {"reward_at_least": 1.0}},
        {"score": {"return_from": 0.0, "return_to": 1.0}},
    ):
        assert simulator(**change) != plain


def test_an_engine_is_found_however_its_package_is_spelled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The index has dm-control, the package says dm_control."""
    owners = {"numpy": ["dm_control"]}
    monkeypatch.setattr(importlib.metadata, "packages_distributions", lambda: owners)
    packages = look("ValidEnv")["manifest"]["simulator"]["packages"]
    assert packages.keys() == {"dm-control"}


# --- images ---


def test_pictures_of_several_sizes_become_tensors_unless_a_size_is_chosen() -> None:
    manifest = look("HasAllSpaces", camera=False)["manifest"]
    space = manifest["observation_space"]
    assert set(space["images"]) == {"front", "grey"}
    assert set(space["tensors"]) == {"grid", "small"}
    assert manifest["image_sizes"] == [{"width": 16, "height": 12}]
    sizes = [{"width": 32, "height": 24}]
    manifest = look("HasAllSpaces", camera=False, image_sizes=sizes)["manifest"]
    assert set(manifest["observation_space"]["images"]) == {"front", "grey", "small"}
    assert manifest["image_sizes"] == sizes


@pytest.mark.slow("draws for a second")
def test_a_camera_gives_its_size_and_without_pictures_there_is_one_choice() -> None:
    seen = look("ValidEnv", camera={"name": "front"})["manifest"]
    assert set(seen["observation_space"]["images"]) == {"front"}
    assert seen["image_sizes"] == [{"width": 8, "height": 6}]
    assert seen["image_codecs"] == ["raw", "png", "jpeg"]
    blind = look("ValidEnv", camera=False)["manifest"]
    assert (len(blind["image_sizes"]), blind["image_codecs"]) == (1, ["raw"])


# --- in a process of its own ---


@pytest.mark.parametrize(
    ("world", "fault"),
    [
        ("Crashes", "task mine (1 of 1): its process ended: SIGSEGV"),
        ("ExitsProcess", "task mine (1 of 1): its process ended: no licence found"),
    ],
)
def test_a_process_that_exits_is_a_fault(world: str, fault: str) -> None:
    found = registration.examine(benchmark(world, camera=False), ENVS, print)
    assert found["faults"] == [fault]


def test_a_hanging_check_times_out_and_reports_progress(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(registration, "_SLOW_S", 0.05)
    monkeypatch.setattr(registration, "SILENCE_S_MAX", 2.0)
    said: list[str] = []
    found = registration.examine(benchmark("Hangs", camera=False), ENVS, said.append)
    assert "no output for 2 s" in found["faults"][0]
    assert said[-1].startswith("mine: checking, ")


def test_a_benchmark_with_a_fault_is_not_offered() -> None:
    reference = f"{ENVS / WORLDS}:Leaks"
    with pytest.raises(BadBenchmark) as caught:
        list(registration.benchmarks(reference, print))
    assert str(caught.value).startswith(f"leaks ({reference}): task leaks: state leaks")


def test_the_command_prints_its_findings(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", f"{ENVS / WORLDS}:AlwaysTheSame"]) == 0
    said = capsys.readouterr().out
    assert "alwaysthesame: warning: task alwaysthesame: every seed gives" in said
    assert "alwaysthesame: OK, 10 episodes" in said
    assert main(["check", f"{ENVS / WORLDS}:IsNotFinite"]) == 1
    assert "isnotfinite: fault: " in capsys.readouterr().out
    assert main(["check", "nothing.toml"]) == 2
    missing = Path("nothing.toml").absolute()
    assert f"there is no file {missing}" in capsys.readouterr().err


@pytest.mark.slow("starts a simulator")
def test_the_command_checks_a_program(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also beside an environment, in one folder."""
    world = ROOT / "examples" / "simulators" / "numpy_world.py"
    command = ["env", f"PYTHONPATH={LIBRARIES}", sys.executable, str(world)]
    (tmp_path / "right.toml").write_text(f"simulator = {command}")
    (tmp_path / "wrong.toml").write_text('simulator = ["no_such_program"]')
    assert main(["check", str(tmp_path)]) == 1
    said = capsys.readouterr().out
    assert re.search(r"^right: OK, \d+ episodes$", said, re.MULTILINE)
    assert re.search(r"^wrong: fault: .*no_such_program", said, re.MULTILINE)


@pytest.mark.slow("starts a server")
def test_a_server_with_an_invalid_benchmark_exits_with_one_line(tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text('environment = "CartPole-v1"\nmax_steps = 0\n')
    command = [sys.executable, "-m", "reference_server", "--benchmarks", str(file)]
    done = run_program(command, cwd=ROOT)
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == (
        f"proctor: {file}: max_steps: 0 must be greater than or equal to 1\n"
    )


def test_a_missing_package_is_named_with_the_command_that_adds_it() -> None:
    """As Gymnasium says it of LunarLander and CartPole."""
    texts = {
        "no camera: pygame is not installed, run "
        '`pip install "gymnasium[classic-control]"`': "gymnasium[classic-control]",
        "Box2D is not installed, you can install it by run `pip install swig` "
        'followed by `pip install "gymnasium[box2d]"`': "gymnasium[box2d]",
    }
    for text, package in texts.items():
        (line,) = check._lines({text: [""]})
        assert line == f"{text}; here: make add PACKAGE='{package}'"
    said = "no step limit is stated"
    assert check._lines({said: [""]}) == [said]
