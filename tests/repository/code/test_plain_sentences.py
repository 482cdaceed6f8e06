"""Docstrings and comments are plain sentences: a noun first, then a verb.

Three constructions make a short sentence a riddle, and are found here:

- "Of a worker that is late." has no noun: write what it is, as "Lease of a worker …";
- "What a page shows." has no verb of its own: name it, as "The rows of a page: …";
- "is no" before a noun hides the verb: write "is not a record", or what it is instead.

`python -m tests.repository.code.test_plain_sentences FOLDER …` prints all findings.
"""

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.repository.imports import HAND_WRITTEN, name_of, nodes_of

# Sentences of each folder that are left to rewrite; a folder without an entry has none.
LEFT_MAX = {"tests": 215}

BEGIN = r"(?:\A|[.!?:]\s+|\n\s*\n|\n\s*- )\s*"
RIDDLE = re.compile(BEGIN + r"(?P<start>(?:Of|What)\s[^.?!]*[.?!]?)")
NO_NOUN = re.compile(
    r"(?<!here )\b(?:is|are|was|were|be)\s+no\s+"
    r"(?!(?:longer|more|less|fewer|later|earlier|better|worse|matter)\b)[\w`].{0,30}"
)
# A file without these need not be parsed.
CANDIDATE = re.compile(r"\b(?:Of|What|(?:is|are|was|were|be)\s+no)\b")
COMMENT_LINE = re.compile(r"(?:[ \t]*# ?.*\n)+")
TRAILING_COMMENT = re.compile(r"\S  # (.*)")


def texts_of(path: Path) -> Iterator[tuple[int, str]]:
    """Line and text of each docstring and comment; lines in succession are one text."""
    source = path.read_text("utf-8")
    if not CANDIDATE.search(source):
        return
    for node in nodes_of(path):
        match node:
            case ast.Expr(value=ast.Constant(value=str(text))):
                yield node.lineno, text
    for match in re.finditer(r"(?m)^" + COMMENT_LINE.pattern, source):
        yield line_of(source, match.start()), re.sub(r"(?m)^\s*# ?", "", match[0])
    for match in TRAILING_COMMENT.finditer(source):
        yield line_of(source, match.start()), match[1]


def line_of(source: str, position: int) -> int:
    return source.count("\n", 0, position) + 1


def riddles(text: str) -> list[str]:
    starts = [" ".join(match["start"].split()) for match in RIDDLE.finditer(text)]
    questions_left_out = [start for start in starts if not start.endswith("?")]
    return questions_left_out + [" ".join(m[0].split()) for m in NO_NOUN.finditer(text)]


def findings(folder: str) -> list[str]:
    return [
        f"{name_of(path)}:{line}: {riddle}"
        for path in HAND_WRITTEN
        if name_of(path).split("/")[0] == folder
        for line, text in texts_of(path)
        for riddle in riddles(text)
    ]


FOLDERS = sorted({name_of(path).split("/")[0] for path in HAND_WRITTEN})


@pytest.mark.parametrize("folder", FOLDERS)
def test_texts_are_plain_sentences(folder: str) -> None:
    found = findings(folder)
    most = LEFT_MAX.get(folder, 0)
    assert len(found) <= most, f"{len(found)}, at most {most}\n" + "\n".join(found)


if __name__ == "__main__":
    for name in sys.argv[1:] or FOLDERS:
        sys.stdout.writelines(f"{finding}\n" for finding in findings(name))
