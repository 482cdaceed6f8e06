"""A run as a Gymnasium environment: `reset` takes the next episode, `step` plays it.

    from reference_client import RemoteEnv

    env = RemoteEnv(url=..., token=..., benchmark="tabletop")

Importing this module also registers the id `proctor/Remote-v0` for `gymnasium.make`.
Seeds and scores are the server's: `reset(seed=...)` seeds what this process draws, not
the episode.
"""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Mapping
from typing import Any, SupportsFloat, cast

import gymnasium
import msgspec
from proctor_client import Assumptions, Observe, Player, Run
from proctor_client.transport.copied_text import read_variable
from pydantic_core import to_jsonable_python

from reference_client.api.observation import (
    Observation,
    decode_observation,
    observation_of,
)
from reference_client.api.policy import chunk_of
from reference_client.errors import ProctorError
from reference_client.evaluation.declared_policy import DeclaredPolicy, declare_player
from reference_client.evaluation.parameters import (
    check_episodes,
    parse_strictly,
    submission,
)
from reference_client.evaluation.rounds import POLL_INTERVAL_S
from reference_client.generated.messages import Turn
from reference_client.gymnasium_env import spaces
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.credentials import find_credential
from reference_client.protocol.data_plane import DataPlane
from reference_client.protocol.heartbeat import HeartbeatThread
from reference_client.protocol.worker_session import (
    SESSION_END_CODES,
    Session,
    WorkerSlot,
    is_wanted,
)

ENV_ID = "proctor/Remote-v0"


class RunDone(ProctorError):
    """`reset` was called and the run has no episode left: `code` is `run_done`."""

    def __init__(self, run_id: str) -> None:
        super().__init__(
            "run_done",
            f"Every episode of run {run_id} that is wanted is scored: `score()` has "
            "the result. Make a new environment for another run, or one with "
            "renew=True.",
        )


