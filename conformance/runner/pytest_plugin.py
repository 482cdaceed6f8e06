"""Runs the checks under pytest: selection, stories, background checks, verdicts.

pytest collects and schedules; it decides nothing. What a check raised becomes a
verdict here, and travels with the test report (also from xdist workers) to the
command line, which owns the result.
"""

import inspect
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import httpx
import pytest

from conformance.cli.settings import Settings
from conformance.client.check_context import Context, Story
from conformance.client.curl import needed_for
from conformance.verdicts import expect
from conformance.verdicts.result import is_offered, select
from conformance.verdicts.verdict import Outcome, Verdict

VERDICT = "kit_verdict"
TALLY = "kit_tally"
DEAD = "kit_server_is_dead"
_PATIENCE_S = 180
_STORY = pytest.StashKey[Story]()
_CONTEXT = pytest.StashKey[Context]()
_BACKGROUND = pytest.StashKey["Background"]()


def requirement_of(item: pytest.Item) -> str:
    """Give the id of the requirement that a check judges."""
    mark = item.get_closest_marker("requirement")
    if mark is None:
        raise pytest.UsageError(f"{item.nodeid} names no requirement")
    return str(mark.args[0])


def story_of(item: pytest.Item) -> str:
    """Give what a check tells of itself."""
    check = getattr(item, "obj", None)
    return inspect.cleandoc(check.__doc__ or "") if check is not None else ""


class Background:
    """The checks that mostly wait, each in its own thread."""

    def __init__(self, context: Context) -> None:
        self._context = context
        self._futures: dict[str, Future[None]] = {}
        self._stories: dict[str, Story] = {}

    def has_begun(self, item: pytest.Function) -> bool:
        """Say whether a check has its thread."""
        return item.nodeid in self._futures

    def start(self, items: list[pytest.Function]) -> None:
        """Start all that are not started yet."""
        items = [item for item in items if item.nodeid not in self._futures]
        if not items:
            return
        for item in items:
            story = Story(self._context, requirement_of(item))
            ending: Future[None] = Future()
            self._stories[item.nodeid] = story
            self._futures[item.nodeid] = ending
            # Daemons: when the server dies, nobody waits for them.
            threading.Thread(
                target=_run_check, args=(item.obj, story, ending), daemon=True
            ).start()

    def collect(self, item: pytest.Function) -> None:
        """Wait for one to end and pass on what it raised; its story is taken over."""
        item.stash[_STORY] = self._stories[item.nodeid]
        try:
            self._futures[item.nodeid].result(timeout=_PATIENCE_S)
        except TimeoutError:
            raise expect.Inconclusive(f"no end within {_PATIENCE_S} s") from None


def _run_check(
    check: Callable[[Story], None], story: Story, ending: Future[None]
) -> None:
    try:
        check(story)
    except BaseException as error:  # noqa: BLE001 - raised where it is collected
        ending.set_exception(error)
    else:
        ending.set_result(None)


def pytest_configure(config: pytest.Config) -> None:
    """Take over the settings and open the connections."""
    config.addinivalue_line("markers", "requirement(id): the rule that a check judges")
    config.addinivalue_line("markers", "background: runs in a thread, as it waits")
    config.addinivalue_line("markers", "xdist_group(name): stays in one process")
    config.stash[_CONTEXT] = Context.of(Settings.take_over())
    config.stash[_BACKGROUND] = Background(config.stash[_CONTEXT])


def pytest_unconfigure(config: pytest.Config) -> None:
    """Close the connections."""
    config.stash[_CONTEXT].close()


def pytest_collection_modifyitems(
    config: pytest.Config, items: list[pytest.Item]
) -> None:
    """Keep what was asked for; checks that wait come last, crashes after them."""
    settings = config.stash[_CONTEXT].settings
    wanted = {row.id for row in select(settings) if is_offered(row, settings)}
    items[:] = [
        item
        for item in items
        if requirement_of(item) in wanted and not (settings.quick and _waits(item))
    ]
    for item in items:
        if _is_crash(item) and settings.restart_cmd is None:
            # It has a server of its own, so it disturbs nobody.
            item.add_marker("background")
        if _waits(item):
            # One process starts them all, so that they wait together.
            item.add_marker(pytest.mark.xdist_group("background"))
    items.sort(key=lambda item: (_is_crash(item), _waits(item)))


def _is_crash(item: pytest.Item) -> bool:
    return requirement_of(item).startswith("CRASH-")


def _waits(item: pytest.Item) -> bool:
    return item.get_closest_marker("background") is not None


