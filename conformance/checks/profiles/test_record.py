"""Recordings and signed records: the profile `record` (REC).

The kit knows which actions it sent and what was answered, so it knows what a true
recording says. `play_everything` plays each kind of episode once.
"""

import base64
import hashlib
from dataclasses import dataclass, field
from typing import Any

from conformance.checks.support.given_states import submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import file_of
from conformance.profiles.record_files import (
    RecordFiles,
    RecordingMessages,
    fetched_record,
    fetched_recording,
    keyid_of,
)
from conformance.runner.private_server import (
    open_private_server,
    open_server_of_its_own,
)
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect

RESULT_MEMBERS = ("outcome", "score", "steps")


@dataclass
class PlayedTurn:
    """A turn that the kit received, and what was executed in it."""

    attempt: int
    seq: int
    actions: list[dict[str, list[float]]]
    rewards: list[float]


@dataclass
class PlayedRun:
    """A run, and the turns that each of its episodes had, by index."""

    run: RunClient
    turns: dict[int, list[PlayedTurn]] = field(default_factory=dict)

    def predict(self, worker: WorkerClient, *actions: dict[str, Any]) -> dict[str, Any]:
        """Play a chunk and note what it executes."""
        before = worker.turn["episode"]
        turn = worker.predict(*actions)
        played = PlayedTurn(
            before["attempt"],
            worker.seq,
            [as_executed(action) for action in actions[: turn["executed_steps"]]],
            turn["rewards"],
        )
        self.turns.setdefault(before["index"], []).append(played)
        return turn

    def recording(self, index: int) -> RecordingMessages:
        """Fetch the recording of an episode."""
        episode_id = self.run.episodes()[index]["episode_id"]
        answer = self.run.call("fetch_recording", episode_id=episode_id)
        return fetched_recording(answer)

    def record(self) -> RecordFiles:
        return fetched_record(self.run.call("fetch_record"))


def as_executed(action: dict[str, Any]) -> dict[str, list[float]]:
    """Give the values of an action after clipping: only `clipped` has such a range."""
    values: dict[str, list[float]] = dict(action["values"])
    values["clipped"] = [min(1.0, max(-1.0, v)) for v in values["clipped"]]
    return values


def ramp(first: float) -> list[float]:
    """Give a vector in which each number is another one."""
    return [first + place / 8 for place in range(8)]


def play_everything(context: CheckContext) -> PlayedRun:
    """Play an episode with a repeat, a takeover and actions behind its end, one with a
    fault and two attempts, and one that is abandoned."""
    run = context.submit("score", "fault", "score", max_attempts=2)
    played = PlayedRun(run)
    worker = run.worker()
    worker.attach()
    chunk = [context.action(score=0.5, clipped=[3, 0.5]), context.action(score=0.125)]
    played.predict(worker, *chunk)
    again = worker.try_predict(*chunk, seq=worker.seq)
    expect.require(again, 200, "predict")
    worker.attach(takeover=True)
    played.predict(worker, context.action(score=0.75, clipped=[-3, 1], vector=ramp(5)))
    played.predict(worker, context.action(score=1, end=1), context.action(score=0.5))
    played.predict(worker, context.action(vector=ramp(1)))
    worker.predict(context.action(fault=1))
    played.predict(worker, context.action(vector=ramp(2)))
    worker.detach()
    worker.attach()
    played.predict(
        worker, context.action(vector=ramp(3)), context.action(success=1, end=1)
    )
    for _ in range(2):
        played.predict(worker, context.action(score=0.25))
        worker.detach()
        if run.get()["state"] != "completed":
            worker.attach()
    run.until("completed")
    return played


@requirement("REC-101")
def test_rec_101_keys_need_no_token(context: CheckContext) -> None:
    """The keys are read without a token, and a record is fetched; where the kit starts
    the server, again after a restart. Expect the key of each record among them, keyids
    that fit, and one key in use."""
    expect_key_in_use(context, play_everything(context))
    settings = context.shared.settings
    is_hooked = settings.restart_cmd is not None  # disturbs other checks
    is_started = settings.start_cmd is not None and not is_hooked
    if settings.quick or not is_started or not settings.durable:
        return
    with open_private_server(context) as server:
        before = expect_key_in_use(server.context, play_everything(server.context))
        server.kill9()
        server.restart()
        expect_key_in_use(server.context, play_everything(server.context))
        shown = [key["keyid"] for key in listed_keys(server.context)]
        expect.true(before in shown, "the key of a record from before a restart", shown)


