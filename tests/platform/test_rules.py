"""Tables of decisions: accounts, tracks and their quotas, states of a submission."""

from __future__ import annotations

import dataclasses
import typing
from pathlib import Path
from typing import Any

import msgspec
import pytest

from reference_platform.accounts.account_rules import (
    DECISIONS,
    Account,
    AccountState,
    Decision,
    decide,
)
from reference_platform.accounts.organisations import Owner
from reference_platform.command_line.challenge_command import main
from reference_platform.parts import Parts
from reference_platform.submissions import lifecycle
from reference_platform.submissions.lifecycle import (
    AFTER_ENDS,
    FINAL,
    OWNERS,
    STATES,
    TRANSITIONS,
    WAITING,
    Event,
    IllegalTransition,
    State,
    Submission,
)
from reference_platform.tracks.served_benchmarks import note_served
from reference_platform.tracks.track_rules import (
    DAY_S,
    AskedRun,
    Phase,
    Place,
    Track,
    TrackRun,
    check_track,
    choose_phase,
    said_time,
)
from reference_record.texts.timestamps import timestamp
from reference_server.rules.refusal import Refused
from tests.support.paths import ROOT

NOW = 1_800_000_000.0


def account(state: AccountState) -> Account:
    return Account(
        "ada", "A", "B", "a@b.org", None, "both", False, NOW, "", "participant", state,
        "", NOW, None,
    )  # fmt: skip


@pytest.mark.parametrize("state", typing.get_args(AccountState))
@pytest.mark.parametrize("decision", typing.get_args(Decision))
def test_a_decision_is_in_the_table(state: AccountState, decision: Decision) -> None:
    expected = DECISIONS[state].get(decision)
    if expected is None:
        with pytest.raises(Refused, match="is not possible"):
            decide(account(state), decision, "a reason")
        return
    assert decide(account(state), decision, "a reason") == expected
    if decision in ("reject", "suspend"):
        with pytest.raises(Refused, match="needs a reason"):
            decide(account(state), decision, " ")


# --- submissions ---


def submission(state: State) -> Submission:
    waiting = WAITING.get(state)
    deadline = None if waiting is None else NOW + waiting.deadline_s
    return Submission(
        "sub_1", "ada", "letters", "image", state, NOW, NOW, deadline, "",
        is_counted=state in ("queued", "running"),
    )  # fmt: skip


@pytest.mark.parametrize("state", STATES)
@pytest.mark.parametrize("event", typing.get_args(Event))
def test_an_event_is_in_the_table(state: State, event: Event) -> None:
    expected = TRANSITIONS[state].get(event)
    if expected is None:
        with pytest.raises(IllegalTransition):
            lifecycle.apply(submission(state), event, NOW)
        return
    after = lifecycle.apply(submission(state), event, NOW, cause="owner")
    assert after.state == expected
    assert (after.deadline_at is None) == (expected in FINAL)


@pytest.mark.parametrize("state", STATES)
def test_every_state_ends(state: State) -> None:
    """A submission that is not final has a reason, a next action and a deadline."""
    assert (state in FINAL) == (state not in WAITING) == (not TRANSITIONS[state])
    causes = {cause for after, cause in AFTER_ENDS if after == state}
    assert (state in FINAL) == bool(causes)
    assert all(bool(OWNERS[cause]) == (state != "completed") for cause in causes)
    if state in FINAL:
        assert lifecycle.at_deadline(submission(state), NOW * 2) is None
        return
    waiting = WAITING[state]
    assert lifecycle.at_deadline(submission(state), NOW) is None
    ended = lifecycle.at_deadline(submission(state), NOW + waiting.deadline_s)
    assert ended is not None
    assert ended.state in FINAL
    assert waiting.reason in ended.reason
    assert not (ended.is_counted and ended.cause == "platform")


@pytest.mark.parametrize(
    ("cause", "is_counted"), [("policy", True), ("platform", False), ("host", True)]
)
def test_a_fault_of_the_platform_gives_the_quota_back(
    cause: lifecycle.Cause, is_counted: bool
) -> None:
    """Counted from the start on, which is after the verification."""
    after = submission("verified")
    assert not after.is_counted
    events: tuple[Event, ...] = ("start", "begin_run")
    for event in events:
        after = lifecycle.apply(after, event, NOW)
        assert after.is_counted
    failed = lifecycle.apply(after, "fail", NOW, cause=cause)
    assert failed.is_counted == is_counted


# --- tracks ---

PHASE = Phase(
    "main", "calibration", NOW - DAY_S, NOW + DAY_S, per_day=2, total=4, at_once=1
)
TRACK = Track("letters", "Letters", (PHASE,))
HERE = Place(TRACK, PHASE)
RUN = AskedRun("run_9", "ada", "calibration")


