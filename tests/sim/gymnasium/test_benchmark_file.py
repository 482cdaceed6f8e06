"""Benchmark files: what they may contain, and the errors for what they may not."""

import tomllib
from pathlib import Path

import pytest

from reference_sim.gymnasium import BadBenchmark
from reference_sim.gymnasium.benchmark_file import (
    BUNDLED_BENCHMARKS,
    Benchmark,
    Split,
    legal_id,
    read,
)
from tests.support.paths import ROOT

EXAMPLES = ROOT / "examples" / "benchmarks"
TASK = '[[tasks]]\nname = "a"\ninstruction = "Do."\n'


def read_text(folder: Path, text: str, name: str = "my-bench.toml") -> Benchmark:
    (folder / name).write_text(text)
    ((benchmark, found),) = read(str(folder / name))
    assert found == folder
    return benchmark


def test_the_shortest_file_names_an_environment(tmp_path: Path) -> None:
    benchmark = read_text(tmp_path, 'environment = "CartPole-v1"')
    assert benchmark.benchmark_id == "my_bench"
    assert benchmark.source == "CartPole-v1"
    assert [episode["seed"] for episode in benchmark.episodes(["a"])] == list(range(10))


def test_episodes_come_split_by_split_and_task_by_task(tmp_path: Path) -> None:
    benchmark = read_text(
        tmp_path,
        'environment = "X-v0"\n'
        + TASK
        + TASK.replace('"a"', '"b"')
        + '[[splits]]\nname = "s"\nseeds = [7, 3]\n'
        + '[[splits]]\nname = "t"\nfirst_seed = 5\nepisodes = 2\ntasks = ["b"]\n',
    )
    assert [tuple(episode.values()) for episode in benchmark.episodes(["a", "b"])] == [
        *[("a", "s", 7), ("a", "s", 3), ("b", "s", 7), ("b", "s", 3)],
        *[("b", "t", 5), ("b", "t", 6)],
    ]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (
            "environment = CartPole",
            "is not valid TOML: Invalid value (at line 1, column 15)",
        ),
        ("\nx = 'é'\ny = [", "is not valid TOML: Invalid value (at end of document)"),
        (
            "max_step = 1\nenvironment = 'X'",
            "unknown key max_step; did you mean max_steps? There is benchmark_id, ver",
        ),
        (
            "environment = 'X'\n[[splits]]\nname = 's'\nseed = [1]",
            "splits[0]: unknown key seed; did you mean seeds? There is name, seeds, fi",
        ),
        (
            "environment = 'X'\n[camera]\nzzz = 1",
            "unknown key zzz; there is name, upside_down",
        ),
        (
            "environment = 'X'\nsuccess_rule = 'anystep'",
            "unknown value anystep; did you mean any_step? There is any_step, last_st",
        ),
        (
            "environment = 'X'\nturn_timeout_s = 9",
            "turn_timeout_s is a setting of the server (--turn-timeout-s), and no key",
        ),
        ("", 'give one of environment = "ID", made_by = "FILE.py:NAME"'),
        ("benchmarks = ['X']", "write each benchmark as a table [[benchmarks]]"),
        (
            "environment = 'X'\n[[benchmarks]]\nmax_steps = 1",
            "benchmarks[0]: benchmark_id: Field required",
        ),
        ("environment = 'X'\nmade_by = 'a:b'", "give one of environment"),
        ("made_by = 'a.py'", "made_by: 'a.py' must match .+:"),
        (
            "environment = 'X'\nbenchmark_id = 'My'",
            "benchmark_id: 'My' must begin with a",
        ),
        (
            "environment = 'X'\nmax_steps = '9'",
            "max_steps: '9' must be a valid integer",
        ),
        (
            "environment = 'X'\ncontrol_rate_hz = inf",
            "control_rate_hz: inf must be a finite number",
        ),
        (
            "environment = 'X'\n[[tasks]]\nname = 'a'",
            "tasks[0].instruction: Field requ",
        ),
        ("environment = 'X'\n" + TASK + TASK, "two tasks have the same name"),
        (
            "environment = 'X'\n[[splits]]\nname = 's'\nseeds = [-1]",
            "splits[0].seeds[0]: -1 must be greater than or equal to 0",
        ),
        (
            "environment = 'X'\n[[splits]]\nname = 's'",
            "splits[0]: give either seeds = [...] or episodes = N (and first_seed)",
        ),
        (
            "environment = 'X'\n[[splits]]\nname = 's'\nseeds = [1, 1]",
            "splits[0]: seeds has a number twice",
        ),
        (
            "environment = 'X'\n" + 2 * "[[splits]]\nname = 's'\nseeds = [1]\n",
            "two splits have the same name",
        ),
        (
            "environment = 'X'\n[[splits]]\nname='s'\nseeds=[1]\ntasks=['z']\n" + TASK,
            "split s: unknown task z; there is ",
        ),
        (
            "environment = 'X'\nsuccess = { info = 'a', terminated = true }",
            "success: give exactly one of info, reward_at_least, return_at_least, ",
        ),
        ("environment = 'X'\nsuccess = {}", "success: give exactly one of info"),
        (
            "success_rule='any_step'\nsuccess={return_at_least=1}\nenvironment='X'",
            "return_at_least is known at the end only: success_rule is last_step",
        ),
        (
            "environment = 'X'\nscore = { return_from = 1, return_to = 1 }",
            "return_from must be less than return_to",
        ),
        ("environment = 'X'\nmax_faults = 0", "max_faults: 0 must be greater"),
        ("environment = 'X'\ncamera = true", "camera"),
        ("environment = 'X'\nimage_codecs = []", "image_codecs: List should have at"),
        (
            "environment = 'X'\n[action.a]\nrotation = 'x'",
            "action.a.rotation: unknown value x; there is none, quat",
        ),
        ("environment = 'X'\naction.a.relative = true", "action.a: relative: now 'no"),
        (
            "environment = 'X'\naction.a.unit = 'm,rad'",
            "action.a: unit: several units need parts",
        ),
        (
            "environment = 'X'\naction.a = {unit = 'm', parts.b = {size = 1}}",
            "action.a: unit: say it of each of the parts",
        ),
        (
            "environment = 'X'\naction.a.parts.b.size = 0",
            "action.a.parts.b.size: 0 must be greater",
        ),
        (
            "environment = 'X'\n[[image_sizes]]\nwidth = 0\nheight = 5",
            "image_sizes[0].w",
        ),
        (
            "environment = 'X'\nray_resources = {}",
            "ray_resources: a simulator needs at",
        ),
        (
            "environment = 'X'\nray_resources = { CPU = 0.5, GPU = inf }",
            "ray_resources: GPU: the amount has to be a number from 0.0001 to 2^50",
        ),
        (
            "environment = 'X'\nray_resources = 'CPU=1'",
            "ray_resources: a simulator needs at least one resource",
        ),
    ],
)
def test_a_fault_of_a_file_is_one_line_with_its_place(
    tmp_path: Path, text: str, fault: str
) -> None:
    with pytest.raises(BadBenchmark) as caught:
        read_text(tmp_path, text)
    said = str(caught.value)
    assert said.startswith(f"{tmp_path / 'my-bench.toml'}: ")
    assert fault in said
    assert "\n" not in said


