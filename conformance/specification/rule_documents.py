"""The rules, as the documents of the specification state them.

A rule is an item of a list in a Markdown file of `spec/`: its id, its sentence, and the
operations that it is about, or none where it holds for every operation. A line
``Profile: `NAME`.`` below the title says to which profile the rules of the document
belong; below another heading, those of that section. A profile behind the id holds for
that rule alone. The last sentence of an item may say why no outsider can judge it.

    - [BEN-002] `get_benchmark` of an unknown id MUST be refused with `not_found`.
      — `get_benchmark`
    - [ERR-011, strict_http] Every response with status 429 MUST carry Retry-After.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

# In the order in which they are read; then those of profiles, by name. Levels says
# what rules mean and states none.
_DOCUMENTS = (
    *("http", "benchmarks", "runs", "play"),
    *("calibration", "conventions", "scoring", "policy", "simulator", "levels"),
)
_PROFILE = re.compile(r"^Profile: `(\w+)`\.$")
_HEADING = re.compile(r"^##+ ")
_RULE = re.compile(r"^- \[([A-Z]{2,6}-\d{3})(?:, (\w+))?\] (.+)$")
_VERIFIER = "verifier"
_LEVEL = re.compile(r"\b(?:MUST|SHOULD|MAY)\b")
_NOT_JUDGED = re.compile(r" \*Not judged: (.+)\.\*$")
_LINK = re.compile(r"\[([^\]]+)\]\([^)]+\)")
_OPERATIONS = re.compile(r" — (`\w+`(?:, `\w+`)*)$")


@dataclass(frozen=True)
class StatedRule:
    """A rule, the document and the line that state it, and what stands beside it.

    document: the path below spec/. operations: their ids; empty where a rule holds for
    all. is_of_verifiers: it obliges programs that read a file. why_not_judged: None
    where an outsider can judge it.
    """

    id: str
    profile: str
    text: str
    operations: tuple[str, ...]
    document: str
    line: int
    is_of_verifiers: bool
    why_not_judged: str | None

    @property
    def level(self) -> str:
        """The word of BCP 14 that the sentence has first: MUST, SHOULD or MAY."""
        match = _LEVEL.search(self.text)
        return match[0] if match else ""


def rule_documents(directory: Path) -> list[Path]:
    """The normative documents, in the order in which they are read."""
    named = [directory / f"{name}.md" for name in _DOCUMENTS]
    return [*named, *sorted((directory / "profiles").glob("*.md"))]


def read_rules(directory: Path) -> Iterator[StatedRule]:
    """Every rule of the documents in `directory`, in their order.

    Raises ValueError if a document does not say to which profile a rule belongs.
    """
    for path in rule_documents(directory):
        document = path.relative_to(directory).as_posix()
        text = path.read_text(encoding="utf-8")
        of_document = of_section = None
        is_below_title = True
        for line, item in _paragraphs(text):
            if _HEADING.match(item):
                is_below_title, of_section = False, of_document
            elif match := _PROFILE.match(item):
                of_section = match[1]
                of_document = of_section if is_below_title else of_document
            elif match := _RULE.match(item):
                mark = match[2] if match[2] != _VERIFIER else None
                profile = mark or of_section
                if profile is None:
                    raise ValueError(f"{document} names no profile above {match[1]}")
                yield _rule(match, profile, document, line)


def without_links(text: str) -> str:
    """The text with the words of its links in the place of the links."""
    return _LINK.sub(r"\1", text)


def _paragraphs(text: str) -> Iterator[tuple[int, str]]:
    """Give each line with its number, joined with the lines that are indented below."""
    number, joined = 0, ""
    for place, line in enumerate(text.splitlines(), 1):
        if line.startswith("  ") and joined.startswith("- "):
            joined += f" {line.strip()}"
            continue
        if joined:
            yield number, joined
        number, joined = place, line
    if joined:
        yield number, joined


def _rule(match: re.Match[str], profile: str, document: str, line: int) -> StatedRule:
    text, why, operations = match[3], None, ()
    if reason := _NOT_JUDGED.search(text):
        text, why = text[: reason.start()], reason[1]
    if listed := _OPERATIONS.search(text):
        text = text[: listed.start()]
        operations = tuple(re.findall(r"\w+", listed[1]))
    # Reports and other pages show the sentence, where a relative link leads nowhere.
    text = without_links(text)
    return StatedRule(
        *(match[1], profile, text, operations, document, line),
        is_of_verifiers=match[2] == _VERIFIER,
        why_not_judged=why,
    )
