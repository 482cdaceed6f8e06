"""The use cases of the leaderboard: publish, withdraw, flag, list, rank, prove.

The rules decide what may become of an entry; the store keeps it with its leaf. It knows
no HTTP. All methods raise Refused, and StoreFailed when the database fails.
"""

from __future__ import annotations

import asyncio
import secrets
import time
from collections import OrderedDict
from collections.abc import Awaitable, Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from reference_record.generated import answers
from reference_record.history.merkle_tree import MerkleTree
from reference_server.files.seed_secret import SeedSecret
from reference_server.records.board_history import BoardHistory
from reference_server.rules.board import entry_changes as rules
from reference_server.rules.board.entry_changes import BoardEntry, Change
from reference_server.rules.board.ranking import Contender, Ranking, rank
from reference_server.rules.board.seed_draws import DrawLeaf, next_leaf
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.runs.benchmarks import Benchmarks, no_benchmark
from reference_server.runs.registry import RunRegistry
from reference_server.storage.board_store import (
    BoardStore,
    Changed,
    RunDeleted,
    SameResult,
)
from reference_server.views import board_views
from reference_sim.host_seeds import draw_key

CACHED_RANKINGS_MAX = 64


@dataclass(frozen=True, slots=True)
class RankedEntries:
    """The public entries of a manifest by id, and their ranking."""

    entries: Mapping[str, BoardEntry]
    contenders: Sequence[Contender]
    ranking: Ranking
    episodes_total: int | None


def no_judges(_run_id: str) -> answers.JudgedRun | None:
    """The default of `judged`: no person judges."""
    return None


