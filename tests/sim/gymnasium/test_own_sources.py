"""What an environment consists of: in the manifest, and refused when it has changed."""

import asyncio
import os
import sysconfig
import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

import reference_sim
from reference_sim import benchmark_registry
from reference_sim.benchmark_registry import SimulatorConfig
from reference_sim.definition import Json
from reference_sim.gymnasium import registration
from reference_sim.gymnasium.benchmark_file import read
from reference_sim.gymnasium.own_sources import OwnSources, hash_files
from reference_sim.process.pool import Begin, SimulatorFault, SimulatorPool
from tests.support.sim.shared_processes import opened_pool

pytestmark = pytest.mark.slow("starts a process for each check")

FILES = {
    "lab.py": """
        import json
        from pathlib import Path

        import gymnasium
        import numpy as np
        from gymnasium.spaces import Box

        import helper
        import utils.geometry
        from PIL import Image

        LAYOUT = json.loads((Path(__file__).parent / "layout.json").read_text())

        class Lab(gymnasium.Env):
            action_space, observation_space = Box(-1, 1, (1,)), Box(-9, 9, (1,))
            max_steps = 30

            def reset(self, *, seed=None, options=None):
                super().reset(seed=seed)
                self.x, self.steps = self.np_random.uniform(0, LAYOUT["width"]), 0
                return np.array([self.x], np.float32), {}

            def step(self, action):
                self.x, self.steps = helper.move(self.x, action[0]), self.steps + 1
                if self.steps > 20:
                    try:
                        import late
                    except Exception:
                        pass
                return np.array([self.x], np.float32), 0.0, False, False, {}
        """,
    "helper.py": """
        def move(x, by):
            return min(9.0, max(-9.0, x + float(by)))
        """,
    "utils/geometry.py": "HALF = 0.5\n",
    "judge.py": """
        import rubric

        def at_mark(environment, info):
            return environment.x > rubric.MARK
        """,
    "rubric.py": "MARK = 3\n",
    "layout.json": '{"width": 1}\n',
    "late.py": "",
    "unrelated.py": "",
    "PIL/README": "A folder with the name of an installed package is not taken for it.",
    "lab.toml": """
        made_by = "lab.py:Lab"
        success = { function = "judge.py:at_mark" }
        files = ["*.json"]
        """,
}
SOURCES = {"helper.py", "judge.py", "lab.py", "layout.json", "rubric.py"}
SOURCES |= {"utils/geometry.py"}


def write(folder: Path) -> Path:
    for name, text in FILES.items():
        (folder / name).parent.mkdir(exist_ok=True)
        mark = "# 1\n" if name.endswith(".py") else ""
        (folder / name).write_text(textwrap.dedent(text) + mark)
    return folder


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    """The folder of an environment of many files."""
    return write(tmp_path)


@pytest.fixture(scope="module")
def checked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, SimulatorConfig]:
    """One that was checked, for tests that put back what they change."""
    folder = write(tmp_path_factory.mktemp("checked"))
    return folder, world_of(check(folder / "lab.toml"))


def check(reference: Path | str) -> Json:
    ((benchmark, folder),) = read(str(reference))
    return registration.examine(benchmark, folder, print)


def world_of(report: Json) -> SimulatorConfig:
    assert report["faults"] == []
    definition = registration._definition(report)
    size = definition.describe({}, 8)["image_sizes"][-1]
    return SimulatorConfig("lab", definition.settings({"codec": "raw", **size}))


def report_of(world: SimulatorConfig) -> Json:
    """As of a check of the files; one source lies outside of their folder."""
    plan = world.settings["plan"]
    folder = Path(plan["made_of"]["folder"])
    sources = hash_files(folder, sorted(SOURCES)) | {"elsewhere.py": "0"}
    manifest = {"simulator": {"sources": sources}}
    return {"plan": plan, "manifest": manifest, "ray_resources": {}}


def edit(file: Path) -> None:
    """Other content of the same size, at the same time: caches do not notice it."""
    before, (text, mark, rest) = file.stat(), file.read_text().rpartition("1")
    assert mark
    file.write_text(f"{text}2{rest}")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))


def test_the_manifest_has_every_file_that_was_executed_or_declared(lab: Path) -> None:
    report = check(lab / "lab.toml")
    assert (report["faults"], report["warnings"]) == ([], [])
    simulator = report["manifest"]["simulator"]
    assert set(simulator["sources"]) == SOURCES
    assert {"numpy", "gymnasium", "pillow"} == set(simulator["packages"])