def test_all_faults_of_a_file_are_reported_together(tmp_path: Path) -> None:
    with pytest.raises(BadBenchmark, match=r"version: .*; max_steps: "):
        read_text(tmp_path, "environment = 'X'\nversion = 1\nmax_steps = 0")


@pytest.mark.parametrize(
    ("reference", "fault"),
    [
        ("nothing.toml", "there is no file /"),
        (
            "juggling",
            "juggling: unknown benchmark reference; expected gymnasium:ID, FILE.toml, ",
        ),
        ("gymnasium:", "unknown benchmark reference; expected"),
        ("x.py:", "unknown benchmark reference; expected"),
        ("gone.py", "name the class, too: gone.py:CLASS"),
        ("examples/benchmarks/corridor.py", "/corridor.py:Corridor"),
        ("/bin/sh", "a program is given as --simulator /bin/sh"),
    ],
)
def test_an_invalid_reference_is_an_error(reference: str, fault: str) -> None:
    with pytest.raises(BadBenchmark) as caught:
        list(read(reference))
    assert fault in str(caught.value)


def test_a_folder_is_all_its_files_in_order(tmp_path: Path) -> None:
    with pytest.raises(BadBenchmark, match=r"no file \*.toml is in this folder"):
        list(read(str(tmp_path)))
    for name in ("b", "a"):
        (tmp_path / f"{name}.toml").write_text('environment = "X-v0"')
    assert [found.benchmark_id for found, _ in read(str(tmp_path))] == ["a", "b"]


