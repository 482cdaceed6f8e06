"""Mutants of the leaderboard: entries, rankings, and the history."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sqlalchemy as sa
from pydantic import MISSING

from reference_record.history.merkle_tree import MerkleTree
from reference_record.keys import make_key
from reference_server.assembly import stored_parts
from reference_server.generated import models
from reference_server.http import dispatch
from reference_server.http.auth import NO_ACCOUNT, READ_ALL, Caller
from reference_server.http.board_handlers import BoardHandlers
from reference_server.http.dispatch import OperationCall
from reference_server.records.board_history import BoardHistory
from reference_server.records.run_records import RunRecords
from reference_server.rules.board import entry_changes, ranking
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.board.ranking import Contender
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.runs import board_service
from reference_server.runs.board_service import BoardService, RankedEntries
from reference_server.storage import board_store
from reference_server.storage.board_store import BoardStore
from reference_server.storage.record_store import RecordStore
from reference_server.storage.tables import database_tables
from reference_server.views import board_views
from tests.mutants import Json, instead_of, mutant, put


@mutant(
    *("BRD-001", "BRD-004", "BRD-013", "BRD-022", "BRD-024"),
    through=instead_of(entry_changes, "publish"),
)
def keeps_the_description_of_an_entry(
    right: Any, fresh: BoardEntry, stored: BoardEntry | None, description: Json
) -> Any:
    """A link that was wrong at first stays wrong, and private entries private."""
    if stored is not None and stored.state == "published":
        return Change(stored)
    return right(fresh, stored, description)


@mutant(
    *("BRD-001", "BRD-022", "BRD-024"),
    through=instead_of(BoardHandlers, "publish_entry"),
)
async def answers_each_publish_with_201(
    right: Any, self: BoardHandlers, call: OperationCall
) -> Any:
    """A script that repeats a lost request counts an entry twice."""
    response = await right(self, call)
    response.status_code = 201
    return response


@mutant("BRD-002", through=instead_of(entry_changes, "new_entry"))
def refuses_an_incomplete_run_as_invalid(right: Any, *arguments: Any) -> Any:
    """A client corrects its request, instead of playing the run to its end."""
    verdict = right(*arguments)
    if isinstance(verdict, Refuse):
        return replace(verdict, code="invalid_request", members={})
    return verdict


@mutant("BRD-003", "BRD-013", through=instead_of(board_views, "entry_view"))
def shows_the_success_rate_as_the_score(right: Any, *arguments: Any) -> Any:
    """A graded benchmark shows a number that no run has earned."""
    view = right(*arguments)
    score = view["score"]
    return view | {"score": score | {"score": score["success_rate"]}}


@mutant("BRD-001", "BRD-024", through=instead_of(board_views, "entry_view"))
def shows_the_notes_of_an_entry_on_one_line(right: Any, *arguments: Any) -> Any:
    """A list in the notes of a submitter becomes one long line."""
    view = right(*arguments)
    notes = view.get("notes")
    return view | ({"notes": " ".join(notes.split())} if notes else {})


@mutant("BRD-003", through=instead_of(entry_changes, "_shown_of"))
def shows_one_task_for_all(right: Any, score: Json, run: Any) -> Any:
    """A policy that fails at one task seems to be equally good at each."""
    first, *_ = score["by_task"].values()
    shown = {**first, "mean": 1 - first["mean"]}
    return right(score, run) | {"by_task": dict.fromkeys(score["by_task"], shown)}


@mutant("BRD-004")
def shows_private_entries_to_every_account() -> None:
    """A competitor reads a result before its authors publish it."""
    put(entry_changes, "may_see_entry", lambda _account, _entry: True)


@mutant("BRD-004", through=instead_of(entry_changes, "withdraw"))
def shows_a_private_entry_that_is_withdrawn(
    right: Any, stored: BoardEntry, at_wall: float
) -> Any:
    """A user who takes back a private result thereby publishes it."""
    change = right(stored, at_wall)
    shown = {**change.entry.description, "is_public": True}
    return replace(change, entry=replace(change.entry, description=shown))


@mutant("BRD-004", "BRD-008", "BRD-009", "BRD-010")
def ranks_withdrawn_entries() -> None:
    """A result that its authors took back goes on to be compared."""
    right, seen = BoardStore.of_manifest, dict[str, dict[str, BoardEntry]]()

    async def wrong(self: BoardStore, benchmark_id: str, sha256: str) -> Any:
        published = await right(self, benchmark_id, sha256)
        entries = seen.setdefault(sha256, {})
        entries |= {entry.entry_id: entry for entry in published}
        for entry_id in list(entries):
            now = await self.find(entry_id)
            if now is None or not now.is_public:
                del entries[entry_id]
        return list(entries.values())

    put(BoardStore, "of_manifest", wrong)


@mutant("BRD-004", "BRD-005", "BRD-006", through=instead_of(BoardStore, "find"))
async def forgets_entries_that_were_withdrawn(
    right: Any, self: BoardStore, entry_id: str
) -> Any:
    """A row that was on the leaderboard yesterday was never there."""
    entry = await right(self, entry_id)
    return None if entry is None or entry.state == "withdrawn" else entry


@mutant("BRD-006", through=instead_of(entry_changes, "publish"))
def publishes_again_after_a_withdrawal(
    right: Any, fresh: BoardEntry, stored: BoardEntry | None, description: Json
) -> Any:
    """A result is on the leaderboard on the days on which it is good to be there."""
    if stored is not None:
        stored = replace(stored, state="published")
    return right(fresh, stored, description)


@mutant("BRD-022")
def takes_one_result_for_several_rows() -> None:
    """Who publishes ten runs of one policy has the first ten places."""
    put(board_store, "has_same_result", lambda _entry, _earlier: False)


@mutant("BRD-007", through=instead_of(BoardService, "page"))
async def lists_the_oldest_entry_of_a_page_first(
    right: Any, self: BoardService, *arguments: Any
) -> Any:
    """The newest entry is looked for at the top, and is at the bottom."""
    return (await right(self, *arguments))[::-1]


@mutant("BRD-007", through=instead_of(BoardStore, "page"))
async def lists_entries_of_every_benchmark(
    right: Any, self: BoardStore, account: str | None, _: Any, before: Any, limit: int
) -> Any:
    """A page of one benchmark has rows of others."""
    return await right(self, account, None, before, limit)


@mutant("BRD-008", "BRD-010", through=instead_of(ranking, "_order"))
def orders_rows_by_successes(_right: Any, contender: Contender) -> Any:
    """A leaderboard that is read by scores is not sorted by them."""
    return -(contender.successes or 0).bit_count(), 0, contender.number


@mutant("BRD-008")
def keeps_a_ranking_while_its_length_stays() -> None:
    """A new entry is not shown, and one that was withdrawn is shown in its place."""
    right, last = BoardService._ranked, dict[str, RankedEntries]()

    async def wrong(self: BoardService, benchmark_id: str, sha256: str) -> Any:
        ranked = await right(self, benchmark_id, sha256)
        previous = last.get(sha256)
        if previous is None or len(previous.contenders) != len(ranked.contenders):
            last[sha256] = ranked
        return last[sha256]

    put(BoardService, "_ranked", wrong)


@mutant("BRD-009", "BRD-010", through=instead_of(ranking, "_distinguish"))
def tests_each_pair_as_if_it_were_the_only_one(
    _right: Any, successes: Sequence[int]
) -> Any:
    """Some of a hundred entries of one policy are said to be better than others."""
    better, worse = [0] * len(successes), [0] * len(successes)
    for _, winner, loser in ranking._candidates(successes):
        better[loser] |= 1 << winner
        worse[winner] |= 1 << loser
    return better, worse


@mutant("BRD-009", through=instead_of(board_service, "rank"))
def gives_each_row_its_place_as_rank(right: Any, *arguments: Any) -> Any:
    """The second of two policies that cannot be distinguished is said to be second."""
    ranking = right(*arguments)
    rows = [
        replace(row, rank=(place, place))
        for place, row in enumerate(ranking.rows, start=1)
    ]
    return replace(ranking, rows=rows)


@mutant("BRD-011", through=instead_of(board_views, "ranking_view"))
def says_that_six_episodes_are_enough(right: Any, *arguments: Any) -> Any:
    """A benchmark is made too small to distinguish what it was made for."""
    return right(*arguments) | {"differing_enough": 6}


@mutant("BRD-013", through=instead_of(entry_changes, "publish"))
def writes_private_entries_into_the_history(right: Any, *arguments: Any) -> Any:
    """A result that its authors keep to themselves is read by every other account."""
    verdict = right(*arguments)
    is_shown = isinstance(verdict, Refuse) or verdict.entry.is_public
    if is_shown or verdict.leaf is not None:
        return verdict
    return replace(verdict, leaf=entry_changes._leaf("publish", verdict.entry))


@mutant("BRD-023", through=instead_of(board_store, "canonical_json"))
def writes_leaves_as_its_language_does(right: Any, members: Json) -> bytes:
    """A reader in another language cannot write the leaf that it expects."""
    return bytes(right(members)).replace(b'"score":1', b'"score":1.0')


@mutant("BRD-014")
def signs_checkpoints_with_a_key_of_its_own() -> None:
    """Any server could have signed it: the host has never shown this key."""
    key = make_key()
    right = BoardHistory.sign

    async def wrong(self: BoardHistory) -> Any:
        put(RunRecords, "key", property(lambda _: key))
        return await right(self)

    put(BoardHistory, "sign", wrong)


@mutant("BRD-014", "BRD-015", "BRD-016")
def hashes_leaves_without_their_prefix() -> None:
    """A node can be passed off as a leaf, and a proof of what was never published."""
    put(stored_parts, "leaf_hash", lambda leaf: hashlib.sha256(leaf).digest())


@mutant("BRD-015", "BRD-016")
def gives_the_hashes_of_proofs_from_the_root() -> None:
    """A verifier calls an honest history a forgery."""
    for name in ("inclusion", "consistency"):
        right = getattr(MerkleTree, name)

        def wrong(self: MerkleTree, *sizes: int, right: Any = right) -> Any:
            return right(self, *sizes)[::-1]

        put(MerkleTree, name, wrong)


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
            hashes: Json = await proof(self, first, min(size, len(tree)))
            return hashes

        put(BoardService, method, clamped)

    put(BoardService, "_tree_of", wrong)
    clamp("inclusion")
    clamp("consistency")


@mutant("BRD-018")
def shows_private_entries_without_a_token() -> None:
    """A private result is there for everyone without an account."""
    put(dispatch, "NO_ACCOUNT", Caller("", frozenset({"read", READ_ALL})))


@mutant("BRD-018", through=instead_of(dispatch, "_caller"))
def reads_the_board_with_any_token(
    right: Any, request: Any, operation: Any, scope: str, tokens: Any
) -> Any:
    """A script does not notice that its token was revoked."""
    try:
        return right(request, operation, scope, tokens)
    except Refused:
        if operation.without_token:
            return NO_ACCOUNT
        raise


@mutant("BRD-019", through=instead_of(RecordStore, "attempts_of"))
async def counts_no_attempt_that_was_deleted(
    _right: Any, self: RecordStore, accounts: Any, benchmarks: Any
) -> Any:
    """An account that deletes nineteen of twenty runs seems to have tried once."""
    runs = database_tables.runs.c
    of = (runs.account, runs.benchmark_id)
    query = sa.select(*of, sa.func.max(runs.attempts_by_submitter))
    there = runs.deleted_at_wall.is_(None), runs.account.in_(accounts)
    query = query.where(*there, runs.benchmark_id.in_(benchmarks)).group_by(*of)
    return await self._transactions.read(
        lambda c: {(a, b): n for a, b, n in c.execute(query)}
    )


@mutant("BRD-020")
def takes_links_of_any_scheme() -> None:
    """A click on a homepage runs a script in the page of the leaderboard."""

    class AnyLinks(models.PublishEntry):
        homepage: str | MISSING = MISSING
        code_url: str | MISSING = MISSING

    put(models, "PublishEntry", AnyLinks)


@mutant("BRD-021", through=instead_of(BoardService, "rank"))
async def ranks_nothing_for_an_unknown_benchmark(
    right: Any, self: BoardService, benchmark_id: str, *rest: Any
) -> Any:
    """A name with a typing error looks like a benchmark without entries."""
    try:
        return await right(self, benchmark_id, *rest)
    except Refused:
        body, count = await right(self, "calibration", "0" * 64, 0, 1)
        return body | {"benchmark_id": benchmark_id}, count
