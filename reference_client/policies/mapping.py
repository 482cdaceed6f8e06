"""A declarative mapping between the benchmark's names and those of a policy.

A TOML file. `[observation]` has an entry for each key of the policy's request,
`[action]` locates the numbers in its answer, and `[action.values]` assigns them to the
vectors of the action space. `[assumes]` has the conventions for which these numbers are
right (schema Assumptions). For policy servers, `[reset]` is the message before an
episode, and `[server]` says how they are spoken to. Every member is explained in
docs/evaluate/policies/policies.md. Nothing in such a file is executed.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any, Self, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt
from proctor_client import Benchmark

from reference_client.api.foreign_arrays import (
    UnreadableNumbers,
    as_numpy,
    kind_of_answer,
)
from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk
from reference_client.policies.image_resize import compress_picture, resize_picture
from reference_client.policies.servers.wire_formats import pack
from reference_record.command_line.spelling import unknown
from reference_record.command_line.toml_file import NotToml, read_toml_file

Array = npt.NDArray[Any]


def _attempt_id(observation: Observation) -> str:
    """Differs in every attempt of every run, for servers that store by such an id."""
    turn = observation.turn
    if turn is None or not turn.episode:
        return f"dry-{observation.episode_id}"
    # The id of a session is for its server alone.
    session = hashlib.sha256(turn.session_id.encode()).hexdigest()[:16]
    return f"{session}-{observation.episode_id}-{turn.episode.attempt}"


_WORDS: Mapping[str, Callable[[Observation], Any]] = {
    "instruction": lambda observation: observation.instruction,
    "episode_id": lambda observation: observation.episode_id,
    "step": lambda observation: observation.step,
    "first_step": lambda observation: observation.step == 0,
    "attempt_id": _attempt_id,
}
_GROUPS = ("state", "images", "tensors")
_TEXTS, _FILES = ("json", "json-numpy"), ("jpeg", "png")
Row = TypeVar("Row", "RequestEntry", "ActionVector")
# A request is a table of entries, tables and lists of them.
Node: TypeAlias = "RequestEntry | Mapping[str, Node] | list[Node]"


class BadMapping(ValueError):
    """The mapping is invalid, or does not fit the benchmark; the message says why."""


class InvalidPolicyAnswer(ValueError):
    """The policy's answer does not fit the mapping."""


@dataclass(frozen=True, slots=True)
class RequestEntry:
    """One key of the request: the source of its value, and how that is converted.

    source: `state.NAME`, `images.NAME`, `tensors.NAME`, or a key of _WORDS; several
    states are concatenated. Then, in this order: take, scale, offset for vectors;
    resize, layout, unit for images; dtype, leading for both; encode: JSON text for any,
    a file in memory for images.
    """

    source: tuple[str, ...] = ()
    value: Any = None
    take: Any = None
    scale: Any = 1.0
    offset: Any = 0.0
    dtype: str | None = None
    resize: tuple[int, int] | None = None
    pad: bool = True
    layout: str = "hwc"
    unit: bool = False
    leading: int = 0
    encode: str | None = None

    def of(self, observation: Observation) -> Any:
        value = self._value(observation)
        if self.encode in _FILES:
            return compress_picture(value, self.encode)
        return value if self.encode is None else pack(value, self.encode).decode()

    def _value(self, observation: Observation) -> Any:
        if not self.source:
            return self.value
        if self.source[0] in _WORDS:
            word = _WORDS[self.source[0]](observation)
            if self.source[0] == "step":
                number = float(word * self.scale + self.offset)
                word = int(number) if number.is_integer() else number
            return [word] if self.leading else word
        group = self.source[0].partition(".")[0]
        array = (
            self._picture(observation)
            if group == "images"
            else self._vector(observation)
        )
        if self.dtype is not None:
            array = array.astype(self.dtype)
        return array.reshape((1,) * self.leading + array.shape)

    def _picture(self, observation: Observation) -> Array:
        picture: Array = observation.images[self.source[0].partition(".")[2]]
        if self.resize is not None:
            picture = resize_picture(picture, *self.resize, pad=self.pad)
        if self.unit:
            picture = picture.astype(np.float32) / np.float32(255)
        return np.moveaxis(picture, -1, 0) if self.layout == "chw" else picture

    def _vector(self, observation: Observation) -> Array:
        parts = [_part(observation, *name.split(".", 1)) for name in self.source]
        vector = parts[0] if len(parts) == 1 else np.concatenate(parts)
        if self.source[0].startswith("tensors."):
            return vector
        vector = np.asarray(_select(vector, self.take) * self.scale + self.offset)
        return vector.astype(np.float32) if self.dtype is None else vector