def runs(*ages_s: float, state: str = "completed") -> list[TrackRun]:
    return [
        TrackRun("r", "letters", "ada", NOW - age, state, None, "main")
        for age in ages_s
    ]


def track_of(**changed: object) -> Track:
    """The track with a phase that differs from PHASE."""
    phase = msgspec.structs.replace(PHASE, **changed)
    return msgspec.structs.replace(TRACK, phases=(phase,))


def refusal(track: Track, asked: AskedRun = RUN, *made: TrackRun) -> Refused:
    with pytest.raises(Refused) as caught:
        choose_phase([track], asked, made, NOW)
    return caught.value


@pytest.mark.parametrize(
    ("track", "asked", "words"),
    [
        ({}, {"benchmark_id": "tabletop"}, "No track of this account"),
        ({}, {"splits": ("a",)}, "without `select`"),
        ({}, {"tasks": ("a",)}, "without `select`"),
        ({"splits": ("a", "b")}, {"splits": ("a",)}, "the splits a, b"),
        ({"splits": ("a",)}, {}, "the split a"),
        (
            {"opens_at": NOW + 1},
            {},
            "not open now. It opens at 2027-01-15 08:00:01 UTC",
        ),
        ({"seeds": "held_out"}, {}, "Hand the policy in"),
        ({"options": {"length": 3}}, {}, 'with `options` {"length":3}'),
        ({"closes_at": NOW}, {}, "not open now. It closed at 2027-01-15 08:00:00 UTC"),
    ],
    ids=str,
)
def test_a_run_outside_of_a_track_is_refused(
    track: dict[str, object], asked: dict[str, object], words: str
) -> None:
    refused = refusal(track_of(**track), msgspec.structs.replace(RUN, **asked))
    assert refused.code == "forbidden"
    assert words in refused.detail
    assert "scope" not in refused.sentences
    assert choose_phase([TRACK], RUN, [], NOW) == HERE


@pytest.mark.parametrize(
    ("phase", "command"),
    [
        ({}, "run --policy POLICY --benchmark calibration"),
        ({"splits": ("a", "b")}, "run … --benchmark calibration --split a,b"),
        (
            {"options": {"max_steps": 3}},
            """run … --benchmark calibration --options '{"max_steps":3}'""",
        ),
        (
            {"seeds": "held_out", "splits": ("a",)},
            "submit --track letters --phase main --code FOLDER --preset PRESET",
        ),
    ],
    ids=str,
)
def test_a_refusal_has_the_whole_command_of_the_phase(
    phase: dict[str, object], command: str
) -> None:
    """A run of a task is made, which no phase evaluates; or any, of held-out seeds."""
    command = command.replace("run …", "run --policy POLICY")
    track = track_of(**phase)
    asked = msgspec.structs.replace(RUN, splits=track.phases[0].splits)
    if not track.phases[0].is_held_out:
        asked = msgspec.structs.replace(asked, tasks=("a",))
    with pytest.raises(Refused) as caught:
        choose_phase([track], asked, [], NOW, "https://h.example")
    said = f"Do it with `proctor {command} --url https://h.example`."
    assert caught.value.act == said
    assert said.replace(" --url https://h.example", "") == refusal(track, asked).act


@pytest.mark.parametrize(
    ("made", "limit", "resets_at", "act"),
    [
        (runs(10, 50), "per_day", NOW - 50 + DAY_S, "Repeat it then"),
        (runs(10, 50, 90), "per_day", NOW - 50 + DAY_S, "Repeat it then"),
        (runs(*[2 * DAY_S] * 4), "total", None, "used up for good"),
        (runs(5, state="running"), "at_once", None, "or stop one"),
        (runs(DAY_S, state="admitted"), "at_once", None, "or stop one"),
    ],
    ids=str,
)
def test_a_limit_says_when_it_opens(
    made: list[TrackRun], limit: str, resets_at: float | None, act: str
) -> None:
    refused = refusal(TRACK, RUN, *made)
    assert (refused.code, refused.members["limit"]) == ("quota_exceeded", limit)
    expected = None if resets_at is None else timestamp(resets_at)
    assert refused.members.get("resets_at") == expected
    assert expected is None or said_time(resets_at or 0.0) in refused.detail
    assert act in refused.act
    assert "Idempotency-Key" not in refused.sentences


@pytest.mark.parametrize(
    "made",
    [runs(10), runs(DAY_S, DAY_S + 1), runs(1, 2, 3, 4, 5, state="refunded")],
    ids=str,
)
def test_a_limit_that_is_not_reached_admits(made: list[TrackRun]) -> None:
    assert choose_phase([TRACK], RUN, made, NOW) == HERE


