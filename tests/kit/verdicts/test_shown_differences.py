"""A report shows each difference, and never leaves it out on both sides."""

from typing import Any

import pytest

from conformance.verdicts import expect

LONG = [*range(180)]


@pytest.mark.parametrize(
    ("observed", "due", "shown", "says"),
    [
        (LONG, [*LONG[:90], -1, *LONG[91:]], "-1", "90"),
        (LONG[:-1], LONG, "180", "179"),
        (LONG[:-1], LONG, "179", "(absent)"),
        ([LONG], [LONG[1:]], "179", "180"),
        ({"a": LONG, "b": 1}, {"a": LONG, "b": 2}, "/b 2", "/b 1"),
        ("x" * 900 + "left", "x" * 900 + "right", "right", "left"),
        ("x" * 400, "x" * 401, "x", "x"),
        ({"text": "é" * 700 + "1"}, {"text": "é" * 700 + "2"}, '2"', '1"'),
    ],
)
def test_both_sides_show_where_they_differ(
    observed: Any, due: Any, shown: str, says: str
) -> None:
    with pytest.raises(expect.Violation) as raised:
        expect.equal(observed, due, "a value")
    assert shown in raised.value.expected
    assert says in raised.value.observed
    assert raised.value.expected.removeprefix("a value with ") != raised.value.observed
    assert len(raised.value.expected) < 1500


def test_what_time_changes_stands_behind_what_was_executed_twice() -> None:
    answers = [
        {"lease": {"expires_at": f"T{n}"}, "timing": {"total_s": n}, "step": n}
        for n in (1, 2)
    ]
    with pytest.raises(expect.Violation) as raised:
        expect.equal(LONG + answers[:1], LONG + answers[1:], "an answer")
    assert raised.value.expected.index("step") < raised.value.expected.index("lease")
