"""A policy that is a chat model: asked by question and picture, answered in words.

Speaks the chat completions that OpenAI's, vLLM's and most other servers offer, for
benchmarks whose actions are answers: `choice`, `number` and `point`, -1 for those that
are not given; and for `calibration`, as calibration.md says. How words become an answer
is written in docs/question-answering.md; what cannot be read is no answer, and no
fault. It must not know which answer is right.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Mapping
from typing import Any

from reference_server.generated import models
from reference_server.push.http_calls import HttpCalls, PolicyFault
from reference_server.push.policy_calls import Description, Turn
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.run import Run

NO_ANSWER = -1.0
ANSWER_SIZES = {"choice": 1, "number": 1, "point": 2}
MEDIA_TYPES = {"png": "image/png", "jpeg": "image/jpeg"}
_UNSUPPORTED_CODEC = (
    "A chat model is shown png or jpeg; submit the run with one of these."
)

_REASONING_END = "</think>"
_LABEL = re.compile(r"answer\s*:\s*", re.IGNORECASE)
_DECORATION = "*` \t"
_CHOICE = re.compile(r"\(([A-Za-z])\)|([A-Za-z])\)?")
_DECIMAL = r"[0-9]{1,6}(?:\.[0-9]{1,9})?"
_NUMBER = re.compile(_DECIMAL)
_POINT = re.compile(rf"[(\[]?\s*({_DECIMAL})(?:\s*,\s*|\s+)({_DECIMAL})\s*[)\]]?")


class ChatPolicy:
    """One run's. It has no memory: each turn is a conversation of its own."""

    def __init__(self, run: Run, config: PolicyServerConfig, calls: HttpCalls) -> None:
        self._run = run
        self._config = config
        self._calls = calls

    async def describe(self) -> Description:
        """Nothing is asked: chat servers agree on one path. Raises PolicyFault."""
        if not is_answered_in_words(self._run.manifest):
            raise PolicyFault(
                f"{self._run.manifest['benchmark_id']} is not answered in words: a "
                "chat model plays benchmarks such as question_answering."
            )
        if not self._is_calibration and self._run.images["codec"] not in MEDIA_TYPES:
            raise PolicyFault(_UNSUPPORTED_CODEC)
        return Description(self._config.max_concurrent)

    @property
    def _is_calibration(self) -> bool:
        return bool(self._run.manifest["benchmark_id"] == "calibration")

    async def reset(self, turn: Turn) -> None:
        """There is nothing to forget."""

    async def predict(self, turn: Turn) -> models.Predict:
        answer = await self._calls.post("/chat/completions", self._question(turn))
        values = self._values(read_answer(_content(answer)))
        return models.Predict(
            session_id=turn["session_id"],
            seq=turn["seq"] + 1,
            actions=[models.Action(values=values)],
        )

    def _values(self, answer: dict[str, list[float]]) -> dict[str, list[float]]:
        """The answer as an action; one beyond what can be said is none."""
        space = self._run.manifest["action_space"]
        if self._is_calibration:
            score = min(max(answer["number"][0], 0.0), 1.0)
            named = {"score": [score], "success": [float(score == 1)], "end": [1.0]}
            return {n: named.get(n, [0.0] * e["size"]) for n, e in space.items()}
        for name, vector in answer.items():
            most = space[name].get("maximum", vector)
            if any(v > high for v, high in zip(vector, most, strict=True)):
                answer[name] = [NO_ANSWER] * len(vector)
        return answer

    def _question(self, turn: Turn) -> dict[str, Any]:
        """The request: our members win over what the submitter asks to be sent."""
        pictures = [
            _image_part(image) for image in turn["observation"]["images"].values()
        ]
        text = {"type": "text", "text": turn["episode"]["instruction"]}
        body: dict[str, Any] = {
            # A number of tokens is a whole one, and so it is written.
            name: int(value) if value == int(value) else value
            for name, value in self._config.generation.items()
        }
        if self._config.model is not None:
            body["model"] = self._config.model
        return body | {"messages": [{"role": "user", "content": [*pictures, text]}]}


def is_answered_in_words(manifest: Mapping[str, Any]) -> bool:
    """Whether a chat model can play the benchmark at all."""
    space = manifest["action_space"]
    sizes = {name: entry["size"] for name, entry in space.items()}
    return manifest["benchmark_id"] == "calibration" or sizes == ANSWER_SIZES


def read_answer(text: str) -> dict[str, list[float]]:
    """The action that a model's words are: at most one of its entries is an answer."""
    values = {name: [NO_ANSWER] * size for name, size in ANSWER_SIZES.items()}
    answer_text = text.rpartition(_REASONING_END)[2].strip()
    line = (
        answer_text.splitlines()[-1].strip().strip(_DECORATION) if answer_text else ""
    )
    line = _LABEL.sub("", line, count=1) if _LABEL.match(line) else line
    # The one full stop may stand inside of what is around the answer, or behind it.
    line = line.strip(_DECORATION).removesuffix(".").strip(_DECORATION)
    if choice := _CHOICE.fullmatch(line):
        letter = (choice[1] or choice[2]).upper()
        values["choice"] = [float(ord(letter) - ord("A"))]
        return values
    if _NUMBER.fullmatch(line):
        values["number"] = [float(line)]
    elif point := _POINT.fullmatch(line):
        values["point"] = [float(point[1]), float(point[2])]
    return values


def _image_part(image: Mapping[str, Any]) -> dict[str, Any]:
    if image["codec"] not in MEDIA_TYPES:
        raise PolicyFault(_UNSUPPORTED_CODEC)
    data = base64.b64encode(image["data"]).decode()
    url = f"data:{MEDIA_TYPES[image['codec']]};base64,{data}"
    return {"type": "image_url", "image_url": {"url": url}}


def _content(answer: Any) -> str:
    """The words of a chat completion; none of them is an answer like any other."""
    try:
        content = answer["choices"][0]["message"]["content"]
    except (LookupError, TypeError) as error:
        raise PolicyFault(
            "The model's answer is no chat completion: it has no "
            "/choices/0/message/content."
        ) from error
    return content if isinstance(content, str) else ""
