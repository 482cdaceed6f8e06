"""The pytest plugin that runs the checks: selection, contexts, background, verdicts.

pytest collects and schedules; it decides nothing. The exception of a check becomes a
verdict in verdicts/verdict_of_check.py. The verdict is attached to the test report for
the command line, which owns the result.
"""

import contextlib
import functools
import gc
import inspect
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from conformance.client.check_context import CheckContext
from conformance.client.connections.transport.fault_texts import WITHOUT_SERVER
from conformance.client.http_client import NoAnswer
from conformance.client.request_context import SharedContext
from conformance.run_settings import Settings
from conformance.runner.private_server import close_private_servers
from conformance.verdicts import expect
from conformance.verdicts.result import is_offered
from conformance.verdicts.verdict import Outcome, Verdict
from conformance.verdicts.verdict_of_check import is_violation, judge

VERDICT = "kit_verdict"
TALLY = "kit_tally"
COVERAGE = "kit_coverage"
SUBMITTED = "kit_submitted_runs"
LEFT = "kit_left_behind"
SERVER_UNREACHABLE = "kit_server_unreachable"
_BACKGROUND_TIMEOUT_S = 180
# A check that the clock or a connection of the kit decided is tried so often, with time
# in between for ports and descriptors to become free.
_TRIES = 3
_PAUSE_S = 0.5
# A check in which answers were lost on the way is tried so often. Before each try, the
# server has this time to be reached again.
_TRIES_ON_THE_WAY = 5
_OUTAGE_S = 5.0
# Python's default is 700: a search for garbage at every third request.
_OBJECTS_BETWEEN_SEARCHES = 50_000
# An answer that is late by less than so many times the noise of a round trip proves
# nothing,
_NOISE_FACTOR = 50
# nor does one that is late by less than two of the longest times without any answer.
_STALL_FACTOR = 2
_CHECK_CONTEXT = pytest.StashKey[CheckContext]()
_SHARED = pytest.StashKey[SharedContext]()
_BACKGROUND = pytest.StashKey["BackgroundChecks"]()
_FAILED_FAST = pytest.StashKey[bool]()
_SELECTED = pytest.StashKey[tuple[str, ...]]()
_ROUND = pytest.StashKey[int]()
_SECONDS = pytest.StashKey[float]()
_PASSED = pytest.StashKey[bool]()


def requirements_of(item: pytest.Item) -> tuple[str, ...]:
    """Give the ids of the requirements that a check judges, of those selected."""
    return item.stash.get(_SELECTED, _all_requirements_of(item))


def requirement_of(item: pytest.Item) -> str:
    """Give the id after which a check is named, whatever is selected."""
    return _all_requirements_of(item)[0]


def _all_requirements_of(item: pytest.Item) -> tuple[str, ...]:
    mark = item.get_closest_marker("requirement")
    if mark is None:
        raise pytest.UsageError(f"{item.nodeid} has no requirement marker")
    return mark.args


def _context_for(item: pytest.Item, shared: SharedContext) -> CheckContext:
    number = item.stash.get(_ROUND, 0)
    context = CheckContext(shared, requirement_of(item), round_number=number)
    context.tally.rules = requirements_of(item)
    return context


def play_round(item: pytest.Item, number: int) -> bool:
    """Play a check again with other examples; say whether it has passed."""
    item.stash[_ROUND] = number
    item.user_properties.clear()
    item.ihook.pytest_runtest_protocol(item=item, nextitem=None)
    return item.stash[_PASSED]


def seconds_of_round(item: pytest.Item, unknown_s: float) -> float:
    """Give how long a check took last, alone in this process."""
    return item.stash.get(_SECONDS, unknown_s)


def docstring_of(item: pytest.Item) -> str:
    """Give the docstring of a check, which the reports print."""
    check = getattr(item, "obj", None)
    return inspect.cleandoc(check.__doc__ or "") if check is not None else ""


