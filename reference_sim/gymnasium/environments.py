"""Makes Gymnasium environments and reads their spaces; alone imports Gymnasium.

Environments are made without Gymnasium's time limit and checker: the protocol counts
the steps, and `check` looks for faults once instead of at every step.
"""

from __future__ import annotations

import importlib
import importlib.util
import inspect
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any, TypeAlias

import gymnasium
import numpy as np
from gymnasium import spaces

from reference_record.command_line.installation import how_to_install
from reference_record.command_line.spelling import did_you_mean
from reference_sim.gymnasium.entries import Entry, Structure, UnsupportedSpace
from reference_sim.gymnasium.own_sources import OWN_SOURCES, OwnLoader

Environment: TypeAlias = "gymnasium.Env[Any, Any]"

RENDER_MODE = "rgb_array"
_STEP_LIMITS = ("max_steps", "max_path_length")  # what environments call theirs
GYMNASIUM_VERSION = gymnasium.__version__


# The lines that a class needs, to be copied.
_NEEDED = """
    import gymnasium

    class {name}(gymnasium.Env):
        action_space = gymnasium.spaces.Box(-1, 1, (2,))
        observation_space = gymnasium.spaces.Box(-10, 10, (4,))

        def reset(self, *, seed=None, options=None):
            super().reset(seed=seed)  # then draw from self.np_random
            return observation, {{}}

        def step(self, action):
            return observation, reward, terminated, truncated, {{"success": done}}"""


class EnvironmentUnavailable(Exception):
    """The environment cannot be made; the text says why, in one line."""


class NotAnEnvironment(EnvironmentUnavailable):
    """An object with another interface; the text has the lines that it needs."""

    def __init__(self, made: object, why: str) -> None:
        name = type(made).__name__
        lines = _NEEDED.format(name=name)
        super().__init__(
            f"{name} is not a Gymnasium environment: {why}; write\n{lines}"
        )


# Making


def make(
    made_of: Mapping[str, Any], kwargs: Mapping[str, Any], *, draws: bool
) -> Environment:
    """An environment, ready to be reset. Raises EnvironmentUnavailable and others.

    made_of: `environment` (a registered id) or `made_by` (see find); `modules`, which
    are imported first; `folder`, where modules and files of the user's own are found.
    draws: whether `render` returns images.
    """
    folder = _import_modules(made_of)
    chosen = dict(kwargs)
    if draws:
        chosen["render_mode"] = RENDER_MODE
    if (environment_id := made_of["environment"]) is not None:
        _require_registered(environment_id)
        return gymnasium.make(
            environment_id, max_episode_steps=-1, disable_env_checker=True, **chosen
        )
    maker = find(made_of["made_by"], folder)
    if draws and not _takes(maker, "render_mode"):
        chosen.pop("render_mode")
    made: Environment = maker(**chosen)
    _require_interface(made)
    return made


def _require_interface(made: Environment) -> None:
    """Raises NotAnEnvironment. `close`, `render` and `metadata` may be absent."""
    names = ("action_space", "observation_space", "reset", "step")
    lacking = [name for name in names if not hasattr(made, name)]
    if lacking:
        raise NotAnEnvironment(made, f"it has no {', '.join(lacking)}")
    for keyword in ("seed", "options"):
        if not _takes(made.reset, keyword):
            raise NotAnEnvironment(made, f"its reset takes no {keyword}")


def parts_of(made: Environment, method: str, returned: Any) -> tuple[Any, ...]:
    """The parts of a returned value. Raises NotAnEnvironment if they are others."""
    parts = {
        "reset": "(observation, info)",
        "step": "(observation, reward, terminated, truncated, info)",
    }[method]
    count = parts.count(",") + 1
    if not isinstance(returned, tuple) or len(returned) != count:
        kind = type(returned).__name__
        is_tuple = isinstance(returned, tuple)
        what = f"{len(returned)} values" if is_tuple else f"a {kind}"
        raise NotAnEnvironment(made, f"its {method} returns {what}, not {parts}")
    if not isinstance(returned[-1], Mapping):
        kind = type(returned[-1]).__name__
        raise NotAnEnvironment(made, f"the info of its {method} is a {kind}, no dict")
    return returned


