"""ControlApi: the operations of the control plane.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from pydantic import (
    ConfigDict,
    Field,
    validate_call,
)

from ..api_client import ApiClient, Timeout
from ..models import (
    Benchmark,
    BenchmarkList,
    BoardEntry,
    BoardEntryList,
    Checkpoint,
    Comparison,
    ConsistencyProof,
    EpisodeList,
    FlagEntry,
    HistoryPage,
    InclusionProof,
    KeyList,
    PublishEntry,
    Ranking,
    RecordImport,
    RecordImportList,
    Run,
    RunList,
    Score,
    Service,
    StopRun,
    SubmitRun,
)

# Built when an operation is first called: importing the client stays fast.
_DEFERRED = ConfigDict(defer_build=True)
Id = Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Version = Annotated[str, Field(strict=True, pattern=r"^[0-9]{1,4}\.[0-9]{1,4}$")]


class ControlApi:
    """Each call waits for its answer.

    It raises ApiException for a refusal, and for an answer that is not the message
    expected; urllib3.exceptions.HTTPError if no answer comes; pydantic.ValidationError
    for an argument that is out of range. Every operation also takes

    _request_timeout: seconds for the whole request, or a pair: to connect, and between
        two reads.
    _headers: sent instead of the usual ones of the same name.
    """

    def __init__(self, api_client: ApiClient | None = None) -> None:
        self.api_client = api_client or ApiClient()

    @validate_call(config=_DEFERRED)
    def compare_runs(
        self,
        baseline: Id,
        runs: Annotated[
            str,
            Field(
                strict=True,
                pattern=r"^[A-Za-z0-9_-]{1,64}(,[A-Za-z0-9_-]{1,64}){0,15}$",
            ),
        ],
        tolerance: Annotated[float, Field(strict=True, ge=0, le=1)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Comparison:
        """Compare runs with a baseline.

        baseline: The run that the others are compared with.
        runs: Ids of one to sixteen runs, with commas between them; the baseline may be one of them.
        tolerance: The largest difference that `release` lets pass; 0.05 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/comparisons",
            Comparison,
            query={"baseline": baseline, "runs": runs, "tolerance": tolerance},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def delete_import(
        self,
        import_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> None:
        """Delete an imported record.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "DELETE",
            "/v1/records/{import_id}",
            None,
            path_parameters={"import_id": import_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def delete_run(
        self,
        run_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> None:
        """Delete a run.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "DELETE",
            "/v1/runs/{run_id}",
            None,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def describe_service(
        self,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Service:
        """Describe the service.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1",
            Service,
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def flag_entry(
        self,
        entry_id: Id,
        flag_entry: FlagEntry,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BoardEntry:
        """Flag an entry, or remove its flag.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "PUT",
            "/v1/entries/{entry_id}/flag",
            BoardEntry,
            path_parameters={"entry_id": entry_id},
            headers={"Proctor-Version": proctor_version},
            body=flag_entry,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_benchmark(
        self,
        benchmark_id: Annotated[
            str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")
        ],
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Benchmark:
        """Get a benchmark.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/benchmarks/{benchmark_id}",
            Benchmark,
            path_parameters={"benchmark_id": benchmark_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_checkpoint(
        self,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Checkpoint:
        """Get the signed checkpoint of the history.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/history/checkpoint",
            Checkpoint,
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_entry(
        self,
        entry_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BoardEntry:
        """Get an entry.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/entries/{entry_id}",
            BoardEntry,
            path_parameters={"entry_id": entry_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_import(
        self,
        import_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> RecordImport:
        """Get an imported record.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/records/{import_id}",
            RecordImport,
            path_parameters={"import_id": import_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_ranking(
        self,
        benchmark_id: Annotated[
            str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")
        ],
        manifest_sha256: Annotated[str, Field(strict=True, pattern=r"^[0-9a-f]{64}$")]
        | None = None,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Ranking:
        """Get the ranking of a benchmark.

        manifest_sha256: Which manifest; that of `get_benchmark` when absent.
        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/benchmarks/{benchmark_id}/ranking",
            Ranking,
            path_parameters={"benchmark_id": benchmark_id},
            query={
                "manifest_sha256": manifest_sha256,
                "cursor": cursor,
                "limit": limit,
            },
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_run(
        self,
        run_id: Id,
        if_none_match: Annotated[str, Field(strict=True, max_length=200)] | None = None,
        prefer: Annotated[str, Field(strict=True, pattern=r"^wait=[0-9]{1,4}$")]
        | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Run:
        """Get a run, or wait for its next change.

        if_none_match: The ETag of the last answer, a list of some, or `*` for the one that the run has when the request arrives; while one of them holds, the answer is 304. A text that is no ETag names none. A tag with `W/` before it may name the same as without. For the profile `waiting`.
        prefer: `wait=N` holds the answer back for up to N seconds until the run changes. Longer than `limits.wait_s_max` is granted as that; without If-None-Match nothing is waited for. Any other value is refused with `invalid_request` (ERR-014).
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/runs/{run_id}",
            Run,
            path_parameters={"run_id": run_id},
            headers={
                "If-None-Match": if_none_match,
                "Prefer": prefer,
                "Proctor-Version": proctor_version,
            },
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def get_score(
        self,
        run_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Score:
        """Get the score of a run.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/runs/{run_id}/score",
            Score,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def import_record(
        self,
        body: bytes,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> RecordImport:
        """Import a record.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/records",
            RecordImport,
            headers={"Proctor-Version": proctor_version},
            body=body,
            content_type="application/zip",
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_benchmarks(
        self,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BenchmarkList:
        """List the benchmarks.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/benchmarks",
            BenchmarkList,
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_entries(
        self,
        benchmark_id: Annotated[
            str, Field(strict=True, pattern=r"^[a-z][a-z0-9_]{0,63}$")
        ]
        | None = None,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BoardEntryList:
        """List entries of the leaderboard.

        benchmark_id: Only entries of this benchmark.
        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/entries",
            BoardEntryList,
            query={"benchmark_id": benchmark_id, "cursor": cursor, "limit": limit},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_episodes(
        self,
        run_id: Id,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> EpisodeList:
        """List the episodes of a run.

        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/runs/{run_id}/episodes",
            EpisodeList,
            path_parameters={"run_id": run_id},
            query={"cursor": cursor, "limit": limit},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_history(
        self,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> HistoryPage:
        """List the history.

        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/history",
            HistoryPage,
            query={"cursor": cursor, "limit": limit},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_imports(
        self,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> RecordImportList:
        """List imported records.

        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/records",
            RecordImportList,
            query={"cursor": cursor, "limit": limit},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_keys(
        self,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> KeyList:
        """List the signing keys.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/keys",
            KeyList,
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def list_runs(
        self,
        cursor: Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,128}$")]
        | None = None,
        limit: Annotated[int, Field(strict=True, ge=1, le=1000)] | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> RunList:
        """List runs.

        cursor: `next_cursor` of the page before; opaque to the caller.
        limit: Most items wanted on a page; 100 when absent.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/runs",
            RunList,
            query={"cursor": cursor, "limit": limit},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def prove_consistency(
        self,
        old_size: Annotated[str, Field(strict=True, pattern=r"^[1-9][0-9]{0,14}$")],
        new_size: Annotated[str, Field(strict=True, pattern=r"^[1-9][0-9]{0,14}$")],
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> ConsistencyProof:
        """Prove that the history only grew.

        old_size: Size of the older history, from 1.
        new_size: Size of the newer history, from 1.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/history/consistency",
            ConsistencyProof,
            query={"old_size": old_size, "new_size": new_size},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def prove_inclusion(
        self,
        leaf_index: Annotated[str, Field(strict=True, pattern=r"^[0-9]{1,15}$")],
        tree_size: Annotated[str, Field(strict=True, pattern=r"^[1-9][0-9]{0,14}$")],
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> InclusionProof:
        """Prove that a leaf is in the history.

        leaf_index: Index of the leaf, from 0.
        tree_size: Size of the history, from 1.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "GET",
            "/v1/history/inclusion",
            InclusionProof,
            query={"leaf_index": leaf_index, "tree_size": tree_size},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def publish_entry(
        self,
        run_id: Id,
        publish_entry: PublishEntry,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BoardEntry:
        """Publish a run on the leaderboard.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "PUT",
            "/v1/runs/{run_id}/entry",
            BoardEntry,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            body=publish_entry,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def resume_run(
        self,
        run_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Run:
        """Resume a run.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/runs/{run_id}/resume",
            Run,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def stop_run(
        self,
        run_id: Id,
        stop_run: StopRun,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Run:
        """Stop a run.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/runs/{run_id}/stop",
            Run,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            body=stop_run,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def submit_run(
        self,
        submit_run: SubmitRun,
        idempotency_key: Annotated[
            str, Field(strict=True, pattern=r"^[\x21-\x7e]{1,128}$")
        ]
        | None = None,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Run:
        """Submit a run.

        idempotency_key: Makes a repeated submit return the first run instead of making another. One that breaks the pattern is refused with `invalid_request` (ERR-014). For the profile `submit_once`.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/runs",
            Run,
            headers={
                "Idempotency-Key": idempotency_key,
                "Proctor-Version": proctor_version,
            },
            body=submit_run,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def withdraw_entry(
        self,
        run_id: Id,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> BoardEntry:
        """Withdraw the entry of a run.

        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "DELETE",
            "/v1/runs/{run_id}/entry",
            BoardEntry,
            path_parameters={"run_id": run_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )
