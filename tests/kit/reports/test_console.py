"""The kit shows plain text on a terminal, whatever the server sent."""

import pytest

from conformance.cli.console import Terminal


def test_texts_of_a_server_do_not_act_on_the_terminal(
    capsys: pytest.CaptureFixture[str],
) -> None:
    Terminal().say("observed \x1b[2J\x9b1A\u202e\ud800 – ½ 你好")
    shown = capsys.readouterr().out
    assert shown == "observed \\x1b[2J\\x9b1A\\u202e\\ud800 – ½ 你好\n"
