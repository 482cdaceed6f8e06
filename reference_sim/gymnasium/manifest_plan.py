"""Completes a benchmark file from the declarations of its environment.

The result is the plan, the settings of the simulator, and the manifest, which contains
everything that can change a score. Both are JSON-able.
"""

from __future__ import annotations

import importlib.metadata
import sys
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from reference_sim.definition import Json, image_sizes, installed_version
from reference_sim.gymnasium import entries, environments
from reference_sim.gymnasium.benchmark_file import (
    FAULTS_MAX,
    Benchmark,
    Camera,
    Convention,
)
from reference_sim.gymnasium.entries import Entry
from reference_sim.gymnasium.own_sources import (
    OWN_SOURCES,
    hash_files,
    packages_imported_by_own_files,
)
from reference_sim.gymnasium.simulator import GymnasiumSimulator
from reference_sim.ray_resources import check_resources
from reference_sim.vector_spaces import vector

_SUCCESS_KEYS = ("is_success", "success")
_MAX_STEPS = 1000
_MAX_FAULTS = 3
_NO_IMAGE_SIZE = (64, 64)  # there is none, but every run records a choice
# Physics engines: results differ between their versions.
_ENGINES = (
    "ale-py",
    "box2d",
    "box2d-py",
    "dm-control",
    "mujoco",
    "numpy",
    "pybullet",
    "pygame",
    "pymunk",
)


class Unsettled(Exception):
    """The file does not fit the environment; the text says why, in one line."""


