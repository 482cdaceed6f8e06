"""What needs LeRobot and torch: `make lerobot-check`, in .venv-lerobot.

Small policies with random weights and statistics that are far from 0 and 1 are saved as
LeRobot saves them. The same dynamics are played by LeRobot's own evaluation and through
`lerobot:FOLDER`: the same observations must give the same actions. Not part of
`make test`, whose environment has no torch.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import numpy.typing as npt
import pytest
import tokenizers
import torch
import transformers
from lerobot.configs.types import FeatureType, PolicyFeature
from lerobot.policies.act.configuration_act import ACTConfig
from lerobot.policies.diffusion.configuration_diffusion import DiffusionConfig
from lerobot.policies.factory import get_policy_class, make_pre_post_processors
from lerobot.policies.smolvla.configuration_smolvla import SmolVLAConfig
from lerobot.processor import PolicyProcessorPipeline
from lerobot.scripts.lerobot_eval import rollout
from proctor_client import Benchmark

from reference_client import LerobotPolicies, Observation, evaluate
from reference_client.policies import BadPolicy, PolicyMapping
from reference_client.policies.policy_http_app import PolicyApp
from tests.support.client.command import Proctor, options
from tests.support.client.policy_apps import run_app
from tests.support.client.sized_benchmark import benchmark_of
from tests.support.servers import TOKENS, ReferenceServer

Array = npt.NDArray[Any]
STEPS = 13
PIXELS = 32
INPUTS = {
    "observation.state": PolicyFeature(FeatureType.STATE, (8,)),
    "observation.images.front": PolicyFeature(FeatureType.VISUAL, (3, PIXELS, PIXELS)),
}
OUTPUTS = {"action": PolicyFeature(FeatureType.ACTION, (8,))}
SMALL = {"input_features": INPUTS, "output_features": OUTPUTS, "device": "cpu"}
ACT = SMALL | {
    "chunk_size": 6,
    "n_action_steps": 5,
    "dim_model": 32,
    "n_heads": 2,
    "dim_feedforward": 32,
    "n_encoder_layers": 1,
    "n_vae_encoder_layers": 1,
    "latent_dim": 8,
    "pretrained_backbone_weights": None,
}
DIFFUSION = SMALL | {
    "n_obs_steps": 2,
    "horizon": 8,
    "n_action_steps": 4,
    "down_dims": (16, 32),
    "n_groups": 4,
    "diffusion_step_embed_dim": 16,
    "num_train_timesteps": 5,
    "crop_shape": (28, 28),
    "spatial_softmax_num_keypoints": 4,
}
SPECIAL = {
    "fake_image_token": "<fake_token_around_image>",
    "image_token": "<image>",
    "global_image_token": "<global-img>",
    "end_of_utterance_token": "<end_of_utterance>",
}
SMOLVLA = SMALL | {
    "chunk_size": 6,
    "n_action_steps": 4,
    "num_steps": 3,
    "num_vlm_layers": 2,
    "resize_imgs_with_padding": (PIXELS, PIXELS),
}


def save_backbone(folder: Path) -> str:
    """A vision-language model of SmolVLA's kind, of a few thousand weights."""
    words = ["<unk>", "<pad>", *SPECIAL.values(), *"Lift the cube. \n"]
    vocabulary = {word: n for n, word in enumerate(dict.fromkeys(words))}
    model = tokenizers.models.WordLevel(vocabulary, unk_token="<unk>")
    raw = tokenizers.Tokenizer(model)
    raw.pre_tokenizer = tokenizers.pre_tokenizers.Split("", "isolated")
    tokenizer = transformers.PreTrainedTokenizerFast(
        tokenizer_object=raw,
        unk_token="<unk>",
        pad_token="<pad>",
        extra_special_tokens=SPECIAL,
    )
    transformers.SmolVLMProcessor(
        transformers.SmolVLMImageProcessor(),
        tokenizer,
        transformers.SmolVLMVideoProcessor(),
    ).save_pretrained(folder)
    text = {
        "model_type": "llama",
        "hidden_size": 32,
        "intermediate_size": 64,
        "num_hidden_layers": 2,
        "num_attention_heads": 4,
        "num_key_value_heads": 2,
        "head_dim": 8,
        "vocab_size": 64,
    }
    vision = {
        "hidden_size": 16,
        "intermediate_size": 32,
        "num_hidden_layers": 1,
        "num_attention_heads": 2,
        "image_size": PIXELS,
        "patch_size": 8,
    }
    transformers.SmolVLMConfig(
        text_config=text, vision_config=vision, image_token_id=3, pad_token_id=1
    ).save_pretrained(folder)
    return str(folder)


