"""A program describes itself and becomes a benchmark, or a sentence says why not."""

import hashlib
import json
import shutil
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reference_sim import benchmark_registry
from reference_sim.external import LIBRARIES
from reference_sim.external.external_simulator import ExternalSimulator
from reference_sim.external.program import Program
from reference_sim.gymnasium import BadBenchmark, registration
from reference_sim.gymnasium.own_sources import DeclaredFiles
from reference_sim.interface import ChangedSource
from reference_sim.shared_frame_buffer import FRAME_BUFFER
from tests.support.example_simulators import build_example
from tests.support.sim import breakable_simulator
from tests.support.sim.breakable_simulator import part, vector

SCRIPT = breakable_simulator.__file__
PYTHON = f"{sys.executable} -S"
# A program that describes what its argument says, as JSON, and then ends.
DESCRIBES = f"""
import json, sys
sys.path.insert(0, {str(LIBRARIES)!r})
import proctor_simulator

class World(proctor_simulator.Simulator):
    benchmark = json.loads(sys.argv[1])

proctor_simulator.serve(World())
"""


def definitions(reference: str) -> dict[str, Any]:
    return dict(registration.benchmarks(reference, lambda _line: None))


def write_toml(folder: Path, text: str, name: str = "counting.toml") -> str:
    (folder / name).write_text(text)
    return str(folder / name)


def entry(*arguments: str) -> str:
    return f"simulator = {json.dumps([sys.executable, '-S', SCRIPT, *arguments])}\n"


def test_a_command_line_is_a_benchmark() -> None:
    ((benchmark_id, definition),) = definitions(f"simulator:{PYTHON} {SCRIPT}").items()
    manifest = definition.describe({}, 32)
    assert benchmark_id == manifest["benchmark_id"] == "breakable"
    assert manifest["tasks"] == ["count", "hold"]
    assert manifest["episodes_total"] == 6
    assert manifest["max_steps"] == 20
    assert manifest["max_chunk"] == 32
    assert manifest["image_sizes"][0] == {"width": 8, "height": 6}
    engine = manifest["simulator"]
    assert (engine["name"], engine["protocol"]) == ("breakable", 1)
    digest = hashlib.sha256(Path(SCRIPT).read_bytes()).hexdigest()
    assert engine["sources"][SCRIPT] == digest
    settings = definition.settings({"codec": "raw", "width": 8, "height": 6})
    assert json.loads(json.dumps(settings))["success_scored_tasks"] == []


def test_a_file_says_otherwise_than_the_program(tmp_path: Path) -> None:
    """Its keys win, its name is the id, and its files are in the manifest."""
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "cube.stl").write_text("solid")
    text = f"""{entry()}
version = "2"
max_steps = 7
max_faults = 9
files = ["assets/*"]
splits = [{{name = "test", episodes = 3, tasks = ["hold"]}}]
"""
    ((benchmark_id, definition),) = definitions(write_toml(tmp_path, text)).items()
    manifest = definition.describe({}, 1)
    assert benchmark_id == "counting"
    assert [manifest[n] for n in ("version", "max_steps", "max_faults")] == ["2", 7, 9]
    assert manifest["episodes_total"] == 3
    assert manifest["sealed_splits"] == ["test"]
    assert "assets/cube.stl" in manifest["simulator"]["sources"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("simulator = []", "simulator: List should have at least 1 item"),
        ('simulator = ["./gone"]', "gone cannot be started: No such file or directory"),
        ('simulator = ["true"]', "true ended with exit code 0"),
        ('simulator = ["unix:"]', "write unix:PATH and nothing behind"),
        ('simulator = ["unix:a", "b"]', "unix:a b: write unix:PATH and nothing behind"),
        (f'simulator = ["unix:{"x" * 200}"]', "a socket has at most 103 bytes"),
        (
            'simulator = ["unix:gone.sock"]\nstart_timeout_s = 0.1',
            "the simulator gone.sock is away (No such file or directory); it was tried",
        ),
        ('simulator = ["echo", "hello world"]', "a reply of 1751477356 bytes"),
        (
            'simulator = ["sleep", "9"]\nstart_timeout_s = 1',
            "1 s; `start_timeout_s`",
        ),
        (entry() + 'success = {info = "x"}', "success: not a key of a simulator"),
        (entry() + "[action.add]\nunit = 'm'", "action: not a key of a simulator"),
        (entry() + 'files = ["*.stl"]', "*.stl: no file matches"),
        (
            'made_by = "a.py:B"\nstart_timeout_s = 1',
            "start_timeout_s: not a key of an environment",
        ),
        (entry() + 'made_by = "a.py:B"', "give one of environment"),
        (entry() + "max_step = 3", "unknown key max_step; did you mean max_steps"),
        (entry() + 'splits=[{name="a",episodes=1,tasks=["x"]}]', "split a: no task x"),
        (entry("protocol_2"), "speaks protocol 2, and 1 was offered"),
        (entry("SIM-008"), "its description: action_space.add.parts.all.unit: Field"),
        (entry("SIM-015"), "in `step` 1 of count, sent another state than"),
        (entry("stages_with_the_goal"), "the stages ['begun', 'goal'] must have"),
        (entry("faults_to_observe"), "in `observe` after 0 steps of count, reports a"),
    ],
)
def test_a_program_that_cannot_be_played_is_refused(
    text: str, said: str, tmp_path: Path
) -> None:
    with pytest.raises(BadBenchmark) as refused:
        definitions(write_toml(tmp_path, text))
    assert said in str(refused.value)


