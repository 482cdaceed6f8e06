"""The run in spec/overview.md is one that a server could play: its JSON fits."""

import json
import re

from conformance.specification.document import JSON, load_spec
from tests.support.paths import SPEC
from tools.diagrams import lifecycle_diagram

# An exchange names its operation. A request may follow, then a status and an answer.
OPERATION = re.compile(r"^`(\w+)` · `(GET|PUT|POST) ", re.MULTILINE)
BLOCK = re.compile(
    r"^(?:(\d{3})[^\n]*\n\n)?```json\n(.*?)^```$", re.MULTILINE | re.DOTALL
)


def test_each_message_fits_its_schema() -> None:
    """Expect requests and answers of all operations shown to be valid."""
    text, spec = (SPEC / "overview.md").read_text(), load_spec()
    shown = list(OPERATION.finditer(text))
    ends = [*(match.start() for match in shown[1:]), len(text)]
    answers = 0
    for match, end in zip(shown, ends, strict=True):
        operation = spec.operations[match[1]]
        assert operation.method == match[2]
        for status, body in BLOCK.findall(text[match.end() : end]):
            message = json.loads(body)
            if not status:
                assert spec.request_faults(operation, message) == []
                continue
            kind = JSON if int(status) < 400 else "application/problem+json"
            assert spec.response_faults(operation, int(status), kind, message) == []
            answers += 1
    assert answers == 6


def test_the_picture_of_a_run_is_that_of_the_lifecycle() -> None:
    picture = lifecycle_diagram(load_spec().lifecycle)
    assert f"```mermaid\n{picture}\n```" in (SPEC / "overview.md").read_text()