@dataclass(frozen=True, slots=True)
class ActionVector:
    """One vector of the action, and the part of the answer that it is made of.

    source: place in the answer, if different from the table's; the numbers of several
    are joined. Then, in this order: columns, threshold, scale, offset, cumulate,
    relative_to, clip; or `value`, a constant. cumulate: cumulative sum of the rows, as
    for velocities. relative_to:
    `state.NAME`, whose value before the chunk is added to every row.
    """

    source: tuple[str, ...] = ()
    columns: Any = None
    threshold: float | None = None
    scale: Any = 1.0
    offset: Any = 0.0
    cumulate: bool = False
    relative_to: str | None = None
    clip: tuple[float, float] | None = None
    value: Any = None

    def of(self, rows: Array, observation: Observation) -> Array:
        """rows: (actions, numbers) of the answer. Returns (actions, size)."""
        chosen = _select(rows, self.columns)
        if self.threshold is not None:
            chosen = (chosen > self.threshold).astype(np.float64)
        chosen = np.asarray(chosen * self.scale + self.offset)
        if self.cumulate:
            chosen = np.cumsum(chosen, axis=0)
        if self.relative_to is not None:
            chosen = chosen + _part(observation, *self.relative_to.split(".", 1))
        return chosen if self.clip is None else np.clip(chosen, *self.clip)


