"""The specification as data: operations, schemas, problems, lifecycle.

Loaded once per process from `spec/openapi.yaml`; an installed kit carries the
documents with it. Knows nothing of servers or checks.
"""

import base64
import copy
import functools
import hashlib
import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import Any

import jsonschema
import jsonschema_rs
import yaml

from conformance.specification.rule_documents import rule_documents
from conformance.specification.whole_numbers import whole_number_faults

_HERE = Path(__file__).resolve().parent
_PACKAGED = _HERE / "files"
SPEC_DIRECTORY = _PACKAGED if _PACKAGED.is_dir() else _HERE.parents[1] / "spec"
JSON = "application/json"
MSGPACK = "application/msgpack"
PROBLEM_JSON = "application/problem+json"
EVENT_STREAM = "text/event-stream"
ZIP = "application/zip"
_METHODS = ("get", "put", "post", "delete")
# RFC 3339, section 5.6, in the form that http.md allows in answers.
_DATE_TIME = re.compile(
    r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,9})?(Z|[+-]([01]\d|2[0-3]):[0-5]\d)",
    re.ASCII,
)
_INTEGER_BITS = {"int32": 32, "int64": 64}
_FORMATS = jsonschema.FormatChecker(formats=())


@_FORMATS.checks("date-time")
def _is_date_time(value: object) -> bool:
    if not isinstance(value, str):
        return True
    try:
        datetime.fromisoformat(value)  # a day and an hour that there is
    except ValueError:
        return False
    return _DATE_TIME.fullmatch(value) is not None


@_FORMATS.checks("base64")
def _is_base64(value: object) -> bool:
    if not isinstance(value, str):
        return True
    try:
        base64.b64decode(value, validate=True)
    except ValueError:
        return False
    return True


def _with_bytes() -> Any:
    """Make a validator class with the type `bytes`, which MessagePack has."""
    checker = jsonschema.Draft202012Validator.TYPE_CHECKER.redefine(
        "bytes", lambda _, value: isinstance(value, bytes)
    )
    extend: Any = jsonschema.validators.extend
    return extend(jsonschema.Draft202012Validator, type_checker=checker)


_Validator = _with_bytes()


@dataclass(frozen=True)
class Operation:
    """One operation of the document; `path` is the template."""

    operation_id: str
    method: str
    path: str
    is_data_plane: bool
    needs_token: bool
    profile: str
    description: Mapping[str, Any]

    def request_media_types(self) -> list[str]:
        """Name the media types in which a body may be sent."""
        return list(self.description.get("requestBody", {}).get("content", {}))

    def answer_media_types(self) -> list[str]:
        """Name the media types of its successful answers."""
        answers = self.description["responses"].items()
        return [
            media_type
            for status, answer in answers
            if status.startswith("2")
            for media_type in answer.get("content", {})
        ]

    def response(self, status: int) -> Mapping[str, Any] | None:
        """Find the response of a status, by code or by class; None if there is none."""
        responses: Mapping[str, Any] = self.description["responses"]
        return responses.get(str(status)) or responses.get(f"{status // 100}XX")


class Spec:
    """The document with every `$ref` resolved."""

    def __init__(self, document: Mapping[str, Any]) -> None:
        self.document = document
        self.version: str = document["info"]["version"]
        self.problems: Mapping[str, Any] = document["x-problems"]
        self.lifecycle: Mapping[str, Any] = document["x-lifecycle"]
        self.operations = {o.operation_id: o for o in self._read_operations()}
        # For each schema: a fast validator, and a slow one that explains faults.
        self._validators: dict[tuple[Any, ...], tuple[Callable[[Any], bool], Any]] = {}

    def _read_operations(self) -> Iterator[Operation]:
        for path, item in self.document["paths"].items():
            for method in _METHODS:
                if method not in item:
                    continue
                description = self._resolve(item[method])
                security = description.get("security", self.document["security"])
                yield Operation(
                    operation_id=description["operationId"],
                    method=method.upper(),
                    path=path,
                    is_data_plane="Play" in description["tags"],
                    needs_token=bool(security),
                    profile=description.get("x-profile", "core"),
                    description=description,
                )

    def _resolve(self, node: Any) -> Any:
        if isinstance(node, dict):
            if "$ref" in node:
                target: Any = self.document
                for key in node["$ref"].removeprefix("#/").split("/"):
                    target = target[key]
                return self._resolve(target)
            return {key: self._resolve(value) for key, value in node.items()}
        if isinstance(node, list):
            return [self._resolve(item) for item in node]
        return node

    def schema(self, name: str) -> dict[str, Any]:
        """Give a schema of `components` without references."""
        resolved: dict[str, Any] = self._resolve(
            copy.deepcopy(self.document["components"]["schemas"][name])
        )
        return resolved

    def find(self, method: str, path: str) -> Operation | None:
        """Find the operation of a concrete path, relative to the server's base."""
        for operation in self.operations.values():
            pattern = re.sub(r"\\{[a-z_]+\\}", "[^/]+", re.escape(operation.path))
            if operation.method == method and re.fullmatch(pattern, path):
                return operation
        return None

    def request_faults(self, operation: Operation, body: Any) -> list[str]:
        """List how a request body breaks its schema."""
        content = operation.description["requestBody"]["content"]
        key = ("request", operation.operation_id)
        return self._faults(key, content[JSON]["schema"], body)

    def response_faults(
        self, operation: Operation, status: int, media_type: str, body: Any
    ) -> list[str]:
        """List how a body breaks the schema of its status and media type."""
        response = operation.response(status)
        if response is None or media_type not in response.get("content", {}):
            return []
        schema = response["content"][media_type]["schema"]
        key = ("response", operation.operation_id, status, media_type)
        if media_type == MSGPACK:
            return self._faults(key, _blobs_as_bytes(schema), body)
        return self._faults(key, schema, body) or whole_number_faults(schema, body)

    def event_faults(self, operation: Operation, kind: str, data: Any) -> list[str]:
        """List how the data of an event of a stream breaks the schema of its kind."""
        content = operation.description["responses"]["200"]["content"][EVENT_STREAM]
        schemas: Mapping[str, Any] = content["x-events"]
        return self._faults((operation.operation_id, kind), schemas[kind], data)

    def _faults(self, key: tuple[Any, ...], schema: Any, body: Any) -> list[str]:
        if key not in self._validators:
            schema = _with_ranges(schema)
            detailed_validator = _Validator(schema, format_checker=_FORMATS)
            knows_bytes = MSGPACK in key
            is_valid_quickly = (
                detailed_validator.is_valid if knows_bytes else _fast_validator(schema)
            )
            self._validators[key] = is_valid_quickly, detailed_validator
        is_valid_quickly, detailed_validator = self._validators[key]
        if is_valid_quickly(body):
            return []
        return _explain(detailed_validator, body)