def acts(space: dict[str, Any]) -> dict[str, Any]:
    return {"action_space": {"a": space}}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"tasks": []}, "tasks: List should have at least 1 item"),
        ({"max_steps": 0}, "max_steps: 0 must be greater than or equal to 1"),
        ({"max_steps": 30.0}, "max_steps: 30.0 must be a valid integer"),
        ({"graded": None}, "graded: null must be a valid boolean"),
        ({"action_space": {}}, "action_space: Dictionary should have at least 1 item"),
        ({"success_rule": "best"}, "success_rule: unknown value best"),
        ({"image_sizes": []}, "images and no image_sizes"),
        (
            {"sources": {"a.usd": "md5"}},
            "sources.a.usd: 'md5' must be 64 digits or letters",
        ),
        (
            acts({"size": 2, "out_of_range": "clip"}),
            "action_space.a.parts: Field required",
        ),
        (
            acts(vector({"b": part(3, quantity="speed")})),
            "action_space.a.parts.b.quantity: unknown value speed; there is position",
        ),
        (
            acts(vector({"b": part(3, rotation="yaw")})),
            "action_space.a.parts.b: yaw has 1 numbers, the part has 3",
        ),
        (acts(vector(2) | {"size": 3}), "the parts have 2 numbers, not 3"),
        (acts(vector(2, minimum=[0, 0], maximum=[1])), "1 bounds for size 2"),
    ],
)
def test_a_description_that_is_not_whole_is_refused(
    changes: dict[str, Any], said: str, tmp_path: Path
) -> None:
    described = breakable_simulator.WORLD.benchmark | changes
    (tmp_path / "world.py").write_text(DESCRIBES)
    command = [sys.executable, "-S", "world.py", json.dumps(described)]
    with pytest.raises(BadBenchmark) as refused:
        definitions(write_toml(tmp_path, f"simulator = {json.dumps(command)}"))
    assert said in str(refused.value)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"control_rate": 5},
            "`control_rate`, which is ignored; did you mean control",
        ),
        ({"is_graded": True}, "`is_graded`, which is ignored; did you mean graded?"),
        (
            {"observation_space": {"sum": vector(1)}},
            "`observation_space.sum`, which is ignored; there is state, images",
        ),
        (
            acts(vector({"b": part(1) | {"gripper_opn": 1}})),
            "`action_space.a.parts.b.gripper_opn`, which is ignored; did you mean g",
        ),
        (acts(vector(1) | {"task": ["a"]}), "`action_space.a.task`, which is ignored"),
        (acts(vector(1) | {"description": "a", "com_acme_a": 1}), None),
        ({"simulator": {"name": "a", "version": "1", "assets": "b"}}, None),
        ({"image_codecs": ["raw"], "splits": [{"name": "a", "seeds": [1]}]}, None),
    ],
)
def test_a_member_that_is_ignored_is_named(
    changes: dict[str, Any], said: str | None, tmp_path: Path
) -> None:
    """But names of others, and what else can change a score. It ends no server."""
    described = breakable_simulator.WORLD.benchmark | changes
    (tmp_path / "world.py").write_text(DESCRIBES)
    command = [sys.executable, "-S", "world.py", json.dumps(described)]
    reference = write_toml(tmp_path, f"simulator = {json.dumps(command)}")
    lines: list[str] = []
    with pytest.raises(BadBenchmark, match="NotImplementedError"):
        dict(registration.benchmarks(reference, lines.append))
    begin = "simulator world.py: its description has "
    assert [line.startswith(begin + said) for line in lines if said] == [True] * bool(
        said
    )
    assert bool(lines) == bool(said)