class BackgroundChecks:
    """The checks that mostly wait, each in its own thread."""

    def __init__(self, shared: SharedContext) -> None:
        self._context = shared
        self._futures: dict[str, Future[None]] = {}
        self._contexts: dict[str, CheckContext] = {}

    def has_begun(self, item: pytest.Function) -> bool:
        """Say whether a check has been started."""
        return item.nodeid in self._futures

    def start(self, items: list[pytest.Function]) -> None:
        """Start all that are not started yet."""
        items = [item for item in items if item.nodeid not in self._futures]
        if not items:
            return
        # The last ones take longest: they start servers, one after the other.
        for item in reversed(items):
            context = _context_for(item, self._context)
            future: Future[None] = Future()
            self._contexts[item.nodeid] = context
            self._futures[item.nodeid] = future
            # Daemons: when the server is gone, the kit does not wait for them.
            check = functools.partial(_call_check, item.obj)
            threading.Thread(
                target=_run_check, args=(check, context, future), daemon=True
            ).start()

    def has_ended(self, item: pytest.Function) -> bool:
        """Say whether a check has been started and does not run any more."""
        return item.nodeid in self._futures and self._futures[item.nodeid].done()

    def has_violation(self) -> bool:
        """Say whether a check that has ended found a violation."""
        return any(
            future.done()
            and is_violation(
                judge(self._contexts[name].name, future.exception()),
                self._contexts[name],
            )
            for name, future in self._futures.items()
        )

    def wait_for_violation(self, item: pytest.Function) -> None:
        """Wait until a check ends, or another one finds a violation."""
        until = time.monotonic() + _BACKGROUND_TIMEOUT_S
        while not self.has_ended(item) and not self.has_violation():
            if time.monotonic() > until:
                return
            pending = [future for future in self._futures.values() if not future.done()]
            wait(pending, until - time.monotonic(), FIRST_COMPLETED)

    def tidy_up(self) -> None:
        """Take back what the checks made so far, those that still run included."""
        for context in self._contexts.values():
            context.tidy_up()

    def collect(self, item: pytest.Function) -> None:
        """Wait for the end of a check and raise its exception."""
        item.stash[_CHECK_CONTEXT] = self._contexts[item.nodeid]
        try:
            self._futures[item.nodeid].result(timeout=_BACKGROUND_TIMEOUT_S)
        except TimeoutError:
            raise expect.Inconclusive(
                f"check did not finish within {_BACKGROUND_TIMEOUT_S} s"
            ) from None


def _bind_parameters(item: pytest.Function) -> Callable[[CheckContext], None]:
    """Give the check of an item, whose only argument is then the context."""
    names = inspect.signature(item.obj).parameters.keys() - {"context"}
    return functools.partial(item.obj, **{n: item.funcargs[n] for n in names})


def _call_check(check: Callable[[CheckContext], None], context: CheckContext) -> None:
    """Call a check; again while a fault of the way to the server may be the reason.

    A request that got no answer in any try shows a fault of the server itself.
    """
    faults = context.exchange_log.way_faults
    faults.begin()
    last: Exception | None = None
    for _ in range(_TRIES_ON_THE_WAY):
        error = _error_of_the_way(check, context)
        if error is None:
            break
        last = error
        context.tidy_up()
    else:
        assert last is not None
        _judge_faults(context, last)
    if last is not None and faults.recur_in_spite():
        raise last
    context.tally.served.note_lost(faults.lost_on_the_way())


def _error_of_the_way(
    check: Callable[[CheckContext], None], context: CheckContext
) -> Exception | None:
    """Call a check once; give the error that a lost answer may have caused, if any."""
    faults = context.exchange_log.way_faults
    context.begin_try()
    try:
        _call_on_this_machine(check, context)
    except Exception as error:
        is_known = isinstance(error, expect.SetUpFailed) and error.allowed
        is_known = is_known or isinstance(error, expect.NotApplicable)
        if is_known or not faults.may_cause(error):
            raise
        faults.end_try()
        if not _is_reachable(context.shared):
            raise
        return error
    return None


