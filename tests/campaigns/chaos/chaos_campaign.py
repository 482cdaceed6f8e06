"""Rounds: a fault while players play, a repair, a pause of all players, a verdict."""

from __future__ import annotations

import contextlib
import itertools
import tempfile
import time
from collections.abc import Iterable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from contextlib import AbstractContextManager
from pathlib import Path
from random import Random
from typing import Any, Self

from tests.campaigns.campaign_server import WATCHER
from tests.campaigns.chaos.chaos_faults import FAULTS, HOSTS, RAY, Fault
from tests.campaigns.chaos.chaos_rounds import Counts, Round
from tests.campaigns.chaos.cluster_player import ClusterPlayer
from tests.campaigns.chaos.clusters.chaos_cluster import ChaosCluster
from tests.campaigns.chaos.clusters.host_cluster import HostCluster
from tests.campaigns.chaos.clusters.linked_cluster import LinkedCluster
from tests.campaigns.chaos.push_player import PushPlayer, scripted_policy
from tests.campaigns.chaos.write_audit import RecordAudit, WriteAudit
from tests.campaigns.players.invariants import check_histories
from tests.campaigns.players.raw_client import Answer, NoAnswer, RawClient

NODES = 3
# Until a round has failed: the players do not go on.
GOING_MAX_S = 60.0
# Turns of each player after a fault, and after its repair.
AFTER_FAULT, AFTER_REPAIR = 5, 2
# Each host of a node has its own disk for recordings, or all share a folder.
OWN_DISKS = "own disks"
TRACEBACK_CHARACTERS = 3000


def open_cluster(
    directory: Path, kinds: AbstractSet[str], lease_s: float, seed: int
) -> AbstractContextManager[ChaosCluster]:
    if HOSTS not in kinds:
        return LinkedCluster.open(
            directory, size=NODES, lease_s=lease_s, seed=seed, ray=RAY in kinds
        )
    own_disks = OWN_DISKS in kinds
    return HostCluster.open(
        directory, size=NODES, lease_s=lease_s, seed=seed, own_disks=own_disks
    )


