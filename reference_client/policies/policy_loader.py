"""Loads the policy of a reference.

References are `module:name`, `file.py:name`, `openpi:ws://host:8000`,
`gr00t:host:5555`, `proctor:http://host:8470` and `lerobot:FOLDER`. A name is a class or
a function without arguments, called once per worker to make a policy, or a function of
the observation, which is the policy.
Modules are found as by `python -m`: in the current folder first. Only code that the
user names is executed.
"""

from __future__ import annotations

import ast
import importlib
import importlib.util
import inspect
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk, Policy
from reference_client.errors import POLICY_FAILED, BadPolicy, ProctorError
from reference_client.policies.mapping import InvalidPolicyAnswer, PolicyMapping
from reference_client.spelling import did_you_mean


def load(reference: str, mapping: PolicyMapping | None = None) -> Callable[[], Policy]:
    """A factory, called once per worker to make its policy.

    mapping: converts observations and actions for the policy. Raises BadPolicy; errors
    raised by the import of the user's module pass through.
    """
    kind, _, rest = reference.partition(":")
    if kind == "openpi":
        return _openpi(rest, mapping)
    if kind == "gr00t":
        return _gr00t(rest, mapping)
    if kind == "proctor":
        return _policy_server(rest, mapping)
    if kind == "lerobot":
        from reference_client.policies.lerobot_policy import LerobotPolicies

        return LerobotPolicies(rest, mapping)
    made = _load_named(reference)
    if mapping is None:
        return _policy_factory(made, reference)
    return lambda: _MappedPolicy(_answer_function(made, reference), mapping)


def read_mapping(reference: str, path: str | None) -> PolicyMapping | None:
    """The mapping file of a policy, if any. Raises BadMapping."""
    if path is None:
        return None
    return PolicyMapping.read(path, is_partial=reference.startswith("lerobot:"))


def _openpi(url: str, mapping: PolicyMapping | None) -> Callable[[], Policy]:
    from reference_client.policies.openpi_client import OpenpiClient

    if not url.startswith(("ws://", "wss://")):
        raise BadPolicy(
            f"openpi: takes a URL like openpi:ws://127.0.0.1:8000, not {url!r}"
        )
    needed = _require(mapping, "openpi")
    return lambda: _of_server(OpenpiClient.connect_to(url), needed)


def _gr00t(address: str, mapping: PolicyMapping | None) -> Callable[[], Policy]:
    from reference_client.policies.gr00t.gr00t_client import (
        Gr00tClient,
        check_keys,
        split_address,
    )

    split_address(address)
    needed = _require(mapping, "gr00t")
    keys = list(needed.entries)
    check_keys(keys)
    return lambda: _of_server(Gr00tClient.connect_to(address, keys), needed)


def _of_server(client: Any, mapping: PolicyMapping) -> Policy:
    """client: has infer(request) and close()."""
    return _MappedPolicy(client.infer, mapping, client.close)


def _require(mapping: PolicyMapping | None, kind: str) -> PolicyMapping:
    if mapping is None:
        raise BadPolicy(
            f"{kind}: needs --mapping FILE, which maps observation and action names; "
            "docs/evaluate/policies.md lists mapping files"
        )
    return mapping


def _policy_server(url: str, mapping: PolicyMapping | None) -> Callable[[], Policy]:
    from reference_client.policies.policy_server_client import PolicyServerClient

    if not url.startswith(("http://", "https://")):
        raise BadPolicy(
            f"proctor: takes a URL like proctor:http://127.0.0.1:8470, not {url!r}"
        )
    if mapping is not None:
        raise BadPolicy("--mapping is not supported with proctor: policies")
    return PolicyServerClient(url)


def _example_in(path: Path) -> str | None:
    """FILE:NAME with the first class or function of a Python file; nothing is run."""
    if path.suffix != ".py":
        return None
    try:
        parts = ast.parse(path.read_bytes()).body
    except (OSError, SyntaxError, ValueError):
        return None
    kinds = (ast.ClassDef, ast.FunctionDef)
    names = [part.name for part in parts if isinstance(part, kinds)]
    return next((f"{path}:{name}" for name in names if name[0] != "_"), None)


