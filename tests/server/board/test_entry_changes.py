"""What may become of an entry, and which changes the history has."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import pytest

from reference_record.generated.answers import Outcome
from reference_server.rules.board import entry_changes
from reference_server.rules.board.entry_changes import BoardEntry, Change, Flag
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.runs.run import Recording, Result, Run
from tests.support.server.runs import make_run

PUBLIC = {"model_name": "A", "is_public": True}
PRIVATE = {"model_name": "A", "is_public": False}
LATER = 2000.0


def completed_run(*outcomes: Outcome, is_recorded: bool = True) -> Run:
    run = make_run(len(outcomes), state="completed")
    run.manifest["version"] = "1"
    for episode, outcome in zip(run.episodes, outcomes, strict=True):
        score = 0.5 if outcome == "failure" else 1.0
        episode.result = Result(outcome, score, 1, 1, True, False, 0.0, 1e9)
        digest = "d" if is_recorded else None
        episode.recording = Recording("0" * 64, 1, 1, digest, digest, {})
    return run


def fresh_entry(*outcomes: Outcome, **how: bool) -> BoardEntry:
    run = completed_run(*outcomes or ("success", "failure"), **how)
    entry = entry_changes.new_entry("entry_1", run, run.episodes, 1000.0)
    assert isinstance(entry, BoardEntry)
    return entry


def change(verdict: Change | Refuse) -> tuple[BoardEntry, Any]:
    assert isinstance(verdict, Change)
    return verdict.entry, verdict.leaf and verdict.leaf["kind"]


def published(description: dict[str, Any] = PUBLIC) -> BoardEntry:
    return change(entry_changes.publish(fresh_entry(), None, description))[0]


def test_an_entry_has_what_is_ranked_and_shown() -> None:
    entry = fresh_entry("success", "failure", "abandoned", "success")
    assert entry.successes == "1001"
    assert entry.score["score"] == 2.5 / 4
    assert set(entry.score) == {
        *("score", "success_rate", "success_interval", "mean_interval", "counts"),
        *("by_task", "by_split"),
    }
    assert entry.level == "signed"
    assert fresh_entry(is_recorded=False).level == "reported"


def test_an_entry_shows_no_more_groups_than_a_row_may_have() -> None:
    outcomes: list[Outcome] = ["success"] * (entry_changes.GROUPS_MAX + 1)
    run = completed_run(*outcomes)
    for number, episode in enumerate(run.episodes):
        episode.task, episode.split = f"task {number}", f"split {number}"
    entry = entry_changes.new_entry("entry_1", run, run.episodes, 1000.0)
    assert isinstance(entry, BoardEntry)
    assert {"by_task", "by_split"}.isdisjoint(entry.score)


def test_an_entry_says_that_people_judged() -> None:
    run = completed_run("success")
    run.manifest["physical"] = {}
    entry = entry_changes.new_entry("entry_1", run, run.episodes, 1000.0)
    assert isinstance(entry, BoardEntry)
    assert entry.score["judged_by"] == "people"


@pytest.mark.parametrize("state", ["ready", "running", "stopped", "failed"])
def test_only_a_completed_run_is_published(state: str) -> None:
    run = make_run(1, state=state)
    verdict = entry_changes.new_entry("entry_1", run, run.episodes, 1000.0)
    assert isinstance(verdict, Refuse)
    assert (verdict.code, verdict.members) == ("illegal_transition", {"state": state})


def test_a_repeat_changes_nothing() -> None:
    entry = published()
    again = entry_changes.publish(fresh_entry(), entry, PUBLIC)
    assert change(again) == (entry, None)


@pytest.mark.parametrize(
    ("before", "after", "kind"),
    [
        (None, PUBLIC, "publish"),
        (None, PRIVATE, None),
        (PUBLIC, PUBLIC | {"notes": "n"}, "change"),
        (PUBLIC, PRIVATE, "hide"),
        (PRIVATE, PUBLIC, "publish"),
        (PRIVATE, PRIVATE | {"notes": "n"}, None),
    ],
)
def test_the_history_has_what_others_could_see(
    before: dict[str, Any] | None, after: dict[str, Any], kind: str | None
) -> None:
    stored = None if before is None else published(before)
    fresh = replace(fresh_entry(), entry_id="entry_2", changed_at_wall=LATER)
    entry, found = change(entry_changes.publish(fresh, stored, after))
    assert found == kind
    assert entry.description == after
    assert entry.changed_at_wall == LATER
    assert entry.entry_id == ("entry_2" if stored is None else "entry_1")


def test_a_result_is_that_of_one_policy_of_one_account() -> None:
    """BRD-022. An entry that an earlier version stored has no digest, and is none."""
    entry = replace(published(), run_id="run_2", result_sha256="a")
    same = replace(entry, run_id="run_1", entry_id="entry_9", description=PRIVATE)
    assert entry_changes.has_same_result(entry, same)
    for other in (
        replace(same, run_id=entry.run_id),
        replace(same, account="bob"),
        replace(same, manifest_sha256="0"),
        replace(same, policy={"name": "another"}),
        replace(same, result_sha256="b"),
    ):
        assert not entry_changes.has_same_result(entry, other)
    unknown = replace(entry, result_sha256="")
    assert not entry_changes.has_same_result(unknown, replace(unknown, run_id="run_1"))
    refused = entry_changes.already_published(same)
    assert (refused.code, refused.members) == (
        "result_published",
        {"entry_id": "entry_9"},
    )


def test_what_is_kept_for_good_is_bounded() -> None:
    """An account cannot fill the disk with changes; a withdrawal is always possible."""
    entry = replace(published(), changes=entry_changes.CHANGES_MAX - 1)
    entry, kind = change(
        entry_changes.publish(fresh_entry(), entry, PUBLIC | {"notes": "n"})
    )
    assert kind == "change"
    refused = entry_changes.publish(fresh_entry(), entry, PUBLIC)
    assert isinstance(refused, Refuse)
    assert refused.code == "quota_exceeded"
    assert change(entry_changes.withdraw(entry, LATER))[1] == "withdraw"


def test_a_leaf_says_all_that_a_ranking_needs() -> None:
    verdict = entry_changes.publish(fresh_entry(), None, PUBLIC)
    assert isinstance(verdict, Change)
    assert verdict.leaf is not None
    assert verdict.leaf["successes"] == "10"
    assert verdict.leaf["description"] == PUBLIC
    assert verdict.leaf["at_ms"] == 1_000_000


def test_a_withdrawal_is_for_good() -> None:
    entry, kind = change(entry_changes.withdraw(published(), LATER))
    assert (entry.state, kind) == ("withdrawn", "withdraw")
    assert change(entry_changes.withdraw(entry, 3000.0)) == (entry, None)
    refused = entry_changes.publish(fresh_entry(), entry, PUBLIC)
    assert isinstance(refused, Refuse)
    assert refused.code == "entry_withdrawn"
    _, kind = change(entry_changes.withdraw(published(PRIVATE), LATER))
    assert kind is None


def test_a_flag_is_set_replaced_and_taken_back() -> None:
    entry = published()

    def flag(stored: BoardEntry, *, flagged: bool, reason: str) -> Any:
        verdict = entry_changes.flag(
            stored, flagged=flagged, reason=reason, at_wall=LATER
        )
        return change(verdict)

    assert flag(entry, flagged=False, reason="r") == (entry, None)
    flagged, kind = flag(entry, flagged=True, reason="r")
    assert (flagged.flag.reason, kind) == ("r", "flag")
    assert flag(flagged, flagged=True, reason="r") == (flagged, None)
    assert flag(flagged, flagged=True, reason="s")[1] == "flag"
    cleared, kind = flag(flagged, flagged=False, reason="mended")
    assert (cleared.flag, kind) == (None, "unflag")
    private = entry_changes.flag(
        published(PRIVATE), flagged=True, reason="r", at_wall=LATER
    )
    assert isinstance(private, Refuse)
    assert private.code == "not_found"


def test_a_leaf_counts_for_the_account_that_caused_it() -> None:
    """The host's flags count for no account."""
    verdicts = (
        entry_changes.publish(fresh_entry(), None, PUBLIC),
        entry_changes.publish(fresh_entry(), published(), PRIVATE),
        entry_changes.withdraw(published(), LATER),
        entry_changes.flag(published(), flagged=True, reason="r", at_wall=LATER),
    )
    counted = {}
    for verdict in verdicts:
        assert isinstance(verdict, Change)
        assert verdict.leaf is not None
        counted[verdict.leaf["kind"]] = entry_changes.is_of_account(verdict.leaf)
    assert counted == {"publish": True, "hide": True, "withdraw": True, "flag": False}


def test_a_flag_stays_while_the_entry_is_private_until_it_is_taken_back() -> None:
    """Hidden after it was flagged. Expect the flag, and that the host can remove it."""
    flagged = replace(published(), flag=Flag("r", LATER))
    hidden, kind = change(entry_changes.publish(fresh_entry(), flagged, PRIVATE))
    assert (hidden.flag, kind) == (flagged.flag, "hide")
    again, kind = change(entry_changes.publish(fresh_entry(), hidden, PUBLIC))
    assert (again.flag, kind) == (flagged.flag, "publish")
    flag = partial(entry_changes.flag, hidden, reason="s", at_wall=LATER)
    cleared, kind = change(flag(flagged=False))
    assert (cleared.flag, kind) == (None, "unflag")
    for refused in (
        flag(flagged=True),
        entry_changes.flag(cleared, flagged=False, reason="s", at_wall=LATER),
    ):
        assert isinstance(refused, Refuse)
        assert refused.code == "not_found"


def test_who_sees_an_entry() -> None:
    public, private = published(), published(PRIVATE)
    for account in ("alice", "bob", "", None):
        assert entry_changes.may_see_entry(account, public)
        sees = account in ("alice", None)
        assert entry_changes.may_see_entry(account, private) is sees