class Campaign:
    """Opened by `open`; `play` as many rounds as wanted."""

    def __init__(
        self, cluster: ChaosCluster, seed: int, players: int, policy_url: str
    ) -> None:
        self._cluster, self._seed = cluster, seed
        self._audit = WriteAudit(cluster)
        self._records = RecordAudit(cluster, cluster.directory)
        self._judged: set[str] = set()
        self._tracebacks = [0] * NODES
        self._players: list[ClusterPlayer] = []
        self._failed: list[ClusterPlayer] = []
        self._policy_url = policy_url
        self._add_player(PushPlayer)
        for _ in range(players):
            self._add_player(ClusterPlayer)

    @classmethod
    @contextlib.contextmanager
    def open(
        cls,
        *,
        seed: int,
        players: int,
        lease_s: float,
        kinds: AbstractSet[str] = frozenset(),
    ) -> Iterator[Self]:
        """kinds: of the cluster, of RAY, HOSTS and OWN_DISKS."""
        with (
            tempfile.TemporaryDirectory(prefix="chaos-") as directory,
            open_cluster(Path(directory), kinds, lease_s, seed) as cluster,
            cluster.open_policy(scripted_policy) as policy,
        ):
            campaign = cls(cluster, seed, players, policy.url)
            campaign._wait_for_operations(time.monotonic(), 1)
            try:
                yield campaign
            finally:
                for player in campaign._players:
                    player.end()

    def _add_player(self, kind: type[ClusterPlayer]) -> None:
        name = f"player{len(self._players) + len(self._failed)}"
        timeout_s = self._cluster.lease_s + 1
        player = kind(self._cluster.url, self._seed, name, timeout_s)
        player.policy_url = self._policy_url
        self._players.append(player)
        player.start()

    def play(self, number: int, names: Sequence[str]) -> Round:
        """One of these faults, chosen by the seed and the number of the round."""
        chance = Random(f"{self._seed} {number}")
        weights = [FAULTS[name].weight for name in names]
        fault = FAULTS[chance.choices(names, weights)[0]]
        return self.play_fault(number, fault, chance)

    def play_fault(self, number: int, fault: Fault, chance: Random) -> Round:
        played = Round(number, fault)
        happens = fault.happens(self._cluster, chance)
        broken = next(happens)
        played.count, since = broken.count, broken.since
        self._wait_for_operations(since, AFTER_FAULT, played)
        ended_at = time.monotonic()
        played.waits_s = [
            _longest_wait(player, since, ended_at) for player in self._players
        ]
        next(happens, None)
        self._wait_for_operations(time.monotonic(), AFTER_REPAIR, played)
        played.findings += self._judge()
        self._replace_failed()
        return played

    def _replace_failed(self) -> None:
        failed = [player for player in self._players if not player.is_alive]
        for player in failed:
            player.end()
            self._players.remove(player)
            self._failed.append(player)
            self._add_player(type(player))

    def logs(self) -> list[str]:
        """The log of each node, from its first start on."""
        return self._cluster.logs()

    def counts(self) -> Counts:
        players = self._players + self._failed
        return Counts(
            sum(len(player.histories) for player in players),
            sum(len(player.samples) for player in players),
            self._audit.claims,
            sum(player.compared for player in players),
            self._audit.rows,
            self._records.records,
        )

    def _wait_for_operations(
        self, since: float, count: int, played: Round | None = None
    ) -> None:
        """Until each player has begun and ended so many turns since then."""
        deadline = time.monotonic() + GOING_MAX_S
        waiting = list(self._players)
        while waiting:
            waiting = [
                one
                for one in waiting
                if one.is_alive and _count_since(one, since) < count
            ]
            if waiting and time.monotonic() > deadline:
                names = ", ".join(one.name for one in waiting)
                found = f"{names} did not go on in {GOING_MAX_S} s"
                assert played is not None, found
                played.findings.append(found)
                return
            time.sleep(0.01)

    def _judge(self) -> list[str]:
        """While no player does anything, and no node plays a run."""
        found = []
        for player in self._players:
            player.hold()
        deadline = time.monotonic() + GOING_MAX_S
        while not all(one.is_held or not one.is_alive for one in self._players):
            if time.monotonic() > deadline:
                found.append("an operation did not end")
                break
            time.sleep(0.01)
        found += self._audit.judge()
        found += self._judge_histories()
        found += self._judge_events()
        found += self._judge_answers()
        for player in self._players:
            player.release()
        return found

    def _judge_histories(self) -> list[str]:
        """Judge the runs that were played since the last time."""
        histories = [
            history
            for player in self._players
            for history in player.histories
            if history.run_id not in self._judged
        ]
        self._judged |= {history.run_id for history in histories if history.is_done}
        timeout_s = self._cluster.lease_s + 1
        try:
            with _RetryingClient(
                self._cluster.url, WATCHER, timeout_s=timeout_s
            ) as client:
                found = check_histories(client, histories, is_fault_expected=True)
                done = [history for history in histories if history.is_done]
                return [*found, *self._records.judge(client, done)]
        except (NoAnswer, OSError) as error:
            return [f"the runs cannot be read: {error!r}"]

    def _judge_events(self) -> Iterator[str]:
        for player in self._players:
            for run_id, follower in list(player.followers.items()):
                yield from follower.judge(GOING_MAX_S)
                if run_id in self._judged:
                    player.followers.pop(run_id).close()

    def _judge_answers(self) -> Iterator[str]:
        for player in self._players:
            yield from player.report.violations
            player.report.violations.clear()
            if player.report.wrong_5xx:
                yield f"{player.name} was answered {dict(player.report.answers)}"
                player.report.answers.clear()
        for number, log in enumerate(self._cluster.logs()):
            tracebacks = log.split("Traceback")[1:]
            for text in tracebacks[self._tracebacks[number] :]:
                yield f"node {number}: Traceback{text[:TRACEBACK_CHARACTERS]}"
            self._tracebacks[number] = len(tracebacks)


def play_faults(names: Iterable[str], **options: Any) -> Counts:
    """One round of each fault; every finding is an AssertionError."""
    with Campaign.open(lease_s=1.0, **options) as campaign:
        rounds = [
            campaign.play_fault(number, FAULTS[name], Random(number))
            for number, name in enumerate(names)
        ]
        findings = [text for played in rounds for text in played.findings]
        assert not findings, "\n".join(findings)
        assert all(played.waits_s for played in rounds)
        return campaign.counts()


class _RetryingClient(RawClient):
    """Repeats what was not answered: a node may just have come back."""

    def request(self, *request: Any, **headers: Any) -> Answer:
        deadline = time.monotonic() + GOING_MAX_S
        while True:
            is_last = time.monotonic() > deadline
            try:
                answer = super().request(*request, **headers)
            except (NoAnswer, OSError):
                if is_last:
                    raise
            else:
                if answer.status != 503 or is_last:
                    return answer
            time.sleep(0.05)


def _count_since(player: ClusterPlayer, since: float) -> int:
    """Begun since then: an answer to what was asked before shows nothing."""
    count = 0
    for sample in reversed(player.samples):
        if sample.began_at < since:
            break
        count += player.turns_of_sample
    return count


def _longest_wait(player: ClusterPlayer, since: float, ended_at: float) -> float:
    ends = [sample.began_at + sample.took_s for sample in player.samples]
    moments = [since, *(end for end in ends if end > since), ended_at]
    return max(later - earlier for earlier, later in itertools.pairwise(moments))