def _load_named(reference: str) -> Any:
    place, _, name = reference.rpartition(":")
    if not place or not name:
        example = _example_in(Path(reference)) or "my_module:MyPolicy"
        raise BadPolicy(f"--policy takes a name like {example}, not {reference!r}")
    module = _module(place)
    named: Any = module
    for part in name.split("."):
        if not hasattr(named, part):
            raise BadPolicy(f"{place} has no {name}{did_you_mean(part, _named(named))}")
        named = getattr(named, part)
    if not callable(named):
        raise BadPolicy(f"{reference} is not callable: {named!r:.60}")
    return named


def _named(owner: Any) -> list[str]:
    """The names that may be meant: not those that begin with an underscore."""
    return [name for name in dir(owner) if not name.startswith("_")]


def _module(place: str) -> ModuleType:
    if place.endswith(".py"):
        path = Path(place)
        if not path.is_file():
            raise BadPolicy(f"there is no file {place}")
        # Modules in the same folder can be imported, as when the file is run.
        _add_to_path(path.resolve().parent)
        spec = importlib.util.spec_from_file_location(path.stem, path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[path.stem] = module
        spec.loader.exec_module(module)
        return module
    _add_to_path(Path.cwd())
    try:
        return importlib.import_module(place)
    except ModuleNotFoundError as error:
        if error.name is None or not f"{place}.".startswith(f"{error.name}."):
            raise  # a module that the policy's module imports
        raise BadPolicy(f"there is no module {error.name}") from error


def _add_to_path(folder: Path) -> None:
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))


def _policy_factory(made: Any, reference: str) -> Callable[[], Policy]:
    if not inspect.isclass(made) and _arguments(made) > 0:
        return lambda: _FunctionPolicy(made)

    def make() -> Policy:
        policy = made()
        if callable(getattr(policy, "act", None)):
            if not callable(getattr(policy, "reset", None)):
                raise BadPolicy(
                    f"{reference} makes a policy without reset(instruction)"
                )
            return policy  # type: ignore[no-any-return]
        if callable(policy):
            return _FunctionPolicy(policy)
        raise BadPolicy(f"{reference} makes a {type(policy).__name__} without act()")

    return make


def _answer_function(made: Any, reference: str) -> Any:
    """The function that answers a request; bound, if the policy is an object."""
    if not inspect.isclass(made) and _arguments(made) > 0:
        return made
    policy = made()
    for name in ("infer", "act", "__call__"):
        if callable(getattr(policy, name, None)):
            return getattr(policy, name)
    raise BadPolicy(f"{reference} makes a {type(policy).__name__} without infer()")


def _arguments(function: Callable[..., object]) -> int:
    """The number of required positional arguments."""
    return sum(
        parameter.default is parameter.empty
        and parameter.kind
        in (parameter.POSITIONAL_ONLY, parameter.POSITIONAL_OR_KEYWORD)
        for parameter in inspect.signature(function).parameters.values()
    )


def close_policy(policy: Policy) -> None:
    """Close the connection of a policy that `load` connected, and no other policy."""
    if isinstance(policy, _MappedPolicy):
        policy.close()


class _FunctionPolicy:
    """A policy that is a function: observation → action or chunk."""

    def __init__(self, function: Callable[[Observation], Any]) -> None:
        self._function = function

    def reset(self, instruction: str) -> None:
        """A function has no state."""

    def act(self, observation: Observation) -> Chunk:
        answer = self._function(observation)
        return [answer] if hasattr(answer, "keys") else answer


class _MappedPolicy:
    """A policy behind a mapping of names."""

    def __init__(
        self,
        infer: Any,
        mapping: PolicyMapping,
        close: Callable[[], None] | None = None,
    ) -> None:
        self._infer = infer
        self._mapping = mapping
        self._close = close
        self._reset = getattr(getattr(infer, "__self__", None), "reset", None)

    def reset(self, instruction: str) -> None:
        if callable(self._reset):
            self._reset(*[instruction][: min(1, _arguments(self._reset))])

    def close(self) -> None:
        if self._close is not None:
            self._close()

    def act(self, observation: Observation) -> Chunk:
        answer = self._infer(self._mapping.request(observation))
        try:
            return self._mapping.chunk(answer, observation)
        except InvalidPolicyAnswer as error:
            raise ProctorError(POLICY_FAILED, str(error)) from error