class PlanDraft:
    """begin, ask, try_camera and settle are called in this order.

    warnings: probable mistakes. notes: assumed defaults.
    """

    def __init__(self, benchmark: Benchmark, folder: Path) -> None:
        self.benchmark = benchmark
        self._folder = folder
        self.warnings: list[str] = []
        self.notes: list[str] = []
        self.tasks = [task.model_dump() for task in benchmark.tasks]
        given = benchmark.success.given() if benchmark.success else {}
        self.plan: Json = {
            "made_of": {
                "environment": benchmark.environment,
                "made_by": benchmark.made_by,
                "modules": benchmark.modules,
                "folder": str(folder),
            },
            "kwargs": benchmark.kwargs,
            "tasks": self.tasks,
            "camera": None,
            "success": given,
            "score": benchmark.model_dump()["score"],
            "ends_on_success": False,
            "rebuild_every_episode": benchmark.rebuild_every_episode,
            "max_steps": benchmark.max_steps or _MAX_STEPS,
            "images_as_tensors": [],
            # Set by settle; a simulator process compares them.
            "sources": {},
            "files": {},
            "packages": {},
        }

    def begin(self) -> None:
        """Settle camera, tasks and resources; the environment is made later.

        Raises EnvironmentUnavailable.
        """
        requested = self.benchmark.camera
        draws = environments.can_draw(self.plan["made_of"])
        if isinstance(requested, Camera) and not draws:
            raise Unsettled("camera: the environment does not draw (rgb_array)")
        if requested is not False and draws:
            self.plan["camera"] = (requested or Camera()).model_dump()
        if not self.tasks:
            self.tasks.append(self._only_task())
        try:
            self.plan["files"] = hash_files(self._folder, self.benchmark.files)
        except ValueError as error:
            raise Unsettled(f"files: {error}") from error
        self._ray_resources = self._declared_resources()
        self._max_faults = self._declared_max_faults()

    def _declared_resources(self) -> Mapping[str, float]:
        """The resources that the file, or its class or function, declares."""
        if self.benchmark.ray_resources is not None:
            return self.benchmark.ray_resources
        declared = self._declared_by_maker("ray_resources")
        if declared is None:
            return {}
        try:
            return check_resources(declared)
        except ValueError as error:
            raise Unsettled(f"ray_resources: {error}") from error

    def _declared_max_faults(self) -> int:
        """How often one episode may fault before its run fails."""
        declared = self.benchmark.max_faults or self._declared_by_maker("max_faults")
        if declared is None:
            return _MAX_FAULTS
        if type(declared) is not int or not 1 <= declared <= FAULTS_MAX:
            raise Unsettled(
                f"max_faults: must be a whole number from 1 to {FAULTS_MAX}"
            )
        return declared

    def _declared_by_maker(self, name: str) -> Any:
        """The attribute of the class or function that makes the environment."""
        if self.benchmark.made_by is None:
            return None
        folder = self.plan["made_of"]["folder"]
        return getattr(environments.find(self.benchmark.made_by, folder), name, None)

    def _only_task(self) -> Json:
        benchmark = self.benchmark
        instruction = f"Collect as much reward as you can in {benchmark.source}."
        if benchmark.made_by is not None:
            maker = environments.find(benchmark.made_by, self.plan["made_of"]["folder"])
            instruction = environments.first_line_of_docstring(maker) or instruction
        name = benchmark.benchmark_id
        return {
            "name": name,
            "instruction": instruction,
            "kwargs": {},
            "reset_options": None,
        }

    def read_environment(self, simulator: GymnasiumSimulator) -> None:
        """Take over the declarations of an environment that has just made a step."""
        declared = environments.facts(simulator.environment, self.benchmark.environment)
        self._modules: Sequence[str] = declared["modules"]
        steps = self.benchmark.max_steps or declared["max_steps"]
        if steps is None:
            self.warnings.append(f"no step limit is stated: max_steps is {_MAX_STEPS}")
        self.plan["max_steps"] = steps or _MAX_STEPS
        self.rate_hz = self.benchmark.control_rate_hz or declared["control_rate_hz"]
        if self.rate_hz is None:
            self.rate_hz = 1.0
            self.notes.append("no control rate is stated: a step counts as a second")
        self._settle_success(simulator.info, declared["reward_threshold"])

    def _settle_success(
        self, info: Mapping[str, Any], reward_threshold: float | None
    ) -> None:
        key = next((key for key in _SUCCESS_KEYS if key in info), None)
        if self.benchmark.success is not None:
            pass
        elif key is not None:
            self.plan["success"] = {"info": key}
            self.notes.append(f"success is info[{key!r}]")
        elif reward_threshold is not None:
            self.plan["success"] = {"return_at_least": float(reward_threshold)}
            self.notes.append(f"success is a return of at least {reward_threshold:g}")
        elif self.plan["score"] == "success":
            self.warnings.append(
                "no success condition is declared, so every score is 0; set success = "
                "{...} or score = {...} in the benchmark file"
            )
        else:
            self.notes.append("no success condition is declared")
        at_end = "return_at_least" in self.plan["success"]
        self.success_rule = self.benchmark.success_rule or (
            "last_step" if at_end else "any_step"
        )
        if at_end and self.success_rule == "any_step":
            raise Unsettled("success is a return, which is known at the end: last_step")
        settled = self.success_rule == "any_step" and self.plan["score"] == "success"
        requested = self.benchmark.ends_on_success
        self.plan["ends_on_success"] = settled if requested is None else requested

    def try_camera(self, simulator: GymnasiumSimulator) -> tuple[int, int] | None:
        """Width and height of its images; a fault only if the file sets camera."""
        try:
            height, width, _ = simulator.draw().shape
        except BaseException as error:
            if isinstance(self.benchmark.camera, Camera):
                raise
            reason = " ".join(str(error).split())[:200]
            self.warnings.append(f"no camera: {type(error).__name__}: {reason}")
            self.plan["camera"] = None
            return None
        return width, height

    def settle(
        self,
        actions: Sequence[Entry],
        observed: Sequence[Entry],
        frame: tuple[int, int] | None,
    ) -> Json:
        """`plan`, `manifest`, `ray_resources`. Raises Unsettled and UnsupportedSpace.

        The manifest is that of Definition.describe, without max_chunk.
        """
        images = [entry for entry in observed if entry.kind == "images"]
        sizes = self._sizes(images, frame)
        if not self.benchmark.image_sizes:
            self.plan["images_as_tensors"] = [
                e.name for e in images if (e.shape[1], e.shape[0]) != sizes[0]
            ]
        tensors = self.plan["images_as_tensors"]
        space = entries.observation_space(
            [replace(entry, as_tensor=entry.name in tensors) for entry in observed]
        )
        if (camera := self.plan["camera"]) is not None:
            if camera["name"] in space["images"]:
                raise Unsettled(f"camera: {camera['name']!r} is in the observation too")
            text = "What the environment draws, RGB"
            space["images"][camera["name"]] = {"channels": 3, "description": text}
        codecs: list[str] = list(self.benchmark.image_codecs)
        if not space["images"]:
            sizes, codecs = [_NO_IMAGE_SIZE], codecs[:1]
        acted = entries.action_space(actions)
        _declare(acted, self.benchmark.action, "action")
        _declare(space["state"], self.benchmark.state, "state")
        manifest = {
            **self._head(),
            "action_space": acted,
            "observation_space": space,
            "image_sizes": image_sizes(*sizes),
            "image_codecs": codecs,
            "simulator": self._simulator(),
        }
        return {
            "plan": self.plan,
            "manifest": manifest,
            "ray_resources": self._ray_resources,
        }

    def _sizes(
        self, images: Sequence[Entry], frame: tuple[int, int] | None
    ) -> list[tuple[int, int]]:
        """The available image sizes: those of the observation's images, on which
        policies are trained, come first."""
        if self.benchmark.image_sizes:
            return [(size.width, size.height) for size in self.benchmark.image_sizes]
        if images:
            return [(images[0].shape[1], images[0].shape[0])]
        return [frame or _NO_IMAGE_SIZE]

    def _head(self) -> Json:
        benchmark = self.benchmark
        tasks = [task["name"] for task in self.tasks]
        episodes = benchmark.episodes(tasks)
        used = {episode["split"] for episode in episodes}
        splits = [split for split in benchmark.splits if split.name in used]
        sealed = [split.name for split in splits if split.is_sealed]
        return {
            "benchmark_id": benchmark.benchmark_id,
            "version": benchmark.version,
            "title": benchmark.title or benchmark.source,
            "description": benchmark.description
            or f"{benchmark.source}, a Gymnasium environment.",
            "episodes_total": len(episodes),
            "episodes": episodes,
            "tasks": tasks,
            "splits": [split.name for split in splits],
            **({"sealed_splits": sealed} if sealed else {}),
            "control_rate_hz": float(self.rate_hz or 1.0),
            "max_steps": self.plan["max_steps"],
            "max_attempts": 3,
            "max_faults": self._max_faults,
            "success_rule": self.success_rule,
        }

    def _simulator(self) -> Json:
        """Versions, and all settings without a member of their own in the manifest."""
        loaded = OWN_SOURCES.loaded
        self.plan["sources"] = {name: own.sha256 for name, own in loaded.items()}
        self.plan["packages"] = _versions(self._modules)
        modules = self.plan["made_of"]["modules"]
        sources = OWN_SOURCES.by_name() | self.plan["files"]
        chosen = ("kwargs", "camera", "success", "score", "ends_on_success")
        return {
            "name": "gymnasium",
            "version": environments.GYMNASIUM_VERSION,
            "environment": self.benchmark.source,
            **({"modules": modules} if modules else {}),
            "sources": dict(sorted(sources.items())),
            "packages": self.plan["packages"],
            **{name: self.plan[name] for name in chosen},
            "rebuild_every_episode": self.plan["rebuild_every_episode"],
            "tasks": self.tasks,
        }


