"""`python -m tools experts`: checks that experts solve the tasks, and chance does not.

Plays every task and split of every benchmark that has an expert, over many seeds: with
the expert, without moving, and with random actions. A benchmark is included if its
package in reference_sim.benchmarks has a module `experts` with `make_expert()`. NAME is
then the benchmark with cameras, NAME_state the one without, and NAME.tasks.TASKS has
the tasks: the docstring of a task's `goal_holds`, or else of its class, is the goal in
words. `experts` may define PICTURE_CAMERA, and PICTURE_MOMENTS: task → share of the
expert's episode.

Exit code 1 if a criterion is missed. With --write the figures are written to
docs/evaluate/tasks.md, with a picture of each task. This module knows no scene and not
MuJoCo.
"""

import importlib
import importlib.util
import multiprocessing
import os
import pkgutil
import statistics
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from reference_sim import benchmark_registry, benchmarks  # noqa: E402
from reference_sim.definition import goals_in_words  # noqa: E402
from reference_sim.interface import Action, Observation, Simulator  # noqa: E402

EXPERT_AT_LEAST = 0.99
LUCK_AT_MOST = 0.02
LUCK_SHARE = {"still": 0.1, "random": 0.5}  # of the expert's seeds: luck hardly varies
FIRST_SEED = 0
DRAWN_SIZE = (640, 480)  # drawn large and shrunk: smooth edges
PICTURE_SIZE = (320, 240)
DEFAULT_MOMENT = 0.7
PAGE = ROOT / "docs" / "evaluate" / "tasks.md"
PICTURES = ROOT / "docs" / "evaluate" / "tasks"


class Expert(Protocol):
    def reset(self, instruction: str) -> None: ...

    def act(
        self, observation_state: Mapping[str, Sequence[float]]
    ) -> Mapping[str, Sequence[float]]: ...


Policy = Callable[[Observation], Action]


@dataclass(frozen=True, slots=True)
class Trial:
    """A player, a task and a number of seeds. player: expert, still or random."""

    benchmark: str
    task: str
    split: str
    player: str
    seeds: int


@dataclass(frozen=True, slots=True)
class TrialResult:
    """steps: of the successful episodes."""

    trial: Trial
    steps: tuple[int, ...]

    @property
    def share(self) -> float:
        return len(self.steps) / self.trial.seeds

    @property
    def is_missed(self) -> bool:
        if self.trial.player == "expert":
            return self.share < EXPERT_AT_LEAST
        return self.share > LUCK_AT_MOST

    def __str__(self) -> str:
        of = self.trial
        counts = f"{len(self.steps)} of {of.seeds}"
        verdict = "  MISSED" if self.is_missed else ""
        return f"{of.benchmark} {of.task} {of.split} {of.player}: {counts}{verdict}"


# Benchmarks and experts


def benchmark_names() -> list[str]:
    """Names of the packages with an expert, whose benchmarks are offered."""
    return [
        package.name
        for package in pkgutil.iter_modules(benchmarks.__path__)
        if f"{package.name}_state" in benchmark_registry.benchmark_ids()
        and importlib.util.find_spec(f"reference_sim.benchmarks.{package.name}.experts")
    ]


def experts_of(benchmark: str) -> Any:
    return importlib.import_module(f"reference_sim.benchmarks.{benchmark}.experts")


def tasks_of(benchmark: str) -> Mapping[str, Any]:
    module = importlib.import_module(f"reference_sim.benchmarks.{benchmark}.tasks")
    tasks: Mapping[str, Any] = module.TASKS
    return tasks


@cache
def manifest(benchmark: str) -> Mapping[str, Any]:
    return benchmark_registry.resolve(f"{benchmark}_state").manifest


@cache
def simulator(benchmark: str) -> Simulator:
    chosen = benchmark_registry.resolve(f"{benchmark}_state")
    return benchmark_registry.make(chosen.world)


@cache
def expert(benchmark: str) -> Expert:
    made: Expert = experts_of(benchmark).make_expert()
    return made


# Playing


def play(trial: Trial) -> TrialResult:
    """In a process of its own."""
    sim, steps = simulator(trial.benchmark), []
    for seed in range(FIRST_SEED, FIRST_SEED + trial.seeds):
        instruction = sim.reset(trial.task, seed, trial.split)
        policy = _policy(trial, instruction, sim.observe(), seed)
        taken = _steps_to_success(sim, policy, manifest(trial.benchmark)["max_steps"])
        if taken is not None:
            steps.append(taken)
    return TrialResult(trial, tuple(steps))


