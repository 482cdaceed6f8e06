"""A challenge that people enter: the profile `hosting` (HST)."""

import hashlib
import json
import threading
import time
from typing import Any

from conformance.checks.support.published_runs import (
    flag_entry,
    read_leaves,
    require_entry,
    try_publish,
)
from conformance.checks.support.submissions import submit
from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.exchanges.answer import Answer
from conformance.profiles.hosting import (
    BASE,
    ENDS_S,
    LOOKS_S,
    POLL_S,
    HostedUpload,
    call_hosting,
    call_with_form,
    entered_track,
    find_result,
    leave_organisation,
    made_key,
    made_organisation,
    open_phase,
    playable,
    played_run,
    require_hosting,
    sign_up,
)
from conformance.runner.requirement import requirement
from conformance.specification.document import EVENT_STREAM
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

WRONG_MEMBERS: dict[str, Any] = {
    "account": "No Name",
    "full_name": " ",
    "organisation": "",
    "email": "nowhere",
    "password": "short",
    "agrees": False,
}
GRANT = "urn:ietf:params:oauth:grant-type:device_code"


def register(context: CheckContext, **members: Any) -> tuple[dict[str, Any], Answer]:
    """Register without a key; give what was sent, too."""
    body = sign_up(**members)
    client = context.client_with_token(None)
    answer = call_hosting(context, "POST", "/accounts", body, client)
    if answer.status == 429:
        text = "the server admits no more registrations of this machine for a time"
        raise SetUpFailed(text, allowed=True)
    return body, answer


@requirement("HST-001")
def test_hst_001_cannot_register_with_wrong_members(context: CheckContext) -> None:
    """All members are wrong; then none. Expect `invalid_request` at each; then 202."""
    _, answer = register(context, **WRONG_MEMBERS)
    for name in WRONG_MEMBERS:
        expect.refused(answer, "invalid_request", pointer=f"/{name}")
    expect.ok(register(context)[1], 202)


@requirement("HST-002")
def test_hst_002_addresses_are_not_shown(context: CheckContext) -> None:
    """A known and a new address register. Expect equal answers but for the name."""
    body, first = register(context)
    expect.ok(first, 202)
    again, second = register(context, email=body["email"])
    expected = {**expect.ok(first, 202), "account": again["account"]}
    expect.equal(dict(expect.ok(second, 202)), expected, "the answer")


@requirement("HST-007")
def test_hst_007_a_secret_is_shown_once(context: CheckContext) -> None:
    """A key is made, and the keys are listed. Expect it there without its secret."""
    with made_key(context) as key:
        listed = call_hosting(context, "GET", "/keys")
        ids = [row["key_id"] for row in expect.ok(listed)["keys"]]
        expect.true(key["key_id"] in ids, "the key in list_keys")
        is_shown = key["secret"].encode() in listed.body
        expect.true(not is_shown, "no secret in list_keys")


def wait_until_refused(context: CheckContext, client: HttpClient) -> None:
    """Expect that both kinds of operations refuse the key of a client."""
    began = time.monotonic()
    while True:
        answers = [
            context.call("list_runs", http_client=client),
            call_hosting(context, "GET", "/account", http_client=client),
        ]
        took_s = time.monotonic() - began
        if all(answer.status == 401 for answer in answers) or took_s > LOOKS_S:
            break
        time.sleep(POLL_S)
    for answer in answers:
        expect.refused(answer, "unauthenticated")
    expect.in_time(took_s, ENDS_S, "a revoked key is refused")


@requirement("HST-008")
def test_hst_008_a_revoked_key_is_refused(context: CheckContext) -> None:
    """A key is used, revoked, and used again. Expect a refusal within five seconds."""
    with made_key(context) as key, made_key(context) as other:
        client = context.client_with_token(key["secret"])
        expect.ok(context.call("list_runs", http_client=client))
        answer = call_hosting(context, "DELETE", f"/keys/{key['key_id']}")
        expect.equal(answer.status, 204, "the status of revoke_key")
        wait_until_refused(context, client)
        valid = context.client_with_token(other["secret"])
        expect.ok(context.call("list_runs", http_client=valid))


@requirement("HST-009")
def test_hst_009_cannot_touch_what_others_have(context: CheckContext) -> None:
    """Another account revokes a key and reads a submission. Expect `not_found`."""
    track, other = entered_track(context), context.second_account
    require_hosting(call_hosting(context, "GET", "/keys", http_client=other))
    created = call_hosting(
        context, "POST", "/submissions", {"track_id": track["track_id"]}
    )
    submission = require_hosting(created, 201)["submission_id"]
    path = f"/submissions/{submission}"
    try:
        with made_key(context) as key:
            for method, at in (("DELETE", f"/keys/{key['key_id']}"), ("GET", path)):
                answer = call_hosting(context, method, at, http_client=other)
                expect.refused(answer, "not_found")
            mine = context.client_with_token(key["secret"])
            expect.ok(call_hosting(context, "GET", path, http_client=mine))
    finally:
        call_hosting(context, "POST", f"{path}/stop")


