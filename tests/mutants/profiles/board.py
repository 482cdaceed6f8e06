"""Mutants of the leaderboard: entries, rankings, and the history."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sqlalchemy as sa
from pydantic import MISSING
from starlette.responses import Response

from reference_record.formats.merkle_tree import MerkleTree
from reference_record.keys import make_key
from reference_server import app
from reference_server.generated import models
from reference_server.http import dispatch
from reference_server.http.auth import NO_ACCOUNT, READ_ALL, Caller
from reference_server.http.board_handlers import BoardHandlers
from reference_server.http.dispatch import OperationCall
from reference_server.records.board_history import BoardHistory
from reference_server.records.run_records import RunRecords
from reference_server.rules.board import entry_changes, ranking
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.board.ranking import Contender, Ranking, Row
from reference_server.rules.lifecycle import Refuse
from reference_server.rules.refusal import Refused
from reference_server.runs import board_service
from reference_server.runs.board_service import BoardService, RankedEntries
from reference_server.storage import database_tables
from reference_server.storage.board_store import BoardStore
from reference_server.storage.store import Store
from reference_server.views import board_views
from tests.mutants import mutant, put

Json = dict[str, Any]


@mutant("BRD-001", "BRD-004", "BRD-013")
def keeps_the_description_of_an_entry() -> None:
    """A link that was wrong at first stays wrong, and private entries private."""
    right = entry_changes.publish

    def wrong(fresh: BoardEntry, stored: BoardEntry | None, description: Json) -> Any:
        if stored is not None and stored.state == "published":
            return Change(stored)
        return right(fresh, stored, description)

    put(entry_changes, "publish", wrong)


@mutant("BRD-001")
def answers_each_publish_with_201() -> None:
    """A script that repeats a lost request counts an entry twice."""
    right = BoardHandlers.publish_entry

    async def wrong(self: BoardHandlers, call: OperationCall) -> Response:
        response = await right(self, call)
        response.status_code = 201
        return response

    put(BoardHandlers, "publish_entry", wrong)


@mutant("BRD-002")
def refuses_an_incomplete_run_as_invalid() -> None:
    """A client corrects its request, instead of playing the run to its end."""
    right = entry_changes.new_entry

    def wrong(*arguments: Any) -> Any:
        verdict = right(*arguments)
        if isinstance(verdict, Refuse):
            return replace(verdict, code="invalid_request", members={})
        return verdict

    put(entry_changes, "new_entry", wrong)


def change_view(change: Any) -> None:
    """Let `change(view)` spoil every entry that is shown."""
    right = board_views.entry_view

    def wrong(entry: BoardEntry, attempts: int) -> Json:
        view = right(entry, attempts)
        change(view)
        return view

    put(board_views, "entry_view", wrong)


@mutant("BRD-003", "BRD-013")
def shows_the_success_rate_as_the_score() -> None:
    """A graded benchmark shows a number that no run has earned."""

    def wrong(view: Json) -> None:
        score = view["score"]
        view["score"] = score | {"score": score["success_rate"]}

    change_view(wrong)


@mutant("BRD-003")
def shows_one_task_for_all() -> None:
    """A policy that fails at one task seems to be equally good at each."""
    put(
        entry_changes,
        "_shown_of",
        lambda score, right=entry_changes._shown_of: (
            right(score)
            | {"by_task": dict.fromkeys(score["by_task"], _of_the_first(score))}
        ),
    )


def _of_the_first(score: Json) -> Json:
    first, *_ = score["by_task"].values()
    return {**first, "mean": 1 - first["mean"]}


@mutant("BRD-001", "BRD-003")
def escapes_names_for_html() -> None:
    """A terminal shows `&lt;` where the name has `<`."""
    change_view(
        lambda view: view.update(model_name=view["model_name"].replace("<", "&lt;"))
    )


@mutant("BRD-004")
def shows_private_entries_to_every_account() -> None:
    """A competitor reads a result before its authors publish it."""
    put(entry_changes, "may_see_entry", lambda _account, _entry: True)


@mutant("BRD-004")
def shows_a_private_entry_that_is_withdrawn() -> None:
    """Who takes back a result that no one else has seen thereby publishes it."""
    right = entry_changes.withdraw

    def wrong(stored: BoardEntry, at_wall: float) -> Change:
        change = right(stored, at_wall)
        shown = {**change.entry.description, "is_public": True}
        return replace(change, entry=replace(change.entry, description=shown))

    put(entry_changes, "withdraw", wrong)


@mutant("BRD-004", "BRD-008")
def ranks_private_entries() -> None:
    """A private result stands on the public leaderboard."""
    right = BoardStore.of_manifest

    async def wrong(self: BoardStore, benchmark_id: str, sha256: str) -> Any:
        found = await right(self, benchmark_id, sha256)
        more = await self.page(None, benchmark_id, None, 1000)
        private = [one for one in more if not one.is_public]
        return found + [one for one in private if one.manifest_sha256 == sha256]

    put(BoardStore, "of_manifest", wrong)


@mutant("BRD-005", "BRD-008", "BRD-009", "BRD-010")
def ranks_withdrawn_entries() -> None:
    """A result that its authors took back goes on to be compared."""
    right, seen = BoardStore.of_manifest, dict[str, dict[str, BoardEntry]]()

    async def wrong(self: BoardStore, benchmark_id: str, sha256: str) -> Any:
        found = await right(self, benchmark_id, sha256)
        entries = seen.setdefault(sha256, {})
        entries |= {one.entry_id: one for one in found}
        for entry_id in list(entries):
            now = await self.find(entry_id)
            if now is None or not now.is_public:
                del entries[entry_id]
        return list(entries.values())

    put(BoardStore, "of_manifest", wrong)


@mutant("BRD-004", "BRD-005", "BRD-006")
def forgets_entries_that_were_withdrawn() -> None:
    """A row that was on the leaderboard yesterday was never there."""
    right = BoardStore.find

    async def wrong(self: BoardStore, entry_id: str) -> BoardEntry | None:
        found = await right(self, entry_id)
        return None if found is None or found.state == "withdrawn" else found

    put(BoardStore, "find", wrong)


@mutant("BRD-006")
def publishes_again_after_a_withdrawal() -> None:
    """A result is on the leaderboard on the days on which it is good to be there."""
    right = entry_changes.publish

    def wrong(fresh: BoardEntry, stored: BoardEntry | None, description: Json) -> Any:
        if stored is not None:
            stored = replace(stored, state="published")
        return right(fresh, stored, description)

    put(entry_changes, "publish", wrong)


@mutant("BRD-006")
def accepts_a_withdrawn_entry_as_it_was() -> None:
    """A script that repeats its request believes that the result is shown."""
    right = entry_changes.publish

    def wrong(fresh: BoardEntry, stored: BoardEntry | None, description: Json) -> Any:
        if stored is not None and stored.description == description:
            return Change(stored)
        return right(fresh, stored, description)

    put(entry_changes, "publish", wrong)


@mutant("BRD-007")
def lists_the_oldest_entry_of_a_page_first() -> None:
    """The newest entry is looked for at the top, and is at the bottom."""
    right = BoardService.page

    async def wrong(self: BoardService, *arguments: Any) -> list[tuple[int, Json]]:
        return (await right(self, *arguments))[::-1]

    put(BoardService, "page", wrong)


@mutant("BRD-007")
def lists_entries_of_every_benchmark() -> None:
    """A page of one benchmark has rows of others."""
    right = BoardStore.page

    async def wrong(
        self: BoardStore, account: str | None, _: Any, before: Any, limit: int
    ) -> list[BoardEntry]:
        return await right(self, account, None, before, limit)

    put(BoardStore, "page", wrong)


@mutant("BRD-008")
def orders_rows_by_successes() -> None:
    """A leaderboard that is read by scores is not sorted by them."""

    def wrong(one: Contender) -> tuple[float, int, int]:
        return -(one.successes or 0).bit_count(), 0, one.number

    put(ranking, "_order", wrong)


@mutant("BRD-008")
def orders_equal_scores_by_publication_alone() -> None:
    """Of two policies with one score, the one that succeeds less stands first."""

    def wrong(one: Contender) -> tuple[float, int]:
        return -one.score, one.number

    put(ranking, "_order", wrong)


@mutant("BRD-008")
def keeps_a_ranking_while_its_length_stays() -> None:
    """A new entry is not shown, and one that was withdrawn is shown in its place."""
    right, last = BoardService._ranked, dict[str, RankedEntries]()

    async def wrong(self: BoardService, benchmark_id: str, sha256: str) -> Any:
        found = await right(self, benchmark_id, sha256)
        kept = last.get(sha256)
        if kept is None or len(kept.contenders) != len(found.contenders):
            last[sha256] = found
        return last[sha256]

    put(BoardService, "_ranked", wrong)


@mutant("BRD-008")
def begins_each_page_of_a_ranking_at_the_top() -> None:
    """The fourth row is never seen, and the first is seen on every page."""
    right = BoardService.rank

    async def wrong(
        self: BoardService, benchmark_id: str, sha256: str | None, _: int, limit: int
    ) -> tuple[Json, int]:
        return await right(self, benchmark_id, sha256, 0, limit)

    put(BoardService, "rank", wrong)


@mutant("BRD-008", "BRD-009", "BRD-013")
def takes_every_score_above_zero_for_a_success() -> None:
    """A policy that never reaches its goal is said to be as good as one that does."""
    right = entry_changes.new_entry

    def wrong(entry_id: str, run: Any, episodes: Sequence[Any], at: float) -> Any:
        verdict = right(entry_id, run, episodes, at)
        if isinstance(verdict, Refuse):
            return verdict
        scores = [one.result.score for one in episodes if one.result]
        return replace(verdict, successes="".join("01"[s > 0] for s in scores))

    put(entry_changes, "new_entry", wrong)


@mutant("BRD-009", "BRD-010")
def tests_each_pair_as_if_it_were_the_only_one() -> None:
    """With a hundred entries of one policy, some are said to be better than others."""

    def wrong(successes: Sequence[int]) -> tuple[list[int], list[int]]:
        better, worse = [0] * len(successes), [0] * len(successes)
        for _, winner, loser in ranking._candidates(successes):
            better[loser] |= 1 << winner
            worse[winner] |= 1 << loser
        return better, worse

    put(ranking, "_distinguish", wrong)


def change_rows(change: Any) -> None:
    """Let `change(place, row)` spoil every row that has a rank."""
    right = ranking.rank

    def wrong(contenders: Sequence[Contender], episodes_total: int) -> Ranking:
        found = right(contenders, episodes_total)
        rows = [change(*one) for one in enumerate(found.rows, start=1)]
        return replace(found, rows=rows)

    put(board_service, "rank", wrong)


@mutant("BRD-009")
def gives_each_row_its_place_as_rank() -> None:
    """The second of two policies that cannot be distinguished is said to be second."""
    change_rows(lambda place, row: replace(row, rank=(place, place)))


@mutant("BRD-010")
def gives_every_row_one_letter() -> None:
    """The best policy and the worst one are said to be the same."""
    change_rows(lambda _, row: replace(row, letters=("a",)))


@mutant("BRD-010")
def gives_every_row_a_letter_of_its_own() -> None:
    """Two runs of one policy are said to differ."""

    def wrong(place: int, row: Row) -> Row:
        return replace(row, letters=(ranking._letter(place - 1),))

    change_rows(wrong)


def change_head(**members: Any) -> None:
    """Replace members of every ranking."""
    right = board_views.ranking_view

    def wrong(*arguments: Any) -> Json:
        return right(*arguments) | members

    put(board_views, "ranking_view", wrong)


@mutant("BRD-011")
def says_that_six_episodes_are_enough() -> None:
    """A benchmark is made too small to distinguish what it was made for."""
    change_head(differing_enough=6)


@mutant("BRD-011")
def says_a_resolution_that_the_benchmark_does_not_have() -> None:
    """Five episodes are said to be enough for policies that differ on six."""
    change_head(differing_min=6)


def change_leaf(change: Any) -> None:
    """Let `change(verdict)` spoil what publishing does to the history."""
    right = entry_changes.publish

    def wrong(fresh: BoardEntry, stored: BoardEntry | None, description: Json) -> Any:
        verdict = right(fresh, stored, description)
        return verdict if isinstance(verdict, Refuse) else change(verdict)

    put(entry_changes, "publish", wrong)


@mutant("BRD-013")
def writes_private_entries_into_the_history() -> None:
    """A result that its authors keep to themselves is read by every other account."""

    def wrong(verdict: Change) -> Change:
        if verdict.leaf is None and not verdict.entry.is_public:
            return replace(verdict, leaf=entry_changes._leaf("publish", verdict.entry))
        return verdict

    change_leaf(wrong)


@mutant("BRD-013")
def hides_an_entry_without_a_trace() -> None:
    """A row leaves the leaderboard, and the history does not say that it was there."""

    def wrong(verdict: Change) -> Change:
        is_hidden = verdict.leaf is not None and verdict.leaf["kind"] == "hide"
        return replace(verdict, leaf=None) if is_hidden else verdict

    change_leaf(wrong)


@mutant("BRD-014")
def signs_checkpoints_with_a_key_of_its_own() -> None:
    """Any server could have signed it: the host has never shown this key."""
    key = make_key()
    right = BoardHistory.sign

    async def wrong(self: BoardHistory) -> Any:
        put(RunRecords, "key", property(lambda _: key))
        return await right(self)

    put(BoardHistory, "sign", wrong)


@mutant("BRD-014")
def repeats_the_first_checkpoint() -> None:
    """A reader is never shown that the history went on."""
    right, first = BoardHistory.sign, list[Any]()

    async def wrong(self: BoardHistory) -> Any:
        if not first:
            first.append(await right(self))
        return first[0]

    put(BoardHistory, "sign", wrong)


@mutant("BRD-014", "BRD-015", "BRD-016")
def hashes_leaves_without_their_prefix() -> None:
    """A node can be passed off as a leaf, and a proof of what was never published."""
    put(app, "leaf_hash", lambda leaf: hashlib.sha256(leaf).digest())


def reverse(name: str) -> None:
    """Give the hashes of a proof from the other end."""
    right = getattr(MerkleTree, name)

    def wrong(self: MerkleTree, *arguments: int) -> list[bytes]:
        found: list[bytes] = right(self, *arguments)
        return found[::-1]

    put(MerkleTree, name, wrong)


@mutant("BRD-015")
def gives_the_path_of_a_leaf_from_the_root() -> None:
    """A verifier calls an honest history a forgery."""
    reverse("inclusion")


@mutant("BRD-016")
def gives_a_consistency_proof_from_the_root() -> None:
    """A verifier calls an honest history rewritten."""
    reverse("consistency")


@mutant("BRD-017")
def proves_for_the_whole_history_when_asked_for_more() -> None:
    """A verifier of a size that was never signed is not warned."""
    right = BoardService._tree_of

    async def wrong(self: BoardService, name: str, size: int) -> MerkleTree:
        tree = await self._history.tree()
        return await right(self, name, min(size, len(tree)))

    def clamp(method: str) -> None:
        proof = getattr(BoardService, method)

        async def clamped(self: BoardService, first: int, size: int) -> Json:
            tree = await self._history.tree()
            found: Json = await proof(self, first, min(size, len(tree)))
            return found

        put(BoardService, method, clamped)

    put(BoardService, "_tree_of", wrong)
    clamp("inclusion")
    clamp("consistency")


@mutant("BRD-018")
def shows_private_entries_without_a_token() -> None:
    """A private result is there for everyone without an account."""
    put(dispatch, "NO_ACCOUNT", Caller("", frozenset({"read", READ_ALL})))


@mutant("BRD-018")
def reads_the_board_with_any_token() -> None:
    """A script does not notice that its token was revoked."""
    right = dispatch._caller

    def wrong(request: Any, operation: Any, scope: str, tokens: Any) -> Caller:
        try:
            return right(request, operation, scope, tokens)
        except Refused:
            if operation.without_token:
                return NO_ACCOUNT
            raise

    put(dispatch, "_caller", wrong)


@mutant("BRD-019")
def counts_one_attempt_for_every_entry() -> None:
    """The best of twenty runs looks like the only one."""
    change_view(lambda view: view.update(attempts=1))


@mutant("BRD-019")
def counts_no_attempt_that_was_deleted() -> None:
    """Who deletes nineteen of twenty runs seems to have tried once."""

    async def wrong(self: Store, accounts: Any, benchmarks: Any) -> Any:
        runs = database_tables.runs.c
        of = (runs.account, runs.benchmark_id)
        query = sa.select(*of, sa.func.max(runs.attempts_by_submitter))
        there = runs.deleted_at_wall.is_(None), runs.account.in_(accounts)
        query = query.where(*there, runs.benchmark_id.in_(benchmarks)).group_by(*of)
        async with self._transaction() as connection:
            found = await connection.execute(query)
        return {(account, benchmark): n for account, benchmark, n in found}

    put(Store, "attempts_of", wrong)


@mutant("BRD-020")
def takes_links_of_any_scheme() -> None:
    """A click on a homepage runs a script in the page of the leaderboard."""

    class AnyLinks(models.PublishEntry):
        homepage: str | MISSING = MISSING
        code_url: str | MISSING = MISSING

    put(models, "PublishEntry", AnyLinks)


@mutant("BRD-021")
def ranks_nothing_for_an_unknown_benchmark() -> None:
    """A name with a typing error looks like a benchmark without entries."""
    right = BoardService.rank

    async def wrong(self: BoardService, benchmark_id: str, *rest: Any) -> Any:
        try:
            return await right(self, benchmark_id, *rest)
        except Refused:
            body, count = await right(self, "calibration", "0" * 64, 0, 1)
            return body | {"benchmark_id": benchmark_id}, count

    put(BoardService, "rank", wrong)
