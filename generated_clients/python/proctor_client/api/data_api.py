"""DataApi: the operations of the data plane.

Generated from spec/openapi.yaml by `make generate`; never edited by hand.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated

from pydantic import ConfigDict, Field, validate_call

from ..api_client import ApiClient, Timeout
from ..models import AttachWorker, Heartbeat, Lease, Predict, Turn

# Built when an operation is first called: importing the client stays fast.
_DEFERRED = ConfigDict(defer_build=True)
Id = Annotated[str, Field(strict=True, pattern=r"^[A-Za-z0-9_-]{1,64}$")]
Version = Annotated[str, Field(strict=True, pattern=r"^[0-9]{1,4}\.[0-9]{1,4}$")]


class DataApi:
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
    def attach_worker(
        self,
        run_id: Id,
        worker_id: Id,
        attach_worker: AttachWorker,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Turn:
        """Attach a worker.

        worker_id: Chosen by the client; stable over re-attachments.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "PUT",
            "/v1/runs/{run_id}/workers/{worker_id}",
            Turn,
            path_parameters={"run_id": run_id, "worker_id": worker_id},
            headers={"Proctor-Version": proctor_version},
            body=attach_worker,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def detach_worker(
        self,
        run_id: Id,
        worker_id: Id,
        session_id: Annotated[str, Field(strict=True, min_length=1, max_length=128)],
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> None:
        """Detach a worker.

        worker_id: Chosen by the client; stable over re-attachments.
        session_id: The session to close.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "DELETE",
            "/v1/runs/{run_id}/workers/{worker_id}",
            None,
            path_parameters={"run_id": run_id, "worker_id": worker_id},
            query={"session_id": session_id},
            headers={"Proctor-Version": proctor_version},
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def heartbeat(
        self,
        run_id: Id,
        worker_id: Id,
        heartbeat: Heartbeat,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Lease:
        """Keep a session alive.

        worker_id: Chosen by the client; stable over re-attachments.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/runs/{run_id}/workers/{worker_id}/heartbeat",
            Lease,
            path_parameters={"run_id": run_id, "worker_id": worker_id},
            headers={"Proctor-Version": proctor_version},
            body=heartbeat,
            more_headers=_headers,
            timeout=_request_timeout,
        )

    @validate_call(config=_DEFERRED)
    def predict(
        self,
        run_id: Id,
        worker_id: Id,
        predict: Predict,
        proctor_version: Version | None = None,
        *,
        _request_timeout: Timeout | None = None,
        _headers: Mapping[str, str] | None = None,
    ) -> Turn:
        """Play a turn.

        worker_id: Chosen by the client; stable over re-attachments.
        proctor_version: The protocol version the caller was written for.
        """
        return self.api_client.call(
            "POST",
            "/v1/runs/{run_id}/workers/{worker_id}/predict",
            Turn,
            path_parameters={"run_id": run_id, "worker_id": worker_id},
            headers={"Proctor-Version": proctor_version},
            body=predict,
            more_headers=_headers,
            timeout=_request_timeout,
        )