class RemoteEnv(gymnasium.Env[spaces.SpaceValue, dict[str, Any]]):
    """One worker of a run.

    url, token: of the server; PROCTOR_URL and PROCTOR_TOKEN when absent, or the token
    that a server on this machine made for itself.
    benchmark: for a new run, submitted by the first `reset`; or run_id: of a run.
    options, images, idle_timeout_s, name: of the new run, as of `evaluate`.
    worker_id: must differ between environments of one run.
    takeover, assumes, retry_timeout_s, episodes: as of `evaluate`.
    renew: when the run is done, or the episodes that are wanted, `reset` submits
    another; otherwise it raises RunDone.

    Every response carries a second observation, because the last one of an episode is
    needed: for cameras at full speed, write a policy for `evaluate` instead.
    """

    def __init__(
        self,
        *,
        url: str | None = None,
        token: str | None = None,
        benchmark: str | None = None,
        run_id: str | None = None,
        options: Mapping[str, Any] | None = None,
        images: Mapping[str, Any] | None = None,
        idle_timeout_s: float | None = None,
        name: str | None = None,
        worker_id: str = "env-0",
        takeover: bool = False,
        assumes: Mapping[str, Any] | None = None,
        retry_timeout_s: float | None = None,
        renew: bool = False,
        episodes: int | None = None,
        render_mode: None = None,
    ) -> None:
        """Raises ProctorError, also if the server is unreachable; ValueError."""
        url = url or read_variable("PROCTOR_URL")
        if url is None or (benchmark is None) == (run_id is None):
            raise ValueError("RemoteEnv needs url=…, and benchmark=… or run_id=…")
        self.metadata = {"render_modes": []}
        self.render_mode = render_mode
        self._worker_id = worker_id
        self._takeover = takeover
        self._assumes = parse_strictly(Assumptions, "assumes", assumes)
        self._renew = renew
        check_episodes(episodes)
        self._episodes = episodes
        self._connection_stack = contextlib.ExitStack()
        self._session_stack = contextlib.ExitStack()  # the session and its heartbeat
        self._session: Session | None = None
        self._planes: dict[str, DataPlane] = {}  # by endpoint
        self._run: Run | None = None
        self._observation: Observation | None = None
        self._in_episode = False
        connection = Connection(url, find_credential(url, token), requests=3)
        self._connection = self._connection_stack.enter_context(connection)
        self._retry_policy = connection.retry_policy(
            threading.Event(), lambda _why: None, retry_timeout_s
        )
        self._control_client = ControlClient(connection.control, self._retry_policy)
        service = self._control_client.check_service(1)
        self._service, self._policy = service, DeclaredPolicy("RemoteEnv", name)
        if run_id is not None:
            self._declare(self._control_client.read(run_id))
            self._run = self._control_client.resume_if_needed(run_id)
            benchmark = self._run.benchmark_id
        manifest = self._control_client.benchmark(str(benchmark))
        self.max_steps = manifest.max_steps  # of an episode, before options
        self._submission = submission(
            manifest.benchmark_id,
            self._policy.info,
            images=images,
            options=options,
            idle_timeout_s=idle_timeout_s,
        )
        chosen = self._run.images if self._run else self._submission.images
        self._space = spaces.observation_space(manifest, chosen)
        self.observation_space = cast(Any, self._space)
        self.action_space = cast(Any, spaces.action_space(manifest))
        self._vectors = {name: v.size for name, v in manifest.action_space.items()}

    @property
    def run_id(self) -> str | None:
        """The id of the run; None before the first `reset` of a new one."""
        return None if self._run is None else self._run.run_id

    def _declare(self, run: Run) -> Player | None:
        return declare_player(self._policy, run, self._service, self._control_client)

    def score(self) -> dict[str, Any]:
        """The run's score so far, as schema Score. RuntimeError before the first."""
        if self._run is None:
            raise RuntimeError("there is no run before the first reset()")
        score: dict[str, Any] = to_jsonable_python(
            self._control_client.score(self._run.run_id).to_dict()
        )
        return score

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[spaces.SpaceValue, dict[str, Any]]:
        """The first observation of the next episode.

        An episode in progress is aborted: its attempt counts, it returns to the queue,
        and is often the next again. Raises RunDone, ProctorError.
        """
        super().reset(seed=seed)
        if self._in_episode:
            self._detach("Its environment was reset before the end of the episode.")
        turn = self._next_turn()
        self._in_episode = False  # until the first step, no attempt is lost by a reset
        self._observation = observation_of(turn)
        return spaces.space_value(self._observation, self._space), self._info(turn)

    def step(
        self, action: Mapping[str, Any]
    ) -> tuple[spaces.SpaceValue, SupportsFloat, bool, bool, dict[str, Any]]:
        """Executes one action, exactly once.

        `info["episode_result"]` is the server's result when the episode ends. If the
        attempt is lost (server restarted, simulator failed) the episode is `truncated`
        and `info["lost"]` says why; it is played again later.
        """
        session, before = self._session, self._observation
        if session is None or before is None:
            raise gymnasium.error.ResetNeeded("call reset() before step()")
        if not isinstance(action, Mapping):
            raise self._no_action(action)
        self._in_episode = True
        try:
            turn = session.predict(chunk_of([dict(action)]), observe=Observe.ALL)
        except ProctorError as error:
            if error.code not in SESSION_END_CODES:
                raise
            self._detach()
            return self._lost_step(before, error.detail)
        if turn.fault:
            self._in_episode = False
            self._observation = None
            return self._lost_step(before, turn.fault.detail)
        assert turn.observations
        observation = decode_observation(
            turn.observations[-1],
            before.instruction,
            before.episode_id,
            before.step + turn.executed_steps,
        )
        ended = turn.terminated or turn.truncated
        self._in_episode = not ended
        self._observation = None if ended else observation
        info = self._info(turn) | {
            "episode_id": observation.episode_id,
            "instruction": observation.instruction,
        }
        if turn.episode_result:
            info["episode_result"] = msgspec.to_builtins(turn.episode_result)
        space_value = spaces.space_value(observation, self._space)
        return space_value, sum(turn.rewards), turn.terminated, turn.truncated, info

    def _no_action(self, given: object) -> ProctorError:
        """Gymnasium and the benchmark order vectors differently: no row is accepted."""
        vectors = ", ".join(f"{name} {size}" for name, size in self._vectors.items())
        what = f"is a {type(given).__name__}; step() takes a dict of vectors: {vectors}"
        return ProctorError(
            "invalid_request",
            "The action cannot be sent, and nothing was executed.",
            errors=[("/actions/0/values", what)],
        )

    def close(self) -> None:
        """Detach; the run remains on the server. May be called again."""
        self._detach("Its environment was closed." if self._in_episode else "")
        self._connection_stack.close()

    def _lost_step(
        self, before: Observation, why: str
    ) -> tuple[spaces.SpaceValue, SupportsFloat, bool, bool, dict[str, Any]]:
        return spaces.space_value(before, self._space), 0.0, False, True, {"lost": why}

    def _info(self, turn: Turn) -> dict[str, Any]:
        if not turn.episode:
            return {}
        return {
            "episode_id": turn.episode.episode_id,
            "instruction": turn.episode.instruction,
            "task": turn.episode.task,
        }

    def _next_turn(self) -> Turn:
        """The turn with the first observation of an episode."""
        is_again = False
        while True:
            turn = None if self._session is None else self._session.turn
            if turn and not turn.done and is_wanted(turn, self._episodes):
                return turn
            self._detach()
            if self._run is None:
                self._control_client.check(self._submission.benchmark_id)
                self._run = self._control_client.submit(self._submission)
            if self._has_work(self._run.run_id):
                if is_again:  # what is wanted is in play elsewhere
                    self._retry_policy.pause(POLL_INTERVAL_S)
                self._attach(self._run)
                is_again = self._episodes is not None
            elif self._renew:
                self._run = None
            else:
                raise RunDone(self._run.run_id)

    def _has_work(self, run_id: str) -> bool:
        """Waits as `wait_for_work`; False also when the wanted episodes are scored."""
        client = self._control_client
        if client.has_scored(run_id, self._episodes):
            return False
        return client.wait_for_work(run_id, held=self._takeover)

    def _attach(self, run: Run) -> None:
        if run.endpoint not in self._planes:  # shared by all sessions and runs
            self._planes[run.endpoint] = self._connection.data(run.endpoint)
        plane = self._planes[run.endpoint]
        slot = WorkerSlot.at_service(
            plane,
            run,
            self._worker_id,
            self._service,
            player=self._declare(run),
            episodes=self._episodes,
        )
        session = Session.attach(
            slot, self._retry_policy, takeover=self._takeover, assumes=self._assumes
        )
        self._takeover = False
        self._session = session
        self._session_stack.callback(session.detach)
        lease_s = session.turn.lease.idle_timeout_s
        heartbeat = self._session_stack.enter_context(
            HeartbeatThread(lease_s, session.send_heartbeat)
        )
        # The time between two calls of step() is unlimited.
        self._session_stack.enter_context(heartbeat.keep_alive())

    def _detach(self, reason: str = "") -> None:
        """reason: why an episode is left, for those who look at the run."""
        if self._session is not None and reason:
            self._session.detach(reason)
        self._session = None
        self._observation = None
        self._in_episode = False
        self._session_stack.close()


gymnasium.register(
    ENV_ID,
    entry_point="reference_client.gymnasium_env.remote_env:RemoteEnv",
    nondeterministic=True,  # the server chooses the episode, not the seed
)
