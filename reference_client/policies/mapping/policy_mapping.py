"""A declarative mapping between the benchmark's names and those of a policy.

A TOML file. `[observation]` has an entry for each key of the policy's request,
`[action]` locates the numbers in its answer, and `[action.values]` assigns them to the
vectors of the action space. `[assumes]` has the conventions for which these numbers are
right (schema Assumptions). For policy servers, `[reset]` is the message before an
episode, and `[server]` says how they are spoken to. Every member is explained in
docs/evaluate/policies/policies.md. Nothing in such a file is executed.
"""

from __future__ import annotations

import contextlib
import datetime as dt
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Annotated, Any, Self, TypeAlias

import msgspec
import numpy as np
from msgspec import Meta
from proctor_client import Benchmark

from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk
from reference_client.policies.mapping.action_vector import (
    ActionVector,
    read_vector,
)
from reference_client.policies.mapping.members import (
    Array,
    BadMapping,
    Count,
    Dimensions,
    SizeMismatch,
    Table,
    read_members,
    require_table,
    shown,
)
from reference_client.policies.mapping.policy_answer import (
    InvalidPolicyAnswer,
    common_length,
    rows_of,
)
from reference_client.policies.mapping.request_entry import (
    GROUPS,
    WORDS,
    RequestEntry,
    group_of,
    read_entry,
)
from reference_client.policies.mapping.unread_numbers import notes_on_unread
from reference_record.command_line.toml_file import NotToml, read_toml_file
from reference_record.texts.counted_text import counted

# A request is a table of entries, tables and lists of them.
Node: TypeAlias = "RequestEntry | Mapping[str, Node] | list[Node]"


class _ActionTable(msgspec.Struct, frozen=True):
    """The table `[action]`."""

    source: Annotated[
        tuple[str] | None, Meta(description="a place in the answer, as text")
    ] = msgspec.field(default=None, name="from")
    execute: Count | None = None
    leading: Dimensions = 0
    values: Table = {}


class _File(msgspec.Struct, frozen=True):
    """The whole file; `members` checks the entries of its tables."""

    observation: Table = {}
    action: Table = {}
    reset: Table | None = None
    server: Table = {}
    assumes: Table | None = None


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
        file = read_members(_File, name, document)
        at = f"{name}: action"
        for table in () if is_partial else ("action", "observation"):
            require_table(f"{name}: {table}", document.get(table))
        action = read_members(_ActionTable, at, file.action)
        require_table(f"{at}.values", action.values, may_be_empty=is_partial)
        if file.reset is not None:
            require_table(f"{name}: reset", file.reset)
        mapping = cls(
            name=name,
            tree=_tree(f"{name}: observation", file.observation),
            source=None if action.source is None else action.source[0],
            execute=action.execute,
            leading=action.leading,
            vectors={
                key: read_vector(f'{at}.values."{key}"', table)
                for key, table in action.values.items()
            },
            first_message=None
            if file.reset is None
            else _tree(f"{name}: reset", file.reset),
            server=file.server,
            assumes=file.assumes,
        )
        _refuse_unusable(name, document)
        return mapping

    def check(self, benchmark: Benchmark) -> None:
        """Raises BadMapping if the mapping does not fit the benchmark."""
        self._check_sources(benchmark)
        space = benchmark.observation_space
        for at, entry in self._placed_entries():
            groups = {group_of(source) for source in entry.source}
            names = [source.partition(".")[2] for source in entry.source]
            with self._naming(at):
                if groups == {"state"}:
                    entry.width(sum(space.state[name].size for name in names))
                elif groups == {"images"}:
                    entry.check_channels(space.images[names[0]].channels)
        for name, vector in self.vectors.items():
            with self._naming(_vector_place(name)):
                _check_size(vector, name, benchmark)

    def _check_sources(self, benchmark: Benchmark) -> None:
        space = benchmark.observation_space
        sources = {
            f"{group}.{name}" for group in GROUPS for name in getattr(space, group)
        }
        wanted = [
            (at, source)
            for at, entry in self._placed_entries()
            for source in entry.source
            if source not in WORDS
        ]
        wanted += [
            (_vector_place(name), vector.relative_to)
            for name, vector in self.vectors.items()
            if vector.relative_to is not None
        ]
        for at, source in wanted:
            if source not in sources:
                raise BadMapping(
                    f"{self.name}: {at} is from {source}; {benchmark.benchmark_id} "
                    f"has {_listed(sources)}"
                )
        if set(self.vectors) != set(benchmark.action_space):
            raise BadMapping(
                f"{self.name}: action.values has {_listed(self.vectors)}; an action of "
                f"{benchmark.benchmark_id} has {_listed(benchmark.action_space)}"
            )

    def _placed_entries(self) -> Iterator[tuple[str, RequestEntry]]:
        """Each entry of a request, with its place in the file."""
        trees = {"observation": self.tree, "reset": self.first_message or {}}
        for table, tree in trees.items():
            for key, entry in _leaves(tree):
                yield f'{table}."{key}"', entry

    @contextlib.contextmanager
    def _naming(self, at: str) -> Iterator[None]:
        """A mismatch of the entry there becomes BadMapping."""
        try:
            yield
        except SizeMismatch as error:
            raise BadMapping(f"{self.name}: {at}: {error}") from error

    def request(self, observation: Observation) -> dict[str, Any]:
        """The policy's request for an observation. Raises BadMapping."""
        filled: dict[str, Any] = self._filled("observation", self.tree, observation)
        return filled

    def reset_message(self, observation: Observation) -> dict[str, Any] | None:
        """The message before the first request of an episode; None if there is none."""
        if self.first_message is None:
            return None
        filled: dict[str, Any] = self._filled("reset", self.first_message, observation)
        return filled

    def _filled(self, at: str, node: Node, observation: Observation) -> Any:
        match node:
            case RequestEntry():
                with self._naming(at):
                    return node.of(observation)
            case list():
                return [
                    self._filled(f"{at}.{index}", part, observation)
                    for index, part in enumerate(node)
                ]
        return {
            key: self._filled(f'{at}."{key}"', part, observation)
            for key, part in node.items()
        }

    def chunk(self, answer: Any, observation: Observation) -> Chunk:
        """The policy's answer as a chunk. Raises InvalidPolicyAnswer."""
        places = self._rows(answer)
        length = common_length(places, self.name)
        whole = {
            name: self._vector(name, vector, places, observation)
            if vector.value is None
            else np.tile(np.atleast_1d(vector.value), (length, 1))
            for name, vector in self.vectors.items()
        }
        return [
            {name: whole[name][i] for name in self.vectors}
            for i in range(min(length, self.execute or length))
        ]

    def notes_on(self, answer: Any) -> list[str]:
        """Sentences on numbers of a valid answer that may be read wrongly."""
        notes = notes_on_unread(self.vectors.values(), self.source, self._rows(answer))
        return [f"{self.name}: {note}" for note in notes]

    def _rows(self, answer: Any) -> dict[str | None, Array]:
        """The rows at each place that a vector is made of."""
        return {
            place: rows_of(answer, place, self.leading, self.name)
            for vector in self.vectors.values()
            if vector.value is None
            for place in vector.source or (self.source,)
        }

    def _vector(
        self,
        name: str,
        vector: ActionVector,
        places: Mapping[str | None, Array],
        observation: Observation,
    ) -> Array:
        parts = [places[place] for place in vector.source or (self.source,)]
        try:
            return vector.of(np.concatenate(parts, axis=1), observation)
        except SizeMismatch as error:
            raise InvalidPolicyAnswer(
                f"{self.name}: {_vector_place(name)}: {error} of the answer"
            ) from error