def pytest_runtestloop(session: pytest.Session) -> None:
    """Let the waiting begin before the first check; workers begin with their share."""
    is_worker = hasattr(session.config, "workerinput")
    is_controller = session.config.getoption("numprocesses", default=None)
    is_late = session.config.stash[_CONTEXT].settings.is_time_up
    if not is_worker and not is_controller and not is_late:
        _start_background(session)


def _start_background(session: pytest.Session) -> None:
    waiting = [item for item in session.items if _waits(item)]
    functions = [item for item in waiting if isinstance(item, pytest.Function)]
    session.config.stash[_BACKGROUND].start(functions)


@pytest.fixture
def story(request: pytest.FixtureRequest) -> Story:
    """Give a check its view of the server."""
    name = requirement_of(request.node)
    made = Story(request.config.stash[_CONTEXT], name)
    request.node.stash[_STORY] = made
    return made


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Collect a background check instead of running it; start none too late."""
    background = pyfuncitem.config.stash[_BACKGROUND]
    settings = pyfuncitem.config.stash[_CONTEXT].settings
    if settings.is_time_up and not background.has_begun(pyfuncitem):
        said = f"--max-time {settings.max_time_s:g}"
        raise expect.SetUpFailed(f"{expect.TIME_WAS_UP} ({said})")
    if not _waits(pyfuncitem):
        return None
    _start_background(pyfuncitem.session)
    background.collect(pyfuncitem)
    return True


def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Stop the runs that the check left behind."""
    if _STORY in item.stash:
        item.stash[_STORY].tidy_up()


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Iterator[Any]:
    """Attach the verdict, and at the end what all answers had to obey."""
    told_of_story = item.stash.get(_STORY, None)
    if call.when == "call" or call.excinfo is not None:
        verdict = judge(requirement_of(item), call.excinfo, told_of_story)
        verdict.check = item.name
        verdict.story = story_of(item)
        verdict.elapsed_s = call.duration
        item.user_properties.append((VERDICT, verdict.as_plain()))
        if told_of_story is not None and verdict.outcome != Outcome.PASSED:
            _stop_if_dead(item, told_of_story)
    if call.when == "teardown" and told_of_story is not None:
        item.user_properties.append((TALLY, told_of_story.tally.as_plain()))
    return (yield)


def _stop_if_dead(item: pytest.Item, story: Story) -> None:
    """End the run when a check got no answer and the server gives none any more."""
    unanswered = [one for one in story.journal.exchanges if one.status is None]
    if not unanswered or _is_alive(story.context):
        return
    reason = f"the server stopped answering during {story.name} ({unanswered[0].error})"
    item.user_properties.append((DEAD, reason))
    item.session.shouldstop = reason


def _is_alive(context: Context) -> bool:
    for _ in range(2):
        try:
            with context.clients.borrow() as client:
                client.get(f"{context.settings.url}/v1", timeout=5.0)
        except httpx.TransportError:
            time.sleep(0.3)
        else:
            return True
    return False


def _has_shapeless_answer(story: Story | None) -> bool:
    return story is not None and story.tally.broken["SVC-003"] > 0


def judge(
    requirement_id: str,
    caught: pytest.ExceptionInfo[BaseException] | None,
    story: Story | None,
) -> Verdict:
    """Make the verdict from what a check raised."""
    verdict = Verdict(requirement_id, Outcome.PASSED)
    error = caught.value if caught is not None else None
    if error is None:
        return verdict
    if story is not None:
        verdict.exchanges = list(story.journal.exchanges)
    match error:
        case expect.Violation():
            verdict.outcome = Outcome.FAILED
            verdict.expected, verdict.observed = error.expected, error.observed
            if error.is_alone:
                verdict.exchanges = needed_for(error.exchange, verdict.exchanges)
        case expect.SetUpFailed():
            verdict.outcome = Outcome.NOT_VERIFIED
            verdict.reason, verdict.allowed = error.reason, error.allowed
        case expect.Inconclusive():
            verdict.outcome, verdict.reason = Outcome.INCONCLUSIVE, str(error)
        case expect.NotApplicable():
            verdict.outcome, verdict.reason = Outcome.NOT_APPLICABLE, str(error)
        case _ if isinstance(error, LookupError) or _has_shapeless_answer(story):
            # An answer lacked what the check needed to go on.
            verdict.outcome = Outcome.NOT_VERIFIED
            last = traceback.extract_tb(error.__traceback__)[-1]
            where = f"{Path(last.filename).name} line {last.lineno}: {last.line}"
            verdict.reason = f"an answer lacks what {where} needs: {error!r}"
        case _:
            verdict.outcome = Outcome.KIT_ERROR
            verdict.reason = "".join(traceback.format_exception(error)[-4:])
    return verdict