class BoardService:
    """The use cases over one server's parts."""

    def __init__(
        self,
        registry: RunRegistry,
        benchmarks: Benchmarks,
        store: BoardStore,
        history: BoardHistory,
        *,
        check_publication: Callable[[str, str], Awaitable[None]] | None = None,
        seed_secret: SeedSecret | None = None,
        judged: Callable[[str], answers.JudgedRun | None] = no_judges,
    ) -> None:
        """check_publication: raises Refused if a run of an account may not be public;
        None if every one may. seed_secret: for draws of seeds. judged: how people
        judged a run.
        """
        self._judged = judged
        self._check_publication = check_publication
        self._seed_secret = seed_secret or SeedSecret()
        self._registry, self._benchmarks = registry, benchmarks
        self._store, self._history = store, history
        # (benchmark, manifest) → its ranking; one computation at a time.
        self._rankings: OrderedDict[tuple[str, str], RankedEntries] = OrderedDict()
        self._ranking = asyncio.Lock()

    # --- entries ---

    async def publish(
        self, account: str, run_id: str, description: Mapping[str, Any]
    ) -> tuple[answers.BoardEntry, bool]:
        """The entry, and whether it is new."""
        entry_id = f"entry_{secrets.token_hex(12)}"
        fresh = await self._registry.reader.read_view(
            run_id,
            account,
            lambda run, all_: rules.new_entry(entry_id, run, all_, time.time()),
            end=None,
        )
        if isinstance(fresh, Refuse):
            raise Refused.from_verdict(fresh)
        if description["is_public"] and self._check_publication is not None:
            await self._check_publication(account, run_id)

        def decide(stored: BoardEntry | None) -> Change:
            return _accepted(rules.publish(fresh, stored, description))

        try:
            changed = await self._change(
                run_id, decide, needs_run=True, check=self._registry.usage.check_kept
            )
        except SameResult as error:
            raise Refused.from_verdict(
                rules.already_published(error.earlier)
            ) from error
        except RunDeleted as error:
            raise Refused("not_found", f"There is no run {run_id}.") from error
        return await self._view(changed.entry), changed.is_new

    async def withdraw(self, account: str, run_id: str) -> answers.BoardEntry:
        """The entry, withdrawn for good."""
        # A run of another account is refused as any run is (AUTH-003).
        await self._registry.reader.read_view(run_id, account, lambda run, _: run)

        def decide(stored: BoardEntry | None) -> Change:
            if stored is None:
                raise Refused("not_found", "The run has no entry.")
            return rules.withdraw(stored, time.time())

        changed = await self._change(run_id, decide)
        return await self._view(changed.entry)

    async def flag(
        self, entry_id: str, *, flagged: bool, reason: str
    ) -> answers.BoardEntry:
        """The entry, with a flag or without one."""
        entry = await self._find(entry_id)

        def decide(stored: BoardEntry | None) -> Change:
            assert stored is not None, "an entry is never removed"
            at = time.time()
            verdict = rules.flag(stored, flagged=flagged, reason=reason, at_wall=at)
            return _accepted(verdict)

        changed = await self._change(entry.run_id, decide)
        return await self._view(changed.entry)

    async def append_of_draw(self, asked: DrawLeaf) -> tuple[int, bytes]:
        """The index of the leaf, and the root of those in front of it.

        A repeat changes nothing.
        """
        key = draw_key(self._seed_secret.value, asked.draw_id)

        def decide(earlier: Sequence[Mapping[str, Any]]) -> Mapping[str, Any] | int:
            for leaf in earlier:
                if asked.is_same(leaf):
                    return int(leaf["index"])
            following = next_leaf(asked, earlier, key, time.time())
            if isinstance(following, Refuse):
                raise Refused.from_verdict(following)
            return following

        index = await self._store.append_of_draw(asked.draw_id, decide)
        return index, (await self._history.tree()).root(index)

    async def _change(
        self, run_id: str, decide: Callable[[BoardEntry | None], Change], **how: Any
    ) -> Changed:
        """Store the change with `BoardStore.change`, and count it for the account.

        Neither is undone when the caller is cancelled: a stored entry is counted.
        """

        async def store() -> Changed:
            changed = await self._store.change(run_id, decide, **how)
            usage = self._registry.usage
            usage.note_kept(changed.entry.account, changed.kept_bytes)
            return changed

        return await self._registry.work.run_to_end(store())

    async def entry_id_of_run(self, run_id: str) -> str | None:
        """The id of its entry, withdrawn or not; `get` decides who may see it."""
        entry = await self._store.find_of_run(run_id)
        return None if entry is None else entry.entry_id

    async def get(self, account: str | None, entry_id: str) -> answers.BoardEntry:
        """The entry, which the account may see."""
        entry = await self._find(entry_id)
        if not rules.may_see_entry(account, entry):
            raise _no_entry(entry_id)
        return await self._view(entry)

    async def page(
        self,
        account: str | None,
        benchmark_id: str | None,
        before: int | None,
        limit: int,
    ) -> list[tuple[int, answers.BoardEntry]]:
        """(number, schema BoardEntry), newest first, below a number (BRD-007)."""
        entries = await self._store.page(account, benchmark_id, before, limit)
        views = await self._views(entries)
        return [
            (entry.number, view) for entry, view in zip(entries, views, strict=True)
        ]

    # --- ranking ---

    async def rank(
        self, benchmark_id: str, manifest_sha256: str | None, start: int, limit: int
    ) -> tuple[answers.Ranking, int]:
        """Schema Ranking with its rows from a place on, and how many there are.

        BRD-021: a benchmark that left the server keeps its ranking.
        """
        if manifest_sha256 is None:
            manifest_sha256 = self._benchmarks.manifest_sha256(benchmark_id)
        ranked = await self._ranked(benchmark_id, manifest_sha256)
        if not ranked.entries and not self._benchmarks.offers(benchmark_id):
            raise no_benchmark(benchmark_id)
        rows = ranked.ranking.rows[start : start + limit]
        views = await self._views([ranked.entries[row.entry_id] for row in rows])
        head = board_views.ranking_view(
            benchmark_id, manifest_sha256, ranked.episodes_total, ranked.ranking
        )
        shown = zip(rows, views, strict=True)
        head["rows"] = [board_views.row_view(row, entry) for row, entry in shown]
        return head, len(ranked.ranking.rows)

    async def _ranked(self, benchmark_id: str, manifest_sha256: str) -> RankedEntries:
        """Computed once for a set of entries, while others are served."""
        key = benchmark_id, manifest_sha256
        async with self._ranking:
            entries = await self._store.of_manifest(*key)
            contenders = [_contender(entry) for entry in entries]
            by_id = {entry.entry_id: entry for entry in entries}
            total = len(entries[0].successes) if entries else None
            cached = self._rankings.get(key)
            if cached is not None and cached.contenders == contenders:
                ranking = cached.ranking
            else:
                ranking = await asyncio.to_thread(rank, contenders, total or 0)
            ranked = RankedEntries(by_id, contenders, ranking, total)
            self._rankings[key] = ranked
            self._rankings.move_to_end(key)
            if len(self._rankings) > CACHED_RANKINGS_MAX:
                self._rankings.popitem(last=False)
        return ranked

    # --- history ---

    async def checkpoint(self) -> answers.Checkpoint:
        """The signed state of the history."""
        return board_views.checkpoint_view(*await self._history.sign())

    async def leaves(self, start: int, limit: int) -> list[answers.HistoryLeaf]:
        """The leaves from an index on."""
        leaves = await self._store.leaves(start, limit)
        return [{"index": start + i, "leaf": leaf} for i, leaf in enumerate(leaves)]

    async def inclusion(
        self, leaf_index: int, tree_size: int
    ) -> answers.InclusionProof:
        """The proof that the history has a leaf (BRD-015)."""
        tree = await self._tree_of("tree_size", tree_size)
        if leaf_index >= tree_size:
            raise _outside("leaf_index", "must be below tree_size")
        hashes = [node.hex() for node in tree.inclusion(leaf_index, tree_size)]
        return {"leaf_index": leaf_index, "tree_size": tree_size, "hashes": hashes}

    async def consistency(
        self, old_size: int, new_size: int
    ) -> answers.ConsistencyProof:
        """The proof that the history only grew (BRD-016)."""
        tree = await self._tree_of("new_size", new_size)
        if not 0 < old_size <= new_size:
            raise _outside("old_size", "must be from 1 to new_size")
        hashes = [node.hex() for node in tree.consistency(old_size, new_size)]
        return {"old_size": old_size, "new_size": new_size, "hashes": hashes}

    async def _tree_of(self, name: str, size: int) -> MerkleTree:
        """The tree, which has as many leaves (BRD-017)."""
        tree = await self._history.tree()
        if size > len(tree):
            raise _outside(name, f"the history has {len(tree)} leaves")
        return tree

    # --- parts ---

    async def _find(self, entry_id: str) -> BoardEntry:
        entry = await self._store.find(entry_id)
        if entry is None:
            raise _no_entry(entry_id)
        return entry

    async def _view(self, entry: BoardEntry) -> answers.BoardEntry:
        (view,) = await self._views([entry])
        return view

    async def _views(self, entries: Sequence[BoardEntry]) -> list[answers.BoardEntry]:
        attempts = await self._store.attempts(entries)
        return [
            board_views.entry_view(
                entry,
                attempts.get((entry.account, entry.benchmark_id)) or 1,
                self._judged(entry.run_id),
            )
            for entry in entries
        ]


def _contender(entry: BoardEntry) -> Contender:
    """BRD-012: a flagged entry has no rank."""
    successes = None if entry.flag else int(entry.successes[::-1], 2)
    return Contender(entry.entry_id, entry.number, entry.score["score"], successes)


def _accepted(verdict: Change | Refuse) -> Change:
    if isinstance(verdict, Refuse):
        raise Refused.from_verdict(verdict)
    return verdict


def _no_entry(entry_id: str) -> Refused:
    return Refused("not_found", f"There is no entry {entry_id[:64]}.")


def _outside(name: str, text: str) -> Refused:
    return Refused(
        "invalid_request",
        "The history has no such part.",
        errors=[(f"query:{name}", text)],
        requirement="BRD-017",
    )
