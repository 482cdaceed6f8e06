"""Judges submissions that have ended, and the remains of their host."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import dropwhile
from typing import Any

from reference_platform.submissions.interfaces import beginning_of
from tests.campaigns import campaign_page as page
from tests.campaigns.promises import Promise, Verdict, judge, percentile
from tests.campaigns.soak.participants import Handed, Participant
from tests.campaigns.soak.soak_host import FAULTS

PROMISED = 200
STEPS = 10  # of an episode of the track
_PRINTED = re.compile(r"line (\d+)")
# Why an attempt was lost: its sandbox ended before the platform closed it, or a call
# had no answer.
_LOST = re.compile(
    r"The sandbox has ended\.(?!.* is over\.$)|The policy did not answer a call "
)
_WRONG_POLICIES = ("crash", "silent", "unanswered", "malformed", "memory")


@dataclass
class Soak:
    """The findings of a campaign. faults: how often each happened.

    absent: faults that never happened, so that nothing is known about them. output: of
    the host, if something was found; build/soak.log.
    """

    submissions: int = 0
    states: Counter[str] = field(default_factory=Counter)
    faults: Counter[str] = field(default_factory=Counter)
    times_s: list[float] = field(default_factory=list)
    stuck: list[str] = field(default_factory=list)
    ends: list[str] = field(default_factory=list)
    logs: list[str] = field(default_factory=list)
    quotas: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)
    answers: list[str] = field(default_factory=list)
    absent: list[str] = field(default_factory=list)
    output: str = ""

    @property
    def findings(self) -> list[str]:
        groups = self.stuck, self.ends, self.logs, self.quotas, self.left
        absent = [f"never: {name}" for name in self.absent]
        return [text for group in (*groups, self.answers, absent) for text in group]


def judge_participant(soak: Soak, participant: Participant) -> None:
    """All that it handed in; the host runs, and nothing of it fails any more."""
    counted, run_ids = 0, set()
    for handed in participant.handed:
        soak.submissions += 1
        soak.times_s.append(handed.took_s)
        if not handed.is_ended:
            soak.stuck.append(f"{handed.name}: {handed.behaviour}, {handed.shown}")
            continue
        shown = handed.shown
        soak.states[f"{shown['state']} {shown['cause']}".strip()] += 1
        soak.ends += _wrong_ends(handed)
        lines = list(participant.log_of(handed))
        wrong = list(_wrong_logs(handed, lines))
        if shown["state"] == "completed":
            wrong += _lost_lines(handed, lines, participant.result_of(handed))
        soak.logs += [f"{handed.name}: {text}" for text in wrong]
        is_refunded = (shown["state"], shown["cause"]) == ("failed", "platform")
        counted += shown["started_at"] is not None and not is_refunded
        run_ids.add(shown["run_id"])
    if (used := participant.used()) != counted:
        soak.quotas.append(f"{participant.name}: {used} are counted, not {counted}")
    if lost := participant.run_ids() - run_ids:
        soak.quotas.append(f"{participant.name}: runs of no submission: {lost}")
    report = participant.report
    soak.answers += report.violations
    soak.answers += [
        f"{n} × {name}" for name, n in report.answers.items() if " " in name
    ]
    if report.hangs:
        soak.answers.append(f"{participant.name}: {report.hangs} hangs")


def _wrong_ends(handed: Handed) -> Iterator[str]:
    state, cause = handed.shown["state"], handed.shown["cause"]
    expected = {("completed", ""), ("failed", "platform")}
    if handed.behaviour in _WRONG_POLICIES:
        expected = {("failed", "policy"), ("failed", "platform")}
    elif handed.behaviour == "stopped":
        expected.add(("stopped", "owner"))
    if (state, cause) not in expected or not handed.shown["reason"]:
        yield f"{handed.name}: {handed.behaviour} ended as {handed.shown}"


def _wrong_logs(handed: Handed, lines: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Every line, in order, to the end of the submission."""
    if [line["number"] for line in lines] != list(range(1, len(lines) + 1)):
        yield "numbers of lines are missing"
    texts = _texts_of("platform", lines)
    end = f"State {handed.shown['state']}: {handed.shown['reason']}"
    if not lines or lines[-1]["text"] != end:
        yield f"it does not end with its end: {texts[-3:]}"
    if texts.count(end) > 1:
        yield "its end is written twice"
    yield from _gaps(handed, _texts_of("policy", lines))
    if handed.shown["state"] == "completed":
        last = max(i for i, text in enumerate(texts) if text == "The policy listens.")
        if not any(t.startswith("The sandbox has ended") for t in texts[last:]):
            yield "the end of its sandbox is missing"


