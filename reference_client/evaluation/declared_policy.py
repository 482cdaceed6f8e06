"""Who plays: what this client declares of itself, and the run it may play.

The profiles `attribution` and `subsets` add members to requests. A server that does not
announce them refuses these members, so nothing is sent there.
"""

from __future__ import annotations

import importlib.metadata
import sys
from dataclasses import dataclass

from proctor_client import Player, PolicyInfo, Run, RunPolicy, Service, SubmitRun

from reference_client.errors import ProctorError
from reference_client.protocol.control_client import ControlClient

_PACKAGE = "proctor-eval"


@dataclass(frozen=True, slots=True)
class DeclaredPolicy:
    """The policy of an evaluation.

    program: the name of its code: a class, a function, a folder. name, version: what a
    person calls it, where one has said that.
    """

    program: str
    name: str | None = None
    version: str | None = None

    @property
    def info(self) -> PolicyInfo:
        """The policy as a new run declares it."""
        for text in (self.name, self.program, self.version):
            if text is not None and any("\ud800" <= char <= "\udfff" for char in text):
                raise ValueError(
                    f"{text!r:.60} is not text in the encoding of this shell "
                    f"({sys.getfilesystemencoding()}); set LC_ALL=C.UTF-8"
                )
        return PolicyInfo(name=self.name or self.program, version=self.version)

    @property
    def client(self) -> str:
        """`proctor-eval/0.1.0 (MyPolicy)`."""
        return f"{_client_version()} ({self.program})"[:200]


def declare_player(
    policy: DeclaredPolicy,
    run: Run,
    service: Service,
    control_client: ControlClient,
) -> Player | None:
    """The player that the workers declare; None where the server does not read it.

    A policy without a name of its own has that of the run, unless another program has
    scored episodes of it: then it has the program's. Raises `policy_mismatch` where
    attaching would be refused, before anything has changed.
    """
    if "attribution" not in service.profiles:
        return None
    name = policy.name
    if name is None:
        others = _programs(run, control_client) - {policy.program}
        name = policy.program if others else run.policy.name
    run_version = run.policy.version if name == run.policy.name else None
    player = Player(
        name=name, version=policy.version or run_version, client=policy.client
    )
    _check_player(run, player)
    return player


def _programs(run: Run, control_client: ControlClient) -> set[str]:
    """The programs that have scored episodes of the run, as far as they said."""
    if run.progress.episodes_scored == 0:
        return set()
    results = [episode.result for episode in control_client.episodes(run.run_id)]
    clients = [r.player.client or "" for r in results if r and r.player]
    return {
        client.partition("(")[2].removesuffix(")")
        for client in clients
        if client.startswith(_PACKAGE)
    }


def _client_version() -> str:
    try:
        return f"{_PACKAGE}/{importlib.metadata.version(_PACKAGE)}"
    except importlib.metadata.PackageNotFoundError:
        return _PACKAGE


def _check_player(run: Run, player: Player) -> None:
    if run.any_policy:
        return
    policy = run.policy
    versions = {player.version, policy.version} - {None}
    if player.name == policy.name and len(versions) < 2:
        return
    raise ProctorError(
        "policy_mismatch",
        f"Run {run.run_id} is of policy {_label(policy)}, not of {_label(player)}: a "
        "score is of one policy. If it is the same, say so with "
        f"`name={policy.name!r}`"
        + (f" and `version={policy.version!r}`" if policy.version else "")
        + "; a run that is submitted with `any_policy=True` takes several.",
    )


def check_offered(submission: SubmitRun, service: Service) -> None:
    """Refuses members that the server does not know."""
    if submission.any_policy and "attribution" not in service.profiles:
        raise ProctorError(
            "invalid_request",
            "any_policy: this server does not record who plays an episode "
            "(it does not announce the profile `attribution`)",
        )
    if submission.select is not None and "subsets" not in service.profiles:
        raise ProctorError(
            "invalid_request",
            "tasks, splits: this server plays whole benchmarks alone (it does not "
            "announce the profile `subsets`); episodes=N plays the first N episodes",
        )


def _label(policy: RunPolicy | Player) -> str:
    return policy.name if not policy.version else f"{policy.name} {policy.version}"