def listed_keys(context: CheckContext) -> list[dict[str, Any]]:
    """Read the keys without a token."""
    answer = context.call("list_keys", http_client=without_token(context))
    keys: list[dict[str, Any]] = expect.ok(answer)["keys"]
    return keys


def expect_key_in_use(context: CheckContext, played: PlayedRun) -> str:
    """Expect one key in use, which signs the record of a run; give its keyid."""
    keys = listed_keys(context)
    for key in keys:
        public_key = base64.b64decode(key["public_key"])
        expect.equal(len(public_key), 32, "bytes of a key")
        expect.equal(key["keyid"], keyid_of(public_key), "keyid")
    in_use = [key["keyid"] for key in keys if key["retired_at"] is None]
    expect.equal(len(in_use), 1, "number of keys in use")
    host = played.record().predicate["host"]
    expect.true(host["keyid"] in in_use, "the record is signed by the key in use", host)
    return str(in_use[0])


def without_token(context: CheckContext) -> Any:
    """Give a client that sends no token."""
    return context.client_with_token(None)


@requirement("REC-102")
def test_rec_102_a_record_names_its_run(context: CheckContext) -> None:
    """A record is fetched. Expect its signature, its files, and the run it is of."""
    played = play_everything(context)
    record, run = played.record(), played.run.get()
    predicate = record.predicate
    expect.equal(predicate["run"]["run_id"], run["run_id"], "run_id")
    digest = run["manifest_sha256"]
    expect.equal(predicate["manifest_sha256"], digest, "manifest_sha256")
    expect.equal(predicate["policy"]["name"], run["policy"]["name"], "policy.name")
    benchmark = predicate["benchmark"]
    expect.equal(benchmark["benchmark_id"], run["benchmark_id"], "benchmark_id")
    expect.equal(benchmark["version"], run["benchmark_version"], "version")
    files = {m["name"]: m["digest"]["sha256"] for m in record.statement["subject"]}
    expect.equal(files["manifest.json"], digest, "SHA-256 of manifest.json")
    expect.equal(len(record.lines), 3, "number of lines")
    keys = expect.ok(context.call("list_keys"))["keys"]
    signed = {key["keyid"]: key["public_key"] for key in keys}
    keyid, public_key = predicate["host"]["keyid"], predicate["host"]["public_key"]
    expect.equal(signed.get(keyid), public_key, "the key in list_keys")


@requirement("REC-103")
def test_rec_103_nothing_before_the_result(context: CheckContext) -> None:
    """A run is asked for its record while it is ready, running and stopped. Expect
    refusals, and a record when the run is completed."""
    run = context.submit("score", "score")
    expect.refused(run.call("fetch_record"), "illegal_transition")
    worker = run.worker()
    worker.attach()
    worker.play()
    expect.refused(run.call("fetch_record"), "illegal_transition")
    run.stop()
    expect.refused(run.call("fetch_record"), "illegal_transition")
    run.resume(until_ready=True)
    worker.attach()
    worker.play()
    fetched_record(run.call("fetch_record"))


@requirement("REC-125")
def test_rec_125_no_recording_before_the_result(context: CheckContext) -> None:
    """Recordings of an episode in play, a pending one, a scored one, and of some that
    the run does not have. Expect `not_found` for all but the scored one."""
    worker = submit_and_attach(context, "score", "score")
    run = worker.run
    worker.predict(context.action())
    for episode_id in ("e0000", "e0001", "e0002", "e9999", "0", "e00000"):
        expect.refused(run.call("fetch_recording", episode_id=episode_id), "not_found")
    worker.play()
    fetched_recording(run.call("fetch_recording", episode_id="e0000"))
    for episode_id in ("e0001", "e0002"):
        expect.refused(run.call("fetch_recording", episode_id=episode_id), "not_found")