def test_the_track_with_room_is_chosen() -> None:
    """Two tracks evaluate the same; the one that closes first is used up."""
    late = msgspec.structs.replace(PHASE, closes_at=NOW + 2 * DAY_S)
    later = msgspec.structs.replace(TRACK, track_id="later", phases=(late,))
    assert choose_phase([later, TRACK], RUN, runs(10), NOW) == HERE
    assert choose_phase([later, TRACK], RUN, runs(10, 20), NOW) == Place(later, late)


@pytest.mark.parametrize(
    "changed",
    [
        {"track_id": "A B"},
        {"title": " "},
        {"phases": ()},
        {"phases": (PHASE, PHASE)},
        {"phases/0/closes_at": 0.0},
        {"phases/0/per_day": 0},
        {"phases/0/phase_id": "A"},
    ],
    ids=str,
)
def test_a_wrong_track_is_refused(changed: dict[str, Any]) -> None:
    check_track(TRACK)
    name, value = next(iter(changed.items()))
    member = name.rpartition("/")[2]
    track = (
        msgspec.structs.replace(TRACK, **{member: value})
        if member == name
        else (track_of(**{member: value}))
    )
    with pytest.raises(Refused, match=name):
        check_track(track)


def test_the_track_of_the_manual_is_right(parts: Parts) -> None:
    page = (ROOT / "docs" / "host" / "challenge.md").read_text()
    text = page.split("```toml\n")[1].split("```")[0]
    file = parts.database.path.with_name("letters.toml")
    assert put_track(parts, file, text) == 0
    development, test = parts.tracks.get("letters").phases
    assert development.per_day == 5
    assert test.is_held_out


TRACK_FILE = """
track_id = "letters"
title = "Letters"
[[phases]]
phase_id = "main"
benchmark_id = "calibration"
opens_at = 2026-01-01T00:00:00Z
closes_at = 2027-01-01T00:00:00Z
"""


def put_track(parts: Parts, file: Path, text: str) -> int:
    """Write the file of a track and put it, by the command; its exit code."""
    file.write_text(text)
    where = ["--database", str(parts.database.path)]
    return main(["track", "put", str(file), *where])


VALUES = "at_once, after_close, never"
SERVED = {"calibration": ["even", "odd"], "tabletop": ["val_train", "test"]}
MOMENT = "write a date with its time in UTC, such as 2026-01-01T00:00:00Z"


def with_members(members: str) -> tuple[str, str]:
    """The change that adds members to the phase of the file."""
    return '= "main"', f'= "main"\n{members}'


