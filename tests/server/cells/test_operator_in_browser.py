"""An operator with a tablet: a whole run by the page alone, in a real browser."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from typing import Any

import pytest

from reference_client import evaluate
from tests.support.cells.scripted_operator import ScriptedOperator
from tests.support.cells.stop_cases import (
    CELL_ID,
    OPERATOR,
    SECOND_OPERATOR,
    UNANSWERED,
    Drive,
    StopBench,
)
from tests.support.pages.browser import Browser
from tests.support.servers import TOKENS

pytestmark = pytest.mark.slow("a server, a robot and a browser are started")

PAGE = f"/pages/cells/{CELL_ID}"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


class Tablet:
    """Presses what the page shows; every wait is for the page itself."""

    def __init__(self, browser: Browser, bench: StopBench) -> None:
        self._browser, self._url = browser, bench.server.url
        browser.sign_in(self._url, OPERATOR)
        self.reload()

    def reload(self) -> None:
        self._browser.open(f"{self._url}{PAGE}")

    def press(self, act: str) -> None:
        form = f"[...document.forms].find(form => form.elements.act?.value === '{act}')"
        self._browser.wait_for(f"!!({form})")
        self._browser.evaluate(f"{form}.querySelector('button').click()")

    def wait_for(self, phase: str) -> None:
        panel = "document.getElementById('panel')"
        self._browser.wait_for(f"{panel}?.dataset.phase === '{phase}'")

    def fill(self, selector: str, value: str) -> None:
        self._browser.evaluate(
            f"document.querySelector('{selector}').value = '{value}'"
        )

    def value_of(self, selector: str) -> Any:
        return self._browser.evaluate(f"document.querySelector('{selector}')?.value")

    def judge(self, success: str) -> None:
        self.wait_for("judging")
        choice = f"[name=success][value={success}]"
        self._browser.evaluate(f"document.querySelector('{choice}').click()")
        self.press("judge")
        self.wait_for("done")
        self.press("next")


def check_widths(browser: Browser, *widths: int) -> None:
    for width in widths:
        browser.resize(width)
        assert browser.find_faults() == browser.find_violations() == []


def test_a_second_person_judges_by_the_page(bench: StopBench, browser: Browser) -> None:
    """Expect a page without faults, pictures that play, and a judgement that counts."""
    operator = ScriptedOperator(bench, "success")
    url, token = bench.server.url, TOKENS["alice"]
    bench.act("claim", takes_over=True)
    with operator.working():
        score = evaluate(Drive, url=url, token=token, benchmark=CELL_ID)
    browser.sign_in(url, SECOND_OPERATOR)
    browser.open(f"{url}/pages/cells")
    check_widths(browser, 400, 1024, 1280)
    links = "[...document.querySelectorAll('a[href*=second_judgements]')]"
    before = browser.evaluate(f"{links}.length")
    browser.follow(f"{links}.at(-1).click()")
    check_widths(browser, 400, 1024, 1280)
    camera = "document.querySelector('figure img')"
    browser.wait_for(f"{camera}.naturalWidth === 64")
    first = browser.evaluate(f"{camera}.src")
    browser.press("End")
    browser.wait_for(f"{camera}.src !== {first!r}")
    for name in (score.run_id, "alice", "Drive", "olga", "seen"):
        assert name not in browser.text
    browser.evaluate("document.querySelector('[name=success][value=no]').click()")
    browser.follow("document.querySelector('form.second-judge button').click()")
    browser.wait_for(f"{links}.length === {before - 1}")
    browser.sign_in(url, token)
    browser.open(f"{url}/pages/runs/{score.run_id}")
    check_widths(browser, 400, 1024, 1280)
    assert "the judges agreed on 0 of 1; 1 of 2 drawn wait" in browser.text
    assert browser.errors == []


@pytest.mark.release("a whole run by the page of an operator")
def test_a_run_needs_nothing_but_the_page(bench: StopBench, browser: Browser) -> None:
    """A stop, a void trial, a closed tablet and a note that is typed slowly.

    Expect the result that was judged, a stop in view at each width, and a page without
    faults of contrast, labels and widths.
    """
    bench.act("release")
    scores: list[Any] = []
    url, token = bench.server.url, TOKENS["alice"]
    client = threading.Thread(
        target=lambda: scores.append(
            evaluate(Drive, url=url, token=token, benchmark=CELL_ID)
        ),
        daemon=True,
    )
    client.start()
    tablet = Tablet(browser, bench)
    tablet.press("claim")
    tablet.wait_for("preparing")
    for width in (400, 820, 1280):
        browser.resize(width)
        assert browser.find_faults() == browser.find_violations() == []
        bottom = "document.querySelector('.stop button').getBoundingClientRect().bottom"
        assert browser.evaluate(f"{bottom} <= innerHeight")
    tablet.press("ready")
    tablet.wait_for("playing")
    tablet.press("stop")
    tablet.wait_for("judging")
    tablet.fill("[name=note]", "slowly")
    browser.wait_for("performance.now() > 2500")  # the panel was asked for meanwhile
    assert tablet.value_of("[name=note]") == "slowly"
    assert "The setup: Put the block" in browser.text
    browser.wait_for("document.querySelector('img.setup').naturalWidth === 320")
    answers = "document.querySelectorAll('[name=success]')"
    browser.evaluate(f"{answers}.forEach(answer => answer.required = false)")
    tablet.press("judge")
    browser.wait_for(f"document.body.innerText.includes('{UNANSWERED}')")
    tablet.judge("yes")
    tablet.wait_for("preparing")
    tablet.reload()  # the tablet was closed at the worst moment
    tablet.press("ready")
    tablet.wait_for("judging")
    tablet.fill("[name=reason]", "the light changed")
    tablet.press("void")
    for success in ("no", "yes", "no"):
        tablet.wait_for("preparing")
        tablet.press("ready")
        tablet.judge(success)
    client.join()
    assert (scores[0].counts.success, scores[0].counts.failure) == (2, 2)
    browser.sign_in(url, token)
    browser.open(f"{url}/pages/runs/{scores[0].run_id}")
    check_widths(browser, 400, 1280)
    assert "1 × the light changed" in browser.text
    assert browser.errors == []


def test_the_page_says_that_the_server_is_gone(
    bench: StopBench, browser: Browser
) -> None:
    """The server is killed. Expect an alarm that names the robot's own stop."""
    tablet = Tablet(browser, bench)
    bench.server.end(signal.SIGKILL)
    browser.wait_for("!document.getElementById('alarm').hidden")
    bench.restart()
    browser.errors.clear()
    tablet.reload()