@dataclass(frozen=True, slots=True)
class PolicyMapping:
    """A mapping, as read from a file.

    assumes: schema Assumptions, as the file has it; compared and sent by the client.
    """

    name: str
    tree: Mapping[str, Node]
    source: str | None
    execute: int | None
    leading: int
    vectors: Mapping[str, ActionVector]
    first_message: Mapping[str, Node] | None = None
    server: Mapping[str, Any] = field(default_factory=dict)
    assumes: Mapping[str, Any] | None = None

    @property
    def entries(self) -> Mapping[str, RequestEntry]:
        """The entries of the request by their dotted names."""
        return dict(_leaves(self.tree))

    def flat(self) -> Self:
        """The same without nesting: `video.front` is one key, quoted or not."""
        return replace(self, tree=self.entries)

    @classmethod
    def read(cls, path: str | Path, *, is_partial: bool = False) -> Self:
        """is_partial: tables may be missing. Raises BadMapping."""
        try:
            document = read_toml_file(path)
        except NotToml as error:
            raise BadMapping(str(error)) from error
        return cls.of(document, str(path), is_partial=is_partial)

    @classmethod
    def of(
        cls,
        document: Mapping[str, Any],
        name: str = "mapping",
        *,
        is_partial: bool = False,
    ) -> Self:
        """The mapping of a parsed TOML document. Raises BadMapping."""
        known = {"observation", "action", "reset", "server", "assumes"}
        _check_known(name, document, known)
        if is_partial:
            action = {"values": {}} | document.get("action", {})
            document = {"observation": {}} | dict(document) | {"action": action}
        action = _table(f"{name}: action", document.get("action"))
        at = f"{name}: action"
        _check_known(at, action, {"from", "execute", "leading", "values"})
        entries = _table(
            f"{name}: observation",
            document.get("observation"),
            may_be_empty=is_partial,
        )
        vectors = _table(f"{at}.values", action.get("values"), may_be_empty=is_partial)
        return cls(
            name=name,
            tree=_tree(f"{name}: observation", entries),
            source=action.get("from"),
            execute=action.get("execute"),
            leading=action.get("leading", 0),
            vectors={
                key: _read(ActionVector, f'{name}: action.values."{key}"', table)
                for key, table in vectors.items()
            },
            first_message=_tree(f"{name}: reset", _table(f"{name}: reset", reset))
            if (reset := document.get("reset")) is not None
            else None,
            server=_table(
                f"{name}: server", document.get("server", {}), may_be_empty=True
            ),
            assumes=document.get("assumes"),
        )

    def check(self, benchmark: Benchmark) -> None:
        """Raises BadMapping if the mapping does not fit the benchmark."""
        space = benchmark.observation_space
        sources = {
            f"{group}.{name}" for group in _GROUPS for name in getattr(space, group)
        }
        wanted = [
            (f'{table}."{key}"', source)
            for table, tree in (
                ("observation", self.tree),
                ("reset", self.first_message or {}),
            )
            for key, entry in _leaves(tree)
            for source in entry.source
            if source not in _WORDS
        ]
        wanted += [
            (f"action.values.{name}", vector.relative_to)
            for name, vector in self.vectors.items()
            if vector.relative_to is not None
        ]
        for entry, source in wanted:
            if source not in sources:
                raise BadMapping(
                    f"{self.name}: {entry} is from {source}; {benchmark.benchmark_id} "
                    f"has {_listed(sources)}"
                )
        if set(self.vectors) != set(benchmark.action_space):
            raise BadMapping(
                f"{self.name}: action.values has {_listed(self.vectors)}; an action of "
                f"{benchmark.benchmark_id} has {_listed(benchmark.action_space)}"
            )

    def request(self, observation: Observation) -> dict[str, Any]:
        """The policy's request for an observation."""
        return {key: _filled(node, observation) for key, node in self.tree.items()}

    def reset_message(self, observation: Observation) -> dict[str, Any] | None:
        """The message before the first request of an episode; None if there is none."""
        if self.first_message is None:
            return None
        filled: dict[str, Any] = _filled(self.first_message, observation)
        return filled

    def chunk(self, answer: Any, observation: Observation) -> Chunk:
        """The policy's answer as a chunk. Raises InvalidPolicyAnswer."""
        columns: dict[str, Array] = {}
        for name, vector in self.vectors.items():
            if vector.value is None:
                places = vector.source or (self.source,)
                try:
                    parts = [self._rows(answer, place) for place in places]
                    rows = np.concatenate(parts, axis=1)
                    columns[name] = vector.of(rows, observation)
                except InvalidPolicyAnswer:
                    raise
                except (IndexError, ValueError) as error:
                    raise InvalidPolicyAnswer(
                        f"{self.name}: {name}: {error}"
                    ) from error
        length = min((len(column) for column in columns.values()), default=1)
        constants = {
            name: np.broadcast_to(
                np.atleast_1d(vector.value), (length, np.size(vector.value))
            )
            for name, vector in self.vectors.items()
            if vector.value is not None
        }
        whole = columns | constants
        return [
            {name: whole[name][i] for name in self.vectors}
            for i in range(min(length, self.execute or length))
        ]

    def _rows(self, answer: Any, source: str | None) -> Array:
        """The rows (actions, numbers) that the answer has at `source`."""
        values, is_list = answer, False
        if source is not None:
            # Some policies return a list of actions instead of an action of lists.
            values, is_list = self._at(answer, source, source)
        place = f"`{source}`" if source else "its answer"
        try:
            rows = as_numpy(values)
        except UnreadableNumbers as error:
            raise InvalidPolicyAnswer(
                f"The policy answered {kind_of_answer(values)} in {place}, where "
                f"{self.name} expects numbers"
            ) from error
        if rows.size == 0:
            raise InvalidPolicyAnswer(
                f"The policy answered no action: {place} is empty"
            )
        if is_list and rows.ndim == 1:
            rows = rows[:, np.newaxis]  # one number for each action
        if rows.ndim > self.leading:
            rows = rows.reshape(rows.shape[self.leading :])
        rows = np.atleast_1d(rows)
        if rows.ndim == 1:
            rows = rows[np.newaxis]
        if rows.ndim != 2:
            raise InvalidPolicyAnswer(
                f"The policy answered the shape {np.shape(values)} in {place}; "
                f"{self.name} expects a chunk (actions, numbers)"
            )
        return rows

    def _at(self, answer: Any, path: str, source: str) -> tuple[Any, bool]:
        """The part of the answer at a dotted path, and whether it is a list of actions.

        A number in the path is an index; any other name is looked up in each item of a
        list. Names may contain dots: the longest that the answer has is taken.
        """
        if not path:
            return answer, False
        parts = path.split(".")
        if isinstance(answer, Mapping):
            for count in range(len(parts), 0, -1):
                name, rest = ".".join(parts[:count]), ".".join(parts[count:])
                for key in (name, name.encode()):
                    if key in answer:
                        return self._at(answer[key], rest, source)
        elif parts[0].isdigit() and isinstance(answer, list | tuple | np.ndarray):
            if int(parts[0]) < len(answer):
                return self._at(answer[int(parts[0])], ".".join(parts[1:]), source)
        elif isinstance(answer, list):
            return [self._at(item, path, source)[0] for item in answer], True
        where = source.removesuffix(path).rstrip(".")
        inside = f" in {where}" if where else ""
        if isinstance(answer, Mapping):
            text = f"{self.name}: the policy's answer has no {path}{inside}, but "
            raise InvalidPolicyAnswer(text + _listed(answer))
        text = (
            f"The policy answered {kind_of_answer(answer)}{inside}, where {self.name} "
        )
        raise InvalidPolicyAnswer(f"{text}expects an object with `{path}`")


def _part(observation: Observation, group: str, name: str) -> Array:
    return np.asarray(getattr(observation, group)[name])


