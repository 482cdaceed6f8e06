"""Records that are handed in: the profile `record_import`.

The kit fetches a record of its own run, and changes it where a rule is about records
that are broken, or signed by an unknown key.
"""

import hashlib
import time
from dataclasses import replace
from typing import Any

from conformance.checks.profiles.test_record import play_everything
from conformance.checks.support.given_states import submit_and_attach
from conformance.client.check_context import CheckContext
from conformance.client.connections.raw_connection import open_raw_connection
from conformance.profiles.changed_records import (
    KEY,
    broken_archives,
    pack,
    signed_again,
    verdict_by_kit,
    with_changed_turn,
    without_verdicts,
)
from conformance.profiles.import_client import (
    accepted,
    finished,
    listed_ids,
    listed_imports,
    send_record,
)
from conformance.profiles.record_files import (
    STATEMENT,
    RecordFiles,
    fetched_record,
    keyid_of,
    verdicts_of,
)
from conformance.runner.private_server import open_server_of_its_own
from conformance.runner.requirement import background, requirement
from conformance.specification.document import ZIP
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable

COUNTS = ("result", "episodes", "exact", "outcome", "diverged")
SLOW_STEP_S = 1.0
# How long other work may keep a replay waiting.
BEGIN_S = 20.0
POLL_S = 0.1


def require_records(context: CheckContext) -> None:
    """Require a server that signs records."""
    if not context.offers("record"):
        raise NotApplicable("the server signs no records: the profile `record`")


def played_record(context: CheckContext) -> RecordFiles:
    """Play two episodes of two turns, and fetch the record."""
    require_records(context)
    worker = submit_and_attach(context, "score", "score")
    run = worker.run
    for first in (0.25, 0.5):
        worker.predict(context.action(score=first), context.action(score=0.125))
        worker.predict(context.action(score=0.75), context.action(score=first, end=1))
    run.until("completed")
    return fetched_record(run.call("fetch_record"))


@requirement("REC-112")
def test_rec_112_a_whole_record_is_taken_in(context: CheckContext) -> None:
    """A record with a fault, several attempts and an abandoned episode is handed in.
    Expect 202, a Location that can be read, and what its statement says."""
    record = play_everything(context).record()
    answer = send_record(context, record.data)
    imported = expect.ok(answer, 202)
    again = context.http_client.request("GET", answer.headers.get("location", ""))
    expect.equal(expect.ok(again)["import_id"], imported["import_id"], "id at Location")
    said = record.predicate
    shown = {
        "run_id": said["run"]["run_id"],
        "benchmark_id": said["benchmark"]["benchmark_id"],
        "benchmark_version": said["benchmark"]["version"],
        "manifest_sha256": said["manifest_sha256"],
        "score": said["score"]["score"],
        "episodes": len(record.lines),
        "keyid": said["host"]["keyid"],
        "size_bytes": len(record.data),
        "archive_sha256": hashlib.sha256(record.data).hexdigest(),
        "statement_sha256": hashlib.sha256(record.files[STATEMENT]).hexdigest(),
    }
    for name, value in shown.items():
        expect.equal(imported[name], value, name)
    expect.equal(imported["policy"]["name"], said["policy"]["name"], "policy.name")


@requirement("REC-113")
def test_rec_113_a_broken_record_is_refused(context: CheckContext) -> None:
    """Archives that break one rule each are handed in, and the good one at last. Expect
    the rule and the file in each refusal, and an import of the good one alone."""
    record = played_record(context)
    for what, (archive, file, rule) in broken_archives(record).items():
        refused = send_record(context, archive)
        expect.refused(refused, "record_broken")
        problem = refused.json
        expect.equal(problem.get("requirement"), rule, f"requirement, {what}")
        pointers = [error["pointer"] for error in problem.get("errors", [])]
        expect.equal(pointers, [f"record:{file}"], f"pointers of `errors`, {what}")
    good = accepted(context, pack(without_verdicts(record.files)))
    of_the_run = [
        imported["import_id"]
        for imported in listed_imports(context)
        if imported["run_id"] == good["run_id"]
    ]
    expect.equal(of_the_run, [good["import_id"]], "imports that were made of the run")


@requirement("REC-114")
def test_rec_114_imports_of_others_do_not_exist(context: CheckContext) -> None:
    """An account reads, fetches, deletes and lists what another one handed in, and
    hands in the same bytes. Expect `not_found` each time, as of an id that never was;
    its owner reads it, and the other one an import of its own."""
    archive = played_record(context).data
    import_id = accepted(context, archive)["import_id"]
    second_account = context.second_account
    for operation in ("get_import", "fetch_imported_record", "delete_import"):
        for id_ in (import_id, "imp_never"):
            refused = context.call(operation, import_id=id_, http_client=second_account)
            expect.refused(refused, "not_found")
    listed = listed_ids(context, http_client=second_account)
    expect.true(import_id not in listed, "no import of another account", listed)
    expect.ok(context.call("get_import", import_id=import_id))
    own = accepted(context, archive, http_client=second_account)["import_id"]
    expect.ok(context.call("get_import", import_id=own, http_client=second_account))
    expect.refused(context.call("get_import", import_id=own), "not_found")


