"""A policy that is a chat model: an instruction and images in, an answer as text out.

Uses the chat completions API that OpenAI, vLLM and most other servers offer, or the
older completions API, for benchmarks whose actions are answers (`choice`, `number` and
`point`, -1 for those that are not given) and for `calibration`, as calibration.md says.
How a text becomes an answer is in docs/evaluate/question-answering.md; a text that
cannot be read is "no answer" and not a fault (CHAT-003). It must not know which answer
is correct.
"""

from __future__ import annotations

import base64
import re
from collections.abc import Mapping
from typing import Any

from pydantic import BaseModel

from reference_record.generated.answers import Turn
from reference_server.generated import models
from reference_server.push.calls_with_retries import (
    HttpCalls,
    PolicyFault,
    read_members,
)
from reference_server.push.policy_calls import Description
from reference_server.rules.policy_server import PolicyServerConfig
from reference_server.rules.runs.run import Run

NO_ANSWER = -1.0
ANSWER_SIZES = {"choice": 1, "number": 1, "point": 2}
MEDIA_TYPES = {"png": "image/png", "jpeg": "image/jpeg"}
_UNSUPPORTED_CODEC = (
    "Chat models accept png or jpeg images only; set images.codec to one of these."
)
_NO_IMAGES = "A completions server accepts no images; use openai_chat."
_NO_TEXT = "The model's answer is not a completion: it has no /choices/0/text."
_NO_COMPLETION = (
    "The model's answer is not a chat completion: it has no /choices/0/message/content."
)

# Only the end of a text of any length is read: so much of the line that may be an
# answer, and so much that is searched for a marked answer (FLE-022).
_LINE_CHARS_MAX, _TEXT_CHARS_MAX = 4096, 2**16
_REASONING_END = "</think>"
_LABEL = re.compile(r"answer\s*:\s*", re.IGNORECASE)
_DECORATION = "*` \t"
_CHOICE = re.compile(r"\(([A-Za-z])\)|([A-Za-z])\)?")
_DECIMAL = r"[0-9]{1,6}(?:\.[0-9]{1,9})?"
_NUMBER = re.compile(_DECIMAL)
# Marks of an answer inside of a text (FLE-022).
_ANSWER_BEGIN, _ANSWER_END = "<answer>", "</answer>"
_BOX = re.compile(r"\\boxed\{(?:\\text\{([^{}]{0,100})\}|([^{}]{0,100}))\}")
_HASHES = re.compile(r"^####(.{0,200})$", re.MULTILINE)
_ANSWER_IS = re.compile(r"\banswer is:?(?: option)?[ \t]([^\n]{0,200})", re.IGNORECASE)
_NAMED_CHOICE = re.compile(r"\(?([A-Z])(?:\)|[.:](?=\s))")  # before its text: `B) left`
_POINT = re.compile(rf"[(\[]?\s*({_DECIMAL})(?:\s*,\s*|\s+)({_DECIMAL})\s*[)\]]?")


class ChatPolicy:
    """The chat model of one run. Each turn is a conversation of its own."""

    def __init__(self, run: Run, config: PolicyServerConfig, calls: HttpCalls) -> None:
        self._run = run
        self._config = config
        self._calls = calls

    async def describe(self) -> Description:
        """No call is made: chat servers share no path for it. Raises PolicyFault."""
        if not is_playable_by_chat(self._run.manifest):
            raise PolicyFault(
                f"A chat model cannot play {self._run.manifest['benchmark_id']}: its "
                "actions are not answers (choice, number, point)."
            )
        if not self._is_calibration and self._run.images["codec"] not in MEDIA_TYPES:
            raise PolicyFault(_UNSUPPORTED_CODEC)
        return Description(self._config.max_concurrent)

    @property
    def _is_calibration(self) -> bool:
        return bool(self._run.manifest["benchmark_id"] == "calibration")

    async def reset(self, turn: Turn) -> None:
        """A chat model has no state to reset."""

    async def predict(self, turn: Turn) -> models.Predict:
        values = self._values(read_answer(await self._ask(turn)))
        return models.Predict(
            session_id=turn["session_id"],
            seq=turn["seq"] + 1,
            actions=[models.Action(values=values)],
        )

    async def _ask(self, turn: Turn) -> str:
        """CHAT-001: one POST for each turn; the text of the answer."""
        body = self._generation() | {"messages": [_message(turn)]}
        return _content(await self._calls.post("/chat/completions", body, _read))

    def _values(self, answer: dict[str, list[float]]) -> dict[str, list[float]]:
        """The answer as an action; a value above its maximum counts as no answer."""
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

    def _generation(self) -> dict[str, Any]:
        """The members of a request beside the question (CHAT-001)."""
        body: dict[str, Any] = {
            # A number of tokens is an integer and must be written as one.
            name: int(value) if value == int(value) else value
            for name, value in self._config.generation.items()
        }
        if self._config.model is not None:
            body["model"] = self._config.model
        return body