def on_tabletop(members: str) -> tuple[str, str]:
    return '"calibration"', f'"tabletop"\n{members}'


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("2027-01", "2025-01"), "phases/0/closes_at must be after opens_at"),
        (('= "main"', '= "main"\nper_day = 0'), "phases/0/per_day must be 1 or more"),
        (('"main"', '"A B"'), "phases/0/phase_id must be a letter and up to 63"),
        (
            ('= "main"', '= "main"\nscore = "atonce"'),
            f"/score: unknown value atonce; did you mean at_once? There is {VALUES}",
        ),
        (("title", "titel"), "unknown name titel; did you mean title? There is track_"),
        (('title = "Letters"', ""), "title is missing"),
        (('"Letters"', "1"), "title: Expected text, got a whole number"),
        (
            ("calibration", "calibratoin"),
            "unknown benchmark calibratoin; did you mean calibration? There is",
        ),
        (
            with_members('splits = ["odd", "eve"]'),
            "unknown split of calibration: eve; did you mean even? There is even, odd",
        ),
        (
            on_tabletop('splits = ["tst"]'),
            "unknown split of tabletop: tst; did you mean test? There is val_train",
        ),
        (
            with_members("options = {max_step = 3}"),
            "unknown option max_step; did you mean max_steps? There is tasks, max_st",
        ),
        (
            with_members('options = {success_rule = "anystep"}'),
            "option with a wrong value, success_rule: unknown value anystep; did you",
        ),
        (
            with_members('options = {tasks = ["scor"]}'),
            "option with a wrong value, tasks/0: unknown value scor; did you mean sc",
        ),
        (
            on_tabletop("options = {max_steps = 3}"),
            "an option that its benchmark does not take: max_steps",
        ),
        (("2026-01-01T00:00:00Z", "2026-01-01"), f"phases/0/opens_at: {MOMENT}"),
        (("2027-01-01T00:00:00Z", "2027-01-01T00:00:00"), f"/closes_at: {MOMENT}"),
        (("2026-01-01T00:00:00Z", '"2026-01-01T00:00:00Z"'), f"/opens_at: {MOMENT}"),
        (("2026-01-01T00:00:00Z", "00:00:00"), f"phases/0/opens_at: {MOMENT}"),
        (("2026-01-01T00:00:00Z", "5"), f"phases/0/opens_at: {MOMENT}"),
        (('"Letters"', "Letters"), "is not valid TOML: Invalid value (at line 3, col"),
        (("[[phases]]", "phases = 5\n[more]"), "phases: Expected a list, got a whole"),
        (("[[phases]]", "[phases]"), "got a table; begin each of its tables with [[ph"),
    ],
    ids=str,
)
def test_a_file_of_a_track_is_refused_in_words(
    parts: Parts,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    change: tuple[str, str],
    said: str,
) -> None:
    """The file, the member, what is wrong, and what is allowed."""
    note_served(parts.database, SERVED)
    file = tmp_path / "letters.toml"
    assert put_track(parts, file, TRACK_FILE.replace(*change)) == 2
    refused = capsys.readouterr().err
    assert str(file) in refused
    assert said in refused
    assert not parts.tracks.all()
    assert put_track(parts, file, TRACK_FILE) == 0, "the control"


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("title", 'entry = "listed"\ntitle'), "`accounts` is empty, so no account c"),
        (
            ("title", 'entry = "listed"\naccounts = ["ada"]\ntitle'),
            "There is no account or organisation ada",
        ),
        (("title", 'accounts = ["ada"]\ntitle'), "`accounts` has no effect without"),
        (("2027", "2026-01-02T00:00:00Z #"), "The phase main closed at 2026-01-02 00"),
        (("title", "title"), ""),
    ],
    ids=str,
)
def test_a_track_that_may_be_a_mistake_is_put_with_a_warning(
    parts: Parts,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    change: tuple[str, str],
    said: str,
) -> None:
    note_served(parts.database, SERVED)
    file = tmp_path / "letters.toml"
    assert put_track(parts, file, TRACK_FILE.replace(*change)) == 0
    written = capsys.readouterr()
    assert written.out == "track letters\n"
    assert said in written.err
    assert written.err.count("\n") == bool(said)
    put_track(parts, file, TRACK_FILE.replace(*change))
    assert "The phase" not in capsys.readouterr().err, "it is not a new one"


def test_a_missing_file_of_a_track_is_named(
    parts: Parts, capsys: pytest.CaptureFixture[str]
) -> None:
    where = ["--database", str(parts.database.path)]
    assert main(["track", "put", "nofile.toml", *where]) == 2
    assert capsys.readouterr().err == "proctor: there is no file nofile.toml\n"


def test_a_phase_stays_when_its_benchmark_changes(parts: Parts) -> None:
    """The server has another version later. Expect that other phases are checked."""
    note_served(parts.database, SERVED)
    first = msgspec.structs.replace(PHASE, splits=("even",))
    parts.tracks.put(track_of(splits=("even",)), "a test")
    note_served(parts.database, {"calibration": ["easy"]})
    more = msgspec.structs.replace(first, phase_id="more", splits=("odd",))
    track = msgspec.structs.replace(TRACK, title="New", phases=(first,))
    parts.tracks.put(track, "a test")
    assert parts.tracks.get(TRACK.track_id).title == "New"
    with pytest.raises(Refused, match="unknown split of calibration: odd"):
        parts.tracks.put(msgspec.structs.replace(track, phases=(first, more)), "a test")


async def test_a_track_that_nothing_has_entered_is_deleted(
    parts: Parts, ada: str, capsys: pytest.CaptureFixture[str]
) -> None:
    parts.tracks.put(TRACK, "a test")
    delete = ["track", "delete", TRACK.track_id]
    where = ["--database", str(parts.database.path)]
    parts.tracks.enter(TRACK.track_id, Owner(ada))
    assert main([*delete, *where]) == 2
    assert "has entrants, so it stays" in capsys.readouterr().err
    parts.tracks.put(msgspec.structs.replace(TRACK, track_id="typo"), "a test")
    assert main(["track", "delete", "typo", *where]) == 0
    assert [track.track_id for track in parts.tracks.all()] == [TRACK.track_id]


async def test_a_track_that_another_process_deletes_is_not_entered(
    parts: Parts, ada: str
) -> None:
    """Or who entered it would have entered the next track of this name, too."""
    parts.tracks.put(TRACK, "a test")

    def delete_meanwhile() -> float:
        parts.tracks.delete(TRACK.track_id, "a test")
        return parts.clock()

    tracks = dataclasses.replace(parts.tracks, clock=delete_meanwhile)
    with pytest.raises(Refused, match="track letters"):
        tracks.enter(TRACK.track_id, Owner(ada))
    assert parts.tracks.entrant(TRACK.track_id, ada) is None