def _import_modules(made_of: Mapping[str, Any]) -> str:
    """Imports the modules that register environments; returns the folder."""
    folder = str(made_of["folder"])
    for module in made_of["modules"]:
        _import(module, folder)
    return folder


def _require_registered(environment_id: str) -> None:
    try:
        gymnasium.spec(environment_id)
    except gymnasium.error.Error as error:
        raise EnvironmentUnavailable(
            f"{_first_line(error)} (a module that registers it is named in `modules`)"
        ) from error


def find(reference: str, folder: str) -> Callable[..., Any]:
    """The object of `FILE.py:NAME` or `MODULE:NAME`. Raises EnvironmentUnavailable."""
    place, _, name = reference.rpartition(":")
    if place.endswith(".py"):
        module = _load(Path(folder, place))
    else:
        module = _import(place, folder)
    made = getattr(module, name, None)
    if not callable(made):
        offered = _defined_in(module)
        advice = did_you_mean(name, offered) or f"; it has {', '.join(offered)}"
        has = f"{place} has no class or function {name}"
        raise EnvironmentUnavailable(f"{has}{advice if offered else ''}")
    return made  # type: ignore[no-any-return]


def _defined_in(module: ModuleType) -> list[str]:
    values = vars(module).items()
    return [n for n, v in values if getattr(v, "__module__", None) == module.__name__]


def _import(module: str, folder: str) -> ModuleType:
    OWN_SOURCES.add_folder(Path(folder))
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise EnvironmentUnavailable(
            f"cannot import {module}: {_why_missing(error, folder)}"
        ) from error


def _load(file: Path) -> ModuleType:
    """The module of a file; what stands beside the file can be imported by it."""
    name = f"benchmark_file_{file.stem}"
    if name in sys.modules and sys.modules[name].__file__ == str(file):
        return sys.modules[name]
    if not file.is_file():
        raise EnvironmentUnavailable(f"there is no file {file}")
    OWN_SOURCES.add_folder(file.parent)
    loader = OwnLoader(name, str(file))
    spec = importlib.util.spec_from_file_location(name, file, loader=loader)
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        loader.exec_module(module)
    except BaseException as error:
        del sys.modules[name]  # it is incomplete
        if isinstance(error, ImportError):
            why = _why_missing(error, str(file.parent))
            raise EnvironmentUnavailable(f"cannot import {file.name}: {why}") from error
        raise
    return module


def _why_missing(error: ImportError, folder: str) -> str:
    """The reason, and what to do if a module is neither installed nor in the folder."""
    why = _first_line(error)
    if "relative import" in why:
        return f"{why}; write `import NAME` for NAME.py beside it"
    if not isinstance(error, ModuleNotFoundError) or error.name is None:
        return why
    return (
        f"{why}; put {error.name.partition('.')[0]}.py into {folder}, or install its "
        f"package: {how_to_install('…')}"
    )


def _takes(maker: Callable[..., Any], keyword: str) -> bool:
    try:
        parameters = inspect.signature(maker).parameters.values()
    except (TypeError, ValueError):  # written in C
        return False
    return any(p.name == keyword or p.kind is p.VAR_KEYWORD for p in parameters)


def _first_line(error: BaseException) -> str:
    return (str(error).strip().splitlines() or [type(error).__name__])[0]


# --- declarations of an environment ---


def can_draw(made_of: Mapping[str, Any]) -> bool:
    """Whether it declares `render`; known before it is made. Raises as `make`."""
    folder = _import_modules(made_of)
    if (environment_id := made_of["environment"]) is None:
        maker: Any = find(made_of["made_by"], folder)
    else:
        _require_registered(environment_id)
        maker = gymnasium.spec(environment_id).entry_point
        if isinstance(maker, str):
            maker = gymnasium.envs.registration.load_env_creator(maker)
    metadata = getattr(maker, "metadata", None)
    if not isinstance(metadata, Mapping) or metadata is gymnasium.Env.metadata:
        return _takes(maker, "render_mode")
    return RENDER_MODE in (metadata.get("render_modes") or ())