@pytest.mark.parametrize(
    ("fault", "more", "is_noted"),
    [
        ("ignores_the_seed", "", True),
        ("ignores_the_seed", 'splits = [{name = "test", episodes = 2}]', True),
        ("ignores_the_seed", 'splits = [{name = "a", seeds = [4]}]', False),
        ("", "", False),
    ],
)
def test_seeds_that_begin_alike_are_noted(
    fault: str, more: str, is_noted: bool, tmp_path: Path
) -> None:
    """Splits of one seed say that it is meant so."""
    lines: list[str] = []
    reference = write_toml(tmp_path, entry(fault) + more)
    dict(registration.benchmarks(reference, lines.append))
    said = "of count, in all that is observed up to the first step of count, hold: does"
    assert [said in line for line in lines] == [True] * is_noted


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ("", None),
        (
            "self.sum = self.offset = self.offset + 0.01",
            "count with the seed 1 was played twice",
        ),
        ("if task == 'hold': raise KeyError('hold')", "`reset` of hold, reports a fa"),
        ("if task == 'hold': begun['stages'] = ['goal']", "the stages ['goal'] must"),
        ("begun['stage'] = ['one']", "`stage`, which is ignored; did you mean stages?"),
    ],
)
def test_each_task_is_played_twice_before_it_is_offered(
    change: str, fault: str | None, tmp_path: Path
) -> None:
    """A member that is ignored is a note, and any other one ends the start."""
    (tmp_path / "world.py").write_text(
        "from breakable_simulator import WORLD, proctor_simulator\n"
        "class World(type(WORLD)):\n"
        "    def reset(self, task, seed, split):\n"
        "        begun = super().reset(task, seed, split)\n"
        f"        {change}\n"
        "        return begun\n"
        "proctor_simulator.serve(World())\n"
    )
    paths = f"PYTHONPATH={LIBRARIES}:{Path(SCRIPT).parent}"
    command = ["env", paths, sys.executable, "-S", "world.py"]
    reference = write_toml(tmp_path, f"simulator = {json.dumps(command)}")
    lines: list[str] = []
    try:
        dict(registration.benchmarks(reference, lines.append))
    except BadBenchmark as refused:
        lines = [str(refused)]
    said = [line for line in lines if fault and fault in line]
    assert len(said) == (fault is not None), lines


PRINTS = {
    "printed_by_python": ("print('by Python')", "by Python"),
    "printed_by_c": ("ctypes.CDLL(None).printf(b'by C\\n')", "by C"),
}


