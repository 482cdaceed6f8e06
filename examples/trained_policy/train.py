"""Trains a small ACT policy, as LeRobot has it, on one core in a few minutes.

    .venv-lerobot/bin/python examples/trained_policy/train.py DATASET FOLDER

DATASET is one of demonstrations.py, or any LeRobotDataset without images. FOLDER is
then what `proctor run --policy lerobot:FOLDER` takes. The policy, its processors and
the loss are LeRobot's own. `lerobot-train` trains the same from the same data set; this
is faster, for it keeps the data set, which is small, in memory.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass
from pathlib import Path

import torch
from lerobot.configs.types import FeatureType
from lerobot.datasets.lerobot_dataset import LeRobotDataset
from lerobot.datasets.utils import dataset_to_policy_features
from lerobot.policies.act.configuration_act import ACTConfig
from lerobot.policies.act.modeling_act import ACTPolicy
from lerobot.policies.factory import make_pre_post_processors

CHUNK = 16
EXECUTED = 8


@dataclass(frozen=True, slots=True)
class Frames:
    """A data set in memory. columns: name → (frames, numbers). firsts, ends: of each
    episode, the index of its first frame and of the one after its last."""

    columns: dict[str, torch.Tensor]
    firsts: torch.Tensor
    ends: torch.Tensor

    @classmethod
    def of(cls, dataset: LeRobotDataset) -> Frames:
        table = dataset.hf_dataset.with_format("torch")
        lengths = torch.bincount(table["episode_index"][:])
        ends = lengths.cumsum(0)
        names = dataset_to_policy_features(dataset.features)
        return cls({name: table[name][:] for name in names}, ends - lengths, ends)

    def batch(self, size: int) -> dict[str, torch.Tensor]:
        """Frames, each with the chunk of actions that follows it.

        Every episode is as likely: short tasks count as much as long ones.
        """
        episode = torch.randint(len(self.ends), (size,))
        first, end = self.firsts[episode], self.ends[episode]
        frame = first + (torch.rand(size) * (end - first)).long()
        index = frame[:, None] + torch.arange(CHUNK)
        last = end[:, None] - 1
        batch = {name: column[frame] for name, column in self.columns.items()}
        return batch | {
            "action": self.columns["action"][index.minimum(last)],
            "action_is_pad": index > last,
        }


def settings(dataset: LeRobotDataset) -> ACTConfig:
    features = dataset_to_policy_features(dataset.features)
    return ACTConfig(
        input_features={
            name: one
            for name, one in features.items()
            if one.type is not FeatureType.ACTION
        },
        output_features={"action": features["action"]},
        chunk_size=CHUNK,
        n_action_steps=EXECUTED,
        dim_model=64,
        n_heads=4,
        dim_feedforward=256,
        n_encoder_layers=2,
        use_vae=False,
        dropout=0.0,
        device="cpu",
    )


def train(
    dataset: LeRobotDataset, folder: Path, steps: int, size: int, lr: float
) -> None:
    config = settings(dataset)
    policy = ACTPolicy(config)
    preprocess, postprocess = make_pre_post_processors(
        config, dataset_stats=dataset.meta.stats
    )
    frames = Frames.of(dataset)
    optimizer = torch.optim.AdamW(policy.parameters(), lr=lr, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, lr, total_steps=steps)
    policy.train()
    begun, total = time.monotonic(), 0.0
    for step in range(1, steps + 1):
        loss, _ = policy.forward(preprocess(frames.batch(size)))
        optimizer.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(policy.parameters(), 10.0)
        optimizer.step()
        schedule.step()
        total += loss.item()
        if step % 500 == 0:
            spent = time.monotonic() - begun
            print(f"step {step}: loss {total / 500:.4f}, {spent:.0f} s", flush=True)
            total = 0.0
    policy.save_pretrained(folder)
    preprocess.save_pretrained(folder)
    postprocess.save_pretrained(folder)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("dataset", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--steps", type=int, default=10_000)
    parser.add_argument("--batch", type=int, default=128)
    parser.add_argument("--lr", type=float, default=1e-3)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    torch.set_num_threads(1)
    torch.manual_seed(options.seed)
    dataset = LeRobotDataset(f"proctor/{options.dataset.name}", root=options.dataset)
    train(dataset, options.folder, options.steps, options.batch, options.lr)


if __name__ == "__main__":
    main()