@requirement("REC-115")
def test_rec_115_an_honest_record_is_replayed(context: CheckContext) -> None:
    """Records of this server with a fault, several attempts and an abandoned episode,
    and of every kind of turn, are handed in. Expect every episode to be simulated again
    with the recorded result."""
    for record in (play_everything(context).record(), played_record(context)):
        imported = finished(context, accepted(context, record.data)["import_id"])
        expect.equal(imported["level"], "replayed", f"level ({imported['reason']})")
        replay, total = imported["replay"], len(record.lines)
        expect.equal(replay["episodes"], total, "number of episodes in the replay")
        expect.equal(imported["episodes_replayed"], total, "episodes_replayed")
        expect.equal(replay["diverged"], 0, "number of episodes that diverged")
        expect.equal(replay["exact"] + replay["outcome"], total, "episodes alike")


@requirement("REC-116")
def test_rec_116_a_false_record_is_found(context: CheckContext) -> None:
    """The last action of a recording is changed, and the record signed again. Expect
    the replay to diverge there: the second episode, behind its last step."""
    record = played_record(context)

    def change(turn: dict[str, Any]) -> None:
        turn["actions"][-1]["score"] = [0.0625]

    last = record.recording(1).turns[-1]["seq"]
    archive = pack(with_changed_turn(record, 1, last, change))
    imported = finished(context, accepted(context, archive)["import_id"])
    expect.equal(imported["level"], "diverged", f"level ({imported['reason']})")
    replay = imported["replay"]
    expect.members(replay, {"result": "diverged", "diverged": 1})
    where = replay["first_divergence"]
    place = {name: where[name] for name in ("episode_index", "attempt", "step")}
    expected = {"episode_index": 1, "attempt": 1, "step": 4}
    expect.equal(place, expected, "first_divergence")


@requirement("REC-117")
def test_rec_117_an_unknown_key_has_no_name(context: CheckContext) -> None:
    """A record of this server, and the same one signed by a key of the kit, which has
    the name of this server in it. Expect a signer of the first one alone, and levels
    that fit as long as there is no replay."""
    record = played_record(context)
    own = accepted(context, record.data)
    finished(context, own["import_id"])
    expect.true(own["signer"] is not None, "a signer of a record of this server", own)
    foreign = accepted(context, pack(signed_again(record, {})))
    keyid = keyid_of(KEY.public_key().public_bytes_raw())
    expect.equal(foreign["keyid"], keyid, "keyid")
    for imported, level in ((own, "signed"), (foreign, "reported")):
        if "replay" not in imported:
            expect.equal(imported["level"], level, "level before the replay")
    again = finished(context, foreign["import_id"])
    expect.equal(again["signer"], None, "signer of a record by a key of the kit")


def expect_sent_with_verdict(context: CheckContext, handed_in: RecordFiles) -> Any:
    """Expect a record that is handed in to be sent with a verdict; give that one."""
    imported = finished(context, accepted(context, handed_in.data)["import_id"])
    answer = context.call("fetch_imported_record", import_id=imported["import_id"])
    sent = fetched_record(answer)
    expect.true(
        handed_in.files.items() <= sent.files.items()
        and without_verdicts(sent.files) == without_verdicts(handed_in.files),
        "the files that were handed in",
        list(sent.files),
    )
    keys = {key["keyid"] for key in expect.ok(context.call("list_keys"))["keys"]}
    digest = hashlib.sha256(handed_in.files[STATEMENT]).hexdigest()
    said = [
        verdict
        for verdict in verdicts_of(sent)
        if verdict["predicate"]["verifier"]["keyid"] in keys
        and verdict["subject"][0]["digest"]["sha256"] == digest
    ]
    expected = {name: imported["replay"][name] for name in COUNTS}
    replays = [verdict["predicate"]["replay"] for verdict in said]
    shown = [{name: replay[name] for name in COUNTS} for replay in replays]
    expect.true(expected in shown, f"a verdict that says {expected}", shown)
    return said[shown.index(expected)]


@requirement("REC-118")
def test_rec_118_it_is_sent_with_a_verdict(context: CheckContext) -> None:
    """An import that is finished is fetched; then the record is handed in with the same
    verdict by a key of the kit, and fetched again. Expect the files that were handed
    in, and a verdict by a key of `list_keys`."""
    record = played_record(context)
    verdict = expect_sent_with_verdict(context, record)
    files = without_verdicts(record.files)
    files["verdicts/kit.dsse.json"] = verdict_by_kit(verdict)
    beside = replace(record, data=pack(files), files=files)
    expect_sent_with_verdict(context, beside)


@requirement("REC-119")
def test_rec_119_the_same_bytes_are_one_import(context: CheckContext) -> None:
    """A record is handed in twice, and another one. Expect one import of the first."""
    record = played_record(context)
    first, again = (accepted(context, record.data)["import_id"] for _ in range(2))
    expect.equal(again, first, "import_id of the same bytes")
    finished(context, first)
    second = accepted(context, pack(signed_again(record, {})))["import_id"]
    expect.true(second != first, "another import of other bytes", second)