@pytest.mark.parametrize(
    ("path", "is_own"),
    [
        ("lab/world.py", True),
        ("elsewhere/robots.py", True),
        ("lab/.venv/lib/python3.11/site-packages/robots.py", False),
        ("usr/lib/python3/dist-packages/robots.py", False),
        ("usr/lib/python3/dist-packages/sitecustomize.py", False),  # a link
        (sysconfig.get_path("stdlib") + "/json/__init__.py", False),
        (reference_sim.__file__, False),
        (pytest.__file__, False),
    ],
)
def test_a_file_is_own_unless_a_package_python_or_this_project_versions_it(
    tmp_path: Path, path: str, is_own: bool
) -> None:
    file = tmp_path / path
    file.parent.mkdir(parents=True, exist_ok=True)
    if file.name == "sitecustomize.py":
        (tmp_path / "etc").mkdir()
        (tmp_path / "etc" / file.name).touch()
        file.symlink_to(tmp_path / "etc" / file.name)
    sources = OwnSources()
    sources._folders = [tmp_path / "lab"]
    assert sources._is_own(file) is is_own


def test_a_change_of_any_of_them_is_another_benchmark(lab: Path) -> None:
    before = check(lab / "lab.toml")["manifest"]["simulator"]["sources"]
    for name in SOURCES:
        edit(lab / name)
    after = check(lab / "lab.toml")["manifest"]["simulator"]["sources"]
    assert {name for name in before if before[name] != after[name]} == SOURCES


@pytest.mark.parametrize(
    ("name", "change", "is_named"),
    [
        ("helper.py", edit, True),
        ("utils/geometry.py", lambda file: file.write_text("HALF = 0.1"), True),
        ("layout.json", lambda file: file.write_text("{}"), True),
        ("lab.toml", lambda file: file.write_text(f"{file.read_text()}\n"), True),
        ("helper.py", Path.unlink, True),
        ("helper.py", lambda file: os.utime(file, ns=(1, 1)), False),
        ("unrelated.py", lambda file: file.write_text("MOVED = 1"), False),
    ],
)
def test_a_benchmark_whose_files_have_changed_is_unavailable(
    checked: tuple[Path, SimulatorConfig],
    monkeypatch: pytest.MonkeyPatch,
    name: str,
    change: Callable[[Path], object],
    *,
    is_named: bool,
) -> None:
    """So no run of it is accepted, until the change is undone."""
    folder, world = checked
    definition = registration._watched(
        registration._definition(report_of(world)),
        folder,
        hash_files(folder, ["lab.toml"]),
    )
    monkeypatch.setattr(benchmark_registry, "_definition", lambda _: definition)
    assert benchmark_registry.unavailable_reason("lab") is None
    content = (folder / name).read_bytes()
    try:
        change(folder / name)
        reason = benchmark_registry.unavailable_reason("lab")
    finally:
        (folder / name).write_bytes(content)
    said = f"{name} has changed since the server started: restart the server"
    assert (reason or "").startswith(said) is is_named
    assert benchmark_registry.unavailable_reason("lab") is None


def test_a_file_of_data_that_is_not_declared_is_a_warning(lab: Path) -> None:
    (warning,) = [w for w in check(f"{lab}/lab.py:Lab")["warnings"] if "reads" in w]
    assert "reads layout.json, which is not in the manifest" in warning
    assert 'files = ["layout.json"]' in warning


@pytest.mark.parametrize(
    ("files", "reason"),
    [
        (["maps/*.json"], "files: maps/*.json: no file matches"),
        (["/etc/hostname"], "files: /etc/hostname: must be relative"),
        (["utils"], "files: utils: no file matches"),
    ],
)
def test_files_that_cannot_be_hashed_are_refused(
    lab: Path, files: list[str], reason: str
) -> None:
    (lab / "lab.toml").write_text(f'made_by = "lab.py:Lab"\nfiles = {files}\n')
    (fault,) = check(lab / "lab.toml")["faults"]
    assert fault.startswith(reason)


async def play(pool: SimulatorPool, world: SimulatorConfig, steps: int) -> None:
    handle = await pool.acquire(world)
    try:
        await handle.begin(Begin("lab", 1, max_steps=30, success_rule="any_step"))
        await handle.play([{"action": [0.1]}] * steps, observe_all=False)
    finally:
        await handle.release()


def play_in_new_process(world: SimulatorConfig, steps: int = 1) -> None:
    async def run() -> None:
        async with opened_pool() as pool:
            await play(pool, world, steps)

    asyncio.run(run())


@pytest.mark.parametrize("change", [edit, Path.unlink])
@pytest.mark.parametrize("name", sorted(SOURCES))
def test_a_changed_file_is_not_played_under_the_manifest_of_before(
    checked: tuple[Path, SimulatorConfig], name: str, change: Callable[[Path], None]
) -> None:
    folder, world = checked
    content = (folder / name).read_bytes()
    change(folder / name)
    try:
        reason = f"{name} has changed since" if change is edit else None
        with pytest.raises(SimulatorFault, match=reason):
            play_in_new_process(world)
    finally:
        (folder / name).write_bytes(content)