class CompletionPolicy(ChatPolicy):
    """A model behind the completions API, which continues a text and sees no image."""

    async def describe(self) -> Description:
        """CHAT-005: no image can be sent. Raises PolicyFault."""
        space: Mapping[str, Any] = self._run.manifest["observation_space"]
        if space.get("images") and not self._is_calibration:
            raise PolicyFault(_NO_IMAGES)
        return await super().describe()

    async def _ask(self, turn: Turn) -> str:
        """CHAT-005: one POST for each turn; the text of the answer."""
        if turn["observation"]["images"]:
            raise PolicyFault(_NO_IMAGES)
        body = self._generation() | {"prompt": turn["episode"]["instruction"]}
        return _text(await self._calls.post("/completions", body, _read_text))


def is_playable_by_chat(manifest: Mapping[str, Any]) -> bool:
    """Whether a chat model can play the benchmark: its actions are answers."""
    space = manifest["action_space"]
    sizes = {name: entry["size"] for name, entry in space.items()}
    return manifest["benchmark_id"] == "calibration" or sizes == ANSWER_SIZES


def read_answer(text: str) -> dict[str, list[float]]:
    """The text of a model as an action, in which at most one entry is an answer.

    CHAT-002: reads the last line that is not blank after the last `</think>`; if that
    is not an answer, the text is searched as FLE-022 has it. CHAT-003: the answer stays
    "no answer" if neither recognises one.
    """
    answer_text = text.rpartition(_REASONING_END)[2].strip()
    last_lines = answer_text[-_LINE_CHARS_MAX:].splitlines()
    line = last_lines[-1].strip().strip(_DECORATION) if last_lines else ""
    line = _LABEL.sub("", line, count=1) if _LABEL.match(line) else line
    values = _read_words(line) or _read_words(_marked(answer_text[-_TEXT_CHARS_MAX:]))
    none = {name: [NO_ANSWER] * size for name, size in ANSWER_SIZES.items()}
    return none | values


def _read_words(line: str) -> dict[str, list[float]]:
    """The entry of an action that the words are, and nothing beside it; or nothing."""
    # The full stop may be inside or after the decoration of the answer.
    line = line.strip(_DECORATION).removesuffix(".").strip(_DECORATION)
    if choice := _CHOICE.fullmatch(line):
        letter = (choice[1] or choice[2]).upper()
        return {"choice": [float(ord(letter) - ord("A"))]}
    if _NUMBER.fullmatch(line):
        return {"number": [float(line)]}
    if point := _POINT.fullmatch(line):
        return {"point": [float(point[1]), float(point[2])]}
    return {}


def _marked(text: str) -> str:
    """FLE-022: the words that a text marks as its answer; empty if it marks none.

    The first kind of mark that there is decides, and of it the last.
    """
    before, end, _ = text.rpartition(_ANSWER_END)
    if end:
        return before.rpartition(_ANSWER_BEGIN)[2].strip()
    if boxes := _BOX.findall(text):
        return str(boxes[-1][0] or boxes[-1][1])
    for mark in (_HASHES, _ANSWER_IS):
        if answers := mark.findall(text):
            words = str(answers[-1]).strip(_DECORATION)
            named = _NAMED_CHOICE.match(words)
            return named[1] if named else words
    return ""


def _message(turn: Turn) -> dict[str, Any]:
    """The question of a turn (CHAT-001)."""
    images = [_image_part(image) for image in turn["observation"]["images"].values()]
    text = {"type": "text", "text": turn["episode"]["instruction"]}
    return {"role": "user", "content": [*images, text]}


def _image_part(image: Mapping[str, Any]) -> dict[str, Any]:
    if image["codec"] not in MEDIA_TYPES:
        raise PolicyFault(_UNSUPPORTED_CODEC)
    data = base64.b64encode(image["data"]).decode()
    url = f"data:{MEDIA_TYPES[image['codec']]};base64,{data}"
    return {"type": "image_url", "image_url": {"url": url}}


class _Message(BaseModel):
    content: Any


class _Choice(BaseModel):
    message: _Message


class _Completion(BaseModel):
    """The members that are read of a large chat completion."""

    choices: list[_Choice]


_read = read_members(_Completion, lambda _: PolicyFault(_NO_COMPLETION))


def _content(answer: Any) -> str:
    """CHAT-004: the text of a chat completion. Raises PolicyFault if it is none.

    A completion without text (`content` is null) is an empty text: no answer, no fault.
    """
    try:
        content = answer["choices"][0]["message"]["content"]
    except (LookupError, TypeError) as error:
        raise PolicyFault(_NO_COMPLETION) from error
    return content if isinstance(content, str) else ""


class _TextChoice(BaseModel):
    text: Any


class _TextCompletion(BaseModel):
    """The members that are read of a large completion."""

    choices: list[_TextChoice]


_read_text = read_members(_TextCompletion, lambda _: PolicyFault(_NO_TEXT))


def _text(answer: Any) -> str:
    """CHAT-005: the text of a completion. Raises PolicyFault if it is none."""
    try:
        text = answer["choices"][0]["text"]
    except (LookupError, TypeError) as error:
        raise PolicyFault(_NO_TEXT) from error
    return text if isinstance(text, str) else ""