@requirement("HST-010")
def test_hst_010_cannot_run_outside_of_a_track(context: CheckContext) -> None:
    """A benchmark of no track, then that of one. Expect `forbidden`, then a run."""
    entered_track(context)
    tracks = expect.ok(call_hosting(context, "GET", "/tracks"))["tracks"]
    evaluated = {phase["benchmark_id"] for track in tracks for phase in track["phases"]}
    listed = context.require(lambda: context.call("list_benchmarks"), 200, "list")
    names = [row["benchmark_id"] for row in listed["benchmarks"]]
    outside = [name for name in names if name not in evaluated]
    if not outside:
        raise NotApplicable("every benchmark has a track")
    body = context.submit_body(benchmark_id=outside[0])
    expect.refused(submit(context, body), "forbidden")
    expect.ok(submit(context, context.submit_body()), 201)


@requirement("HST-014")
def test_hst_014_participants_are_no_administrators(context: CheckContext) -> None:
    """A participant asks for reviews and images, and decides on itself. Expect
    `forbidden`."""
    own = require_hosting(call_hosting(context, "GET", "/account"))
    if own["role"] != "participant":
        raise NotApplicable("the first account is an administrator")
    for path in ("/reviews", "/images"):
        expect.refused(call_hosting(context, "GET", path), "forbidden")
    path = f"/accounts/{own['account']}/decisions"
    body = {"decision": "suspend", "reason": "A check of the conformance kit."}
    expect.refused(call_hosting(context, "POST", path, body), "forbidden")


@requirement("HST-015")
def test_hst_015_a_run_counts_at_once(context: CheckContext) -> None:
    """The limits of a track before and after a run. Expect one more of each."""

    def used() -> dict[str, int]:
        track = expect.ok(call_hosting(context, "GET", f"/tracks/{name}"))
        phase = open_phase(track) or {"limits": []}
        return {limit["limit"]: limit["used"] for limit in phase["limits"]}

    name = entered_track(context)["track_id"]
    before = used()
    if not before:
        raise NotApplicable("the track has no limits")
    expect.ok(submit(context, context.submit_body()), 201)
    expect.equal(used(), {limit: n + 1 for limit, n in before.items()}, "used")


@requirement("HST-016")
def test_hst_016_cannot_make_a_stronger_key(context: CheckContext) -> None:
    """A key without `run` makes keys. Expect `forbidden` for one that has it."""
    with made_key(context, scopes=["read", "account"]) as key:
        client = context.client_with_token(key["secret"])
        strong = call_hosting(context, "POST", "/keys", {"scopes": ["run"]}, client)
        expect.refused(strong, "forbidden")
        weak = call_hosting(context, "POST", "/keys", {"scopes": ["read"]}, client)
        made = expect.ok(weak, 201)
        call_hosting(context, "DELETE", f"/keys/{made['key_id']}")


@requirement("HST-017")
def test_hst_017_a_revoked_key_ends_its_streams(context: CheckContext) -> None:
    """A run is followed with a key that is revoked, and the log of a submission, where
    the host plays policies. Expect the end of each in five seconds."""
    track = entered_track(context)["track_id"]
    answer = call_hosting(context, "POST", "/submissions", {"track_id": track})
    path = f"/submissions/{expect.ok(answer, 201)['submission_id']}"
    paths = []
    try:
        if call_hosting(context, "GET", f"{path}/log").status != 404:
            paths.append(f"{BASE}{path}/log")
        if context.offers("events"):
            operation = context.spec.operations["stream_events"]
            paths.append(operation.path.format(run_id=context.submit("score").id))
        if not paths:
            raise NotApplicable("the server has no streams, and plays no policies")
        for followed in paths:
            _expect_the_end_with_its_key(context, followed)
    finally:
        call_hosting(context, "POST", f"{path}/stop")


def _expect_the_end_with_its_key(context: CheckContext, path: str) -> None:
    with made_key(context, scopes=["read"]) as key:
        client = context.client_with_token(key["secret"])
        url, accept = client.base_url + path, {"Accept": EVENT_STREAM}
        with client.stream(None, url, accept) as stream:
            if isinstance(stream, Answer):
                expect.ok(stream)
                return
            call_hosting(context, "DELETE", f"/keys/{key['key_id']}")
            began = time.monotonic()
            end = threading.Timer(LOOKS_S, stream.shut_down)
            end.start()
            for _ in stream.parts():
                pass
            end.cancel()
    expect.in_time(time.monotonic() - began, ENDS_S, "the stream ends")