@requirement("REC-104")
def test_rec_104_every_turn_once_as_executed(context: CheckContext) -> None:
    """Episodes are played with a repeat, a takeover, values that are clipped, actions
    behind the end, a fault, and several attempts. Expect the turns of each recording to
    be those that were received."""
    played = play_everything(context)
    for index, turns in played.turns.items():
        recorded = played.recording(index).turns
        what = f"episode {index}"
        expect.equal(len(recorded), len(turns), f"number of turns, {what}")
        for turn, expected in zip(recorded, turns, strict=True):
            expect.equal(turn["actions"], expected.actions, f"actions, {what}")
            expect.equal(turn["rewards"], expected.rewards, f"rewards, {what}")
            expect.equal(turn["steps"], len(expected.actions), f"steps, {what}")
            expect.equal(turn["seq"], expected.seq, f"seq, {what}")
            expect.equal(turn["attempt"], expected.attempt, f"attempt, {what}")


def expect_failure_and_stop(context: CheckContext) -> None:
    """Expect the fault that fails a run, and the attempt that a stop ends."""
    worker = submit_and_attach(context, "fault", "score", max_faults=1, max_attempts=3)
    run = worker.run
    worker.try_predict(context.action(fault=1))
    run.until("failed")
    attach_again(worker)
    worker.play()
    worker.predict(context.action())
    run.stop()
    attach_again(worker)
    worker.play()
    run.until("completed")
    first, second = (PlayedRun(run).recording(index) for index in range(2))
    counted = run.episodes()[0]["faults"]
    expect.equal(len(first.of("/fault")), counted, "faults of a run that failed")
    ended = [m["attempt"] for m in second.of("/attempt") if m["event"] == "ended"]
    expect.equal(ended[:1], [1], "the attempt that a stop ended")


def attach_again(worker: WorkerClient) -> None:
    """Resume a run that is over, and attach the worker."""
    worker.run.resume(until_ready=True)
    worker.attach()


@requirement("REC-105")
def test_rec_105_every_attempt_and_fault(context: CheckContext) -> None:
    """Episodes are played with one attempt, with a fault and two, and abandoned; in
    another run one whose fault fails the run, and one that is stopped. Expect each
    start, each end without a result, and each fault."""
    expect_failure_and_stop(context)
    played = play_everything(context)
    starts, ends, faults = [], [], []
    for index in range(3):
        recording = played.recording(index)
        starts.append([m["attempt"] for m in recording.started])
        over = [m for m in recording.of("/attempt") if m["event"] == "ended"]
        ends.append([m["attempt"] for m in over if m.get("reason") != "scored"])
        faults.append([m["attempt"] for m in recording.of("/fault")])
    expect.equal(starts, [[1], [1, 1, 2], [1, 2]], "attempts that started")
    expect.equal(ends, [[], [1], [1, 2]], "attempts that ended without a result")
    expect.equal(faults, [[], [1], []], "attempts with a fault")


@requirement("REC-106")
def test_rec_106_results_are_those_of_the_run(context: CheckContext) -> None:
    """A run with a failure, a success and an abandoned episode has its record. Expect
    the results of `list_episodes` in it, and the score of `get_score`."""
    played = play_everything(context)
    record = played.record()
    expect.equal(record.predicate["score"], played.run.score(), "score")
    for episode in played.run.episodes():
        line, result = record.lines[episode["index"]], episode["result"]
        recorded = record.recording(episode["index"]).result
        for member in RESULT_MEMBERS:
            expect.equal(line[member], result[member], f"{member} of a line")
            expect.equal(recorded[member], result[member], f"{member} of a recording")
        expect.equal(line["attempts"], result["attempt"], "attempts of a line")
        expect.equal(recorded["attempts"], result["attempt"], "attempts of a recording")
        expect.equal(line["episode_id"], episode["episode_id"], "episode_id")
        expect.equal(line["task"], episode["task"], "task")
        expect.equal(line["split"], episode["split"], "split")


@requirement("REC-107")
def test_rec_107_a_record_has_the_sent_recordings(context: CheckContext) -> None:
    """Each recording is fetched alone and in the record. Expect the same bytes."""
    played = play_everything(context)
    record = played.record()
    for index in range(3):
        alone = played.recording(index)
        inside = record.files[record.lines[index]["recording"]["path"]]
        expect.true(alone.data == inside, f"the same bytes of episode {index}")