def _steps_to_success(sim: Simulator, policy: Policy, max_steps: int) -> int | None:
    for step in range(1, max_steps + 1):
        outcome = sim.step(policy(sim.observe()))
        if outcome.success:
            return step
        if outcome.terminated:
            return None
    return None


def _policy(trial: Trial, instruction: str, first: Observation, seed: int) -> Policy:
    if trial.player == "expert":
        expert(trial.benchmark).reset(instruction)
        return lambda observation: expert(trial.benchmark).act(_as_sent(observation))
    space = manifest(trial.benchmark)["action_space"]
    if trial.player == "still":
        still = {name: _still(name, one, first) for name, one in space.items()}
        return lambda _: still
    return _at_random(space, np.random.default_rng(seed))


def _as_sent(observation: Observation) -> dict[str, list[float]]:
    """The state as a policy gets it."""
    return {name: values.tolist() for name, values in observation.state.items()}


def _still(name: str, space: Mapping[str, Any], first: Observation) -> list[float]:
    """An action that commands no change."""
    if any(part["relative_to"] != "none" for part in space["parts"].values()):
        return [0.0] * space["size"]
    values: list[float] = first.state[name].tolist()
    return values


def _at_random(space: Mapping[str, Any], rng: np.random.Generator) -> Policy:
    """Half of the episodes from end to end: hard enough to throw things about."""
    wild = bool(rng.integers(2))

    def act(_: Observation) -> Action:
        action = {}
        for name, one in space.items():
            low, high = np.array(one["minimum"]), np.array(one["maximum"])
            share = rng.uniform(size=one["size"])
            part = share.round() if wild else share
            action[name] = (low + (high - low) * part).tolist()
        return action

    return act


def measure(
    names: Iterable[str], seeds: int, processes: int, only_task: str | None = None
) -> list[TrialResult]:
    """Play the trials of all tasks, or of one."""
    trials = [
        Trial(name, task, split, player, max(1, int(seeds * share)))
        for name in names
        for player, share in {"expert": 1.0, **LUCK_SHARE}.items()
        for task in manifest(name)["tasks"]
        for split in manifest(name)["splits"]
        if only_task in (None, task)
    ]
    outcomes = []
    spawn = multiprocessing.get_context("spawn")  # a process that drew must not fork
    with ProcessPoolExecutor(processes, mp_context=spawn) as pool:
        for outcome in pool.map(play, trials):
            outcomes.append(outcome)
            print(outcome, flush=True)
    return outcomes


# The page


def page(names: Iterable[str], outcomes: Sequence[TrialResult]) -> str:
    sections = [_section(name, outcomes) for name in names]
    return _HEAD + "".join(sections)


_HEAD = f"""# Tasks

Written by `make experts`, which plays all of it and fails if an expert succeeds in less
than {100 * EXPERT_AT_LEAST:.0f} % of the episodes of a task and split, or luck in more
than {100 * LUCK_AT_MOST:.0f} %. An expert is a scripted policy that sees what any
policy sees: the instruction and the observation's state. *Still* repeats the state in
which the episode began; *random* draws every action anew, in half of the episodes from
the ends of its range. Figures are successes of episodes played; steps are the expert's,
median and longest.

A score is the share of stages reached in order, the best so far; the goal is the last
stage, so the score is 1 exactly on success. A goal is reached when it has held for
three control steps in a row; by the rule `any_step` of the manifests, an episode in
which that has happened once is a success.
"""


