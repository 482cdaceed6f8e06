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

from reference_record.recordings import recording_file, recording_parts
from reference_record.recordings.recording_parts import PartMessage
from reference_server.http import handlers
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.records import recordings, run_records
from reference_server.records.recordings import Recordings
from reference_server.records.run_records import RunRecords
from reference_server.rules.refusal import Refused
from reference_server.runs import service
from reference_server.runs.service import RunService
from reference_server.storage import record_store
from reference_server.storage.record_store import RecordStore
from reference_server.storage.runs import run_store
from reference_server.storage.tables.database_tables import signing_keys
from reference_server.views import run_views
from tests.mutants import Json, instead_of, mutant, put


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


@mutant("REC-101", "REC-102", through=instead_of(run_views, "key_view"))
def names_keys_without_their_digest(right: Any, key: Any) -> Any:
    """The key that a statement names is in no list."""
    return right(key) | {"keyid": "SHA256:key"}


@mutant("REC-101", through=instead_of(RecordStore, "use_key"))
async def retires_its_key_at_a_restart(
    right: Any, self: RecordStore, keyid: str, public_key: bytes, now_wall: float
) -> None:
    """After an update of the server every record looks as if signed by an old key."""
    keyids = {key.keyid for key in await self.keys()}
    await right(self, keyid, public_key, now_wall)
    if keyid in keyids:
        retire = sa.update(signing_keys).values(retired_at_wall=now_wall)
        write = self._transactions.write_in_turn
        await write(lambda connection: connection.execute(retire))


@mutant("REC-103")
def does_not_refuse_records_of_runs_in_play() -> None:
    """A run that goes on looks like one that does not exist."""
    put(service, "refuse_record", lambda _run: None)


@mutant("REC-125", through=instead_of(RunService, "find_recording"))
async def sends_the_last_recording_for_an_unknown_episode(
    right: Any, self: RunService, account: str, run_id: str, episode_id: str
) -> Any:
    """A reader takes what happened in one episode for another one."""
    try:
        return await right(self, account, run_id, episode_id)
    except Refused:
        return await right(self, account, run_id, "e0000")


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


@mutant("REC-104")
def records_actions_backwards() -> None:
    """A replay of the recorded actions ends somewhere else."""
    change_messages("/turn", lambda turn: turn["actions"].reverse())


@mutant("REC-105")
def forgets_faults_and_how_attempts_end() -> None:
    """A simulator that breaks often looks like one that never does."""
    put(Recordings, "add_fault", lambda *_: None)
    put(Recordings, "end_attempt", lambda *_: None)


@mutant("REC-106", through=instead_of(run_records, "_line"))
def adds_a_step_to_each_line(right: Any, episode: Any) -> Any:
    """The table of a record contradicts the run."""
    line = right(episode)
    line.steps += 1
    return line


@mutant("REC-106", through=instead_of(RunRecords, "_evaluation"))
async def signs_a_higher_score(right: Any, self: RunRecords, *arguments: Any) -> Any:
    """A number that no policy reached carries a signature."""
    evaluation = await right(self, *arguments)
    evaluation.score = evaluation.score | {"mean": 1.0}
    return evaluation


@mutant("REC-107", "REC-124", through=instead_of(handlers, "blocks_of"))
def sends_other_bytes_than_the_record_has(right: Any, path: Path) -> Any:
    """A recording that was downloaded alone does not match the signed record."""
    return (block.replace(b"proctor", b"Proctor", 1) for block in right(path))


@mutant("REC-108", through=instead_of(Handlers, "fetch_record"))
async def sends_records_to_every_account(
    right: Any, self: Handlers, call: OperationCall
) -> Any:
    """A competitor reads every action of an unpublished policy."""
    run = await self.service.registry.get(call.path["run_id"])
    assert call.caller is not None
    call.caller = type(call.caller)(run.account, call.caller.scopes)
    return await right(self, call)


@mutant("REC-109")
def signs_a_record_anew_each_time() -> None:
    """Two people hold two records of one run, and each doubts the other's."""
    right = RecordStore.add_statement

    async def find(_self: RecordStore, _run_id: str) -> None:
        return None

    async def add(self: RecordStore, run_id: str, *statement: Any) -> None:
        await right(self, f"{run_id}-{secrets.token_hex(4)}", *statement)

    put(RecordStore, "find_statement", find)
    put(RecordStore, "add_statement", add)


@mutant("REC-110")
def counts_every_run_as_the_first() -> None:
    """The best of a hundred runs looks like the only one."""
    for module in (run_store, record_store):
        put(module, "last_attempt", lambda *_: 0)


@mutant("REC-111")
def digests_that_are_never_equal() -> None:
    """A replay of an honest record is said to diverge at its first step."""
    numbers = itertools.count()

    def wrong(event: Json) -> None:
        if event["event"] == "started":
            event["state_digest"] = f"{next(numbers):032x}"

    change_messages("/attempt", wrong)


@mutant("REC-124", through=instead_of(Recordings, "open"))
def loses_what_was_in_play_at_a_restart(right: Any, self: Recordings) -> None:
    """The record of an episode that a crash cut off shows its second half alone."""
    right(self)
    for parts in self._folder.glob("*/*.parts"):
        shutil.rmtree(parts)