def _judge_faults(context: CheckContext, error: Exception) -> None:
    """Raise the error of a check if the server itself left a request unanswered."""
    faults = context.exchange_log.way_faults
    of_server = faults.of_server()
    for fault in of_server:
        context.tally.served.note_unanswered(fault.place[0])
        if fault.page is not None:
            fault.exchange.status = fault.page.status
            context.tally.observe(fault.operation, fault.page, fault.exchange)
    if of_server:
        raise error
    context.tally.served.note_lost(faults.lost_on_the_way())
    last = faults.latest[-1]
    raise expect.SetUpFailed(
        f"in each of {_TRIES_ON_THE_WAY} tries an answer was lost on the way: look at "
        f"the network, or at a proxy, before the server",
        exchange=last.exchange.number,
    ) from error


def _call_on_this_machine(
    check: Callable[[CheckContext], None], context: CheckContext
) -> None:
    """Call a check; again while a busy machine or the kit itself may be the reason."""
    for _ in range(_TRIES - 1):
        try:
            return _call_once(check, context)
        except (expect.OwnConnectionFailed, expect.Inconclusive, expect.TooLate):
            context.tidy_up()
            time.sleep(_PAUSE_S)
            context.measure_noise()
    try:
        with context.watch_for_stalls() as stalls_s:
            return _call_once(check, context)
    except expect.TooLate as error:
        noise_s = _NOISE_FACTOR * context.measure_noise()
        if error.late_s <= max(noise_s, _STALL_FACTOR * max(stalls_s, default=0.0)):
            text = f"expected {error.expected}; observed {error.observed}"
            raise expect.Inconclusive(f"this machine is too busy: {text}") from error
        raise


def _call_once(check: Callable[[CheckContext], None], context: CheckContext) -> None:
    """Call a check; effects that it caused itself prove nothing about the server."""
    context.own_causes.begin()
    try:
        check(context)
    except (expect.Violation, expect.SetUpFailed) as error:
        excuse = context.own_causes.excuse(context.name, error)
        is_known = isinstance(error, expect.SetUpFailed) and error.allowed
        if excuse is None or is_known:
            raise
        raise excuse from error


def _run_check(
    check: Callable[[CheckContext], None], context: CheckContext, future: Future[None]
) -> None:
    try:
        check(context)
    except BaseException as error:  # noqa: BLE001 - raised where it is collected
        future.set_exception(error)
    else:
        future.set_result(None)


def pytest_configure(config: pytest.Config) -> None:
    """Load the settings and open the connections."""
    config.addinivalue_line("markers", "requirement(*ids): the rules of a check")
    config.addinivalue_line("markers", "background: waits, so it runs in a thread")
    config.addinivalue_line("markers", "long_run: reads a run of many episodes")
    config.addinivalue_line("markers", "histories: plays generated ones")
    config.addinivalue_line("markers", "minutes: tries more with --minutes")
    config.addinivalue_line("markers", "one_process(name): runs where its like run")
    # pytest's own style parses the source of what failed, which checks that run in
    # threads can break in Python 3.11 (SystemError: recursion depth mismatch).
    config.option.tbstyle = "native"
    config.stash[_SHARED] = SharedContext.of(Settings.load_from_environment())
    config.stash[_BACKGROUND] = BackgroundChecks(config.stash[_SHARED])


def pytest_collection_finish() -> None:
    """Spare what exists now from the search for garbage, and search less often."""
    gc.freeze()
    gc.set_threshold(_OBJECTS_BETWEEN_SEARCHES)
    gc.enable()


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    """Tidy up checks without a teardown: Ctrl-C ended them, or the server is gone."""
    for item in session.items:
        if _CHECK_CONTEXT in item.stash:
            item.stash[_CHECK_CONTEXT].tidy_up()
    session.config.stash[_BACKGROUND].tidy_up()


def pytest_unconfigure(config: pytest.Config) -> None:
    """Close the connections, and end the servers of checks that still run."""
    shared = config.stash[_SHARED]
    close_private_servers(shared)
    shared.close()