def _gaps(handed: Handed, printed: Sequence[str]) -> Iterator[str]:
    """Each sandbox begins to count at 0."""
    numbers = _numbers_in(printed)
    for before, number in zip([-1, *numbers], numbers, strict=False):
        if number not in (before + 1, 0):
            yield f"line {number} follows {before}"
    is_crash = handed.behaviour == "crash" and handed.shown["cause"] == "policy"
    if is_crash and "ValueError: the weights are missing" not in printed:
        yield "the reason that the policy printed is missing"


def _lost_lines(
    handed: Handed, lines: Sequence[dict[str, Any]], result: dict[str, Any]
) -> Iterator[str]:
    """The last sandbox that played has printed each step of the result.

    An episode whose attempts are used up is abandoned (EPI-004): its last sandbox was
    lost in the middle, and the log says why each of them was.
    """
    is_abandoned = result["outcome"] == "abandoned"
    steps = result["steps"] if is_abandoned else STEPS
    numbers = _numbers_in(_texts_of("policy", lines))
    is_whole = numbers[-1:] >= [steps - 1]  # more if an episode began again
    if handed.behaviour != "image" and not is_whole:
        yield f"the lines of the last sandbox are missing: {numbers[-3:]}"
    is_before = beginning_of("evaluation").__ne__
    evaluation = dropwhile(is_before, _texts_of("platform", lines))
    lost = sum(_LOST.match(text) is not None for text in evaluation)
    if is_abandoned and lost < result["attempt"]:
        yield f"{lost} of {result['attempt']} attempts were lost for a reason"


def _texts_of(source: str, lines: Sequence[dict[str, Any]]) -> list[str]:
    return [line["text"] for line in lines if line["source"] == source]


def _numbers_in(printed: Sequence[str]) -> list[int]:
    return [int(m[1]) for text in printed if (m := _PRINTED.fullmatch(text))]


def _found(name: str, text: str, unit: str) -> Promise[Soak]:
    return Promise(
        text,
        unit,
        lambda soak: len(getattr(soak, name)),
        promised=PROMISED,
        count=lambda soak: soak.submissions,
    )


PROMISES = [
    _found("stuck", "No submission is stuck", "stuck"),
    _found("ends", "Each ends for a reason, which is its own", "wrong ends"),
    _found("logs", "Each log is complete, to the end", "logs with gaps"),
    _found("quotas", "Quotas are exact: started, not failed by the host", "wrong"),
    _found("left", "No process, group, mount or file is left", "left"),
    _found("answers", "No request is answered by a defect", "wrong answers"),
    _found("absent", "Each fault has happened", "never happened"),
]


def judge_all(soak: Soak) -> list[Verdict]:
    return judge(PROMISES, [soak], lambda _: "")


def summary(soak: Soak) -> str:
    states = ", ".join(f"{count} {name}" for name, count in sorted(soak.states.items()))
    times = [f"{percentile(soak.times_s, part):.0f}" for part in (0.5, 0.99)]
    return (
        f"{soak.submissions} submissions: {states}; from upload to end p50 "
        f"{times[0]} s, p99 {times[1]} s; {soak.faults.total()} faults"
    )


def write(soak: Soak, conditions: str) -> None:
    rows = [(name, str(soak.faults[name])) for name in FAULTS]
    table = page.table(("fault", "how often"), rows)
    found = [f"- {text}" for text in soak.findings]
    cases = [f"{summary(soak)}.\n", *table, "", *found]
    page.write("soak", conditions, judge_all(soak), cases)
