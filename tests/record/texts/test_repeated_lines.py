"""Lines of a log that come again are shown once, and none is lost."""

import random

import pytest

from reference_record.texts.repeated_lines import RepeatedLines

RULE = "-" * 40
OTHER = [RULE, "Exception in a call", "Traceback:", "  File", "KeyError: 1"]
BLOCK = [RULE, "Exception in a call", "Traceback:", "  File", "ValueError: no", RULE]


def shown(lines: list[str]) -> list[str]:
    repeats = RepeatedLines()
    return [text for line in lines for text in repeats.add(line)] + repeats.flush()


def again(times: str, lines: str = "6 lines") -> str:
    return f"(the same {lines}, {times} more)"


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        ([], []),
        (["a", "b", "a", "b"], ["a", "b", "a", "b"]),
        (["a"] * 3, ["a"] * 3),
        (["a"] * 900, ["a", again("899 times", "line")]),
        (BLOCK * 2, [*BLOCK, again("once")]),
        (["x", *BLOCK * 9, "y"], ["x", *BLOCK, again("8 times"), "y"]),
        (
            [*BLOCK * 3, *OTHER, *BLOCK * 2],
            [*BLOCK, again("2 times"), *OTHER, *BLOCK, again("once")],
        ),
    ],
)
def test_a_block_that_comes_again_is_shown_once(
    lines: list[str], expected: list[str]
) -> None:
    assert shown(lines) == expected


def test_what_is_shown_says_what_was_printed() -> None:
    """Random logs of few different lines. Expect each one back from what is shown."""
    chance = random.Random(7)
    for _ in range(300):
        lines = chance.choices("abc", k=chance.randrange(80))
        whole: list[str] = []
        for text in shown(lines):
            if not text.startswith("(the same"):
                whole.append(text)
                continue
            _, _, first, *rest = text.strip("()").split()
            length = 1 if first == "line," else int(first)
            times = 1 if "once" in rest else int(rest[-3])
            whole += whole[-length:] * times
        assert whole == lines


def test_a_pause_shows_what_is_no_whole_block() -> None:
    """The rest of a block may never come; a whole one may go on to come again."""
    repeats = RepeatedLines()
    for line in BLOCK:
        assert repeats.add(line) == [line] or line == RULE
    repeats.pause()
    assert repeats.add(BLOCK[1]) == []
    assert repeats.pause() == [BLOCK[1]]
    for line in [*BLOCK, *BLOCK]:
        repeats.add(line)
    assert repeats.pause() == []
    assert repeats.flush()[-1] == again("once")
