"""Wrong values and requests that schemathesis makes from openapi.yaml, as plain data.

Its coverage phase breaks every keyword of every schema once; its fuzzing phase makes
whole requests at random, right and wrong. Knows nothing of a server.

The library takes a second of processor time, so that only checks that need it load it.
"""

import dataclasses
import functools
import json
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING, Any, cast
from urllib.parse import unquote

from hypothesis.strategies import SearchStrategy

from conformance.checks.support.operation_samples import OperationSample
from conformance.specification.document import MSGPACK, ZIP, load_spec, schema_faults

if TYPE_CHECKING:
    from schemathesis import Case
    from schemathesis.specs.openapi.schemas import OpenApiSchema

# Names of the library: a member that no schema has, and an entry of a map.
_UNKNOWN = "x-schemathesis-unknown-property"
_ENTRY = "x-schemathesis-additional"
_MISSING_MEMBER = re.compile(r"Missing required property: (\w+)")
_OF_MEMBERS = ("required", "additionalProperties")
# Values out of these bounds are wrong for another reason as well: they name no session,
# contradict the benchmark, or are not offered.
_WRONG_TWICE = frozenset({"session_id", "seq", "assumes", "images", "values"})
# Headers that a random request does not have: the kit's token, and those that are for
# the HTTP library, which may refuse them before the server sees the request.
_NOT_RANDOM = frozenset(
    [
        *("authorization", "connection", "content-length", "expect", "host"),
        *("te", "trailer", "transfer-encoding", "upgrade"),
    ]
)


class RequestPart(StrEnum):
    """Where in a request its wrong value is."""

    BODY = "body"
    QUERY = "query"
    HEADER = "header"


@dataclass(frozen=True)
class WrongValue:
    """One value that breaks one keyword of a schema.

    `at`: the name of a parameter, or the way to a value in the body. `keyword`: `type`,
    `required`, `additionalProperties`, or that of a bound, a pattern or an enum.
    `member`: the one that is missing or unknown.
    """

    operation_id: str
    place: RequestPart
    at: tuple[str, ...]
    keyword: str
    value: Any = None
    member: str = ""

    @property
    def rule(self) -> str | None:
        """The rule that refuses it; None if another rule may refuse it as well."""
        if self.place != RequestPart.BODY:
            return "ERR-014"
        if self.keyword == "type":
            return "ERR-004" if self.at else "ERR-015"
        if self.keyword == "additionalProperties":
            return "ERR-003"
        is_bound = self.keyword != "required"
        return None if is_bound and _WRONG_TWICE & {*self.at} else "ERR-016"

    @property
    def pointer(self) -> str:
        """Where the server has to point."""
        if self.place != RequestPart.BODY:
            return f"{self.place.value}:{self.at[0]}"
        named = (*self.at, self.member) if self.keyword in _OF_MEMBERS else self.at
        return "".join(f"/{name}" for name in named)

    @property
    def parent(self) -> str:
        """Where it may point instead: to the object that lacks a member."""
        return "".join(f"/{name}" for name in self.at)

    def put_into(self, how: Mapping[str, Any]) -> tuple["WrongValue", dict[str, Any]]:
        """Put it into a right request. Raises NoRoom if that has no place for it.

        The wrong value that is given has the names of that request.
        """
        if self.place == RequestPart.BODY:
            if "json" not in how:
                raise NoRoom
            way = tuple(_real_names(how["json"], self.at))
            body = _put(how["json"], way, self._change)
            return dataclasses.replace(self, at=way), {**how, "json": body}
        part = "params" if self.place == RequestPart.QUERY else "headers"
        given = {**how.get(part, {}), self.at[0]: self.value}
        present = {name: value for name, value in given.items() if value is not None}
        return self, {**how, part: present}

    def _change(self, value: Any) -> Any:
        if self.keyword not in _OF_MEMBERS:
            return self.value
        if not isinstance(value, dict):
            raise NoRoom
        if self.keyword == "additionalProperties":
            return {**value, self.member: 42}
        if self.member not in value:
            raise NoRoom
        return {name: value[name] for name in value if name != self.member}


class NoRoom(Exception):
    """A request does not have the part that a wrong value has."""


def _put(body: Any, way: tuple[str, ...], change: Callable[[Any], Any]) -> Any:
    if not way:
        return change(body)
    name, *more = way
    if isinstance(body, list) and body:
        return [*body[:-1], _put(body[-1], tuple(more), change)]
    if not isinstance(body, dict) or (more and name not in body):
        raise NoRoom
    return {**body, name: _put(body.get(name), tuple(more), change)}


def _real_names(body: Any, way: tuple[str, ...]) -> Iterator[str]:
    """Name the entries of maps as in a right body, and the last entry of a list."""
    for step in way:
        name = step
        if isinstance(body, list):
            name = str(max(len(body) - 1, 0))
            body = body[-1] if body else None
        elif isinstance(body, dict):
            name = next(iter(body), step) if step.startswith(_ENTRY) else step
            body = body.get(name)
        yield name


@functools.cache
def all_wrong_values(operation_ids: frozenset[str]) -> tuple[WrongValue, ...]:
    """Give every wrong value that the library knows for these operations."""
    from schemathesis import GenerationMode

    schema, values = load_schema(), dict[str, WrongValue]()
    for result in schema.get_all_operations():
        operation = cast("Any", result).ok()
        if operation.definition.raw["operationId"] not in operation_ids:
            continue
        config = schema.config.generation_for(operation=operation, phase="coverage")
        for case in schema.iter_coverage_cases(
            operation,
            generation_modes=[GenerationMode.NEGATIVE],
            generation_config=config,
        ):
            if (wrong := _read_wrong_value(case)) is not None:
                values[repr(dataclasses.replace(wrong, keyword=""))] = wrong
    return tuple(values.values())


def _read_wrong_value(case: "Case[Any]") -> WrongValue | None:
    data: Any = case.meta.phase.data if case.meta else None
    place = data.parameter_location and data.parameter_location.name.lower()
    if case.method != case.operation.method.upper() or place not in [*RequestPart]:
        return None  # other rules judge methods and media types
    operation_id = str(case.operation.definition.raw["operationId"])
    keyword = (data.location or "/").rpartition("/")[2]
    if place == RequestPart.BODY:
        if case.media_type == "application/json" and data.location:
            return _read_wrong_body(operation_id, case, data)
        return None
    name = str(data.parameter)
    containers = {
        RequestPart.QUERY: case.query,
        RequestPart.HEADER: case.headers,
    }
    value = containers[RequestPart(place)].get(name)
    is_known = any(p["name"] == name for p in _parameters(operation_id))
    is_text = isinstance(value, str) or (value is None and place == RequestPart.QUERY)
    if not (is_known and is_text and _breaks(operation_id, name, value)):
        return None
    return WrongValue(operation_id, RequestPart(place), (name,), keyword, value)


def _read_wrong_body(operation_id: str, case: "Case[Any]", data: Any) -> WrongValue:
    *way, keyword = data.location.split("/")[1:]
    names = iter(way)
    at = tuple(
        "0" if step == "items" else next(names)
        for step in names
        if step in ("items", "properties", "additionalProperties")
    )
    missing = _MISSING_MEMBER.search(data.description)
    member = missing[1] if missing else _UNKNOWN
    value: Any = case.body
    for name in at if keyword not in _OF_MEMBERS else ():
        value = value[int(name) if isinstance(value, list) else name]
    kept = None if keyword in _OF_MEMBERS else value
    return WrongValue(operation_id, RequestPart.BODY, at, keyword, kept, member)


def _parameters(operation_id: str) -> list[dict[str, Any]]:
    description = load_spec().operations[operation_id].description
    parameters: list[dict[str, Any]] = description.get("parameters", [])
    return parameters


def _breaks(operation_id: str, name: str, value: str | None) -> bool:
    """Whether a text breaks the schema of a parameter, or is missing and required."""
    parameter = next(p for p in _parameters(operation_id) if p["name"] == name)
    if value is None:
        return bool(parameter.get("required"))
    schema, read = parameter["schema"], cast("Any", value)
    if schema.get("type") in ("integer", "number"):
        try:
            read = float(value)
        except ValueError:
            return True
    return bool(schema_faults(schema, read))


@functools.cache
def load_schema() -> "OpenApiSchema":
    """Load the library, and let it read openapi.yaml."""
    import schemathesis

    # Bytes are sent as they are.
    schemathesis.serializer(ZIP)(lambda _, value: str(value).encode())
    document: Any = load_spec().document
    return schemathesis.openapi.from_dict(document)


def random_requests(
    operation_id: str, is_right: bool
) -> SearchStrategy[OperationSample]:
    """Make whole requests of one operation, which keep its schema or break it."""
    from schemathesis import GenerationMode

    mode = GenerationMode.POSITIVE if is_right else GenerationMode.NEGATIVE
    operation = load_schema().find_operation_by_id(operation_id)
    strategy: SearchStrategy[Case[Any]] = operation.as_strategy(generation_mode=mode)
    return strategy.map(_as_sample)


def _as_sample(case: "Case[Any]") -> OperationSample:
    how: dict[str, Any] = {
        name: unquote(str(value)) for name, value in case.path_parameters.items()
    }
    headers = {
        name: str(value)
        for name, value in case.headers.items()
        if name.lower() not in _NOT_RANDOM
    }
    if case.query:
        how["params"] = dict(case.query)
    if case.media_type == MSGPACK:
        how |= {"msgpack": True, "json": case.body}
    elif case.media_type == ZIP:
        how["content"] = str(case.body).encode()
    elif case.media_type is not None:
        how["json"] = json.loads(json.dumps(case.body, default=str))
    return case.operation.definition.raw["operationId"], how | {"headers": headers}