@requirement("REC-120")
def test_rec_120_the_list_has_what_was_not_deleted(context: CheckContext) -> None:
    """Three records are handed in, and the second one is deleted. Expect them newest
    first, and the second one in no answer any more."""
    record = played_record(context)

    def rename(number: int) -> Any:
        return lambda predicate: predicate["policy"].update(name=f"policy {number}")

    ids = []
    for n in range(3):
        archive = pack(signed_again(record, {}, rename(n)))
        ids.append(accepted(context, archive)["import_id"])
        finished(context, ids[-1])
    for limit in (100, 2, 1):
        listed = [
            import_id
            for import_id in listed_ids(context, limit=limit)
            if import_id in ids
        ]
        expect.equal(listed, ids[::-1], f"imports by pages of {limit}, newest first")
    expect.ok(context.call("delete_import", import_id=ids[1]), 204)
    for operation in ("get_import", "fetch_imported_record", "delete_import"):
        expect.refused(context.call(operation, import_id=ids[1]), "not_found")
    listed = [import_id for import_id in listed_ids(context) if import_id in ids]
    expect.equal(listed, [ids[2], ids[0]], "imports after one was deleted")


@requirement("REC-121")
def test_rec_121_too_long_a_record_is_not_awaited(context: CheckContext) -> None:
    """The headers of a record that is longer than the limit are sent, and no body; and
    those of one that is as long as announced, with its body. Expect 413 at once, and
    422 for the second, which is not a record."""
    limit = context.limits.get("max_record_bytes")
    if limit is None:
        raise NotApplicable("`limits.max_record_bytes` is not announced")
    token = context.shared.settings.token
    for length, body, status in ((limit + 1, b"", 413), (2, b"{}", 422)):
        lines = [f"Authorization: Bearer {token}", f"Content-Type: {ZIP}"]
        lines += [f"Content-Length: {length}", "Connection: close"]
        with open_raw_connection(context.http_client.base_url) as connection:
            request = connection.head("POST", "/v1/records", *lines) + b"\r\n"
            ending = connection.send_until_end(request + body)
        expect.equal(ending.status, status, f"status with Content-Length {length}")


def slow_record(context: CheckContext) -> RecordFiles:
    """Give a record of which the replay takes two seconds and more."""
    require_records(context)
    worker = submit_and_attach(context, "delay")
    for _ in range(2):
        worker.predict(context.action(delay_s=SLOW_STEP_S))
    worker.play()
    worker.run.until("completed")
    return fetched_record(worker.run.call("fetch_record"))


def wait_until_replayed(context: CheckContext, import_id: str) -> None:
    until = time.monotonic() + BEGIN_S
    while time.monotonic() < until:
        imported = expect.ok(context.call("get_import", import_id=import_id))
        if imported["state"] in ("replaying", "finished"):
            return
        time.sleep(POLL_S)


def expect_all_finished(context: CheckContext, ids: list[str], archive: bytes) -> None:
    """Expect imports from before a restart to end, where a later one does.

    They get as long as the later one took, and as a slow replay, before they are lost.
    """
    began_at = time.monotonic()
    answer = send_record(context, archive)
    if answer.code == "quota_exceeded":
        return  # an account may have one waiting at a time
    finished(context, str(expect.ok(answer, 202)["import_id"]))
    until = time.monotonic() + BEGIN_S + (time.monotonic() - began_at)
    for id_ in ids:
        while True:
            imported = expect.ok(context.call("get_import", import_id=id_))
            if imported["state"] == "finished":
                break
            what = "an import to go on after a restart"
            expect.true(time.monotonic() < until, what, imported["state"])
            time.sleep(POLL_S)


@background
@requirement("REC-123")
def test_rec_123_imports_outlive_a_crash(context: CheckContext) -> None:
    """Records are handed in, and the server is killed in the replay of the first one
    and restarted; then another one is handed in. Expect the imports, replayed like the
    last one, and their archives."""
    with open_server_of_its_own(context) as server:
        record = slow_record(server.context)
        archives = [record.data, pack(signed_again(record, {}))]
        ids: list[str] = []
        for archive in archives:
            answer = send_record(server.context, archive)
            if ids and answer.code == "quota_exceeded":
                break  # an account may have one waiting at a time
            ids.append(str(expect.ok(answer, 202)["import_id"]))
        wait_until_replayed(server.context, ids[0])
        server.kill9()
        server.restart()
        expect_all_finished(server.context, ids, played_record(server.context).data)
        for id_, archive in zip(ids, archives, strict=False):
            imported = finished(server.context, id_)
            expect.equal(imported["level"], "replayed", f"level ({imported['reason']})")
            digest = hashlib.sha256(archive).hexdigest()
            expect.equal(imported["archive_sha256"], digest, "archive_sha256")
            fetched_record(server.context.call("fetch_imported_record", import_id=id_))