def test_a_file_has_several_benchmarks(tmp_path: Path) -> None:
    """Expect the keys above them in each that has no others; a program has its id."""
    (tmp_path / "two.toml").write_text(
        "max_steps = 9\nversion = '2'\n"
        "[[benchmarks]]\nbenchmark_id = 'a'\nenvironment = 'X'\n"
        "[[benchmarks]]\nsimulator = ['./x']\nmax_steps = 3\n"
    )
    several = [benchmark for benchmark, _ in read(str(tmp_path / "two.toml"))]
    assert [(b.benchmark_id, b.source, b.max_steps, b.version) for b in several] == [
        ("a", "X", 9, "2"),
        ("simulator", "./x", 3, "2"),
    ]


def test_short_references_stand_for_files() -> None:
    ((benchmark, folder),) = read("gymnasium:my_robots:ns/Arm-v2")
    assert (benchmark.environment, benchmark.modules) == ("ns/Arm-v2", ["my_robots"])
    assert (benchmark.benchmark_id, folder) == ("ns_arm_v2", Path.cwd())
    ((benchmark, folder),) = read(f"{EXAMPLES}/corridor.py:Corridor")
    assert (benchmark.made_by, folder) == ("corridor.py:Corridor", EXAMPLES)


@pytest.mark.parametrize(
    ("name", "benchmark_id"),
    [
        ("CartPole-v1", "cartpole_v1"),
        ("ALE/Pong-v5", "ale_pong_v5"),
        ("3Body-v0", "env_3body_v0"),
        ("---", "env"),
        ("a" * 80, "a" * 64),
    ],
)
def test_ids_are_legal(name: str, benchmark_id: str) -> None:
    assert legal_id(name) == benchmark_id
    assert Benchmark(benchmark_id=benchmark_id, environment=name).source == name


def test_meta_world_has_fifty_tasks_with_distinct_instructions() -> None:
    ((benchmark, _),) = read("metaworld_mt50")
    assert benchmark.benchmark_id in BUNDLED_BENCHMARKS
    assert len({task.name for task in benchmark.tasks}) == 50
    assert len({task.instruction for task in benchmark.tasks}) == 50
    assert all(task.kwargs == {"task": task.name} for task in benchmark.tasks)
    assert len(benchmark.episodes([task.name for task in benchmark.tasks])) == 500
    assert benchmark.success_rule == "any_step"


@pytest.mark.parametrize(
    ("text", "sealed"),
    [
        ("name = 'test'\nepisodes = 2", True),
        ("name = 'test'\nepisodes = 2\nsealed = false", False),
        ("name = 'test'\nepisodes = 2\nfirst_seed = 0", False),
        ("name = 'test'\nseeds = [1]", False),
        ("name = 'hidden'\nepisodes = 2", False),
        ("name = 'hidden'\nepisodes = 2\nsealed = true", True),
    ],
)
def test_a_split_is_sealed_if_it_is_the_test_and_names_no_seeds(
    text: str, sealed: bool
) -> None:
    """Also when the file was read and written again, as for the check process."""
    split = Split.model_validate(tomllib.loads(text))
    assert split.is_sealed == sealed
    assert Split.model_validate(split.model_dump()).is_sealed == sealed


@pytest.mark.parametrize("named", ["seeds = [1]", "episodes = 2\nfirst_seed = 3"])
def test_a_sealed_split_names_no_seeds(named: str) -> None:
    with pytest.raises(ValueError, match="takes episodes = N alone"):
        Split.model_validate(tomllib.loads(f"name = 's'\nsealed = true\n{named}"))