def facts(environment: Environment, environment_id: str | None) -> dict[str, Any]:
    """Declared step limit, reward threshold and control rate; None if undeclared."""
    registered = gymnasium.spec(environment_id) if environment_id else None
    metadata = getattr(environment, "metadata", None) or {}
    unwrapped = getattr(environment, "unwrapped", environment)
    rate = metadata.get("render_fps")
    if not rate and (dt_s := getattr(unwrapped, "dt", None)):
        rate = 1 / dt_s
    declared = (getattr(unwrapped, name, None) for name in _STEP_LIMITS)
    own_limit = next((n for n in declared if isinstance(n, int) and n > 0), None)
    return {
        "max_steps": (registered and registered.max_episode_steps) or own_limit,
        "reward_threshold": registered.reward_threshold if registered else None,
        "control_rate_hz": float(rate) if rate else None,
        "modules": [cls.__module__ for cls in type(unwrapped).__mro__],
    }


def first_line_of_docstring(maker: object) -> str:
    """Empty when there is none."""
    lines = (maker.__doc__ or "").strip().splitlines() or [""]
    return lines[0].strip()


# Spaces


def read_space(space: Any, root: str) -> tuple[list[Entry], Structure]:
    """The leaves of a space, and how they are nested. Raises UnsupportedSpace.

    root: the name of a space that is a leaf itself.
    """
    entries: list[Entry] = []
    structure = _read(space, (), root, entries)
    names = [entry.name for entry in entries]
    if twice := {name for name in names if names.count(name) > 1}:
        raise UnsupportedSpace(f"two of its entries are called {twice.pop()!r}")
    return entries, structure


def _read(
    space: Any, path: tuple[str, ...], root: str, entries: list[Entry]
) -> Structure:
    if isinstance(space, spaces.Dict):
        return {
            key: _read(part, (*path, str(key)), root, entries)
            for key, part in space.spaces.items()
        }
    if isinstance(space, spaces.Tuple):
        return tuple(
            _read(part, (*path, str(index)), root, entries)
            for index, part in enumerate(space.spaces)
        )
    name = ".".join(path) or root
    entries.append(_leaf(space, name))
    return name


def _leaf(space: Any, name: str) -> Entry:
    text = _text(space)
    match space:
        case spaces.Box():
            low, high = space.low, space.high
            return _entry(name, text, space.dtype, low, high, whole=False)
        case spaces.Discrete():
            last = space.start + space.n - 1
            return _entry(name, text, space.dtype, space.start, last, whole=True)
        case spaces.MultiDiscrete():
            last = space.start + space.nvec - 1
            return _entry(name, text, space.dtype, space.start, last, whole=True)
        case spaces.MultiBinary():
            low = np.zeros(space.shape)
            return _entry(name, text, space.dtype, low, low + 1, whole=True)
    kind = type(space)
    if not isinstance(space, spaces.Space):
        named = f"{kind.__module__}.{kind.__qualname__}"
        raise UnsupportedSpace(f"{name!r} is a {named}, no space of gymnasium.spaces")
    raise UnsupportedSpace(f"{name!r} is a {kind.__name__}, which has no vector")


def _entry(
    name: str, text: str, dtype: Any, low: Any, high: Any, *, whole: bool
) -> Entry:
    low, high = np.asarray(low, np.float64), np.asarray(high, np.float64)
    return Entry(name, text, low.shape, np.dtype(dtype), low, high, whole)


def _text(space: Any) -> str:
    """A short text of a space: the bounds of a Box can be a page."""
    if isinstance(space, spaces.Box):
        return f"Box {space.shape} of {space.dtype}"
    return str(space)
