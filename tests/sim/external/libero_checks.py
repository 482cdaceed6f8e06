"""Tests that need LIBERO and its assets: `make libero-check LIBERO_PATH=…/LIBERO`.

The program is started by LIBERO_PYTHON, in .venv-libero. Not part of `make test`, which
has no assets; test_libero.py is. They take minutes: a model is compiled at each reset.
"""

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest

from reference_sim import benchmark_registry
from reference_sim.external.libero import libero_world
from reference_sim.gymnasium import registration
from reference_sim.interface import StepOutcome
from tests.support.libero import play_libero
from tests.support.libero.play_libero import by_lerobot, by_openpi

pytestmark = pytest.mark.slow("plays LIBERO, which compiles a model at each reset")
# The digest of the folder `assets` in commit 8f1084e of LIBERO's repository.
ASSETS_SHA256 = "779eb467bba0cf6197dba5ccda298cd6de215160156c944e6e037c82af1472d1"
SOUP, BASKET = (-0.1191, -0.2398), (0.0148, 0.2521)  # of the published state 0
OPEN, CLOSED = -1.0, 1.0


@pytest.fixture(scope="module")
def served() -> dict[str, Any]:
    return dict(registration.benchmarks("libero", print))


@pytest.fixture(scope="module")
def direct(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """The observations of robosuite itself, by suite."""
    folder = tmp_path_factory.mktemp("direct")
    python, program = os.environ["LIBERO_PYTHON"], play_libero.__file__
    subprocess.run([python, program, str(folder)], check=True)
    return {suite: np.load(folder / f"{suite}.npz") for suite in libero_world.MAX_STEPS}


@contextmanager
def simulator(served: dict[str, Any], suite: str) -> Iterator[Any]:
    settings = served[suite].settings({"codec": "raw", "width": 256, "height": 256})
    made = benchmark_registry.make(benchmark_registry.SimulatorConfig(suite, settings))
    try:
        yield made
    finally:
        made.close()


def test_the_assets_are_those_that_were_published() -> None:
    assert libero_world.digest_of(libero_world.assets_folder()) == ASSETS_SHA256


@pytest.mark.parametrize("suite", libero_world.MAX_STEPS)
def test_an_episode_is_that_of_openpi_and_lerobot(
    suite: str, served: dict[str, Any], direct: dict[str, Any]
) -> None:
    """The same published state and actions. Expect each pixel and number to agree."""
    manifest = served[suite].describe({}, 1)
    assert len(manifest["tasks"]) == 10
    assert manifest["episodes_total"] == 500
    raw, seen = direct[suite], []
    with simulator(served, suite) as played:
        played.reset(manifest["tasks"][0], play_libero.STATE)
        seen.append(played.observe())
        for action in play_libero.actions():
            played.step({"action": action.tolist()})
            seen.append(played.observe())
    for row, observation in enumerate(seen):
        state = observation.state["state"]
        assert np.array_equal(state[:3], raw["robot0_eef_pos"][row])
        quaternion = raw["robot0_eef_quat"][row]
        assert state[3:6] == pytest.approx(by_openpi(quaternion), abs=1e-12)
        assert state[3:6] == pytest.approx(by_lerobot(quaternion), abs=2e-6)
        assert np.array_equal(state[6:], raw["robot0_gripper_qpos"][row])
        for name, camera in libero_world.CAMERAS.items():
            drawn = raw[f"{camera}_image"][row]
            assert np.array_equal(observation.images[name], drawn[::-1, ::-1])


def test_a_hand_written_controller_succeeds(served: dict[str, Any]) -> None:
    """It knows where the alphabet soup is, and drops it into the basket."""
    with simulator(served, "libero_object") as played:
        played.reset("pick_up_the_alphabet_soup_and_place_it_in_the_basket", 0)
        step: StepOutcome | None = None
        steps = 0
        for place, gripper, most in (
            *(((*SOUP, 0.20), OPEN, 40), ((*SOUP, 0.03), OPEN, 40)),
            *(((*SOUP, 0.03), CLOSED, 12), ((*SOUP, 0.28), CLOSED, 40)),
            *(((*BASKET, 0.28), CLOSED, 60), ((*BASKET, 0.20), CLOSED, 20)),
            *(((*BASKET, 0.20), OPEN, 30),),
        ):
            for _ in range(most):
                if step is not None and step.success:
                    break
                hand = played.observe().state["state"][:3]
                speed = np.clip((np.array(place) - hand) / 0.1, -1, 1)
                action = [*speed.tolist(), 0.0, 0.0, 0.0, gripper]
                step = played.step({"action": action})
                steps += 1
        assert step is not None
        assert step.success
        assert step.terminated
        assert steps < libero_world.MAX_STEPS["libero_object"]