def pytest_collection_modifyitems(
    config: pytest.Config, items: list[pytest.Item]
) -> None:
    """Keep the selected checks; waiting checks come last, crash checks after them."""
    settings = config.stash[_SHARED].settings
    wanted = {row.id for row in settings.selected_rules if is_offered(row, settings)}
    for item in items:
        rules = _all_requirements_of(item)
        item.stash[_SELECTED] = tuple(rule for rule in rules if rule in wanted)
    items[:] = [
        item
        for item in items
        if requirements_of(item) and not (settings.quick and _is_long(item))
    ]
    for item in items:
        if is_crash(item) and settings.restart_cmd is None:
            # It has its own server, so it does not disturb other checks.
            item.add_marker("background")
        if _waits(item):
            # One process starts them all, so that they wait together.
            item.add_marker(pytest.mark.one_process("background"))
    if settings.quick and not settings.fail_fast:
        items[:] = _interleave_files(items)
    items.sort(
        key=lambda item: (
            is_crash(item),
            _waits(item),
            _place(item, settings),
        )
    )


def _interleave_files(items: list[pytest.Item]) -> list[pytest.Item]:
    """Spread the checks of each file evenly over the run.

    Checks of one file load the server alike. In the order of the files, all processes
    would wait for timers at one time, and for the server at another.
    """
    counts = Counter(item.path for item in items)
    placed = Counter[Path]()
    places: dict[str, float] = {}
    for item in items:
        places[item.nodeid] = (placed[item.path] + 0.5) / counts[item.path]
        placed[item.path] += 1
    return sorted(items, key=lambda item: places[item.nodeid])


def is_crash(item: pytest.Item) -> bool:
    return requirement_of(item).startswith("CRASH-")


def _place(item: pytest.Item, settings: Settings) -> int:
    """With --fail-fast the rules that --only names first are judged first."""
    rules = requirements_of(item)
    places = [
        n
        for n, name in enumerate(settings.only)
        if any(rule.startswith(name) for rule in rules)
    ]
    return min(places) if settings.fail_fast and places else 0


def _waits(item: pytest.Item) -> bool:
    return item.get_closest_marker("background") is not None


def _is_long(item: pytest.Item) -> bool:
    plays_long = item.get_closest_marker("long_run") is not None
    return _waits(item) or plays_long or is_crash(item)


def pytest_runtestloop(session: pytest.Session) -> None:
    """Start the background checks before the first check, if this process runs all."""
    if not session.config.stash[_SHARED].settings.is_time_up:
        _start_background(session)


def _start_background(session: pytest.Session) -> None:
    waiting = [item for item in session.items if _waits(item)]
    functions = [item for item in waiting if isinstance(item, pytest.Function)]
    session.config.stash[_BACKGROUND].start(functions)