MAKERS: dict[str, Callable[[Path], Any]] = {
    "act": lambda _: ACTConfig(**ACT),
    "act_ensemble": lambda _: ACTConfig(
        **ACT | {"n_action_steps": 1, "temporal_ensemble_coeff": 0.01}
    ),
    "diffusion": lambda _: DiffusionConfig(**DIFFUSION),
    "smolvla": lambda folder: SmolVLAConfig(
        **SMOLVLA, vlm_model_name=save_backbone(folder)
    ),
}


def statistics() -> dict[str, dict[str, torch.Tensor]]:
    """The statistics of a data set whose numbers are far from normally distributed."""
    ramp = torch.arange(8, dtype=torch.float32)
    colour = torch.tensor([0.2, 0.5, 0.7]).reshape(3, 1, 1)
    return {
        "observation.state": _spread(ramp - 3, 0.2 + ramp / 4),
        "observation.images.front": _spread(colour, colour / 3),
        "action": _spread(0.05 * ramp + 0.06, 0.01 + ramp / 50),
    }


def _spread(mean: torch.Tensor, std: torch.Tensor) -> dict[str, torch.Tensor]:
    low, high = mean - 2 * std, mean + 2 * std
    return {"mean": mean, "std": std, "min": low, "max": high}


def save_policy(folder: Path, settings: Any, stats: Any = None) -> Path:
    """As LeRobot's training saves it: weights, configuration, processors."""
    torch.manual_seed(7)
    model = get_policy_class(settings.type)(settings)
    model.save_pretrained(folder)
    for one in make_pre_post_processors(settings, dataset_stats=stats or statistics()):
        one.save_pretrained(folder)
    return folder


def next_state(state: Array, action: Array) -> Array:
    return (0.9 * state + action + np.sin(state)).astype(np.float32)


def picture_of(state: Array) -> Array:
    grid = np.arange(PIXELS * PIXELS * 3).reshape(PIXELS, PIXELS, 3)
    return ((grid * 7 + int(abs(state).sum() * 100)) % 256).astype(np.uint8)


class Dynamics(gymnasium.Env[Any, Any]):
    """A robot whose next state follows from the action, as LeRobot's environments."""

    observation_space = gymnasium.spaces.Dict(
        {
            "agent_pos": gymnasium.spaces.Box(-1e3, 1e3, (8,), np.float32),
            "pixels": gymnasium.spaces.Dict(
                {"front": gymnasium.spaces.Box(0, 255, (PIXELS, PIXELS, 3), np.uint8)}
            ),
        }
    )
    action_space = gymnasium.spaces.Box(-1e3, 1e3, (8,), np.float32)
    task_description = "Lift the cube."
    task = "lift"
    _max_episode_steps = STEPS

    def reset(self, **_: Any) -> Any:
        self._state = np.linspace(-1, 1, 8, dtype=np.float32)
        return self._observe(), {}

    def step(self, action: Any) -> Any:
        self._state = next_state(self._state, action)
        return self._observe(), 0.0, False, False, {"is_success": False}

    def _observe(self) -> dict[str, Any]:
        pixels = {"front": picture_of(self._state)}
        return {"agent_pos": self._state, "pixels": pixels}


def actions_of_lerobot(folder: Path, settings: Any) -> Array:
    """(steps, numbers) by the rollout of `lerobot-eval`."""
    torch.manual_seed(3)
    model = get_policy_class(settings.type).from_pretrained(folder)
    before, after = make_pre_post_processors(
        model.config, str(folder), preprocessor_overrides={}
    )
    nothing = PolicyProcessorPipeline(steps=[])
    torch.manual_seed(5)
    with torch.no_grad():
        played = rollout(
            gymnasium.vector.SyncVectorEnv([Dynamics]),
            model,
            nothing,
            nothing,
            before,
            after,
        )
    return np.asarray(played["action"][0])


def dynamics(max_chunk: int = 64) -> Benchmark:
    """A benchmark with the sizes of the dynamics."""
    sizes = {"joint_position": 7, "gripper": 1}
    return benchmark_of(sizes, {"front": 3}, sizes, max_chunk=max_chunk)


def actions_of_ours(policies: LerobotPolicies, benchmark: Benchmark) -> Array:
    policies.check(benchmark)
    policy = policies()
    torch.manual_seed(5)
    policy.reset(Dynamics.task_description)
    state = np.linspace(-1, 1, 8, dtype=np.float32)
    rows: list[Array] = []
    while len(rows) < STEPS:
        observation = Observation(
            state={
                "joint_position": state[:7].astype(np.float64),
                "gripper": state[7:].astype(np.float64),
            },
            images={"front": picture_of(state)},
            tensors={},
            instruction=Dynamics.task_description,
            episode_id="e0000",
            step=len(rows),
        )
        for action in policy.act(observation):
            row = np.concatenate([action["joint_position"], action["gripper"]])
            rows.append(row)
            state = next_state(state, row.astype(np.float32))
    return np.stack(rows[:STEPS])