def _vector_place(name: str) -> str:
    return f'action.values."{name}"'


def _check_size(vector: ActionVector, name: str, benchmark: Benchmark) -> None:
    """Raises SizeMismatch if the mapping makes another size than the benchmark has."""
    size = benchmark.action_space[name].size
    width = vector.width()
    if width is not None and width != size:
        raise SizeMismatch(
            f"{vector.deciding_member()} makes {counted(width, 'number')}, and {name} "
            f"of {benchmark.benchmark_id} has {size}"
        )
    if vector.relative_to is not None:
        _, _, state = vector.relative_to.partition(".")
        start = benchmark.observation_space.state[state].size
        vector.check_start(start, size)


def _refuse_unusable(name: str, given: Any, *keys: str) -> None:
    """Raises BadMapping for dates and nan, also where a member may have any value."""
    is_nan = isinstance(given, float) and math.isnan(given)
    if is_nan or isinstance(given, dt.date | dt.time):
        place = ".".join(keys)
        raise BadMapping(f"{name}: {place} is {shown(given)}, which no member takes")
    if isinstance(given, Mapping | list):
        parts = given.items() if isinstance(given, Mapping) else enumerate(given)
        for key, part in parts:
            _refuse_unusable(name, part, *keys, str(key))


def _tree(at: str, table: Mapping[str, Any]) -> Mapping[str, Node]:
    return {key: _node(f'{at}."{key}"', part) for key, part in table.items()}


def _node(at: str, given: Any) -> Node:
    """An entry is a table that has `from` or `value`; other tables and lists nest."""
    if isinstance(given, list) and given:
        return [_node(f"{at}.{index}", part) for index, part in enumerate(given)]
    names = {field.encode_name for field in msgspec.structs.fields(RequestEntry)}
    is_nested = (
        isinstance(given, Mapping)
        and given
        and all(isinstance(part, Mapping | list) for part in given.values())
        and not names & set(given)
    )
    return _tree(at, given) if is_nested else read_entry(at, given)


def _leaves(node: Node, at: str = "") -> Iterator[tuple[str, RequestEntry]]:
    if isinstance(node, RequestEntry):
        yield at, node
        return
    parts = node.items() if isinstance(node, Mapping) else enumerate(node)
    for key, part in parts:
        yield from _leaves(part, f"{at}.{key}" if at else str(key))


def _listed(names: Iterable[object]) -> str:
    return ", ".join(sorted(map(str, names)))
