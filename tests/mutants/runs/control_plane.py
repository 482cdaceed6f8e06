"""Mutants of the control plane: service, accounts, benchmarks, runs."""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from starlette.responses import Response

from reference_server.http import auth, codec, dispatch, handlers, problems
from reference_server.http.dispatch import OperationCall
from reference_server.http.handlers import Handlers
from reference_server.rules import effects, scoring
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from reference_server.storage.store import Store
from reference_server.views import run_views
from reference_sim import benchmark_registry
from tests.mutants import mutant, put

# --- service, accounts, benchmarks ---


@mutant("SVC-001")
def requires_a_token_for_the_service() -> None:
    """A client without a token cannot read the service description."""
    right = Handlers.table

    def wrong(self: Handlers) -> Any:
        table = right(self)
        table["/v1"]["GET"] = dispatch.Operation(self.describe_service, scope="read")
        return table

    put(Handlers, "table", wrong)


@mutant("AUTH-001", "AUTH-002")
def accepts_requests_without_a_token() -> None:
    """No token is needed."""
    right = auth.Tokens.authenticate

    def wrong(self: auth.Tokens, authorization: str | None, scope: str) -> auth.Caller:
        try:
            return right(self, authorization, scope)
        except Refused as refused:
            if refused.code == "forbidden":
                raise
            return auth.Caller("get_of_any_account", auth.SCOPES)

    put(auth.Tokens, "authenticate", wrong)


@mutant("AUTH-002")
def does_not_say_how_to_authenticate() -> None:
    """A generic HTTP client does not know what to send."""
    right = problems.problem_response

    def wrong(refused: Refused, *headers: Any) -> Response:
        response = right(refused, *headers)
        if "www-authenticate" in response.headers:
            del response.headers["www-authenticate"]
        return response

    put(dispatch, "problem_response", wrong)


