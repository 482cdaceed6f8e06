"""Turns: execution of chunks, ends of episodes, members of a turn (PRED)."""

import base64
import time
from functools import partial

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.given_states import (
    attach_workers,
    require_duration,
    submit_and_attach,
)
from conformance.client.check_context import CheckContext
from conformance.client.run_client import WorkerClient
from conformance.exchanges.answer import Answer
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import Inconclusive

SEVERAL_WORKERS = 6


@requirement("PRED-001")
def test_pred_001_executes_all_actions_in_order(context: CheckContext) -> None:
    """A chunk of three different actions. Expect three executed actions, the last one
    last."""
    worker = submit_and_attach(context, "score", "score")
    chunk = [context.action(vector=[n] * 8, score=n / 4) for n in (3.0, 1.0, 2.0)]
    expect.ok(worker.try_predict(*chunk))


@requirement("PRED-006")
def test_pred_006_chunks_are_single_actions(context: CheckContext) -> None:
    """The same actions, sent one by one, in chunks, and in random chunks. Expect the
    same observations and rewards at every cut, and the same result, whether the episode
    ends by itself, at `max_steps`, or not at all."""

    def play(example: tuple[list[int], int]) -> None:
        cuts, ends_at = example
        actions = [
            context.action(
                vector=[n] * 8, score=n / 16, success=n % 2, end=int(n == ends_at)
            )
            for n in range(sum(cuts))
        ]
        for lengths in (cuts, [1] * len(actions)):
            worker, rest = submit_and_attach(context, "score", max_steps=7), [*actions]
            for length in lengths:
                if not worker.turn["done"]:
                    worker.predict(*rest[:length])
                    del rest[:length]
            worker.run.results()

    longest = min(4, context.limits["max_chunk"])
    for example in (([longest, longest], 9), ([1, longest], 2)):
        play(example)
    cuts = st.lists(st.integers(1, longest), min_size=1, max_size=4)
    for_all(context, st.tuples(cuts, st.integers(0, 9)), play, times=10)


@requirement("PRED-007", "PRED-021", "PRED-028")
def test_pred_007_stops_when_the_episode_ends(context: CheckContext) -> None:
    """Chunks that are longer than the episode, end with it, or end before it, with
    scores. Expect nothing executed after the end, `stopped_early` for the first alone,
    and the reward of each executed action, which is its `score`."""
    worker = submit_and_attach(context, "count", "count", "count", max_steps=3)
    step, end = context.action(), context.action(end=1)
    for chunk in ([step, end, step, step], [step, end], [step], [step, step, step]):
        worker.predict(*chunk)
    worker = submit_and_attach(context, "score", "score")
    for scores, ends in (([0.25, 1.0, 0.5], [0, 0, 0]), ([0.75, 0.125, 1], [0, 1, 0])):
        pairs = zip(scores, ends, strict=True)
        worker.predict(*[context.action(score=score, end=end) for score, end in pairs])


@requirement("PRED-008", "PRED-009", "PRED-020")
def test_pred_008_ends_episodes(context: CheckContext) -> None:
    """Two episodes; the first ends with its second action. So do two more, of which
    every observation is read. One with `max_steps` 3 is played to the limit, and
    another terminates there. Expect no result before the end; then the result of that
    episode, and the first observation of the next one, or `done` after the last; the
    first of the last two truncated and not terminated, the other one terminated."""
    for observe in (None, "all") if context.offers("observations") else (None,):
        worker = submit_and_attach(context, "count", "count")
        worker.predict(context.action())
        worker.predict(context.action(end=1, success=1), observe=observe)
        worker.play()
    worker = submit_and_attach(context, "score", "score", max_steps=3)
    step = context.action()
    for action in (step, context.action(end=1)):
        worker.predict(step, step)
        worker.predict(action)


@requirement("PRED-012")
def test_pred_012_observes_all(context: CheckContext) -> None:
    """A chunk that is executed completely, one that the episode's end truncates, and
    one that ends the last episode. Expect one observation per executed action, in
    order, each with its own image."""
    worker = submit_and_attach(context, "echo", "echo")
    chunk = [context.action(vector=[n] * 8) for n in (3.0, 1.0, 2.0)]
    chunk_ending = [context.action(), context.action(end=1), context.action()]
    last_chunk = chunk_ending[:2]
    played = ((chunk, [1, 2, 3]), (chunk_ending, [4, 5]), (last_chunk, [1, 2]))
    for actions, counts in played:
        turn = expect.ok(worker.try_predict(*actions, observe="all"))
        worker.seq += 1
        images = [o["images"]["pattern"] for o in turn["observations"]]
        # The first byte of the image is the number of actions before it.
        first = [base64.b64decode(image["data"][:4])[0] for image in images]
        expect.equal(first, counts, "first bytes of the images")
        if "episode_result" not in turn:
            last = turn["observations"][-1]
            expect.equal(last, turn["observation"], "the last observation")


