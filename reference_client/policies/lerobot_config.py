"""The configuration of a LeRobot policy, and the mapping that follows from it.

`config.json` of the policy's folder has the names and sizes of what it reads and
answers; a benchmark has those of its spaces. Names that leave a choice are refused, and
a mapping file decides. Needs neither LeRobot nor torch.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from msgspec.structs import replace
from proctor_client import Benchmark

from reference_client.errors import BadPolicy
from reference_client.policies.mapping import (
    ActionVector,
    BadMapping,
    PolicyMapping,
    RequestEntry,
)

# LeRobot's names for the inputs that every policy may have.
_TASK = "task"
_STATE = "observation.state"
_IMAGES = "observation.images."
_ENTRY = "an entry of [observation] in a --mapping file decides"


@dataclass(frozen=True, slots=True)
class LerobotConfig:
    """The facts about the policy that are in its config.json.

    inputs: key → shape; three numbers (channels, height, width) are an image.
    actions_per_look: actions after which the policy reads an observation again.
    """

    folder: Path
    kind: str
    inputs: Mapping[str, tuple[int, ...]]
    action_size: int
    actions_per_look: int
    actions_predicted: int | None

    @classmethod
    def read(cls, folder: str | Path) -> LerobotConfig:
        """Read the config; raises BadPolicy unless LeRobot 0.4 or later saved it."""
        folder = Path(folder)
        path = folder / "config.json"
        if not path.is_file():
            raise BadPolicy(
                f"lerobot: takes the folder of a saved policy; there is no {path}"
            )
        try:
            document = json.loads(path.read_text(encoding="utf-8"))
            config = cls._of(folder, document)
        except (ValueError, KeyError, TypeError, AttributeError) as error:
            raise BadPolicy(
                f"{path} is no configuration of a LeRobot policy: {error!r:.80}"
            ) from error
        for name in ("preprocessor", "postprocessor"):
            if not (folder / f"policy_{name}.json").is_file():
                raise BadPolicy(
                    f"{folder} has no policy_{name}.json, which normalizes; convert it "
                    "with python -m lerobot.processor.migrate_policy_normalization "
                    f"--pretrained-path {folder}"
                )
        if document.get("use_peft"):
            raise BadPolicy(f"{folder} holds an adapter (use_peft); merge it first")
        return config

    @classmethod
    def _of(cls, folder: Path, document: Mapping[str, Any]) -> LerobotConfig:
        # A policy that reads several observations, or blends its chunks, reads each.
        reads_each = (
            document.get("n_obs_steps", 1) > 1
            or document.get("temporal_ensemble_coeff") is not None
        )
        return cls(
            folder=folder,
            kind=document["type"],
            inputs={
                key: tuple(map(int, feature["shape"]))
                for key, feature in document["input_features"].items()
                if "empty_camera" not in key
            },
            action_size=int(document["output_features"]["action"]["shape"][0]),
            actions_per_look=1
            if reads_each
            else int(document.get("n_action_steps") or 1),
            actions_predicted=document.get("chunk_size"),
        )

    def mapping(
        self, benchmark: Benchmark, overrides: PolicyMapping | None = None
    ) -> PolicyMapping:
        """The whole mapping. Raises BadMapping.

        overrides: its entries come before what the configuration says; the form of a
        value (batch, channels first, 0 … 1) is always LeRobot's.
        """
        name = overrides.name if overrides else f"lerobot:{self.folder}"
        given = dict(overrides.entries) if overrides else {}
        _refuse_unknown(name, given, [*self.inputs, _TASK])
        entries = {
            key: self._entry(key, given.get(key), benchmark) for key in self.inputs
        }
        self._refuse_repeated(entries, given)
        task = given.get(_TASK, RequestEntry(("instruction",)))
        mapping = PolicyMapping(
            name=name,
            tree=entries | {_TASK: replace(task, leading=1)},
            source=None,
            execute=overrides.execute if overrides else None,
            leading=0,
            vectors=(overrides.vectors if overrides else None)
            or self._vectors(benchmark),
        )
        mapping.check(benchmark)
        self._check_sizes(mapping, benchmark)
        return mapping

    def _refuse_repeated(
        self, entries: Mapping[str, RequestEntry], given: Mapping[str, RequestEntry]
    ) -> None:
        """No source is chosen twice: one of the two would be wrong."""
        chosen: dict[tuple[str, ...], str] = {}
        for key, entry in entries.items():
            first_key = chosen.setdefault(entry.source, key)
            if first_key != key and key not in given:
                raise BadMapping(
                    f"the policy's {first_key} and {key} would both be "
                    f"{' + '.join(entry.source)}; {_ENTRY}"
                )

    def _entry(
        self, key: str, given: RequestEntry | None, benchmark: Benchmark
    ) -> RequestEntry:
        shape = self.inputs[key]
        if len(shape) == 3:
            entry = given or RequestEntry((f"images.{self._image(key, benchmark)}",))
            resize = entry.resize or (shape[1], shape[2])
            return replace(entry, resize=resize, layout="chw", unit=True, leading=1)
        entry = given or RequestEntry(self._vector_sources(key, shape, benchmark))
        return replace(entry, leading=1)

    def _image(self, key: str, benchmark: Benchmark) -> str:
        """The image of the same name; or the only one, for the only camera."""
        images = benchmark.observation_space.images
        name = key.removeprefix(_IMAGES)
        if name in images:
            return name
        cameras = [shape for shape in self.inputs.values() if len(shape) == 3]
        if len(cameras) == len(images) == 1:
            return next(iter(images))
        raise BadMapping(
            f"the policy's {key} is none of the images of {benchmark.benchmark_id} "
            f"({', '.join(images) or 'none'}); {_ENTRY}"
        )

    def _vector_sources(
        self, key: str, shape: tuple[int, ...], benchmark: Benchmark
    ) -> tuple[str, ...]:
        """The state of the same name; or the one choice of states that has the size.

        Choices are a single state, the states named as the action's vectors, and all.
        """
        (size,) = shape
        sizes = {n: v.size for n, v in benchmark.observation_space.state.items()}
        name = key.removeprefix("observation.")
        if sizes.get(name) == size:
            return (f"state.{name}",)
        action = tuple(n for n in benchmark.action_space if n in sizes)
        choices = {(n,) for n in sizes} | {action, tuple(sizes)}
        fitting = [c for c in choices if sum(sizes[n] for n in c) == size]
        if len(fitting) == 1:
            return tuple(f"state.{n}" for n in fitting[0])
        listed = ", ".join(f"{n} {s}" for n, s in sizes.items())
        problem = "more than one choice" if fitting else "no choice"
        raise BadMapping(
            f"the policy's {key} has {size} numbers, and {problem} of the states of "
            f"{benchmark.benchmark_id} ({listed}) has that size; {_ENTRY}"
        )

    def _vectors(self, benchmark: Benchmark) -> dict[str, ActionVector]:
        """The numbers of the action in the order of the action space."""
        vectors, first = {}, 0
        for name, space in benchmark.action_space.items():
            vectors[name] = ActionVector(columns=f"{first}:{first + space.size}")
            first += space.size
        if first != self.action_size:
            listed = ", ".join(
                f"{n} {s.size}" for n, s in benchmark.action_space.items()
            )
            raise BadMapping(
                f"the policy answers {self.action_size} numbers; an action of "
                f"{benchmark.benchmark_id} has {first} ({listed}); [action.values] in "
                "a --mapping file decides"
            )
        return vectors

    def _check_sizes(self, mapping: PolicyMapping, benchmark: Benchmark) -> None:
        space = benchmark.observation_space
        for key, shape in self.inputs.items():
            entry = mapping.entries[key]
            if entry.source[:1] and entry.source[0].startswith("state."):
                names = [source.partition(".")[2] for source in entry.source]
                size = entry.width(sum(space.state[n].size for n in names))
            elif entry.source[:1] and entry.source[0].startswith("images."):
                size = space.images[entry.source[0].partition(".")[2]].channels
            else:
                continue
            if size != shape[0]:
                unit = "channels" if len(shape) == 3 else "numbers"
                raise BadMapping(
                    f"{mapping.name}: {key} would have {size} {unit}; the policy reads "
                    f"{shape[0]}"
                )

    def describe(self, mapping: PolicyMapping) -> str:
        """One line: what the policy reads and what its numbers are."""
        reads = ", ".join(
            f"{key} = {' + '.join(entry.source) or 'a constant'}"
            for key, entry in mapping.entries.items()
            if key != _TASK
        )
        numbers = ", ".join(
            f"{name} = {'a constant' if v.value is not None else v.columns or 'all'}"
            for name, v in mapping.vectors.items()
        )
        return f"LeRobot {self.kind}: {reads}; action: {numbers}"


def _refuse_unknown(name: str, given: Iterable[str], inputs: list[str]) -> None:
    unknown = sorted(set(given) - set(inputs))
    if unknown:
        raise BadMapping(
            f"{name}: the policy does not read {', '.join(unknown)}; it reads "
            f"{', '.join(inputs)}"
        )