@mutant("AUTH-004")
def lists_the_runs_of_every_account() -> None:
    """Every account sees the evaluations of all accounts."""
    import sqlalchemy as sa

    from reference_server.storage import store
    from reference_server.storage.database_tables import runs

    async def wrong(
        self: Store, _account: str, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        query = sa.select(runs.c.number, runs.c.run_id)
        query = query.where(store._IS_THERE)
        if before is not None:
            query = query.where(runs.c.number < before)
        query = query.order_by(runs.c.number.desc()).limit(limit)
        return await self.read(lambda found: [(n, r) for n, r in found.execute(query)])

    put(Store, "page", wrong)
    right = RunRegistry.page

    async def wrong_page(self: RunRegistry, *arguments: Any) -> list[Any]:
        get = RunRegistry.get

        async def get_of_any_account(
            self: RunRegistry, run_id: str, _account: str | None = None
        ) -> Run:
            return await get(self, run_id)

        put(RunRegistry, "get", get_of_any_account)
        try:
            return await right(self, *arguments)
        finally:
            put(RunRegistry, "get", get)

    put(RunRegistry, "page", wrong_page)


@mutant("BEN-001")
def does_not_list_calibration() -> None:
    """The kit cannot find the benchmark that it plays."""
    right = Benchmarks.summaries

    def wrong(self: Benchmarks) -> list[dict[str, Any]]:
        return [b for b in right(self) if b["benchmark_id"] != "calibration"]

    put(Benchmarks, "summaries", wrong)


@mutant("BEN-002")
def answers_for_unknown_benchmarks() -> None:
    """A misspelt benchmark seems to exist."""
    right = Benchmarks.view

    async def wrong(self: Benchmarks, benchmark_id: str) -> dict[str, Any]:
        known = benchmark_id in benchmark_registry.benchmark_ids()
        return await right(self, benchmark_id if known else "calibration")

    put(Benchmarks, "view", wrong)


@mutant("BEN-003", "BEN-004")
def hashes_a_benchmark_anew_each_time() -> None:
    """Two runs of the same benchmark cannot be compared."""
    right = Benchmarks.view
    count = iter(range(10**9))

    async def wrong(self: Benchmarks, benchmark_id: str) -> Any:
        shown = await right(self, benchmark_id)
        return shown | {"manifest_sha256": f"{next(count):064x}"}

    put(Benchmarks, "view", wrong)


# --- runs ---


def spoil_run(change: Any) -> None:
    """Let `change(body, run)` spoil every run that is shown."""
    right = run_views.run_view

    def wrong(run: Run, *rest: Any) -> dict[str, Any]:
        body = right(run, *rest)
        change(body, run)
        return body

    put(run_views, "run_view", wrong)


@mutant("RUN-001")
def returns_a_wrong_location_after_submit() -> None:
    """A client that follows Location does not find its run."""
    right = Handlers.submit_run

    async def wrong(self: Handlers, call: Any) -> Response:
        response = await right(self, call)
        response.headers["Location"] = "/v1/runs/run_elsewhere"
        return response

    put(Handlers, "submit_run", wrong)


@mutant("RUN-002", "RUN-019")
def calls_a_new_run_running() -> None:
    """A client believes that a worker is attached."""
    right = Handlers.submit_run

    async def wrong(self: Handlers, call: Any) -> Response:
        response = await right(self, call)
        body = json.loads(bytes(response.body)) | {"state": "running"}
        answer = codec.encode_response(body, status=201)
        answer.headers["Location"] = response.headers["Location"]
        return answer

    put(Handlers, "submit_run", wrong)


@mutant("RUN-005")
def shares_idempotency_keys_between_accounts() -> None:
    """Two accounts that count their runs from 1 block each other."""
    right_add, right_find = Store.insert, Store.find_key
    owners: dict[str, str] = {}

    async def insert(
        self: Store, run: Run, key: str | None, body: str, check: Any = None
    ) -> bool:
        if key is not None and owners.setdefault(key, run.account) != run.account:
            return False
        return await right_add(self, run, key, body, check)

    async def find(self: Store, account: str, key: str) -> Any:
        found = await right_find(self, owners.get(key, account), key)
        return found and (found[0] + "-other", found[1])

    put(Store, "insert", insert)

    async def find_own(self: Store, account: str, key: str) -> Any:
        if owners.get(key, account) == account:
            return await right_find(self, account, key)
        return await find(self, account, key)

    put(Store, "find_key", find_own)


@mutant("RUN-006")
def points_at_the_wrong_member() -> None:
    """A user looks for the mistake in the wrong place."""
    right = Benchmarks.resolve

    async def wrong(self: Benchmarks, submission: Any) -> Any:
        try:
            return await right(self, submission)
        except Refused as refused:
            refused.errors = tuple(
                ("/benchmark" if p == "/benchmark_id" else p, d)
                for p, d in refused.errors
            )
            raise

    put(Benchmarks, "resolve", wrong)


@mutant("RUN-007")
def ignores_options_that_do_not_apply() -> None:
    """A submitter believes that the options were applied."""
    right = Benchmarks.resolve

    async def wrong(self: Benchmarks, submission: Any) -> Any:
        if submission["benchmark_id"] != "calibration":
            submission = {k: v for k, v in submission.items() if k != "options"}
        return await right(self, submission)

    put(Benchmarks, "resolve", wrong)


@mutant("RUN-008")
def omits_the_queue_position() -> None:
    """A user cannot estimate the time in the queue."""
    put(RunRegistry, "queue_position", lambda _self, _run: None)


@mutant("RUN-009")
def skips_a_run_between_pages() -> None:
    """A run is missing from the list."""
    right = Store.page

    async def wrong(
        self: Store, account: str, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        before = before - 1 if before is not None else None
        return await right(self, account, before, limit)

    put(Store, "page", wrong)


@mutant("AUTH-003", "RUN-010")
def answers_for_unknown_runs() -> None:
    """A run that was never submitted seems to wait."""
    right = Handlers.get_run

    async def wrong(self: Handlers, call: Any) -> Response:
        try:
            return await right(self, call)
        except Refused as refused:
            raise Refused("illegal_transition", refused.detail) from refused

    put(Handlers, "get_run", wrong)


@mutant("RUN-014", "RUN-022")
def counts_episodes_in_play_twice() -> None:
    """Progress exceeds a hundred per cent."""

    def wrong(body: dict[str, Any], _run: Run) -> None:
        progress = body["progress"]
        progress["episodes_pending"] += progress["episodes_in_progress"]

    spoil_run(wrong)


@mutant("RUN-016")
def names_an_endpoint_without_a_host() -> None:
    """A client cannot reach the data plane."""
    spoil_run(lambda body, _: body.update(endpoint="/"))


def _unlimited(*names: str) -> None:
    right = RunService.prepare_run

    async def wrong(self: RunService, account: str, submission: dict[str, Any]) -> Run:
        wanted = {name: submission.pop(name) for name in names if name in submission}
        run = await right(self, account, submission)
        for name, value in wanted.items():
            setattr(run, name, value)
        submission.update(wanted)
        return run

    put(RunService, "prepare_run", wrong)


@mutant("RUN-015")
def grants_any_number_of_workers() -> None:
    """One submitter can take every simulator."""
    _unlimited("max_workers")


@mutant("LEASE-007")
def grants_leases_of_any_length() -> None:
    """A crashed client keeps its session for a day."""
    _unlimited("idle_timeout_s")


@mutant("RUN-017")
def replaces_an_image_choice_it_does_not_offer() -> None:
    """A policy is evaluated on other images than requested."""
    right = Benchmarks._resolved

    def wrong(
        self: Benchmarks, name: str, options: Any, images: Any, *choices: Any
    ) -> Any:
        try:
            return right(self, name, options, images, *choices)
        except benchmark_registry.InvalidChoice as error:
            if not error.pointer.startswith("/images"):
                raise
            return right(self, name, options, None, *choices)

    put(Benchmarks, "_resolved", wrong)


@mutant("EPI-006", "RUN-009")
def repeats_an_episode_between_pages() -> None:
    """An episode seems to be scored twice."""
    right = handlers._number

    def wrong(cursor: str | None) -> int | None:
        number = right(cursor)
        return number - 1 if number is not None else None

    put(handlers, "_number", wrong)


@mutant("SCORE-010")
def hides_scores_until_the_end() -> None:
    """Partial results cannot be read."""
    right = Handlers.get_score

    async def wrong(self: Handlers, call: Any) -> Response:
        run = await self.service.get_run(call.account, call.path["run_id"])
        if run.state == "stopped":
            raise Refused("illegal_transition", "Not while stopped.")
        return await right(self, call)

    put(Handlers, "get_score", wrong)


@mutant("SCORE-008")
def counts_abandoned_episodes_as_failures() -> None:
    """Abandoned episodes cannot be distinguished from failed ones."""
    right = scoring.score_of

    def wrong(episodes: Any) -> dict[str, Any]:
        score = right(episodes)
        counts = score["counts"]
        counts["failure"] += counts["abandoned"]
        counts["abandoned"] = 0
        return score

    put(run_views, "score_of", wrong)


@mutant("RUN-003", "RUN-004", "RUN-019", "RUN-026", "RUN-027", "RUN-028")
def ignores_idempotency_keys() -> None:
    """A repeated submit evaluates everything twice."""
    right = RunRegistry.add

    async def wrong(self: RunRegistry, run: Run, _key: str | None, body: str) -> Run:
        return await right(self, run, None, body)

    put(RunRegistry, "add", wrong)


@mutant("RUN-004")
def answers_a_used_key_whatever_the_body() -> None:
    """The second of two different runs is not created, without an error."""
    right = RunRegistry.add

    async def wrong(self: RunRegistry, run: Run, key: str | None, _body: str) -> Run:
        return await right(self, run, key, "same")

    put(RunRegistry, "add", wrong)


@mutant("AUTH-003", "CMP-010")
def shows_runs_to_every_account() -> None:
    """Every account can read and stop the runs of all accounts."""
    right = RunRegistry.get

    async def wrong(self: RunRegistry, run_id: str, _account: str | None = None) -> Run:
        return await right(self, run_id)

    put(RunRegistry, "get", wrong)


@mutant("AUTH-003", "CMP-010")
def says_that_a_foreign_run_exists() -> None:
    """Run ids of other accounts can be found by trying."""
    right = RunRegistry.get

    async def wrong(self: RunRegistry, run_id: str, account: str | None = None) -> Run:
        run = await right(self, run_id)
        if account not in (None, run.account):
            raise Refused("forbidden", "This run is not yours.")
        return run

    put(RunRegistry, "get", wrong)


@mutant("AUTH-005")
def lets_readers_write() -> None:
    """A token for a dashboard can stop runs."""
    right = auth.Tokens.parse

    def wrong(text: str) -> auth.Tokens:
        tokens: auth.Tokens = right(text)
        for hashed, caller in tokens._by_hash.items():
            tokens._by_hash[hashed] = auth.Caller(caller.account, auth.SCOPES)
        return tokens

    put(auth.Tokens, "parse", wrong)


@mutant("RUN-011", "RUN-012", "RUN-013")
def ignores_etags() -> None:
    """Every poll transfers the whole answer."""
    put(handlers, "_matches", lambda _wanted, _etag: False)


@mutant("LEASE-011", "RUN-012")
def answers_long_polls_only_at_their_end() -> None:
    """A long poll is no faster than polling at intervals."""

    async def wrong(
        _self: RunRegistry, _change_events: asyncio.Event, timeout_s: float
    ) -> bool:
        await asyncio.sleep(timeout_s)
        return True

    put(RunRegistry, "wait_for_change", wrong)


def wait_less(is_meant: Callable[[Handlers, OperationCall], bool]) -> None:
    """Let the calls of `get_run` that are meant wait for nothing."""
    right = Handlers.get_run

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        if is_meant(self, call):
            call = replace(call, headers={**call.headers, "prefer": "wait=0"})
        return await right(self, call)

    put(Handlers, "get_run", wrong)


@mutant("RUN-012")
def answers_waits_that_are_too_long_at_once() -> None:
    """A script that asks for a long wait sends as many requests as it can."""

    def is_too_long(self: Handlers, call: OperationCall) -> bool:
        wait_s = call.headers.get("prefer", "wait=0").removeprefix("wait=")
        return float(wait_s) > self.settings.wait_s_max

    wait_less(is_too_long)


@mutant("RUN-012", "RUN-013")
def does_not_wait_beside_any_etag() -> None:
    """A script that names no ETag of its own sends as many requests as it can."""
    wait_less(lambda _self, call: call.headers.get("if-none-match") == "*")


@mutant("LIFE-801")
def forgets_runs_that_were_held_in_the_queue() -> None:
    """A queued run never starts."""
    right = effects.admit

    def wrong(run: Run, now_wall: float) -> bool:
        is_held = bool(run.submission.get("options", {}).get("queue_s"))
        return not is_held and right(run, now_wall)

    put(effects, "admit", wrong)


# --- the queue ---


@mutant("LIFE-504", "LIFE-604", "LIFE-810", "RUN-012")
def lets_a_resumed_run_out_of_the_queue_at_once() -> None:
    """A run that is resumed overtakes those that wait."""
    right = effects.resume
    put(effects, "resume", lambda run, _until: right(run, 0.0))


@mutant("LIFE-604", "LIFE-810", "RUN-012")
def goes_on_with_the_queue_time_of_the_submit() -> None:
    """A run that waits anew leaves the queue when its first wait would have ended."""
    right = effects.resume
    put(effects, "resume", lambda run, _until: right(run, run.queue_until_wall))


@mutant("LIFE-811")
def starts_a_run_that_was_stopped_in_the_queue() -> None:
    """A run that its submitter has stopped begins."""
    right = effects.stop

    def wrong(run: Run, mode: str, now_wall: float) -> Any:
        was_queued = run.state == "queued"
        sessions = right(run, mode, now_wall)

        def start() -> None:
            if run.state == "stopped":
                run.state = "ready"

        if was_queued and run.queue_until_wall < now_wall + 5:
            wait_s = max(0.0, run.queue_until_wall - now_wall)
            asyncio.get_running_loop().call_later(wait_s, start)
        return sessions

    put(effects, "stop", wrong)


@mutant("LIFE-811")
def forgets_to_end_the_queue_of_before_a_resume() -> None:
    """A run that its submitter has resumed and stopped begins."""
    right = RunService.resume_run

    async def wrong(self: RunService, account: str, run_id: str) -> Run:
        run = await self.registry.get(run_id, account)

        def start() -> None:
            if run.state == "stopped":
                run.state = "ready"
                self.registry.commit_later(run)

        if run.state == "queued":
            wait_s = max(0.0, run.queue_until_wall - time.time())
            asyncio.get_running_loop().call_later(wait_s, start)
        return await right(self, account, run_id)

    put(RunService, "resume_run", wrong)


@mutant("SCORE-007")
def rounds_the_bounds_of_a_score() -> None:
    """The bounds of a score exclude the score."""
    right = scoring.score_of

    def wrong(episodes: Any) -> dict[str, Any]:
        score = right(episodes)
        low, high = round(score["score_low"], 6), round(score["score_high"], 6)
        return score | {"score_low": low, "score_high": high}

    put(run_views, "score_of", wrong)


@mutant("SCORE-010", "SCORE-014")
def shows_another_state_beside_the_score() -> None:
    """A dashboard calls a run that was stopped running."""
    right = scoring.score_of
    put(run_views, "score_of", lambda episodes: right(episodes) | {"state": "running"})


@mutant("RUN-012")
def takes_any_etag_for_the_newest() -> None:
    """A script that waits for any change waits for ever."""
    right = Handlers.get_run

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        if call.headers.get("if-none-match") != "*":
            return await right(self, call)
        wait_s = float(call.headers.get("prefer", "wait=0").removeprefix("wait="))
        headers = {**call.headers, "prefer": "wait=0"}
        now = await right(self, replace(call, headers=headers))
        if now.status_code == 304:  # not for a run that does not exist
            await asyncio.sleep(min(wait_s, self.settings.wait_s_max))
        return now

    put(Handlers, "get_run", wrong)


@mutant("RUN-012")
def answers_late_that_a_run_has_failed() -> None:
    """A script that waits for its run learns of a failure when it gives up."""
    right = Handlers.get_run

    async def wrong(self: Handlers, call: OperationCall) -> Response:
        response = await right(self, call)
        is_failed = b'"state":"failed"' in bytes(response.body)
        if is_failed and call.headers.get("prefer", "wait=0") != "wait=0":
            await asyncio.sleep(3)
        return response

    put(Handlers, "get_run", wrong)


@mutant("RUN-013")
def waits_anew_when_another_run_changes() -> None:
    """On a busy server a wait that was to be short never ends."""
    right, changes = RunRegistry.wait_for_change, [0]
    notify = RunRegistry.notify

    def wrong_notify(self: RunRegistry, run: Run) -> None:
        changes[0] += 1
        notify(self, run)

    async def wrong(self: RunRegistry, change: Any, timeout_s: float) -> bool:
        seen = -1
        while seen != changes[0]:
            seen = changes[0]
            if await right(self, change, timeout_s):
                return True
        return False

    put(RunRegistry, "notify", wrong_notify)
    put(RunRegistry, "wait_for_change", wrong)