@requirement("EPI-013")
def test_epi_013_max_steps_is_that_of_the_benchmark(context: CheckContext) -> None:
    """Runs with and without an option; turns, a takeover, an end, another attempt.
    Expect its `max_steps` in every episode, whatever was played of it."""
    for options in ({"max_steps": 5}, {}):
        worker = submit_and_attach(context, "score", "score", **options)
        worker.predict(context.action(), context.action())
        if context.offers("sessions"):
            worker.attach(takeover=True)
        worker.play()
        worker.predict(context.action())
        if context.offers("sessions"):
            worker.detach()
            worker.attach()


def longest_beside(slow: WorkerClient, quick: WorkerClient, delay_s: float) -> float:
    """Let one worker take a long turn; give the longest turn of the other."""
    context = slow.run.context
    until = time.monotonic() + delay_s / 2
    turns_s: list[float] = []

    def play_on() -> None:
        while time.monotonic() < until:
            answer = quick.try_predict(context.action())
            expect.require(answer, 200, "a quick turn")
            quick.seq += 1
            turns_s.append(answer.elapsed_s)

    def take_long() -> None:
        answer = slow.try_predict(context.action(delay_s=delay_s))
        expect.require(answer, 200, "the long turn")
        slow.seq += 1
        require_duration(answer, delay_s)

    context.call_concurrently(take_long, play_on)
    if not turns_s:
        raise Inconclusive("the kit came too late to play beside the long turn")
    return max(turns_s)


@requirement("PRED-022")
@background
def test_pred_022_workers_do_not_wait_for_each_other(context: CheckContext) -> None:
    """One worker takes a turn of a second while another takes short ones; then several
    take long ones at once. Expect each short turn to end long before the long one. As
    the machine may be slow for a moment, there are three tries, three times."""
    slow, quick = attach_workers(context.submit("delay", "count", max_steps=10000), 2)
    delay_s = min(5.0, max(1.0, 4 * context.tolerance_s))
    longest_s: list[float] = []
    while len(longest_s) < 3 and (not longest_s or longest_s[-1] > delay_s / 2):
        longest_s.append(longest_beside(slow, quick, delay_s))
    what = f"each turn beside one of {delay_s:g} s"
    expect.in_time(longest_s[-1], delay_s / 2, what, may_be_noise=False)
    if not context.shared.settings.quick:
        expect_no_wait_beside_many(context, delay_s)


def expect_no_wait_beside_many(context: CheckContext, delay_s: float) -> None:
    """Expect a short turn not to wait for the long ones of several workers."""
    many = context.worker_count(SEVERAL_WORKERS)
    run = context.submit(*["delay"] * many, max_steps=1000)
    *slow, quick = attach_workers(run, many)

    def play_later() -> Answer:
        time.sleep(delay_s / 4)
        return quick.try_next()

    took_s: list[float] = []
    while len(took_s) < 3 and (not took_s or took_s[-1] > delay_s / 2):
        *turns, answer = context.call_concurrently(
            *[partial(worker.try_next, delay_s=delay_s) for worker in slow], play_later
        )
        for turn in (*turns, answer):
            expect.require(turn, 200, "predict")
        took_s.append(answer.elapsed_s)
    what = f"a turn beside {len(slow)} of {delay_s:g} s"
    expect.in_time(took_s[-1], delay_s / 2, what, may_be_noise=False)


@requirement("PRED-023")
def test_pred_023_timing_adds_up(context: CheckContext) -> None:
    """Turns with images, several in a turn, with a delay, and with a change of episode.
    Expect queue, simulate, render and encode never to be more than the total."""
    # The last size is the largest, the last codec costs most to encode.
    images = {"codec": context.benchmark["image_codecs"][-1]}
    images |= context.benchmark["image_sizes"][-1]
    worker = submit_and_attach(
        context, "echo", "delay", "score", images=images, max_steps=100
    )
    many = min(32, context.limits["max_chunk"])
    for values in ({}, {}, {"end": 1}, {"delay_s": 0.05}, {"end": 1}, {}):
        chunk = [context.action(**values)] * (1 if values else many)
        worker.predict(*chunk, observe="all")
