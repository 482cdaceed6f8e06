"""Evaluate a robot policy on any Proctor server.

    from reference_client import evaluate, headline

    score = evaluate(MyPolicy, url="http://127.0.0.1:8460", benchmark="tabletop")
    print(headline(score))

A policy is a class with `reset(instruction)` and `act(observation)`, see `Policy`.
`RemoteEnv` offers a run as a Gymnasium environment instead. The packages, from the
protocol up:

    errors.py, generated/   exceptions; message structures made from the specification
    api/                    what a policy author implements and receives
    protocol/               HTTP connections, retries, sessions, the control plane
    policies/               adapters for existing policies and policy servers
    evaluation/             a run from submission to score, and its workers
    gymnasium_env/          `RemoteEnv`
    view/, command/         the live view and the command `proctor`

A package imports only packages above it in this list.
"""

import importlib
import typing

if typing.TYPE_CHECKING:
    from reference_client.api.observation import Observation
    from reference_client.api.policy import Policy
    from reference_client.errors import ProctorError, RunFailed, RunStopped
    from reference_client.evaluation.evaluate import evaluate, headline
    from reference_client.evaluation.status_board import Progress
    from reference_client.gymnasium_env.remote_env import RemoteEnv
    from reference_client.policies.lerobot_policy import LerobotPolicies

__all__ = [
    "LerobotPolicies",
    "Observation",
    "Policy",
    "ProctorError",
    "Progress",
    "RemoteEnv",
    "RunFailed",
    "RunStopped",
    "evaluate",
    "headline",
]

# Name → its module, imported on first use: the command reports missing dependencies
# itself, and gymnasium is needed for RemoteEnv only.
_MODULES = {
    "LerobotPolicies": "policies.lerobot_policy",
    "Observation": "api.observation",
    "Policy": "api.policy",
    "ProctorError": "errors",
    "Progress": "evaluation.status_board",
    "RemoteEnv": "gymnasium_env.remote_env",
    "RunFailed": "errors",
    "RunStopped": "errors",
    "evaluate": "evaluation.evaluate",
    "headline": "evaluation.evaluate",
}


if not typing.TYPE_CHECKING:  # else every name would have a type

    def __getattr__(name: str) -> typing.Any:
        if name not in _MODULES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        return getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