@requirement("REC-108")
def test_rec_108_not_for_other_accounts(context: CheckContext) -> None:
    """Another account asks for a record and a recording of a completed run and of one
    that is not played, then the completed run's own. Expect `not_found` each time, and
    both for its own account."""
    run, unplayed = play_everything(context).run, context.submit("score")
    second_account = context.second_account
    for operation_id, how in [
        ("fetch_record", {}),
        ("fetch_recording", {"episode_id": "e0000"}),
    ]:
        for own_run in (run, unplayed):
            refused = own_run.call(operation_id, http_client=second_account, **how)
            expect.refused(refused, "not_found")
        expect.ok(run.call(operation_id, **how))


@requirement("REC-109")
def test_rec_109_a_record_stays_the_same(context: CheckContext) -> None:
    """A record is fetched, then that of another run, then the first one again. Expect
    the same bytes, and another record of the other run."""
    runs = [play_everything(context).run, play_everything(context).run]
    files = [file_of(run.call("fetch_record")) for run in (*runs, runs[0])]
    first, second, again = files
    expect.true(first, "a record")
    expect.true(first == again, "the same bytes")
    expect.true(first != second, "other bytes of another run")


@requirement("REC-110")
def test_rec_110_attempts_are_counted(context: CheckContext) -> None:
    """Two runs of a benchmark are submitted, the first is stopped, a third is played.
    Expect numbers that grow, the same in every view, and at least that in the record.
    """
    runs = [context.submit("score") for _ in range(2)]
    runs[0].stop()
    played = play_everything(context)
    numbers = [run.get()["attempts_by_submitter"] for run in (*runs, played.run)]
    expect.true(numbers[0] >= 1, "the first counts itself", numbers)
    expect.true(numbers == sorted(set(numbers)), "each is larger", numbers)
    listed = context.require(lambda: context.call("list_runs"), 200, "list_runs")
    by_id = {run["run_id"]: run for run in listed["runs"]}
    views = [by_id.get(run.id, {}) for run in (*runs, played.run)]
    for view, number in zip(views, numbers, strict=True):
        expect.equal(view.get("attempts_by_submitter", number), number, "in list_runs")
    said = played.record().predicate["attempts_by_submitter"]
    expect.true(said >= numbers[2], "at least that in the record", said)


@requirement("REC-111")
def test_rec_111_starts_have_equal_digests(context: CheckContext) -> None:
    """An episode starts three times. Expect equal state digests, and those of the
    lines: the first of its first start, the last of its last turn."""
    record = play_everything(context).record()
    for index in range(3):
        recording = record.recording(index)
        digests = {start["state_digest"] for start in recording.started}
        expect.equal(len(digests), 1, f"number of different starts, episode {index}")
        facts = record.lines[index]["recording"]
        expect.true(facts["first_digest"] in digests, "first_digest", facts)
        turns = recording.of("/turn")
        expect.true(turns, f"a turn of episode {index}")
        last = turns[-1]["state_digest"]
        expect.equal(facts["last_digest"], last, "last_digest")


@background
@requirement("REC-124")
def test_rec_124_turns_outlive_a_crash(context: CheckContext) -> None:
    """A private server is killed in an episode, twice, and restarted; then the run is
    played to its end. Expect every turn that was received in the recording, in order,
    and each start; and the same bytes in the record."""
    with open_server_of_its_own(context) as server:
        played = PlayedRun(server.context.submit("score"))
        for score in (0.25, 0.5):
            worker = played.run.worker()
            worker.attach()
            for vector in (ramp(score), ramp(1)):
                played.predict(worker, context.action(score=score, vector=vector))
            server.kill9()
            server.restart()
        worker = played.run.worker()
        worker.attach()
        played.predict(worker, context.action(score=1, success=1, end=1))
        played.run.until("completed")
        recording = played.recording(0)
        recorded = [(turn["actions"], turn["rewards"]) for turn in recording.turns]
        received = [(turn.actions, turn.rewards) for turn in played.turns[0]]
        expect.equal(recorded, received, "turns that were received")
        starts = [start["attempt"] for start in recording.started]
        expect.equal(starts, [1, 1, 1], "attempts that started")
        line = played.record().lines[0]["recording"]
        digest = hashlib.sha256(recording.data).hexdigest()
        expect.equal(line["sha256"], digest, "SHA-256 of the recording in the record")