@pytest.mark.parametrize("change", [edit, Path.unlink])
@pytest.mark.parametrize("name", sorted(SOURCES))
def test_a_process_that_has_played_does_not_play_on_with_the_old_code(
    checked: tuple[Path, SimulatorConfig], name: str, change: Callable[[Path], None]
) -> None:
    """An episode that runs goes on; no other begins until the change is undone."""
    folder, world = checked
    content = (folder / name).read_bytes()

    async def run() -> None:
        async with opened_pool() as pool:
            handle = await pool.acquire(world)
            begin = Begin("lab", 1, max_steps=30, success_rule="any_step")
            await handle.begin(begin)
            change(folder / name)
            await handle.play([{"action": [0.1]}], observe_all=False)
            with pytest.raises(SimulatorFault, match=f"{name} has changed since"):
                await handle.begin(begin)
            (folder / name).write_bytes(content)
            await play(pool, world, 1)

    try:
        asyncio.run(run())
    finally:
        (folder / name).write_bytes(content)


def test_a_file_that_is_imported_during_play_alone_is_refused(
    checked: tuple[Path, SimulatorConfig],
) -> None:
    play_in_new_process(checked[1], steps=15)
    with pytest.raises(SimulatorFault, match=r"late\.py was not imported when"):
        play_in_new_process(checked[1], steps=25)


def test_another_version_of_a_package_is_refused(lab: Path) -> None:
    world = world_of(check(lab / "lab.toml"))
    world.settings["plan"]["packages"]["gymnasium"] = "0.1"
    with pytest.raises(SimulatorFault, match=r"gymnasium is .* and was 0\.1 when"):
        play_in_new_process(world)


def test_two_environments_with_a_helper_of_one_name_each_play_their_own(
    lab: Path, tmp_path_factory: pytest.TempPathFactory
) -> None:
    """An idle process has imported one of them, and is not used for the other."""
    twin = write(tmp_path_factory.mktemp("twin"))
    edit(twin / "helper.py")
    worlds = [world_of(check(folder / "lab.toml")) for folder in (lab, twin)]

    async def run() -> None:
        async with opened_pool() as pool:
            for world in [*worlds, *worlds]:
                await play(pool, world, 3)
            assert (pool.starts, pool.idle) == (2, 2)

    asyncio.run(run())


# --- messages ---


@pytest.mark.parametrize(
    ("source", "reasons"),
    [
        ("import labtools", ["No module named 'labtools'", "labtools.py", "make add"]),
        ("from .helper import move", ["relative import", "`import NAME`"]),
        ("from helper import walk", ["cannot import name 'walk' from 'helper'"]),
    ],
)
def test_an_import_that_fails_says_what_to_do(
    lab: Path, source: str, reasons: list[str]
) -> None:
    (lab / "mine.py").write_text(source)
    (fault,) = check(f"{lab}/mine.py:Mine")["faults"]
    assert fault.startswith("cannot import mine.py: ")
    assert all(reason in fault for reason in reasons)


RESET = "    def reset(self, *, seed=None, options=None): return {}\n"
STEP = "    def step(self, action): return {}\n"
SPACES = (
    "    from gymnasium.spaces import Box\n"
    "    action_space = observation_space = Box(-1, 1, (1,))\n"
)
FIVE = "[0.0], 0.0, False, False, {}"


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("    pass\n", "it has no action_space, observation_space, reset, step"),
        (SPACES + STEP.format(FIVE), "it has no reset"),
        (SPACES + "    def reset(self): ...\n" + STEP, "its reset takes no seed"),
        (
            SPACES + "    def reset(self, seed): ...\n" + STEP,
            "its reset takes no options",
        ),
        (
            SPACES + RESET.format("[0.0]") + STEP,
            "its reset returns a list, not (observation, info)",
        ),
        (SPACES + RESET.format("[0.0], 3") + STEP, "the info of its reset is a int"),
        (
            SPACES + RESET.format("[0.0], {}") + STEP.format("[0.0], 0.0, False, {}"),
            "its step returns 4 values, not (observation, reward, terminated, ",
        ),
    ],
)
def test_a_class_of_another_interface_is_shown_the_lines_that_it_needs(
    tmp_path: Path, body: str, reason: str
) -> None:
    (tmp_path / "mine.py").write_text(f"class Mine:\n{body}")
    (fault,) = check(f"{tmp_path}/mine.py:Mine")["faults"]
    first, _, lines = fault.partition("\n")
    assert reason in first
    assert "class Mine(gymnasium.Env):" in lines
    assert "def step(self, action):" in lines


def test_a_class_without_close_render_and_metadata_is_enough(tmp_path: Path) -> None:
    body = SPACES + RESET.format("[0.0], {}") + STEP.format(FIVE)
    (tmp_path / "mine.py").write_text(f"class Mine:\n{body}")
    assert check(f"{tmp_path}/mine.py:Mine")["faults"] == []