@pytest.mark.parametrize("name", PRINTS)
def test_the_last_print_before_a_crash_is_in_the_fault(
    name: str, tmp_path: Path
) -> None:
    """C, too, prints line by line, although its standard output is a pipe."""
    statement, said = PRINTS[name]
    (tmp_path / "world.py").write_text(
        "import ctypes, os\n"
        "from breakable_simulator import WORLD, proctor_simulator\n"
        "class World(type(WORLD)):\n"
        "    def step(self, action):\n"
        f"        {statement}\n"
        "        os._exit(9)\n"
        "proctor_simulator.serve(World())\n"
    )
    paths = f"PYTHONPATH={LIBRARIES}:{Path(SCRIPT).parent}"
    command = ["env", "-u", "PYTHONUNBUFFERED", paths, sys.executable, "-S", "world.py"]
    with pytest.raises(BadBenchmark) as refused:
        definitions(write_toml(tmp_path, f"simulator = {json.dumps(command)}"))
    fault = f"env, in `step` 1 of count, ended with exit code 9; its last line: {said}"
    assert fault in str(refused.value)


def test_a_program_that_was_edited_is_not_played(tmp_path: Path) -> None:
    """Its manifest has the hash of another file."""
    shutil.copy(SCRIPT, tmp_path / "world.py")
    command = ["env", f"PYTHONPATH={LIBRARIES}", sys.executable, "-S", "world.py"]
    reference = write_toml(tmp_path, f"simulator = {json.dumps(command)}")
    ((_, definition),) = definitions(reference).items()
    settings = definition.settings({"codec": "raw", "width": 8, "height": 6})
    with (tmp_path / "world.py").open("a") as file:
        file.write("# another one")
    with pytest.raises(ChangedSource, match=r"world\.py has changed since the server"):
        definition.make(settings)


HELPED = """
import arms.left
import proctor_simulator
from breakable_simulator import WORLD

class World(type(WORLD)):
    def step(self, action):
        import_late()
        return super().step(action)

def import_late():
    pass

proctor_simulator.serve(World())
"""


LATE = HELPED.replace("    pass", "    import late")


def helped_program(folder: Path) -> str:
    """A program with a module and a package beside it, and its benchmark file."""
    (folder / "arms").mkdir()
    (folder / "arms" / "__init__.py").write_text("")
    (folder / "arms" / "left.py").write_text("reach_m = 0.5\n")
    (folder / "late.py").write_text("")
    (folder / "world.py").write_text(HELPED)
    paths = f"PYTHONPATH={LIBRARIES}:{Path(SCRIPT).parent}"
    command = ["env", paths, sys.executable, "-S", "world.py"]
    return write_toml(folder, f"simulator = {json.dumps(command)}")


@pytest.mark.parametrize("edited", ["arms/left.py", "arms/__init__.py", "world.py"])
def test_an_edited_module_is_another_benchmark(edited: str, tmp_path: Path) -> None:
    """Its hash is in the manifest, and the server that has the old one says so."""
    reference = helped_program(tmp_path)
    ((_, definition),) = definitions(reference).items()
    before = definition.describe({}, 1)["simulator"]["sources"]
    content = (tmp_path / edited).read_bytes()
    assert before[edited] == hashlib.sha256(content).hexdigest()
    assert {"proctor_simulator.py", "breakable_simulator.py"} <= before.keys()
    assert not [n for n in before if n.startswith("/") and n != sys.executable]
    settings = definition.settings({"codec": "raw", "width": 8, "height": 6})
    simulator = definition.make(settings)
    task = definition.describe({}, 1)["tasks"][0]
    simulator.reset(task, 1)
    assert not definition.changed_files()
    with (tmp_path / edited).open("a") as file:
        file.write("# another one\n")
    assert definition.changed_files() == [edited]
    said = f"^{edited} has changed since the server"
    with pytest.raises(ChangedSource, match=said):
        definition.make(settings)
    with pytest.raises(ChangedSource, match=said):
        simulator.reset(task, 1)
    simulator.close()
    ((_, definition),) = definitions(reference).items()
    after = definition.describe({}, 1)["simulator"]["sources"]
    assert {name for name in before if after[name] != before[name]} == {edited}


