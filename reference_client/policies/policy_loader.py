"""Loads the policy of a reference.

References are `module:name`, `file.py:name`, `lerobot:FOLDER`, and policy servers:
`openpi:ws://host:8000`, `vla-eval:ws://host:8000`, `gr00t:host:5555`, `ws://host/path`,
`http://host/path` and `proctor:http://host:8470`. A name is a class or a function
without arguments, called once per worker to make a policy, or a function of the
observation, which is the policy.
Modules are found as by `python -m`: in the current folder first. Only code that the
user names is executed.
"""

from __future__ import annotations

import ast
import importlib
import importlib.util
import inspect
import sys
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any, Protocol

from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk, Policy
from reference_client.errors import POLICY_FAILED, BadPolicy, ProctorError
from reference_client.policies.mapping import (
    InvalidPolicyAnswer,
    Node,
    NoNumbers,
    PolicyMapping,
    RequestEntry,
)
from reference_client.policies.servers.first_greeting import FirstGreeting
from reference_client.policies.servers.server_transport import warn
from reference_client.policies.servers.wire_settings import ServerSettings
from reference_record.command_line.spelling import did_you_mean

_WEBSOCKET_KINDS = ("openpi", "vla-eval")


def load(reference: str, mapping: PolicyMapping | None = None) -> Callable[[], Policy]:
    """A factory, called once per worker to make its policy.

    mapping: converts observations and actions for the policy. Raises BadPolicy; errors
    raised by the import of the user's module pass through.
    """
    kind, rest = server_kind(reference), reference.partition(":")[2]
    if kind is not None:
        if kind in _WEBSOCKET_KINDS:
            _require_scheme(kind, rest, ("ws", "wss"))
        if mapping is None:
            raise BadPolicy(
                f"{kind}: needs --mapping FILE, which maps observation and action "
                "names; docs/evaluate/policies/policy-servers.md lists mapping files"
                + _MEANT.get(kind, "")
            )
        is_url = kind in ("ws", "http")
        return _SERVERS[kind](reference if is_url else rest, mapping)
    if mapping is not None and (mapping.server or mapping.first_message):
        raise BadPolicy(f"{mapping.name}: [server] and [reset] are of policy servers")
    if reference.startswith("proctor:"):
        return _policy_server(rest, mapping)
    if reference.startswith("lerobot:"):
        from reference_client.policies.lerobot_policy import LerobotPolicies

        return LerobotPolicies(rest, mapping)
    made = _load_named(reference)
    if mapping is None:
        return policy_factory(made, reference)
    _require_maker(made, reference)
    return lambda: _MappedPolicy(_answer_function(made, reference), mapping)


def server_kind(reference: str) -> str | None:
    """`openpi`, `vla-eval`, `gr00t`, `ws` or `http`; None for any other policy."""
    kind, _, rest = reference.partition(":")
    if kind in _SCHEMES:
        return _SCHEMES[kind] if rest.startswith("//") else None
    return kind if kind in _SERVERS else None


def name_of_reference(reference: str) -> str:
    """The name of a policy that nothing else names: its server, folder or function."""
    if (kind := server_kind(reference)) is not None:
        return kind
    if reference.startswith("lerobot:"):
        return Path(reference.partition(":")[2]).resolve().name
    return reference.rpartition(":")[2] or reference


def read_mapping(reference: str, path: str | None) -> PolicyMapping | None:
    """The mapping file of a policy, if any. Raises BadMapping."""
    if path is None:
        return None
    return PolicyMapping.read(path, is_partial=reference.startswith("lerobot:"))


def _openpi(url: str, mapping: PolicyMapping) -> Callable[[], Policy]:
    readable = {"expect", "varying", "answer_s", "new_connection"}
    settings = ServerSettings.of(mapping, "openpi:", readable)
    return _websocket_policies(url, mapping, settings, ("OPENPI_API_KEY", "Api-Key"))


def _websocket(url: str, mapping: PolicyMapping) -> Callable[[], Policy]:
    readable = {*ServerSettings.__struct_fields__} - {"reset_path"}
    settings = ServerSettings.of(mapping, "ws:", readable)
    of_greetings = (settings.expect, settings.ready, settings.varying)
    if any(of_greetings) and not settings.greeting:
        raise BadPolicy(
            f"{mapping.name}: [server]: ready, expect and varying are of servers that "
            "greet"
        )
    return _websocket_policies(url, mapping, settings, ("PROCTOR_POLICY_KEY", "Bearer"))


def _websocket_policies(
    url: str,
    mapping: PolicyMapping,
    settings: ServerSettings,
    key: tuple[str, str],
) -> Callable[[], Policy]:
    """key: the variable that has it, and the word before it in its header."""
    from reference_client.policies.servers.websocket_client import WebsocketClient

    variable, scheme = key
    first = FirstGreeting(settings.varying)
    return lambda: _ServedPolicy(
        WebsocketClient(
            url, settings, key=variable, key_scheme=scheme, first=first
        ).connected(),
        mapping,
    )


