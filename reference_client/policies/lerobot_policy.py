"""Policies of LeRobot, loaded from the folder in which it saved them.

As in LeRobot's own evaluation, an observation goes through the policy's preprocessor,
`select_action` and the postprocessor: they rename, normalize and tokenize by what was
saved with the weights. LeRobot and torch are imported when a policy is loaded, not
before.
"""

from __future__ import annotations

import contextlib
import copy
import logging
import threading
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from proctor_client import Benchmark

from reference_client.api.observation import Observation
from reference_client.api.policy import Chunk
from reference_client.errors import POLICY_FAILED, BadPolicy, ProctorError
from reference_client.policies.lerobot_config import LerobotConfig
from reference_client.policies.mapping import InvalidPolicyAnswer, PolicyMapping


class LerobotPolicies:
    """Makes a policy for each worker from `folder`; all share its weights.

    overrides: a mapping, whose entries come before those of the policy's config.json.
    say: called with a line about the mapping that was chosen. Raises BadPolicy.
    """

    def __init__(
        self, folder: str | Path, overrides: PolicyMapping | None = None
    ) -> None:
        self.config = LerobotConfig.read(folder)
        self.__name__ = Path(folder).resolve().name  # of the policy, in a run
        self.say: Callable[[str], None] = logging.getLogger("proctor").info
        self._overrides = overrides
        self._benchmark: Benchmark | None = None
        self._loaded: tuple[Any, Any, Any] | None = None
        self._lock = threading.Lock()

    def check(self, benchmark: Benchmark) -> None:
        """Set the benchmark. Raises BadMapping if the policy does not fit it."""
        self.say(self.config.describe(self.mapping(benchmark)))
        self._benchmark = benchmark

    @property
    def assumes(self) -> Mapping[str, Any] | None:
        """The conventions that the mapping assumes."""
        return self._overrides.assumes if self._overrides else None

    def mapping(self, benchmark: Benchmark) -> PolicyMapping:
        return self.config.mapping(benchmark, self._overrides)

    def __call__(self) -> LerobotPolicy:
        with self._lock:
            if self._loaded is None:
                self._loaded = _load(self.config, self._execute)
        model, preprocess, postprocess = self._loaded
        shared = {id(t): t for t in (*model.parameters(), *model.buffers())}
        policy = LerobotPolicy(
            self,
            copy.deepcopy(model, shared),
            copy.deepcopy(preprocess),
            copy.deepcopy(postprocess),
            self._execute or self.config.actions_per_look,
        )
        if self._benchmark is not None:
            policy.bind(self._benchmark)
        return policy

    @property
    def _execute(self) -> int | None:
        """n_action_steps instead of the configuration's; where each is read, none."""
        execute = self._overrides.execute if self._overrides else None
        return None if self.config.actions_per_look == 1 else execute


class LerobotPolicy:
    """The policy of one worker, with its own queue of actions."""

    def __init__(
        self,
        policies: LerobotPolicies,
        model: Any,
        preprocess: Any,
        postprocess: Any,
        actions_per_look: int,
    ) -> None:
        self._policies = policies
        self._model = model
        self._preprocess = preprocess
        self._postprocess = postprocess
        self._actions_per_look = actions_per_look
        self._left = 0  # actions before the policy reads an observation again
        self._mapping: PolicyMapping | None = None
        self._max_chunk = 1

    def bind(self, benchmark: Benchmark) -> None:
        """Set the benchmark. Raises BadMapping."""
        self._mapping = self._policies.mapping(benchmark)
        self._max_chunk = benchmark.max_chunk

    def reset(self, instruction: str) -> None:
        self._left = 0
        self._model.reset()
        self._preprocess.reset()
        self._postprocess.reset()

    def act(self, observation: Observation) -> Chunk:
        """The actions up to the next observation that the policy reads."""
        assert self._mapping is not None, "bind sets the benchmark"
        if self._left == 0:
            self._left = self._actions_per_look
        count = min(self._left, self._max_chunk)
        self._left -= count
        rows = self._select_actions(self._mapping.request(observation), count)
        try:
            return self._mapping.chunk(rows, observation)[:count]
        except InvalidPolicyAnswer as error:
            raise ProctorError(POLICY_FAILED, str(error)) from error

    def _select_actions(self, request: dict[str, Any], count: int) -> Any:
        import torch

        config = self._model.config
        amp = (
            torch.autocast(device_type=torch.device(config.device).type)
            if config.use_amp
            else contextlib.nullcontext()
        )
        with torch.inference_mode(), amp:
            batch = self._preprocess(_tensors(request))
            actions = [
                self._postprocess(self._model.select_action(dict(batch)))
                for _ in range(count)
            ]
        return np.stack([action[0].float().cpu().numpy() for action in actions])


def _tensors(request: dict[str, Any]) -> dict[str, Any]:
    import torch

    return {
        key: value
        if key == "task"
        else torch.from_numpy(np.array(value, np.float32, ndmin=2))
        for key, value in request.items()
    }


def _load(config: LerobotConfig, execute: int | None) -> tuple[Any, Any, Any]:
    """The model, its preprocessor and its postprocessor."""
    try:
        from lerobot.configs.policies import PreTrainedConfig
        from lerobot.policies.factory import get_policy_class, make_pre_post_processors
    except ImportError as error:
        raise BadPolicy(
            f"lerobot: needs LeRobot in this environment; `make lerobot` ({error})"
        ) from error
    folder = str(config.folder)
    settings = PreTrainedConfig.from_pretrained(folder)
    settings.pretrained_path = config.folder
    if execute is not None:
        if execute > (config.actions_predicted or execute):
            raise BadPolicy(
                f"execute = {execute}; the policy predicts {config.actions_predicted}"
            )
        settings.n_action_steps = execute
    if hasattr(settings, "pretrained_backbone_weights"):
        settings.pretrained_backbone_weights = None  # replaced by the saved weights
    model = get_policy_class(settings.type).from_pretrained(folder, config=settings)
    model.eval()
    device = {"device_processor": {"device": str(settings.device)}}
    preprocess, postprocess = make_pre_post_processors(
        settings, folder, preprocessor_overrides=device
    )
    return model, preprocess, postprocess
