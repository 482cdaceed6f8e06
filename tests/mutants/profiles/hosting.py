"""Mutants of the profile `hosting`: accounts, keys, tracks and submissions."""

from __future__ import annotations

import dataclasses
from typing import Any

import msgspec

from reference_platform.accounts import account_rules
from reference_platform.accounts.account_keys import Key, Keys
from reference_platform.accounts.accounts import Accounts
from reference_platform.accounts.devices import Devices
from reference_platform.accounts.organisations import Member, Organisations
from reference_platform.http import (
    api_calls,
    api_handlers,
    server_calls,
    track_handlers,
)
from reference_platform.images import upload_folder
from reference_platform.images.upload_folder import UploadFolder
from reference_platform.submissions.submission_store import SubmissionStore
from reference_platform.tracks import tracks
from reference_platform.tracks.results import Results
from reference_platform.tracks.track_rules import Phase, Place
from reference_platform.tracks.tracks import Tracks
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused
from reference_server.runs import board_service
from tests.mutants import instead_of, mutant


@mutant("HST-001", through=instead_of(account_rules, "check_sign_up"))
def names_one_wrong_member_of_many(right: Any, filled: Any) -> None:
    """A person corrects a form again and again."""
    try:
        right(filled)
    except Refused as refused:
        refused.errors = refused.errors[:1]
        raise


@mutant("HST-002", through=instead_of(Accounts, "register"))
async def says_which_addresses_are_known(
    right: Any, self: Accounts, filled: Any, *rest: Any, **more: Any
) -> Any:
    """A spammer learns which researchers take part."""
    statement = "SELECT count(*) FROM accounts WHERE email = ?"
    if self.database.number(statement, filled.email):
        raise Refused("invalid_request", "There is an account with this address.")
    return await right(self, filled, *rest, **more)


@mutant("HST-007", through=instead_of(Keys, "make"))
def stores_the_secret_of_a_key(right: Any, self: Keys, *rest: Any, **more: Any) -> Any:
    """Every page that lists keys shows what others could use."""
    key, secret = right(self, *rest, **more)
    self._database.execute(
        "UPDATE keys SET label = ? WHERE key_id = ?", secret, key.key_id
    )
    return key, secret


@mutant("HST-008", "HST-017", through=instead_of(Keys, "revoke"))
def only_says_that_a_key_is_revoked(
    right: Any, self: Keys, account: str, key_id: str, now: float
) -> None:
    """A stolen key works until it expires."""
    if all(key.key_id != key_id for key in self.of_account(account, now)):
        right(self, account, key_id, now)


@mutant("HST-008", "HST-017", "HST-035", through=instead_of(Keys, "find"))
def accepts_revoked_keys_for_its_own_api(
    right: Any, self: Keys, secret: str, now: float
) -> Any:
    """A thief of a revoked key makes new ones with it."""
    statement = "SELECT * FROM keys WHERE hash = ?"
    found = self._database.row(Key, statement, hash_of(secret))
    return right(self, secret, now) or found


@mutant("HST-017", through=instead_of(api_calls.LastingEndpoint, "_look"))
def lets_a_log_go_on_without_its_key(_right: Any, *_rest: Any) -> None:
    """A thief reads on what a policy prints, for as long as it is played."""


@mutant("HST-009", through=instead_of(SubmissionStore, "get_own"))
def shows_the_submissions_of_others(
    _right: Any, self: SubmissionStore, submission_id: str, _account: str
) -> Any:
    """Competitors read what others hand in."""
    return self.get(submission_id)


@mutant("HST-009", through=instead_of(Keys, "revoke"))
def revokes_the_keys_of_others(
    _right: Any, self: Keys, _account: str, key_id: str, now: float
) -> None:
    """A competitor ends the evaluation of another."""
    self._database.execute(
        "UPDATE keys SET revoked_at = ? WHERE key_id = ?", now, key_id
    )


@mutant("HST-010", through=instead_of(tracks, "choose_phase"))
def admits_runs_of_any_benchmark(
    right: Any, entered: Any, asked: Any, *rest: Any
) -> Any:
    """Participants use the machines of the host for what is not evaluated."""
    phases = [phase for track in entered for phase in track.phases]
    if asked.benchmark_id in {phase.benchmark_id for phase in phases}:
        return right(entered, asked, *rest)
    return Place(entered[0], phases[0])


@mutant("HST-014", through=instead_of(api_calls, "_authenticate"))
def lets_every_account_review(right: Any, parts: Any, request: Any, scope: str) -> Any:
    """A participant approves its own accounts, and reads the addresses of others."""
    return right(parts, request, "read" if scope == "host" else scope)