def schema_faults(schema: Any, body: Any) -> list[str]:
    """List how a body breaks a schema, without formats."""
    return _explain(_Validator(schema), body)


def _explain(validator: Any, body: Any) -> list[str]:
    return [
        f"{error.json_path}: {error.message[:300]}{_hint(error)}"
        for error in validator.iter_errors(body)
    ]


def _hint(error: Any) -> str:
    is_time = (error.validator, error.validator_value) == ("format", "date-time")
    return " (RFC 3339, with Z or an offset at its end)" if is_time else ""


def _with_ranges(schema: Any) -> Any:
    """Express the formats int32 and int64, and the encoding base64, in JSON Schema."""
    if isinstance(schema, dict):
        widened = {key: _with_ranges(value) for key, value in schema.items()}
        if schema.get("contentEncoding") == "base64":
            widened["format"] = "base64"
        bits = _INTEGER_BITS.get(str(schema.get("format")))
        if bits is not None:
            bound = 2 ** (bits - 1)
            widened["allOf"] = [{"minimum": -bound, "maximum": bound - 1}]
        return widened
    if isinstance(schema, list):
        return [_with_ranges(item) for item in schema]
    return schema


def _fast_validator(schema: Any) -> Callable[[Any], bool]:
    """Make a fast validator: bodies that it accepts are valid.

    The detailed validator decides on all others.
    """
    validator = jsonschema_rs.Draft202012Validator(
        schema,
        validate_formats=True,
        formats={"base64": _is_base64, "date-time": _is_date_time},
    )

    def is_valid(body: Any) -> bool:
        try:
            return bool(validator.is_valid(body))
        except ValueError:  # for example a string that is not Unicode
            return False

    return is_valid


def _blobs_as_bytes(schema: Any) -> Any:
    """Replace base64 strings of JSON by `bin` of MessagePack."""
    if isinstance(schema, dict):
        if schema.get("contentEncoding") == "base64":
            return {"type": "bytes"}
        return {key: _blobs_as_bytes(value) for key, value in schema.items()}
    if isinstance(schema, list):
        return [_blobs_as_bytes(item) for item in schema]
    return schema


@functools.cache
def load_spec() -> Spec:
    """Load openapi.yaml."""
    return Spec(_read(SPEC_DIRECTORY / "openapi.yaml"))


@functools.cache
def load_registry(name: str) -> list[dict[str, Any]]:
    """Load the entries of a registry by the name of its file."""
    entries: Any = _read(SPEC_DIRECTORY / "registry" / f"{name}.yaml")
    return [*entries]


@functools.cache
def load_policy_spec() -> Spec:
    """Load policy.yaml: its paths and rules, with the schemas of openapi.yaml."""
    whole, policy = load_spec().document, _read(SPEC_DIRECTORY / "policy.yaml")
    here = _with_own_references(policy)
    here["components"]["schemas"] |= whole["components"]["schemas"]
    codes = policy["x-problems"]
    shared = {code: whole["x-problems"][code] for code in codes}
    here["x-problems"] = shared | policy["x-problems-of-policies"]
    return Spec(here | {"x-lifecycle": {"transitions": []}})


def _with_own_references(node: Any) -> Any:
    if isinstance(node, dict):
        own = {key: _with_own_references(value) for key, value in node.items()}
        if "$ref" in own:
            own["$ref"] = own["$ref"].removeprefix("openapi.yaml")
        return own
    if isinstance(node, list):
        return [_with_own_references(item) for item in node]
    return node


def _read(path: Path) -> dict[str, Any]:
    # The C loader is ten times faster; both are safe ones.
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    text = path.read_text(encoding="utf-8")
    document: dict[str, Any] = yaml.load(text, Loader=loader)  # noqa: S506
    return document


@functools.cache
def spec_sha256() -> str:
    """Give the hash over all documents, so that two reports can be compared."""
    paths = [SPEC_DIRECTORY / "openapi.yaml", SPEC_DIRECTORY / "policy.yaml"]
    paths += rule_documents(SPEC_DIRECTORY)
    for folder in ("profiles", "registry"):
        paths += sorted((SPEC_DIRECTORY / folder).glob("*.yaml"))
    documents = [path.read_bytes() for path in paths]
    # A checkout may have converted the line endings.
    return hashlib.sha256(b"".join(documents).replace(b"\r\n", b"\n")).hexdigest()


def spec_name() -> str:
    """Give the version and the hash of the specification."""
    return f"Proctor {load_spec().version} ({spec_sha256()[:12]})"