def test_each_benchmark_of_a_folder_watches_its_own_file(tmp_path: Path) -> None:
    """Others of the folder may change. Runs of before go on: nothing reads it again."""
    for name in ("a", "b"):
        write_toml(tmp_path, entry() + f'benchmark_id = "{name}"\n', f"{name}.toml")
    found = definitions(str(tmp_path))
    settings = found["b"].settings({"codec": "raw", "width": 8, "height": 6})
    with (tmp_path / "b.toml").open("a") as file:
        file.write("max_steps = 5\n")
    changed = {name: one.changed_files() for name, one in found.items()}
    assert changed == {"a": [], "b": ["b.toml"]}
    simulator = found["b"].make(settings)
    simulator.reset("count", 1)
    simulator.close()


def test_a_link_in_an_installed_folder_is_not_announced(tmp_path: Path) -> None:
    """As Debian's sitecustomize.py, which lies in /etc. Expect the module beside it."""
    reference = helped_program(tmp_path)
    (tmp_path / "late.py").rename(tmp_path / "real.py")
    (tmp_path / "site-packages").mkdir()
    (tmp_path / "site-packages" / "late.py").symlink_to(tmp_path / "real.py")
    program = "import sys\nsys.path.append('site-packages')\nimport late\n" + HELPED
    (tmp_path / "world.py").write_text(program)
    ((_, definition),) = definitions(reference).items()
    sources = definition.describe({}, 1)["simulator"]["sources"]
    assert "arms/left.py" in sources
    assert {"real.py", "late.py"}.isdisjoint(sources)


@pytest.mark.parametrize(
    ("program", "said"),
    [
        (LATE, "late.py was not imported when the program described itself"),
        (HELPED.replace("World())", "World(), installed=['.'])"), None),
        (LATE.replace("World())", "World(), installed=['.'])"), None),
        (HELPED.replace("    pass", "    import wave"), None),
        (HELPED.replace("    pass", "    import multiprocessing"), None),
    ],
)
def test_an_import_that_is_late_is_a_fault(
    program: str, said: str | None, tmp_path: Path
) -> None:
    """The file is in no manifest; installed packages and Python's own may be late."""
    reference = helped_program(tmp_path)
    (tmp_path / "world.py").write_text(program)
    if said is None:
        definitions(reference)
    else:
        with pytest.raises(BadBenchmark, match=said):
            definitions(reference)


def test_shared_memory_has_the_pixels_that_data_has() -> None:
    """The first observation is sent, the second is drawn into memory."""
    program = Program([sys.executable, "-S", SCRIPT], ".")
    simulator = ExternalSimulator(program, DeclaredFiles(Path(), {}), (640, 480))
    try:
        simulator.reset("count", 1)
        simulator.step({"add": [0.1]})
        drawn = []
        for _ in range(3):
            FRAME_BUFFER.swap()
            drawn.append(simulator.observe().images["bar"])
        assert FRAME_BUFFER.place_of(drawn[-1]) is not None
        assert drawn[0].max() == 5
        assert all(np.array_equal(drawn[0], pixels) for pixels in drawn)
    finally:
        simulator.close()


@pytest.mark.slow("compiles, starts programs and judges them")
@pytest.mark.parametrize(
    "example", ["numpy_world.py", "drawn_world.cpp", "mujoco_world.cpp", "go_world"]
)
def test_an_example_is_played_as_its_head_says(example: str, tmp_path: Path) -> None:
    """Expect the score of a policy that goes straight to the target: every episode."""
    command = build_example(example, tmp_path)
    lines: list[str] = []
    reference = f"simulator:{' '.join(command)}"
    ((_, definition),) = registration.benchmarks(reference, lines.append)
    assert not [line for line in lines if "alike" in line or "ignored" in line]
    manifest = definition.describe({}, 1)
    settings = definition.settings({"codec": "raw", **manifest["image_sizes"][0]})
    world = benchmark_registry.SimulatorConfig(manifest["benchmark_id"], settings)
    simulator = benchmark_registry.make(world)
    try:
        for seed in range(3):
            simulator.reset(manifest["tasks"][0], seed)
            for _ in range(manifest["max_steps"]):
                state = simulator.observe().state
                gap = state["target"] - state["position"]
                step = simulator.step({"velocity": np.clip(10 * gap, -1, 1).tolist()})
                if step.terminated:
                    break
            assert step.success
    finally:
        simulator.close()