def _select(array: Array, which: Any) -> Array:
    """Columns by `"first:last"`, by a list of indices, or all."""
    if which is None:
        return array
    if isinstance(which, str):
        first, last = (int(end) for end in which.split(":"))
        if last > array.shape[-1]:
            raise IndexError(f"the columns {which} of {array.shape[-1]} numbers")
        return array[..., first:last]
    return array[..., which]


def _tree(at: str, table: Mapping[str, Any]) -> Mapping[str, Node]:
    return {key: _node(f'{at}."{key}"', part) for key, part in table.items()}


def _node(at: str, given: Any) -> Node:
    """An entry is a table that has `from` or `value`; other tables and lists nest."""
    if isinstance(given, list) and given:
        return [_node(f"{at}.{index}", part) for index, part in enumerate(given)]
    names = {"from" if f.name == "source" else f.name for f in fields(RequestEntry)}
    is_nested = (
        isinstance(given, Mapping)
        and given
        and not {"from", "value"} & set(given)
        and all(isinstance(part, Mapping | list) for part in given.values())
        and not names & set(given)
    )
    return _tree(at, given) if is_nested else _entry(at, given)


def _leaves(node: Node, at: str = "") -> Iterator[tuple[str, RequestEntry]]:
    if isinstance(node, RequestEntry):
        yield at, node
        return
    parts = node.items() if isinstance(node, Mapping) else enumerate(node)
    for key, part in parts:
        yield from _leaves(part, f"{at}.{key}" if at else str(key))


def _filled(node: Node, observation: Observation) -> Any:
    match node:
        case RequestEntry():
            return node.of(observation)
        case list():
            return [_filled(part, observation) for part in node]
    return {key: _filled(part, observation) for key, part in node.items()}


def _entry(at: str, table: Any) -> RequestEntry:
    entry = _read(RequestEntry, at, table)
    if bool(entry.source) == (entry.value is not None):
        raise BadMapping(f"{at} needs either `from` or `value`")
    if entry.layout not in ("hwc", "chw"):
        raise BadMapping(f"{at}: layout is hwc or chw, not {entry.layout!r}")
    for source in entry.source:
        if source not in _WORDS and source.partition(".")[0] not in _GROUPS:
            raise BadMapping(
                f"{at}: from is state.NAME, images.NAME, tensors.NAME, "
                f"{', '.join(_WORDS)}; not {source!r}"
            )
    if len(entry.source) > 1 and not all(s.startswith("state.") for s in entry.source):
        raise BadMapping(f"{at}: only states can be joined")
    if entry.encode not in (None, *_TEXTS, *_FILES):
        raise BadMapping(f"{at}: encode is one of {_listed((*_TEXTS, *_FILES))}")
    is_picture = bool(entry.source) and entry.source[0].startswith("images.")
    if entry.encode in _FILES and (
        not is_picture or entry.unit or entry.leading or entry.layout != "hwc"
    ):
        raise BadMapping(f"{at}: encode {entry.encode} is for images alone, as uint8")
    if entry.dtype is not None and not _is_of_numbers(entry.dtype):
        raise BadMapping(
            f"{at}: numpy has no numbers of dtype {entry.dtype}; float32, float16, "
            "int64 and uint8 are some that it has"
        )
    return entry


def _is_of_numbers(dtype: str) -> bool:
    try:
        return np.dtype(dtype).kind in "biuf"
    except TypeError:
        return False


def _read(row: type[Row], at: str, table: Any) -> Row:
    table = _table(at, table, may_be_empty=True)
    names = {"from" if f.name == "source" else f.name for f in fields(row)}
    _check_known(at, table, names)
    members: dict[str, Any] = {}
    for key, given in table.items():
        value = np.asarray(given) if key in ("scale", "offset") else given
        if key in ("resize", "clip"):
            value = tuple(given)
        if key == "from":
            value = tuple([given] if isinstance(given, str) else given)
        members["source" if key == "from" else key] = value
    return row(**members)


def _table(at: str, table: Any, *, may_be_empty: bool = False) -> Mapping[str, Any]:
    if not isinstance(table, Mapping) or not (table or may_be_empty):
        raise BadMapping(f"{at} is missing or not a table")
    return table


def _check_known(at: str, table: Mapping[str, Any], names: set[str]) -> None:
    if wrong := sorted(set(table) - names):
        faults = [unknown("key", name, sorted(names)) for name in wrong]
        raise BadMapping(f"{at}: {'; '.join(faults)}")


def _listed(names: Any) -> str:
    return ", ".join(sorted(map(str, names)))
