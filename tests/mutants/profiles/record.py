"""Mutants of recordings and records: what is missing, doubled, or not theirs."""

from __future__ import annotations

import itertools
import secrets
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import msgspec
import sqlalchemy as sa
from starlette.responses import Response

from reference_record import export, recording_file
from reference_record.formats import recording_parts
from reference_record.formats.recording_parts import PartMessage
from reference_record.statement import EpisodeLine, Evaluation
from reference_server.http import handlers
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.records import recordings, run_records
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import RunRecords
from reference_server.rules import lifecycle
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Episode, Run
from reference_server.runs import service
from reference_server.storage import store
from reference_server.storage.database_tables import signing_keys
from reference_server.storage.store import Store
from reference_server.views import run_views
from tests.mutants import mutant, put

Json = dict[str, Any]


def change_parts(change: Callable[[list[PartMessage]], list[PartMessage]]) -> None:
    """Let `change` spoil what is read of each part of a recording."""
    right = recording_parts.read_part

    def wrong(path: Path) -> Iterator[PartMessage]:
        return iter(change(list(right(path))))

    put(recording_file, "read_part", wrong)


def change_messages(topic: str, change: Callable[[Json], None]) -> None:
    """Let `change(message)` spoil each message of a topic."""

    def change_one(entry: PartMessage) -> PartMessage:
        if entry[0] != topic:
            return entry
        message = msgspec.json.decode(recording_parts.json_of(entry[2]))
        change(message)
        return topic, entry[1], msgspec.json.encode(message)

    change_parts(lambda entries: [change_one(entry) for entry in entries])


def change_evaluation(change: Callable[[Evaluation], None]) -> None:
    """Let `change(predicate)` spoil what a record states of its run."""
    right = RunRecords._evaluation

    async def wrong(self: RunRecords, *arguments: Any) -> Evaluation:
        evaluation = await right(self, *arguments)
        change(evaluation)
        return evaluation

    put(RunRecords, "_evaluation", wrong)


@mutant("REC-101")
def shows_every_key_as_retired() -> None:
    """A reader takes a record that was signed today for one with an old key."""
    right = run_views.key_view

    def wrong(key: Any) -> Json:
        body = right(key)
        return body | {"retired_at": body["created_at"]}

    put(run_views, "key_view", wrong)


@mutant("REC-101", "REC-102")
def names_keys_without_their_digest() -> None:
    """The key that a statement names is in no list."""
    right = run_views.key_view
    put(run_views, "key_view", lambda key: right(key) | {"keyid": "SHA256:key"})


@mutant("REC-101")
def retires_its_key_at_a_restart() -> None:
    """After an update of the server every record looks as if signed by an old key."""
    right = Store.use_key

    async def wrong(
        self: Store, keyid: str, public_key: bytes, now_wall: float
    ) -> None:
        known = {key.keyid for key in await self.keys()}
        await right(self, keyid, public_key, now_wall)
        if keyid in known:
            retire = sa.update(signing_keys).values(retired_at_wall=now_wall)
            await self.write_in_turn(lambda connection: connection.execute(retire))

    put(Store, "use_key", wrong)


@mutant("REC-102")
def signs_another_run_id() -> None:
    """A record is published for a run that never was."""

    def wrong(evaluation: Evaluation) -> None:
        evaluation.run.run_id = "run_other"

    change_evaluation(wrong)


@mutant("REC-102")
def signs_another_policy() -> None:
    """The score of one policy is shown for another one."""

    def wrong(evaluation: Evaluation) -> None:
        evaluation.policy.name = "a better policy"

    change_evaluation(wrong)


@mutant("REC-103")
def does_not_refuse_records_of_runs_in_play() -> None:
    """A run that goes on looks like one that does not exist."""
    put(service, "refuse_record", lambda _run: None)


@mutant("REC-104", "REC-124")
def loses_the_first_turn_of_each_part() -> None:
    """A recording shows an episode that began later than it did."""

    def wrong(entries: list[PartMessage]) -> list[PartMessage]:
        turns = [n for n, (topic, *_) in enumerate(entries) if topic == "/turn"]
        left_out = turns[0] if len(turns) > 1 else None
        return [entry for n, entry in enumerate(entries) if n != left_out]

    change_parts(wrong)
    right = recording_file.join_parts
    # Nor does it compare the steps of the turns with those of the result.
    put(recordings, "join_parts", lambda *arguments, **_: right(*arguments))


@mutant("REC-104", "REC-124")
def records_rewards_as_zero() -> None:
    """A reader computes a return that the policy never had."""

    def wrong(turn: Json) -> None:
        turn["rewards"] = [0.0 for _ in turn["rewards"]]

    change_messages("/turn", wrong)


