"""LIBERO's benchmarks, with a package that stands in for LIBERO and its assets.

`make libero-check` plays LIBERO itself (libero_checks.py).
"""

import math
import os
import pickle
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from reference_client.api.observation import Observation
from reference_client.policies.mapping import PolicyMapping
from reference_record.contents.contradicted_assumptions import contradictions
from reference_sim import benchmark_registry
from reference_sim.external.libero import libero_world
from reference_sim.gymnasium import registration
from tests.support.libero import fake_libero
from tests.support.libero.play_libero import by_lerobot, by_openpi
from tests.support.paths import ROOT
from tests.support.processes import run_program

PROGRAM = str(ROOT / "reference_sim" / "external" / "libero" / "libero_world.py")
HOLD = {"action": [0.0] * 6 + [-1.0]}


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, Any]]:
    """The definitions of the bundled file, by id."""
    folder = tmp_path_factory.mktemp("libero") / "site-packages"
    clone = fake_libero.install(folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("PYTHONPATH", str(folder))
        patch.setenv("LIBERO_PATH", str(clone))
        patch.setenv("LIBERO_PYTHON", sys.executable)
        yield dict(registration.benchmarks("libero", lambda _line: None))


@pytest.fixture
def simulator(served: dict[str, Any]) -> Iterator[Any]:
    images = {"codec": "raw", "width": 256, "height": 256}
    settings = served["libero_goal"].settings(images)
    world = benchmark_registry.SimulatorConfig("libero_goal", settings)
    made = benchmark_registry.make(world)
    yield made
    made.close()


def test_each_suite_is_a_benchmark(served: dict[str, Any]) -> None:
    """Expect the limits of steps that openpi's evaluation has."""
    manifests = {name: d.describe({}, 1) for name, d in served.items()}
    assert {name: m["max_steps"] for name, m in manifests.items()} == {
        "libero_spatial": 220,
        "libero_object": 280,
        "libero_goal": 300,
        "libero_10": 520,
    }
    for manifest in manifests.values():
        assert manifest["tasks"] == fake_libero.TASKS
        assert manifest["episodes_total"] == 50 * len(fake_libero.TASKS)
        assert {e["seed"] for e in manifest["episodes"]} == set(range(50))
        assert "sealed_splits" not in manifest
        engine = manifest["simulator"]
        assert (engine["version"], engine["robosuite"]) == ("0.1.4", "1.4.0")
        assert len(engine["assets_sha256"]) == 64
        assert engine["sources"].keys() == {"libero_world.py", "proctor_simulator.py"}


def test_an_episode_begins_at_its_published_state(simulator: Any) -> None:
    """After ten steps in which the gripper opens. Expect the trained instruction."""
    text = simulator.reset("KITCHEN_SCENE10_close_the_drawer", 7)
    state = simulator.observe().state
    assert text == "close the drawer"
    assert state["state"][:3] == pytest.approx(fake_libero.STATES[7])
    assert state["state"][3:6] == pytest.approx([math.pi, 0, 0])
    assert state["state"][6:] == pytest.approx([0.09, -0.09])


def test_a_seed_without_a_published_state_is_sampled(simulator: Any) -> None:
    simulator.reset("push_the_plate", 50)
    assert simulator.observe().state["state"][:3] == pytest.approx([0.5] * 3)


def test_an_episode_does_not_depend_on_those_before(simulator: Any) -> None:
    """LIBERO's list of samplers grows at each reset. Expect equal digests."""
    digests = []
    for seed in (3, 4, 3):
        simulator.reset("push_the_plate", seed)
        digests.append(simulator.state_bytes())
    assert digests[0] == digests[2] != digests[1]


def test_success_ends_an_episode(simulator: Any) -> None:
    simulator.reset("push_the_plate", 0)
    steps = [simulator.step({"action": [1.0] * 7}) for _ in range(7)]
    assert [step.success for step in steps] == [False] * 6 + [True]
    assert [step.terminated for step in steps] == [False] * 6 + [True]
    assert steps[-1].reward == 1.0


def test_images_are_of_the_state_that_is_observed(simulator: Any) -> None:
    """Turned by 180°: the corner that robosuite draws first is the last one."""
    simulator.reset("push_the_plate", 0)
    for _ in range(3):
        simulator.step({"action": [1.0] * 7})
        seen = simulator.observe()
        grey = 100 + round(100 * seen.state["state"][0])
        for name, camera in libero_world.CAMERAS.items():
            image = seen.images[name]
            assert (image[-64:, -64:] == grey).all()
            assert image[0, 0, 0] == (camera == "agentview")
            assert (image[64:-64] == 9).all()
    assert grey == 110


def test_the_page_has_the_mapping_of_openpi(
    served: dict[str, Any], simulator: Any, tmp_path: Path
) -> None:
    """Expect the request of openpi's example, and its answer as five actions."""
    page = (ROOT / "docs" / "host" / "simulators.md").read_text()
    (text,) = re.findall(r"```toml\n(# libero-openpi\.toml\n.*?)```", page, re.DOTALL)
    (tmp_path / "m.toml").write_text(text)
    mapping = PolicyMapping.read(tmp_path / "m.toml")
    manifest = served["libero_goal"].describe({}, 1)
    assert list(contradictions(mapping.assumes or {}, manifest)) == []
    instruction = simulator.reset("push_the_plate", 0)
    seen = simulator.observe()
    observation = Observation(
        state=dict(seen.state),
        images=dict(seen.images),
        tensors={},
        instruction=instruction,
        episode_id="e",
        step=0,
    )
    request = mapping.request(observation)
    assert request["prompt"] == "push the plate"
    assert request["observation/state"] == pytest.approx(seen.state["state"])
    for name in ("observation/image", "observation/wrist_image"):
        assert request[name].shape == (224, 224, 3)
    rows = np.linspace(-1, 1, 70).reshape(10, 7)
    chunk = mapping.chunk({"actions": rows}, observation)
    assert len(chunk) == 5
    assert chunk[2]["action"] == pytest.approx(rows[2])


@pytest.mark.parametrize(
    ("quaternion", "turn"),
    [
        ([0, 0, 0, 1], [0, 0, 0]),
        ([0, 0, 0, -1], [0, 0, 0]),
        ([1, 0, 0, 0], [math.pi, 0, 0]),
        ([0, 0, math.sin(0.15), math.cos(0.15)], [0, 0, 0.3]),
        # The hand at the beginning of an episode of libero_spatial: more than half a
        # turn, which is not written as less than half a turn the other way.
        (
            [0.999609615, -0.000906336483, -0.0279235845, -0.000264635271],
            [3.1408953968, -0.0028478215, -0.0877393101],
        ),
        ([0, -math.sin(2.5), 0, math.cos(2.5)], [0, -5.0, 0]),
    ],
)
def test_orientations_are_written_as_openpi_and_lerobot_do(
    quaternion: list[float], turn: list[float]
) -> None:
    ours = libero_world.axis_angle(*quaternion)
    assert ours == pytest.approx(turn, abs=2e-7)
    numbers = np.array(quaternion, np.float64)
    assert ours == pytest.approx(by_openpi(numbers), abs=1e-12)
    assert ours == pytest.approx(by_lerobot(numbers), abs=2e-6)


def test_a_published_file_runs_nothing(tmp_path: Path) -> None:
    """A file with numbers is read; one that names a function is refused."""
    path = tmp_path / "task.pruned_init"
    path.write_bytes(fake_libero.torch_file(fake_libero.STATES))
    assert np.array_equal(libero_world.read_states(path), fake_libero.STATES)
    path.write_bytes(fake_libero.torch_file(os.getpid))
    with pytest.raises(pickle.UnpicklingError, match="no array of numbers"):
        libero_world.read_states(path)


@pytest.mark.parametrize(
    ("environment", "arguments", "said"),
    [
        ({}, ["libero_goal"], "LIBERO_PATH is not set; `git clone"),
        ({"LIBERO_PATH": "/gone"}, ["libero_goal"], "LIBERO_PATH has no /gone/libero"),
        ({}, ["libero_90"], "name a suite: libero_spatial, libero_object, "),
        ({}, [], "name a suite: "),
        ({"LIBERO_PYTHON": "/gone/python"}, [], "LIBERO_PYTHON: no /gone/python"),
        ({"PYTHONPATH": "/gone"}, ["libero_10"], "hf-libero is not installed for "),
    ],
)
def test_missing_parts_are_named(
    environment: dict[str, str], arguments: list[str], said: str, tmp_path: Path
) -> None:
    fake_libero.install(tmp_path)
    done = run_program(
        [sys.executable, PROGRAM, *arguments],
        env={"PATH": os.environ["PATH"], "PYTHONPATH": str(tmp_path)} | environment,
    )
    assert done.returncode == 1
    assert done.stderr.startswith(said)
    assert done.stderr.count("\n") == 1
