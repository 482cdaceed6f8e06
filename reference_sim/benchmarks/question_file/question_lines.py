"""The lines of a question file: what one may say, and what is asked and right.

A line is a JSON object: `question`, `answer`, and `choices` if one of several texts is
right; `task` or `subject` names its task. These are the members that MMLU and GSM8K
have, so that sets of their shape need no conversion. It must not know manifests.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from reference_record.command_line.text_file import NotText, read_text_file
from reference_sim.benchmarks.question_answering.items import NO_ANSWER, NUMBER_MAX
from reference_sim.gymnasium import BadBenchmark
from reference_sim.interface import Action

LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
FILE_BYTES_MAX = 64 * 2**20
_TEXT_MAX = 20_000
_BY_LETTER = "Answer with the letter alone."
_BY_NUMBER = "Answer with the number alone."
# `1,234.5`, or what stands behind `####` in a worked solution.
_NUMBER = re.compile(r"(?s:.*####)?\s*([0-9][0-9,]*(?:\.[0-9]{1,9})?)\s*")

Text = Annotated[str, Field(min_length=1, max_length=_TEXT_MAX)]


class _Line(BaseModel):
    """One line; other members, such as an id, are ignored."""

    model_config = ConfigDict(strict=True)

    question: Text
    answer: int | float | str
    choices: list[Text] | None = Field(None, min_length=2, max_length=len(LETTERS))
    task: str = Field("", max_length=200)
    subject: str = Field("", max_length=200)


@dataclass(frozen=True, slots=True)
class FileQuestion:
    """text: what is asked. right: the entry of an action. choices: 0 for a number."""

    task: str
    text: str
    right: Action
    choices: int

    def is_right(self, answer: Action) -> bool:
        """The right entry, and no answer in any other."""
        due = {
            name: self.right.get(name, [NO_ANSWER] * len(answer[name]))
            for name in answer
        }
        return all(list(answer[name]) == list(due[name]) for name in answer)


def read_questions(path: Path) -> Sequence[FileQuestion]:
    """Every question of a file. Raises BadBenchmark with the line's number."""
    try:
        if path.stat().st_size > FILE_BYTES_MAX:
            raise BadBenchmark(f"{path}: has more than {FILE_BYTES_MAX} bytes")
        text = read_text_file(path)
    except OSError as error:
        raise BadBenchmark(f"{path}: {error.strerror}") from error
    except NotText as error:
        raise BadBenchmark(f"{path}: {error}") from error
    # Not splitlines: a question may contain other separators of lines.
    numbered = enumerate(text.split("\n"), start=1)
    questions = [
        _question(f"{path}: line {number}", line, path.stem)
        for number, line in numbered
        if line.strip()
    ]
    if not questions:
        raise BadBenchmark(f"{path}: has no question")
    return questions


def _question(at: str, line: str, default_task: str) -> FileQuestion:
    try:
        content = json.loads(line)
        read = _Line.model_validate(content)
    except RecursionError as error:
        raise BadBenchmark(f"{at}: is nested too deeply") from error
    except ValidationError as error:
        fault = error.errors(include_url=False, include_context=False)[0]
        where = ".".join(map(str, fault["loc"][:1])) or "the line"
        raise BadBenchmark(f"{at}: {where}: {fault['msg']}") from error
    except ValueError as error:
        raise BadBenchmark(f"{at}: is not JSON: {error}") from error
    task = read.task or read.subject or default_task
    if read.choices is None:
        right = {"number": [_number(at, read.answer)]}
        return FileQuestion(task, f"{read.question}\n\n{_BY_NUMBER}", right, 0)
    options = [f"{letter}) {c}" for letter, c in zip(LETTERS, read.choices)]  # noqa: B905 - fewer choices than letters
    text = "\n".join([read.question, *options, "", _BY_LETTER])
    place = _place(at, read.answer, len(options))
    return FileQuestion(task, text, {"choice": [float(place)]}, len(options))


def _place(at: str, answer: Any, choices: int) -> int:
    """The place of the right choice, from its letter or from its place, from 0."""
    if isinstance(answer, str) and len(answer.strip()) == 1:
        answer = LETTERS.find(answer.strip().upper())
    if not isinstance(answer, int) or not 0 <= answer < choices:
        last = LETTERS[choices - 1]
        raise BadBenchmark(
            f"{at}: answer: must be a letter from A to {last}, or 0 to {choices - 1}"
        )
    return answer


def _number(at: str, answer: Any) -> float:
    """The number that is right; the last one of a worked solution."""
    match = _NUMBER.fullmatch(str(answer))
    number = float(match[1].replace(",", "")) if match else -1.0
    if not 0 <= number <= NUMBER_MAX:
        raise BadBenchmark(
            f"{at}: answer: must be a number from 0 to {NUMBER_MAX}, or text that ends "
            "with #### and such a number; or give choices"
        )
    return number