@requirement("HST-018")
def test_hst_018_a_program_waits_for_its_key(context: CheckContext) -> None:
    """A code waits, another is unknown. Expect `authorization_pending`, `not_found`."""
    begun = expect.ok(call_with_form(context, "/device_authorizations", label="kit"))

    def poll(code: str) -> Answer:
        return call_with_form(
            context, "/device_tokens", grant_type=GRANT, device_code=code
        )

    waiting = expect.ok(poll(begun["device_code"]), 202)
    expect.equal(waiting["error"], "authorization_pending", "error")
    expect.refused(poll("unknown"), "not_found")


@requirement("HST-019")
def test_hst_019_a_submission_says_what_follows(context: CheckContext) -> None:
    """A submission is created and stopped. Expect a deadline until it is stopped."""
    track = entered_track(context)["track_id"]
    answer = call_hosting(context, "POST", "/submissions", {"track_id": track})
    created = expect.ok(answer, 201)
    path = f"/submissions/{created['submission_id']}"
    read = expect.ok(call_hosting(context, "GET", path))
    for submission in (created, read):
        for member in ("deadline_at", "reason", "next_action"):
            expect.true(submission.get(member), f"{member} of a new submission")
    stopped = expect.ok(call_hosting(context, "POST", f"{path}/stop"))
    expect.equal(stopped["state"], "stopped", "state")


@requirement("HST-043")
def test_hst_043_an_end_has_an_owner(context: CheckContext) -> None:
    """A submission is stopped. Expect who did it, why, and what to do now."""
    track = entered_track(context)["track_id"]
    answer = call_hosting(context, "POST", "/submissions", {"track_id": track})
    path = f"/submissions/{require_hosting(answer, 201)['submission_id']}"
    stopped = expect.ok(call_hosting(context, "POST", f"{path}/stop"))
    for submission in (stopped, expect.ok(call_hosting(context, "GET", path))):
        expect.equal(submission.get("cause"), "owner", "cause")
        for member in ("reason", "next_action"):
            expect.true(submission.get(member), f"{member} of a stopped submission")


@requirement("HST-020")
def test_hst_020_an_upload_goes_on_where_it_ended(context: CheckContext) -> None:
    """A part at a wrong offset, then at the right one. Expect a refusal, then more."""
    upload = HostedUpload(context)
    expect.equal(expect.ok(upload.append(0, 100))["offset"], 100, "offset")
    for offset in (0, 99, 101):
        expect.refused(upload.append(offset, offset + 100), "invalid_request")
        expect.equal(expect.ok(upload.read())["offset"], 100, "offset")
    done = expect.ok(upload.append(100, upload.size))
    expect.equal(done["is_complete"], True, "is_complete")


@requirement("HST-021")
def test_hst_021_an_upload_has_its_digest(context: CheckContext) -> None:
    """As many bytes, and others; then the right ones. Expect only these complete."""
    upload = HostedUpload(context)
    upload.append(0, upload.size, content=bytes(upload.size))
    expect.equal(expect.ok(upload.read())["is_complete"], False, "is_complete")
    again = HostedUpload(context)
    done = expect.ok(again.append(0, again.size))
    expect.equal(done["is_complete"], True, "is_complete")


@requirement("HST-026")
def test_hst_026_others_see_what_a_phase_shows(context: CheckContext) -> None:
    """A run is completed in each phase that the kit can play. Expect that the second
    account sees the score and the record by the table."""
    track, other = entered_track(context), context.second_account
    phases = {phase["phase_id"]: phase for phase in track["phases"]}
    for phase in playable(track):
        run = played_run(context, phase)
        own = find_result(context, track["track_id"], run.id)
        expect.true(own is not None, "the result for its own account")
        assert own is not None
        shown_in = phases[own["phase_id"]]
        sees_score, sees_record = (
            shown_in[part] == "at_once" for part in ("score", "record")
        )
        seen = find_result(context, track["track_id"], run.id, other)
        expect.equal(seen is not None, sees_score or sees_record, "a result for others")
        if seen is not None:
            expect.equal(seen["score"], own["score"] if sees_score else None, "score")
        path = f"/results/{run.id}/record"
        record = call_hosting(context, "GET", path, http_client=other)
        if sees_record:
            expect.equal(record.status, 200, "the status of fetch_result_record")
        else:
            expect.refused(record, "not_found")


