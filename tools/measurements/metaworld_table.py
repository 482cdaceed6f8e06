"""Meta-World's scripted experts, directly and through the protocol.

It writes docs/evaluate/metaworld.md.

Run by `make metaworld-table` in .venv-metaworld. Each of the 500 episodes is played
twice: by a loop around Meta-World itself, in an environment made for it alone, and by
`reference_client.evaluate` with four workers against a server of its own. Success and
number of steps must agree in every episode, or nothing is written. The direct loop must
not import the adapter or the module with which it is compared.
"""

import importlib.metadata
import subprocess
import sys
import tempfile
import time
import tomllib
import warnings
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import metaworld.env_dict
import metaworld.policies
import numpy as np
from proctor_client import ControlApi

from reference_client import Observation, evaluate
from reference_client.protocol.connection import Connection

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "evaluate" / "metaworld.md"
BENCHMARK = tomllib.loads(
    (ROOT / "reference_sim" / "benchmarks" / "metaworld" / "benchmark.toml").read_text()
)
MAX_STEPS = BENCHMARK["max_steps"]
TASK_OF = {task["instruction"]: task["name"] for task in BENCHMARK["tasks"]}
WORKERS = 4
TOKEN = "table"  # noqa: S105 - of a server that lives as long as this does
HEAD = """# Meta-World's scripted experts

The benchmark `metaworld_mt50`: Meta-World {metaworld} on MuJoCo {mujoco}, {tasks} tasks
with {seeds} seeds each, at most {max_steps} steps; success at any step ends an episode.
Its own experts play it twice: in a loop around Meta-World itself, and through the
protocol, with `reference_client.evaluate` and {workers} workers. **All {total} episodes
agree, in success and in the number of steps.** Success: {successes} of {total}
({rate:.1%}).

Written by `make metaworld-table`, which fails if one episode differs.

| task | direct | through the protocol | median of steps to success |
|---|---|---|---|
"""


class EpisodeOutcome(NamedTuple):
    success: bool
    steps: int


Results = dict[tuple[str, int], EpisodeOutcome]


def play_directly(task: str, seed: int) -> EpisodeOutcome:
    """One episode in an environment of its own, until success or the end."""
    made = metaworld.env_dict.ALL_V3_ENVIRONMENTS_GOAL_OBSERVABLE
    environment: Any = made[f"{task}-goal-observable"]()
    expert = metaworld.policies.ENV_POLICY_MAP[task]()
    # Its reset(seed) disregards the seed; this is how it can be given one.
    environment.seeded_rand_vec = True
    environment._freeze_rand_vec = False  # noqa: SLF001 - no other way
    environment.seed(seed)
    observation, _ = environment.reset()
    try:
        for step in range(1, MAX_STEPS + 1):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")  # it commands more than it may
                command = expert.get_action(observation)
            action = np.clip(command, -1, 1).astype(np.float32)
            observation, _, _, _, info = environment.step(action)
            if info["success"]:
                return EpisodeOutcome(True, step)
        return EpisodeOutcome(False, MAX_STEPS)
    finally:
        environment.close()


class Expert:
    """A policy that recognises its task by the instruction."""

    def reset(self, instruction: str) -> None:
        self._expert = metaworld.policies.ENV_POLICY_MAP[TASK_OF[instruction]]()

    def act(self, observation: Observation) -> Sequence[Mapping[str, Any]]:
        return [
            {
                "action": self._expert.get_action(
                    np.array(observation.state["observation"])
                )
            }
        ]


def play_through_protocol(url: str, token: str, benchmark_id: str) -> Results:
    """Every episode of a benchmark, by (task, seed)."""
    warnings.filterwarnings("ignore", "Constant")
    score = evaluate(
        Expert, url=url, token=token, benchmark=benchmark_id, workers=WORKERS
    )
    return results_of(url, token, score.run_id)


def results_of(url: str, token: str, run_id: str) -> Results:
    """Of a run that is completed."""
    with Connection(url, token, requests=1) as connection:
        return {
            (one.task, one.seed): EpisodeOutcome(
                one.outcome.value == "success", one.steps
            )
            for one in _results(connection.control, run_id)
        }


def _results(control: ControlApi, run_id: str) -> Iterable[Any]:
    cursor = None
    while True:
        page = control.list_episodes(run_id, cursor=cursor)
        yield from (episode.result for episode in page.episodes)
        cursor = page.next_cursor
        if cursor is None:
            return


def serve_and_play() -> Results:
    with tempfile.TemporaryDirectory() as scratch:
        server = subprocess.Popen(
            [
                *(sys.executable, "-m", "reference_server", "--port", "0"),
                *("--database", f"{scratch}/proctor.sqlite"),
                *("--tokens", f"table:read+run:{TOKEN}"),
                *("--benchmarks", BENCHMARK["benchmark_id"]),
            ],
            cwd=ROOT,
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            assert server.stdout is not None
            url = server.stdout.readline().split()[-1]
            return play_through_protocol(url, TOKEN, BENCHMARK["benchmark_id"])
        finally:
            server.terminate()
            server.wait()


def table(direct: Results, served: Results) -> str:
    """The rows, task by task in Meta-World's order."""
    rows = []
    seeds = defaultdict(list)
    for task, seed in direct:
        seeds[task].append(seed)
    for task, its_seeds in seeds.items():
        counts = [
            f"{sum(results[task, seed].success for seed in its_seeds)}/{len(its_seeds)}"
            for results in (direct, served)
        ]
        steps = [direct[task, s].steps for s in its_seeds if direct[task, s].success]
        median = f"{np.median(steps):g}" if steps else "–"
        rows.append(f"| `{task}` | {counts[0]} | {counts[1]} | {median} |\n")
    return "".join(rows)


def main() -> int:
    began = time.perf_counter()
    served = serve_and_play()
    print(f"through the protocol: {time.perf_counter() - began:.0f} s, start included")
    began = time.perf_counter()
    direct: Results = {}
    for task, seed in sorted(
        served, key=lambda key: list(TASK_OF.values()).index(key[0])
    ):
        direct[task, seed] = play_directly(task, seed)
    print(f"directly: {time.perf_counter() - began:.0f} s")
    if differing := [key for key in direct if direct[key] != served[key]]:
        for key in differing[:20]:
            print(f"{key}: directly {direct[key]}, through the protocol {served[key]}")
        print(f"{len(differing)} of {len(direct)} episodes differ; nothing is written")
        return 1
    successes = sum(played.success for played in direct.values())
    head = HEAD.format(
        metaworld=importlib.metadata.version("metaworld"),
        mujoco=importlib.metadata.version("mujoco"),
        tasks=len(TASK_OF),
        seeds=len(direct) // len(TASK_OF),
        max_steps=MAX_STEPS,
        workers=WORKERS,
        total=len(direct),
        successes=successes,
        rate=successes / len(direct),
    )
    PAGE.write_text(head + table(direct, served))
    print(f"{successes} of {len(direct)} succeed, in both ways alike: {PAGE.name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