def _section(name: str, outcomes: Sequence[TrialResult]) -> str:
    state_manifest = manifest(name)
    splits = state_manifest["splits"]
    camera_manifest = benchmark_registry.resolve(name).manifest
    version, episodes = state_manifest["version"], state_manifest["episodes_total"]
    max_steps, rate_hz = state_manifest["max_steps"], state_manifest["control_rate_hz"]
    about = (
        f"Benchmarks `{name}` (with cameras) and `{name}_state`, version {version}: "
        f"{episodes} episodes of at most {max_steps} steps at {rate_hz:g} Hz. "
        f"{camera_manifest['description']}"
    )
    lines = [
        f"\n## {camera_manifest['title']}\n\n{about}\n",
        "| task | "
        + " | ".join(f"expert, `{s}`" for s in splits)
        + " | steps | still | random |",
        "|---|" + "---|" * (len(splits) + 3),
    ]
    for task in state_manifest["tasks"]:
        key = name, task
        mine = [o for o in outcomes if (o.trial.benchmark, o.trial.task) == key]
        experts = {o.trial.split: o for o in mine if o.trial.player == "expert"}
        steps = [step for one in experts.values() for step in one.steps]
        taken = f"{statistics.median(steps):.0f}, {max(steps)}" if steps else "–"
        cells = [_of([experts[split]]) for split in splits]
        luck = [_of([o for o in mine if o.trial.player == who]) for who in LUCK_SHARE]
        lines.append(f"| `{task}` | " + " | ".join([*cells, taken, *luck]) + " |")
    lines += [task_section(name, task) for task in state_manifest["tasks"]]
    return "\n".join(lines) + "\n"


def _of(outcomes: Sequence[TrialResult]) -> str:
    return (
        f"{sum(len(one.steps) for one in outcomes)} of "
        f"{sum(one.trial.seeds for one in outcomes)}"
    )


def task_section(name: str, task: str) -> str:
    """A task's part of the page."""
    kind = tasks_of(name)[task]
    instruction = simulator(name).reset(task, *_first_episode(name, task))
    stages = ", ".join([*kind.stages, "**goal**"])
    goal = goals_in_words({task: kind})[task]
    return (
        f"\n### `{task}`\n\n![{task}](tasks/{name}_{task}.png)\n\n"
        f"“{instruction}”\n\nGoal: {goal}\n\nStages: {stages}."
    )


# Drawing


def _first_episode(name: str, task: str) -> tuple[int, str]:
    """Seed and split of the task's first episode."""
    first = next(one for one in manifest(name)["episodes"] if one["task"] == task)
    return first["seed"], first["split"]


def draw(name: str) -> None:
    """A picture of each task, at its moment of an expert's episode."""
    module = experts_of(name)
    moments: Mapping[str, float] = getattr(module, "PICTURE_MOMENTS", {})
    size = dict(zip(("width", "height"), DRAWN_SIZE, strict=True))
    chosen = benchmark_registry.resolve(name, images={"codec": "raw", **size})
    camera = getattr(module, "PICTURE_CAMERA", None) or next(
        iter(chosen.manifest["observation_space"]["images"])
    )
    finest = {**chosen.world.settings, "quality": "standard"}
    drawn = benchmark_registry.make(benchmark_registry.SimulatorConfig(name, finest))
    PICTURES.mkdir(exist_ok=True)
    for task in chosen.manifest["tasks"]:
        actions = _experts_actions(name, task)
        drawn.reset(task, *_first_episode(name, task))
        end = round(len(actions) * moments.get(task, DEFAULT_MOMENT))
        for action in actions[:end]:
            drawn.step(action)
        seen = np.ascontiguousarray(drawn.observe().images[camera])
        picture = Image.fromarray(seen)
        small = picture.resize(PICTURE_SIZE, Image.Resampling.LANCZOS)
        small.save(PICTURES / f"{name}_{task}.png", optimize=True)
    drawn.close()


def _experts_actions(name: str, task: str) -> list[Action]:
    sim = simulator(name)
    expert(name).reset(sim.reset(task, *_first_episode(name, task)))
    actions: list[Action] = []
    for _ in range(manifest(name)["max_steps"]):
        actions.append(expert(name).act(_as_sent(sim.observe())))
        if sim.step(actions[-1]).terminated:
            break
    return actions


def main(
    *,
    benchmarks: Sequence[str],
    seeds: int,
    task: str | None,
    only_pictures: bool,
    processes: int,
    write: bool,
) -> int:
    # The processes are the parallelism; threads on top make it twice as slow.
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    names = list(benchmarks) or benchmark_names()
    if write and (names != benchmark_names() or task):
        sys.exit("experts: the page shows all benchmarks: --write measures all")
    if task and not any(task in tasks_of(name) for name in names):
        sys.exit(f"experts: no task {task} in {', '.join(names)}")
    if only_pictures:
        for name in names:
            draw(name)
        return 0
    outcomes = measure(names, seeds, processes, task)
    if write:
        for name in names:
            draw(name)
        PAGE.write_text(page(names, outcomes))
    missed = sum(outcome.is_missed for outcome in outcomes)
    print(f"{len(outcomes)} measured, {missed} missed")
    return 1 if missed else 0