@pytest.fixture
def context(request: pytest.FixtureRequest) -> CheckContext:
    """Give a check its view of the server."""
    created = _context_for(request.node, request.config.stash[_SHARED])
    request.node.stash[_CHECK_CONTEXT] = created
    return created


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Collect a background check instead of running it; start none after --max-time."""
    background = pyfuncitem.config.stash[_BACKGROUND]
    settings = pyfuncitem.config.stash[_SHARED].settings
    if settings.is_time_up and not background.has_begun(pyfuncitem):
        limit = f"--max-time {settings.max_time_s:g}"
        raise expect.SetUpFailed(f"{expect.TIME_WAS_UP} ({limit})")
    if not _waits(pyfuncitem) or _ROUND in pyfuncitem.stash:
        _end_if_violated(pyfuncitem, background)
        _call_check(_bind_parameters(pyfuncitem), pyfuncitem.stash[_CHECK_CONTEXT])
        return True
    _start_background(pyfuncitem.session)
    if settings.fail_fast and not pyfuncitem.config.stash.get(_FAILED_FAST, False):
        background.wait_for_violation(pyfuncitem)
    if not background.has_ended(pyfuncitem):
        _end_if_violated(pyfuncitem, background)
    background.collect(pyfuncitem)
    return True


def _end_if_violated(item: pytest.Function, background: BackgroundChecks) -> None:
    """With --fail-fast: leave a check out when a rule was violated before it."""
    if not item.config.stash[_SHARED].settings.fail_fast:
        return
    is_violated = item.config.stash.get(_FAILED_FAST, False)
    if is_violated or background.has_violation():
        item.config.stash[_FAILED_FAST] = True
        raise expect.SetUpFailed(expect.VIOLATION_FOUND)


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item: pytest.Item) -> None:
    """Stop the runs of the check, after pytest's own teardown."""
    if _CHECK_CONTEXT in item.stash:
        context = item.stash[_CHECK_CONTEXT]
        context.tidy_up()
        context.judge.history.forget(context.name)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Iterator[Any]:
    """Attach the verdict, and after teardown the tally of the universal rules."""
    check_context = item.stash.get(_CHECK_CONTEXT, None)
    if call.when == "call" or call.excinfo is not None:
        error = call.excinfo.value if call.excinfo is not None else None
        verdict = judge(requirement_of(item), error, check_context)
        if check_context is not None and check_context.shared.settings.exchanges:
            verdict.exchanges = (
                verdict.exchanges or check_context.exchange_log.exchanges[:]
            )
        if _waits(item) and verdict.breaks == expect.ANY_SEQUENCE:
            verdict.breaks = ""  # a lease may have ended where the machine is slow
        verdict.check = item.name
        verdict.story = docstring_of(item)
        if check_context is not None and verdict.outcome != Outcome.PASSED:
            _note_unreachable(item, check_context, verdict, error)
        verdict.elapsed_s = call.duration
        item.stash[_PASSED] = verdict.outcome == Outcome.PASSED
        if _ROUND in item.stash or not _waits(item):
            item.stash[_SECONDS] = call.duration
        if _ROUND not in item.stash or _decides(verdict):
            for rule in requirements_of(item):
                of_rule = replace(verdict, requirement_id=rule)
                item.user_properties.append((VERDICT, of_rule.as_plain()))
        if is_violation(verdict, check_context):
            item.config.stash[_FAILED_FAST] = True
    if call.when == "teardown" and check_context is not None:
        item.user_properties.append((TALLY, check_context.tally.as_plain()))
        item.user_properties.append((COVERAGE, check_context.coverage.as_plain()))
        item.user_properties.append((SUBMITTED, check_context.submitted))
        item.user_properties.append((LEFT, check_context.left))
    return (yield)


def _decides(verdict: Verdict) -> bool:
    """Whether a further round of a check says more than the first one did.

    A quota that it used up, or a machine that was too slow for it, leaves a rule as the
    first round has judged it.
    """
    is_said = verdict.outcome in (Outcome.FAILED, Outcome.KIT_ERROR)
    return is_said or bool(verdict.breaks)


def _note_unreachable(
    item: pytest.Item,
    context: CheckContext,
    verdict: Verdict,
    error: BaseException | None,
) -> None:
    """End the kit run when the server does not respond any more.

    A request that another one left without an answer, by ending it, violates no rule.
    """
    exchanges = context.exchange_log.exchanges
    lost = [exchange for exchange in exchanges if exchange.status is None]
    is_lost = isinstance(error, NoAnswer | OSError)  # also beside the client
    if not (lost or is_lost) or _is_reachable(context.shared):
        return
    error_text = f" ({lost[0].error})" if lost else ""
    reason = f"server stopped responding during {context.name}{error_text}"
    if context.shared.unanswered:
        reason += f"; without an answer were {', '.join(context.shared.unanswered)}"
    item.user_properties.append((SERVER_UNREACHABLE, reason))
    item.session.shouldstop = reason
    if is_lost:
        verdict.outcome, verdict.reason = Outcome.NOT_VERIFIED, reason
        verdict.expected = verdict.observed = ""


def _is_reachable(shared: SharedContext) -> bool:
    """Wait a while for an answer that is none of a gateway."""
    until = time.monotonic() + _OUTAGE_S
    while time.monotonic() < until:
        with (
            contextlib.suppress(httpx.RequestError),
            shared.connections.borrow() as connections,
        ):
            response = connections.get(f"{shared.settings.url}/v1", _OUTAGE_S)
            if response.status not in WITHOUT_SERVER:
                return True
        time.sleep(0.3)
    return False