@pytest.mark.parametrize("kind", MAKERS)
@pytest.mark.parametrize("max_chunk", [64, 2])
def test_that_actions_are_those_of_lerobots_own_evaluation(
    tmp_path: Path, kind: str, max_chunk: int
) -> None:
    settings = MAKERS[kind](tmp_path / "backbone")
    folder = save_policy(tmp_path / "policy", settings)
    theirs = actions_of_lerobot(folder, settings)
    ours = actions_of_ours(LerobotPolicies(folder), dynamics(max_chunk))
    spread = np.abs(theirs - theirs[0]).max()
    assert spread > 0.01, "the actions depend on the observations"
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-6)


# Through a server


@pytest.fixture(scope="module")
def calibrated(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A policy whose statistics alone make its actions: score 0.75, success, end."""
    inputs = {
        "observation.state": PolicyFeature(FeatureType.STATE, (11,)),
        "observation.environment_state": PolicyFeature(FeatureType.ENV, (8,)),
    }
    outputs = {"action": PolicyFeature(FeatureType.ACTION, (15,))}
    members = {"input_features": inputs, "output_features": outputs}
    mean = torch.tensor([0.75, 1.0, 1.0] + [0.0] * 12)
    stats = {
        "observation.state": _spread(torch.ones(11), torch.ones(11)),
        "observation.environment_state": _spread(torch.ones(8), torch.ones(8)),
        "action": _spread(mean, torch.zeros(15)),
    }
    folder = tmp_path_factory.mktemp("policies") / "calibrated"
    return save_policy(folder, ACTConfig(**ACT | members), stats)


@pytest.mark.parametrize("workers", [1, 3])
def test_the_command_evaluates_it(
    server: ReferenceServer,
    calibrated: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    workers: int,
) -> None:
    """Expect the score of its statistics: the postprocessor has made the actions."""
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    proctor = Proctor(server.url, capsys)
    policy = ["--policy", f"lerobot:{calibrated}", "--workers", str(workers)]
    score = proctor.json("run", *policy, *options(*["score"] * 4))
    assert (proctor.code, score["score"]) == (0, pytest.approx(0.75, abs=1e-6))
    assert "environment_state = state.vector; action: score = 0:1," in proctor.err


def test_python_evaluates_it(server: ReferenceServer, calibrated: Path) -> None:
    score = evaluate(
        LerobotPolicies(calibrated),
        url=server.url,
        token=TOKENS["alice"],
        benchmark="calibration",
        options={"tasks": ["score"]},
    )
    assert score.score == pytest.approx(0.75, abs=1e-6)


def test_a_served_one_is_evaluated(
    server: ReferenceServer,
    calibrated: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """`proctor serve-policy` on one machine, the command on another. Two workers."""
    monkeypatch.setenv("PROCTOR_TOKEN", TOKENS["alice"])
    monkeypatch.delenv("PROCTOR_POLICY_KEY", raising=False)
    proctor = Proctor(server.url, capsys)
    with run_app(PolicyApp(LerobotPolicies(calibrated), "calibrated").app) as url:
        run = ["run", "--policy-url", url, "--workers", "2"]
        score = proctor.json(*run, *options(*["score"] * 4))
    assert (proctor.code, score["score"]) == (0, pytest.approx(0.75, abs=1e-6))


def test_workers_share_the_weights_and_nothing_else(calibrated: Path) -> None:
    policies = LerobotPolicies(calibrated)
    one, other = policies(), policies()
    ours, theirs = one._model, other._model
    for a, b in zip(ours.parameters(), theirs.parameters(), strict=True):
        assert a is b
    assert ours is not theirs
    assert ours._action_queue is not theirs._action_queue


def test_execute_is_n_action_steps(tmp_path: Path) -> None:
    """As `lerobot-eval --policy.n_action_steps`. Expect the actions of that policy."""
    settings = ACTConfig(**ACT | {"n_action_steps": 3})
    folder = save_policy(tmp_path / "three", settings)
    theirs = actions_of_lerobot(folder, settings)
    folder = save_policy(tmp_path / "five", ACTConfig(**ACT))
    three = PolicyMapping.of({"action": {"execute": 3}}, is_partial=True)
    ours = actions_of_ours(LerobotPolicies(folder, three), dynamics())
    np.testing.assert_allclose(ours, theirs, rtol=0, atol=1e-6)
    more = PolicyMapping.of({"action": {"execute": 7}}, is_partial=True)
    with pytest.raises(BadPolicy, match="execute = 7; the policy predicts 6"):
        LerobotPolicies(folder, more)()