@requirement("HST-044")
def test_hst_044_a_result_says_why_it_has_no_rank(context: CheckContext) -> None:
    """The entry of a run is flagged, the flag is taken back, and the entry withdrawn.
    Expect `excluded` to be null, `flagged`, null and `withdrawn`."""
    track = entered_track(context)
    phase = open_phase(track)
    assert phase is not None, "as `entered_track` chooses it"
    run = played_run(context, phase)

    def expect_excluded(value: str | None) -> None:
        result = find_result(context, track["track_id"], run.id) or {}
        expect.equal(result.get("excluded", ""), value, "excluded")

    expect_excluded(None)
    if not context.offers("board"):
        return  # there are no flags
    if phase["score"] != "at_once":
        raise SetUpFailed(
            "no entry shows the score before the phase ends", allowed=True
        )
    entry_id = require_entry(run)["entry_id"]
    flag_entry(context, entry_id, flagged=True)
    try:
        expect_excluded("flagged")
    finally:
        flag_entry(context, entry_id, flagged=False)
    expect_excluded(None)
    context.require(lambda: run.call("withdraw_entry"), 200, "withdraw_entry")
    expect_excluded("withdrawn")


@requirement("HST-027")
def test_hst_027_cannot_publish_what_a_phase_hides(context: CheckContext) -> None:
    """A run is published in a phase that hides scores. Expect `forbidden`. A private
    entry shows nothing to others: expect 201."""
    if not context.offers("board"):
        raise NotApplicable("the server has no leaderboard: the profile `board`")
    hiding = [
        phase
        for phase in playable(entered_track(context))
        if phase["score"] != "at_once" and phase["options"] is not None
    ]
    if not hiding:
        raise NotApplicable("no phase that the kit can play hides scores")
    run = played_run(context, hiding[0])
    expect.refused(try_publish(run), "forbidden")
    expect.ok(try_publish(run, is_public=False), 201)


DRAWN_VALUES = {"seal": "key_sha256", "commit": "digest", "open": "key"}


@requirement("HST-031")
def test_hst_031_draws_have_their_order(context: CheckContext) -> None:
    """The history is read. Expect of each draw the leaves of the table, in its order. A
    key that was opened is the one that was sealed."""
    if not context.offers("board"):
        raise NotApplicable("the server has no history: the profile `board`")
    draws: dict[str, list[dict[str, Any]]] = {}
    for leaf in map(json.loads, read_leaves(context)):
        if "draw_id" in leaf:
            draws.setdefault(leaf["draw_id"], []).append(leaf)
    if not draws:
        raise NotApplicable("the history has no draw")
    for draw_id, leaves in draws.items():
        kinds = [leaf["kind"] for leaf in leaves]
        commits = kinds.count("commit")
        whole = ["seal", *["commit"] * commits, "draw", "open"]
        least = 1 if not commits else 1 + commits
        expect.equal(kinds, whole[: max(least, len(kinds))], f"leaves of {draw_id}")
        for leaf in leaves:
            if (member := DRAWN_VALUES.get(leaf["kind"])) is not None:
                expect.true(leaf.get(member), f"{member} of `{leaf['kind']}`")
        if kinds[-1] == "open":
            sealed = hashlib.sha256(bytes.fromhex(leaves[-1]["key"])).hexdigest()
            expect.equal(leaves[0]["key_sha256"], sealed, "key_sha256")


@requirement("HST-033")
def test_hst_033_others_have_no_organisation_of_mine(context: CheckContext) -> None:
    """Another account reads, joins and uses an organisation. Expect `not_found`."""
    other = context.second_account
    with made_organisation(context) as name:
        path = f"/organisations/{name}"
        invitation = {"email": "kit@example.org"}
        for method, at, body in (
            ("GET", path, None),
            ("POST", f"{path}/invitations", invitation),
            ("POST", "/keys", {"organisation": name}),
        ):
            expect.refused(call_hosting(context, method, at, body, other), "not_found")
        expect.ok(call_hosting(context, "GET", path))


@requirement("HST-035")
def test_hst_035_who_leaves_has_no_key_any_more(context: CheckContext) -> None:
    """A key of an organisation is used before and after its account leaves. Expect an
    answer, then `unauthenticated` within five seconds."""
    with (
        made_organisation(context) as name,
        made_key(context, organisation=name) as key,
    ):
        client = context.client_with_token(key["secret"])
        expect.ok(context.call("list_runs", http_client=client))
        answer = leave_organisation(context, name)
        expect.equal(answer.status, 204, "the status of remove_member")
        wait_until_refused(context, client)


@requirement("HST-036")
def test_hst_036_runs_belong_to_the_organisation(context: CheckContext) -> None:
    """An organisation enters a track and makes a run. Expect it for its keys alone."""
    track = entered_track(context)
    if track["entry"] != "open":
        raise NotApplicable("the host reviews entries of this track")
    with (
        made_organisation(context) as name,
        made_key(context, organisation=name) as key,
    ):
        client = context.client_with_token(key["secret"])
        path = f"/tracks/{track['track_id']}/entries"
        require_hosting(call_hosting(context, "POST", path, {}, client), 201)
        run = context.submit("score", http_client=client)
        expect.ok(context.call("get_run", run_id=run.id, http_client=client))
        expect.refused(context.call("get_run", run_id=run.id), "not_found")