def _declare(space: Json, declared: Mapping[str, Convention], where: str) -> None:
    """The file's conventions override those derived from the environment's space."""
    for name, convention in declared.items():
        if name not in space:
            there = ", ".join(space) or "nothing"
            raise Unsettled(
                f"{where}.{name}: unknown name; the environment has {there}"
            )
        try:
            parts = convention.declared_parts(space[name]["size"])
        except ValueError as error:
            raise Unsettled(f"{where}.{name}: {error}") from error
        if parts is not None:
            space[name] |= {"parts": vector(*parts)["parts"]}
        if convention.meaning is not None:
            space[name]["description"] = convention.meaning


def _versions(modules: Sequence[str]) -> dict[str, str]:
    """Versions of the packages that define the environment, or that its own files
    import, and of physics engines."""
    tops = {module.partition(".")[0] for module in modules}
    tops |= packages_imported_by_own_files()
    owners = importlib.metadata.packages_distributions()
    packages = _owners_of(tops, owners)
    packages |= _owners_of(sys.modules, owners).intersection(_ENGINES)
    return {name: installed_version(name) for name in sorted(packages)}


def _owners_of(tops: Iterable[str], owners: Mapping[str, Sequence[str]]) -> set[str]:
    """The packages of modules; one may write itself otherwise than its index does."""
    names = {owner for top in tops for owner in owners.get(top, ())}
    return {name.lower().replace("_", "-") for name in names}