def _vla_eval(url: str, mapping: PolicyMapping) -> Callable[[], Policy]:
    from reference_client.policies.servers.vla_eval_client import VlaEvalClient

    readable = {"expect", "varying", "answer_s"}
    settings = ServerSettings.of(mapping, "vla-eval:", readable, format="msgpack-text")
    first = FirstGreeting(settings.varying)
    if mapping.first_message is None:
        mapping = replace(mapping, first_message=VLA_EVAL_TASK)
    return lambda: _ServedPolicy(
        VlaEvalClient(url, settings, first=first).connected(), mapping
    )


def _http(url: str, mapping: PolicyMapping) -> Callable[[], Policy]:
    from reference_client.policies.servers.http_policy_client import HttpPolicyClient

    readable = {"format", "envelope", "reset_path", "answer_s"}
    settings = ServerSettings.of(mapping, "http:", readable, format="json")
    if settings.envelope is not None and not settings.format.startswith("json"):
        raise BadPolicy(
            f"{mapping.name}: [server]: envelope is for the formats json and json-numpy"
        )
    return lambda: _ServedPolicy(HttpPolicyClient(url, settings).connected(), mapping)


def _gr00t(address: str, mapping: PolicyMapping) -> Callable[[], Policy]:
    from reference_client.policies.servers.gr00t.gr00t_client import (
        Gr00tClient,
        check_keys,
        split_address,
    )

    split_address(address)
    settings = ServerSettings.of(mapping, "gr00t:", {"answer_s"})
    if mapping.first_message is not None:
        raise BadPolicy("gr00t: [reset] is not read; its reset has no message")
    flat = mapping.flat()
    keys = list(flat.entries)
    check_keys(keys)
    first = FirstGreeting()
    return lambda: _ServedPolicy(
        Gr00tClient.connect_to(address, keys, answer_s=settings.answer_s, first=first),
        flat,
    )


def _require_scheme(kind: str, url: str, schemes: tuple[str, ...]) -> None:
    if url.partition("://")[0] not in schemes or "://" not in url:
        raise BadPolicy(
            f"{kind}: takes a URL like {kind}:{schemes[0]}://127.0.0.1:8000, "
            f"not {url!r}"
        )


# The first message of an episode to a model server of vla-eval.
VLA_EVAL_TASK: Mapping[str, Node] = {
    "task": {"name": RequestEntry(source=("instruction",))}
}
_SERVERS: Mapping[str, Callable[[str, PolicyMapping], Callable[[], Policy]]] = {
    "openpi": _openpi,
    "vla-eval": _vla_eval,
    "gr00t": _gr00t,
    "ws": _websocket,
    "http": _http,
}
_SCHEMES = {"ws": "ws", "wss": "ws", "http": "http", "https": "http"}
_MEANT = {
    "ws": "; openpi's protocol is openpi:ws://…, vla-eval's is vla-eval:ws://…",
    "http": "; a policy server of policy.yaml is proctor:http://…",
}


def _policy_server(url: str, mapping: PolicyMapping | None) -> Callable[[], Policy]:
    from reference_client.policies.servers.policy_server_client import (
        PolicyServerClient,
    )

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
        try:
            spec.loader.exec_module(module)
        except ImportError as error:
            if "no known parent package" in str(error):
                error.add_note(_cure_of_relative_import(path))
            raise
        return module
    _add_to_path(Path.cwd())
    try:
        return importlib.import_module(place)
    except ModuleNotFoundError as error:
        if error.name is None or not f"{place}.".startswith(f"{error.name}."):
            raise  # a module that the policy's module imports
        raise BadPolicy(f"there is no module {error.name}") from error


def _cure_of_relative_import(path: Path) -> str:
    """How the policy of a file is named that is a module of a package."""
    full, folder = path.resolve(), Path.cwd()
    where = ""
    if not full.parent.is_relative_to(folder) or full.parent == folder:
        folder = full.parent.parent
        where = f" in the folder {folder}"
    module = ".".join(full.relative_to(folder).with_suffix("").parts)
    return (
        "A file that imports from its own package is named as a module of it: "
        f"--policy {module}:NAME{where}."
    )


def _add_to_path(folder: Path) -> None:
    if str(folder) not in sys.path:
        sys.path.insert(0, str(folder))


def policy_factory(made: Any, reference: str) -> Callable[[], Policy]:
    """The maker of the workers' policies, from a class, a maker, or a function.

    reference: its name for messages. Raises BadPolicy, as does the call.
    """
    _require_maker(made, reference)
    if _answers_itself(made):
        return lambda: _FunctionPolicy(made)

    def make() -> Policy:
        policy = made()
        if callable(getattr(policy, "act", None)):
            _require_method(policy, "reset", "instruction", reference)
            _require_method(policy, "act", "observation", reference)
            return policy  # type: ignore[no-any-return]
        if callable(policy):
            return _FunctionPolicy(policy)
        raise BadPolicy(f"{reference} makes a {type(policy).__name__} without act()")

    return make


