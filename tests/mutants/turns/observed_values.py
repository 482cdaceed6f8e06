"""Mutants of observations: numbers, tensors and images on their way to the policy."""

from __future__ import annotations

import io
from collections.abc import Callable
from typing import Any

from PIL import Image

from reference_sim.process.pool import SimulatorHandle
from tests.mutants import Json, Row, instead_of, mutant, mutants


def change_observations(change: Callable[[Any], None]) -> None:
    """Change every observation on its way from the simulator."""

    def change_report(report: Any) -> Any:
        # The last of all is the observation itself: changed once is enough.
        all_but_last = (getattr(report, "observations", None) or [])[:-1]
        for observation in [report.observation, *all_but_last]:
            if observation is not None:
                change(observation)
        return report

    async def of_report(right: Any, *arguments: Any, **named: Any) -> Any:
        return change_report(await right(*arguments, **named))

    async def of_observation(right: Any, self: Any) -> Any:
        observation = await right(self)
        change(observation)
        return observation

    instead_of(SimulatorHandle, "begin")(of_report)
    instead_of(SimulatorHandle, "play")(of_report)
    instead_of(SimulatorHandle, "observe")(of_observation)


@mutant(
    *(
        "CAL-003",
        "PRED-001",
        "PRED-012",
        "PRED-017",
    ),
    through=change_observations,
)
def counts_one_action_too_many(observation: Json) -> None:
    """The kit cannot determine what was executed."""
    if observation["state"]["count"][0] > 2:
        observation["state"]["count"][0] += 1


@mutant("CAL-006", "PRED-025", through=change_observations)
def sends_a_tensor_in_every_task(observation: Json) -> None:
    """A policy that needs no tensors pays for them in every turn."""
    tensor = {"dtype": "float64", "shape": [2, 3], "data": bytes(48)}
    observation["tensors"].setdefault("float64", tensor)


@mutant("CAL-007", "ENC-003", "ENC-012")
def sends_numbers_in_single_precision() -> None:
    """All positions are slightly wrong."""
    import numpy as np

    def wrong(observation: Json) -> None:
        vector = observation["state"]["vector"]
        observation["state"]["vector"] = [
            float(np.float32(v)) if abs(v) < 1e38 else v for v in vector
        ]

    change_observations(wrong)


@mutant("ENC-004", through=change_observations)
def sends_tensors_big_endian(observation: Json) -> None:
    """Every tensor is noise on a little-endian machine."""
    for tensor in observation["tensors"].values():
        tensor["data"] = bytes(tensor["data"])[::-1]


def change_images(change: Callable[[Json], None]) -> None:
    """Change every image of every observation."""

    def change_all(observation: Json) -> None:
        for image in observation["images"].values():
            change(image)

    change_observations(change_all)


@mutant("ENC-005", "PRED-012", through=change_images)
def sends_images_upside_down(image: Json) -> None:
    """A policy sees every image upside down."""
    if image["codec"] == "raw":
        row = image["width"] * image["channels"]
        data = bytes(image["data"])
        rows = [data[i : i + row] for i in range(0, len(data), row)]
        image["data"] = b"".join(reversed(rows))


@mutants(
    Row(
        "loses_colours_in_png",
        ("ENC-006",),
        "A lossless image has lost information.",
        ("png", lambda picture: picture.convert("L").convert("RGB")),
    ),
    Row(
        "halves_the_size_of_jpeg",
        ("ENC-007",),
        "A policy is evaluated on images of another size than chosen.",
        ("jpeg", lambda picture: picture.reduce(2)),
    ),
)
def encode_again(wrong: tuple[str, Callable[[Any], Any]]) -> None:
    """Encode the images of one codec again after a change of the picture."""
    codec, change = wrong

    def encode(image: Json) -> None:
        if image["codec"] == codec:
            picture = change(Image.open(io.BytesIO(bytes(image["data"]))))
            out = io.BytesIO()
            picture.save(out, codec.upper())
            image["data"] = out.getvalue()

    change_images(encode)
