"""SIGKILL of the server inside runs of 8 workers: the record of each is whole and true.

A worker gives each action a number of its own, so a turn that was answered can be found
in the recordings. A run that is completed is exported, verified and simulated again.
"""

from __future__ import annotations

import itertools
import random
import signal
import time
from collections import Counter
from collections.abc import Iterator
from typing import Any

import msgspec

from reference_record.formats.bundle import Bundle
from reference_record.formats.names import MANIFEST, is_recording
from reference_record.recordings.mcap_reader import McapReader
from reference_sim import benchmark_registry
from reference_sim.replay.episode_replay import replay_episode
from reference_sim.replay.record_replay import resolve
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attacks.process_kills import server_of
from tests.campaigns.campaign_server import WATCHER
from tests.campaigns.players.invariants import check_histories
from tests.campaigns.players.raw_client import Answer, RawClient
from tests.campaigns.players.records import (
    WrongRecord,
    missing_results,
    missing_turns,
    verified_record,
)
from tests.campaigns.players.run_history import History, Report
from tests.campaigns.players.watcher import Ended, Player

WORKERS, EPISODES_OF_A_RUN = 8, 48
RUN_S = 120.0  # for a run to end after the last kill
NUMBER = "vector"  # the part of an action that has its number


class NumberingPlayer(Player):
    """One of several workers of a run, which plays until the run is completed.

    history: of the run, which its workers share. answered: numbers of the actions whose
    turn arrived.
    """

    def __init__(self, target: Target, number: int) -> None:
        super().__init__(target.url, target.seed, f"worker{number}", EPISODES_OF_A_RUN)
        self.worker = f"w{number}"
        self.history = History("", EPISODES_OF_A_RUN)
        self.answered: list[float] = []
        self._numbers = itertools.count(1_000_000 * number)

    def submit(self) -> History:
        return self._submit()

    def _submission(self) -> dict[str, Any]:
        return super()._submission() | {"max_workers": WORKERS}

    def step(self) -> None:
        turn = self._attach(self.history)
        if turn is None:
            raise Ended
        self._play(self.history, turn)
        self._is_ending.wait(0.02)  # what the others play may have to be played again

    def _may_attach_again(
        self, history: History, answer: Answer, body: dict[str, Any]
    ) -> bool:
        if answer.code == "worker_busy":  # its own session, which had nothing to play
            body["takeover"] = True
            return True
        return super()._may_attach_again(history, answer, body)

    def _predict_body(self, turn: dict[str, Any], **values: float) -> dict[str, Any]:
        values |= {NUMBER: float(next(self._numbers))}
        return super()._predict_body(turn, **values)

    def _timed(self, kind: str, *request: Any) -> Answer:
        answer = super()._timed(kind, *request)
        if answer.status == 200:
            self.answered += _numbers_of(request[2])
        return answer


def kill_recording_server(target: Target) -> Report:
    """Counts kills. A run that is completed before the last kill is followed by one,
    unless something was found: then the kills that are left may never come.
    """
    report, randomness = Report(), target.random("kills")
    kills = target.count(30)
    report.figures = {"records": 0, "episodes": 0, "turns": 0, "replayed_exact": 0}
    while report.sent < kills and not (report.hangs or report.violations):
        players = [NumberingPlayer(target, n) for n in range(1, WORKERS + 1)]
        history = players[0].submit()
        for player in players:
            player.history = history
            player.start()
        _kill_while_playing(target, report, players, randomness, kills)
        deadline = time.monotonic() + RUN_S
        while any(one.is_alive for one in players) and time.monotonic() < deadline:
            time.sleep(0.01)
        for player in players:
            report.hangs += player.is_alive + player.report.hangs
            player.end()
            report.answers += player.report.answers
            report.violations += player.report.violations
        with RawClient(target.url, WATCHER, timeout_s=60) as client:
            report.violations += check_histories(client, [history])
            report.violations += _check_record(client, target, players, report)
    return report


def _kill_while_playing(
    target: Target,
    report: Report,
    players: list[NumberingPlayer],
    randomness: random.Random,
    kills: int,
) -> None:
    """Until all kills are done, or the players are."""
    server = server_of(target)
    while report.sent < kills:
        answered = sum(len(player.answered) for player in players)
        deadline = time.monotonic() + RUN_S
        wanted = answered + randomness.randint(1, 60)
        while sum(len(player.answered) for player in players) < wanted:
            if not any(player.is_alive for player in players):
                return
            if time.monotonic() > deadline:
                report.hangs += 1
                return
            time.sleep(0.001)
        time.sleep(randomness.uniform(0.0, 0.02))
        server.end(signal.SIGKILL)
        server.start()
        report.sent += 1


def _check_record(
    client: RawClient, target: Target, players: list[NumberingPlayer], report: Report
) -> Iterator[str]:
    """What is wrong with the record of a run; the report counts what is right."""
    history = players[0].history
    try:
        with verified_record(
            client, history.run_id, server_of(target).directory
        ) as record:
            report.figures["records"] += 1
            report.figures["turns"] += record.verified.turns
            recorded = Counter(_recorded_numbers(record.bundle))
            for player in players:
                yield from missing_turns(recorded, player.answered)
            yield from missing_results(record.lines, history.acknowledged)
            benchmark = resolve(
                record.verified.evaluation, record.bundle.read(MANIFEST)
            )
            simulator = benchmark_registry.make(benchmark.config)
            for line in record.lines:
                plan = benchmark.plan_of(line.index)
                replay = replay_episode(record.path, simulator, plan, line.result)
                report.figures["episodes"] += 1
                report.figures["replayed_exact"] += replay.result == "exact"
                if replay.result != "exact":
                    yield f"episode {line.index} is replayed {replay}"
    except WrongRecord as wrong:
        yield f"record of {history.run_id}: {wrong}"


def _recorded_numbers(bundle: Bundle) -> Iterator[float]:
    for name in filter(is_recording, bundle.sizes):
        with bundle.open(name) as file:
            for topic, data in McapReader(name, file, bundle.sizes[name]).messages():
                if topic == "/turn":
                    turn = msgspec.json.decode(data)
                    yield from (action[NUMBER][0] for action in turn["actions"])


def _numbers_of(body: dict[str, Any]) -> Iterator[float]:
    return (action["values"][NUMBER][0] for action in body["actions"])


ATTACKS = (
    Attack(
        "recorded kills",
        "SIGKILL of the server; each completed run is verified and replayed",
        "30 kills, runs of 8 workers",
        kill_recording_server,
        long_size=100 / 30,
        is_alone=True,
        is_beside=True,
        is_timed=False,
        watchers=0,
    ),
)