def _require_maker(made: Any, reference: str) -> None:
    """Raise BadPolicy for a policy in place of what makes one, and for other values."""
    if not inspect.isclass(made) and callable(getattr(made, "act", None)):
        raise BadPolicy(
            f"{reference} is an object of {type(made).__name__}; give its class, or a "
            "function that makes one: each worker has a policy of its own"
        )
    if not callable(made):
        raise BadPolicy(f"{reference} is not callable: {made!r:.60}")
    _require_sync(made, reference)
    given = ("observation",) if _answers_itself(made) else ()
    try:
        inspect.signature(made).bind(*given)
    except ValueError:  # it is not written in Python
        return
    except TypeError as error:
        name = getattr(made, "__name__", "MyPolicy")
        cure = (
            "give its other arguments default values"
            if given
            else "name a function without arguments that makes the policy, such as "
            f"`def make(): return {name}(…)`"
        )
        raise BadPolicy(
            f"{reference} is called as {name}({', '.join(given)}), and that fails: "
            f"{error}; {cure}"
        ) from error


def _answers_itself(made: Any) -> bool:
    """Whether it is the policy, a function of the observation, and makes none."""
    return not inspect.isclass(made) and _arguments(made) > 0


def _require_sync(function: object, name: str) -> None:
    if inspect.iscoroutinefunction(function):
        raise BadPolicy(
            f"{name} is async, and is called without await: make it a plain function, "
            "which may run what is async with asyncio.run(…)"
        )


def _require_method(policy: object, name: str, argument: str, reference: str) -> None:
    """Raise BadPolicy unless the policy has a method that takes this argument."""
    method = getattr(policy, name, None)
    if not callable(method):
        raise BadPolicy(f"{reference} makes a policy without {name}({argument})")
    try:
        inspect.signature(method).bind(None)
    except ValueError:  # it is not written in Python
        return
    except TypeError as error:
        raise BadPolicy(
            f"{reference} makes a policy of which {name} does not take the {argument}: "
            f"{name}({argument}) is called ({error})"
        ) from error
    _require_sync(method, f"{name} of {reference}")


def _answer_function(made: Any, reference: str) -> Any:
    """The function that answers a request; bound, if the policy is an object."""
    if _answers_itself(made):
        return made
    policy = made()
    for name in ("infer", "act", "__call__"):
        if callable(method := getattr(policy, name, None)):
            _require_sync(method, f"{name} of {reference}")
            return method
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
    if isinstance(policy, _ServedPolicy):
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


class _MappedChunks:
    """The chunks of a policy's answers; warns about the first one."""

    def __init__(self, mapping: PolicyMapping) -> None:
        self._mapping = mapping
        self._is_first = True

    def of(self, answer: Any, observation: Observation) -> Chunk:
        """Raises InvalidPolicyAnswer."""
        chunk = self._mapping.chunk(answer, observation)
        if self._is_first:
            self._is_first = False
            for note in self._mapping.notes_on(answer):
                warn(note)
        return chunk


class _MappedPolicy:
    """A policy of this process, behind a mapping of names."""

    def __init__(self, infer: Any, mapping: PolicyMapping) -> None:
        self._infer = infer
        self._mapping = mapping
        self._chunks = _MappedChunks(mapping)
        self._reset = getattr(getattr(infer, "__self__", None), "reset", None)

    def reset(self, instruction: str) -> None:
        if callable(self._reset):
            self._reset(*[instruction][: min(1, _arguments(self._reset))])

    def act(self, observation: Observation) -> Chunk:
        answer = self._infer(self._mapping.request(observation))
        try:
            return self._chunks.of(answer, observation)
        except InvalidPolicyAnswer as error:
            raise ProctorError(POLICY_FAILED, str(error)) from error


class _PolicyServer(Protocol):
    """A connection to a policy server, of one worker."""

    def infer(self, request: Mapping[str, Any]) -> Any:
        """The decoded answer. Raises ProctorError `policy_failed`."""

    def begin_episode(self, message: Mapping[str, Any] | None) -> None:
        """Called before the first `infer` of an episode, with the message of it."""

    def without_numbers(self, answer: Any, why: str) -> ProctorError:
        """The failure for an answer that has none where the mapping expects them."""

    def close(self) -> None:
        """Leave; a request in progress fails."""


class _ServedPolicy:
    """A policy server, behind a mapping of names."""

    def __init__(self, server: _PolicyServer, mapping: PolicyMapping) -> None:
        self._server = server
        self._mapping = mapping
        self._chunks = _MappedChunks(mapping)
        self._is_new = True

    def reset(self, instruction: str) -> None:
        self._is_new = True  # its message is made of the observation

    def act(self, observation: Observation) -> Chunk:
        if self._is_new:
            self._server.begin_episode(self._mapping.reset_message(observation))
            self._is_new = False
        answer = self._server.infer(self._mapping.request(observation))
        try:
            return self._chunks.of(answer, observation)
        except NoNumbers as error:
            raise self._server.without_numbers(answer, str(error)) from error
        except InvalidPolicyAnswer as error:
            raise ProctorError(POLICY_FAILED, str(error)) from error

    def close(self) -> None:
        self._server.close()