@mutant("REC-104")
def records_actions_backwards() -> None:
    """A replay of the recorded actions ends somewhere else."""
    change_messages("/turn", lambda turn: turn["actions"].reverse())


@mutant("REC-105")
def forgets_faults() -> None:
    """A simulator that breaks often looks like one that never does."""
    put(Recordings, "add_fault", lambda *_: None)


@mutant("REC-105")
def forgets_how_attempts_end() -> None:
    """An attempt that its policy left looks like one that the server lost."""
    put(Recordings, "end_attempt", lambda *_: None)


@mutant("REC-105")
def forgets_the_fault_that_fails_a_run() -> None:
    """Why a run failed is in no recording of it."""
    right = Recordings.add_fault

    def wrong(self: Recordings, run: Run, episode: Episode, *fault: Any) -> None:
        since_resume = episode.faults - episode.faults_forgiven + 1
        if since_resume < run.manifest["max_faults"]:
            right(self, run, episode, *fault)

    put(Recordings, "add_fault", wrong)


@mutant("REC-105")
def forgets_attempts_that_a_stop_ends() -> None:
    """An attempt that its submitter stopped looks like one that the server lost."""
    right = Recordings.end_attempt

    def wrong(
        self: Recordings, run: Run, index: int, attempt: int, reason: str
    ) -> None:
        if run.state != "stopped":
            right(self, run, index, attempt, reason)

    put(Recordings, "end_attempt", wrong)


@mutant("REC-106")
def adds_a_step_to_each_line() -> None:
    """The table of a record contradicts the run."""
    right = run_records._line

    def wrong(episode: Any) -> EpisodeLine:
        line = right(episode)
        line.steps += 1
        return line

    put(run_records, "_line", wrong)


@mutant("REC-106")
def signs_a_higher_score() -> None:
    """A number that no policy reached carries a signature."""

    def wrong(evaluation: Evaluation) -> None:
        evaluation.score = evaluation.score | {"mean": 1.0}

    change_evaluation(wrong)


@mutant("REC-107", "REC-124")
def sends_other_bytes_than_the_record_has() -> None:
    """What was downloaded alone is no evidence for the signed record."""
    right = export.blocks_of

    def wrong(path: Path) -> Iterator[bytes]:
        return (block.replace(b"proctor", b"Proctor", 1) for block in right(path))

    put(handlers, "blocks_of", wrong)


@mutant("REC-108")
def sends_records_to_every_account() -> None:
    """A competitor reads every action of an unpublished policy."""
    right = Handlers.fetch_record

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        run = await self.service.registry.get(call.path["run_id"])
        assert call.caller is not None
        call.caller = type(call.caller)(run.account, call.caller.scopes)
        return await right(self, call)

    put(Handlers, "fetch_record", wrong)


@mutant("REC-108")
def shows_the_state_of_runs_of_others() -> None:
    """A competitor sees that a run exists, and whether it goes on."""
    right = Handlers.fetch_record

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        run = await self.service.registry.get(call.path["run_id"])
        refused = lifecycle.refuse_record(run)
        if refused is not None:
            raise Refused.from_verdict(refused)
        return await right(self, call)

    put(Handlers, "fetch_record", wrong)


@mutant("REC-109")
def signs_a_record_anew_each_time() -> None:
    """Two people hold two records of one run, and each doubts the other's."""
    right = Store.add_statement

    async def find(_self: Store, _run_id: str) -> None:
        return None

    async def add(self: Store, run_id: str, *statement: Any) -> None:
        await right(self, f"{run_id}-{secrets.token_hex(4)}", *statement)

    put(Store, "find_statement", find)
    put(Store, "add_statement", add)


@mutant("REC-110")
def counts_every_run_as_the_first() -> None:
    """The best of a hundred runs looks like the only one."""
    put(store, "_last_attempt", lambda _run: sa.select(sa.literal(0)))


@mutant("REC-111")
def digests_that_are_never_equal() -> None:
    """A replay of an honest record is said to diverge at its first step."""
    numbers = itertools.count()

    def wrong(event: Json) -> None:
        if event["event"] == "started":
            event["state_digest"] = f"{next(numbers):032x}"

    change_messages("/attempt", wrong)


@mutant("REC-124")
def loses_what_was_in_play_at_a_restart() -> None:
    """Of an episode that a crash cut off, the record shows the second half alone."""
    right = Recordings.open

    def wrong(self: Recordings) -> None:
        right(self)
        for parts in self._folder.glob("*/*.parts"):
            shutil.rmtree(parts)

    put(Recordings, "open", wrong)