@mutant("HST-015", through=instead_of(tracks, "usages"))
def counts_runs_that_have_ended(right: Any, phase: Any, runs: Any, now: float) -> Any:
    """Many runs at once are more than the track allows."""
    return right(phase, [run for run in runs if not run.is_open], now)


@mutant("HST-016", through=instead_of(api_handlers, "make_key"))
async def makes_stronger_keys(right: Any, call: Any) -> Any:
    """A key that may only read, once leaked, makes one that submits runs."""
    strong = msgspec.structs.replace(call.key, scopes="read run account host")
    return await right(dataclasses.replace(call, key=strong))


@mutant("HST-018", through=instead_of(Devices, "poll"))
def lets_a_program_wait_for_ever(right: Any, self: Devices, code: str) -> Any:
    """`proctor login` never says that its code is too old."""
    try:
        return right(self, code)
    except Refused:
        return "authorization_pending"


@mutant("HST-019", through=instead_of(track_handlers, "submission_view"))
def has_submissions_without_a_deadline(right: Any, submission: Any) -> Any:
    """A submission is stuck, and its owner waits for weeks."""
    return right(submission) | {"deadline_at": None}


@mutant("HST-043", through=instead_of(track_handlers, "submission_view"))
def ends_submissions_without_an_owner(right: Any, submission: Any) -> Any:
    """A participant changes a policy that the host has stopped."""
    return right(submission) | {"cause": ""}


@mutant("HST-020", through=instead_of(UploadFolder, "append"))
async def appends_at_any_offset(
    right: Any, self: UploadFolder, account: str, digest: str, size: int, *rest: Any
) -> Any:
    """A part that is sent twice breaks an image of many gigabytes."""
    offset = self.state(account, digest).offset
    return await right(self, account, digest, size, offset, *rest[1:])


@mutant("HST-021", through=instead_of(upload_folder, "_digest_of"))
def believes_the_name_of_an_upload(_right: Any, path: Any) -> str:
    """The host reviews other bytes than it runs."""
    return f"sha256:{path.stem}"


@mutant("HST-026", "HST-027", through=instead_of(Phase, "shows"))
def shows_results_before_a_phase_closes(
    right: Any, self: Phase, part: str, now: float
) -> bool:
    """Participants of a test see how others do, and try again."""
    return bool(right(self, part, now) or (part == "score" and self.score != "never"))


@mutant("HST-026", through=instead_of(Results, "get"))
def shows_the_records_of_others(
    right: Any, self: Results, result_id: str, part: str, owners: Any
) -> Any:
    """A competitor copies recorded actions that the host has promised to keep."""
    try:
        return right(self, result_id, part, owners)
    except Refused:
        return right(self, result_id, part, _EveryName())


class _EveryName:
    def __contains__(self, _name: object) -> bool:
        return True


@mutant("HST-044", through=instead_of(track_handlers, "result_view"))
def never_says_that_a_result_is_excluded(right: Any, result: Any) -> Any:
    """A reader takes a result that the host has flagged for the best one."""
    return {**right(result), "excluded": None}


@mutant("HST-044", through=instead_of(track_handlers, "result_view"))
def ranks_a_result_that_was_withdrawn(right: Any, result: Any) -> Any:
    """The track praises what its author has taken off the leaderboard."""
    view = right(result)
    return view | {"excluded": None} if view["excluded"] == "withdrawn" else view


@mutant("HST-027", through=instead_of(Tracks, "check_publication"))
def publishes_scores_of_an_open_test(_right: Any, _self: Tracks, _run_id: str) -> None:
    """The leaderboard shows what the track promises to show after its end."""


@mutant("HST-031", through=instead_of(board_service, "next_leaf"))
def seals_no_key(right: Any, *rest: Any) -> Any:
    """The host chooses the key of a draw when it knows the policies."""
    leaf = right(*rest)
    return {name: value for name, value in leaf.items() if name != "key_sha256"}


@mutant("HST-033", through=instead_of(Organisations, "_member"))
def shows_organisations_to_every_account(
    right: Any, self: Organisations, organisation: str, account: str
) -> Any:
    """A competitor reads who works together, and submits in their name."""
    try:
        return right(self, organisation, account)
    except Refused:
        return Member(organisation, account, "admin")


@mutant("HST-035", through=instead_of(Organisations, "remove"))
def leaves_former_members_their_keys(
    _right: Any, self: Organisations, organisation: str, _actor: str, account: str
) -> None:
    """Who has left a team goes on to use its quota and to read its results."""
    self.database.execute(
        "UPDATE keys SET organisation = '' WHERE account = ? AND organisation = ?",
        *(account, organisation),
    )


@mutant("HST-036", through=instead_of(server_calls, "owner_of"))
def gives_the_runs_of_a_team_to_one_member(_right: Any, key: Key) -> str:
    """A team loses its results with the member who submitted them."""
    return key.account
