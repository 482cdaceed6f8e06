"""Evaluate a robot policy on any Proctor server.

    from reference_client import evaluate

    score = evaluate(MyPolicy, url="http://127.0.0.1:8460", benchmark="tabletop")
    print(score.score)

A policy is a class with `reset(instruction)` and `act(observation)`, see `Policy`. The
command `proctor` is in `command`, policies that exist already are in `policies`, and a
Gymnasium environment is in `remote_env`. All are built of `session` and `runs`.
"""

import importlib
import typing

if typing.TYPE_CHECKING:
    from reference_client.api.errors import ProctorError, RunFailed, RunStopped
    from reference_client.api.observation import Observation
    from reference_client.api.policy import Policy
    from reference_client.evaluation.evaluate import evaluate
    from reference_client.evaluation.status_board import Progress

__all__ = [
    "Observation",
    "Policy",
    "ProctorError",
    "Progress",
    "RunFailed",
    "RunStopped",
    "evaluate",
]

# Name → its module, imported when it is asked for: the command has to be able to say
# what is not installed here.
_MODULES = {
    "Observation": "api.observation",
    "Policy": "api.policy",
    "ProctorError": "api.errors",
    "Progress": "evaluation.status_board",
    "RunFailed": "api.errors",
    "RunStopped": "api.errors",
    "evaluate": "evaluation.evaluate",
}


def __getattr__(name: str) -> typing.Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
