"""The server as another client sees it: for actions beside the reference client, and
for the facts that its answers are compared with.
"""

import os
from typing import Any, Self

from proctor_client import (
    ApiClient,
    AttachWorker,
    CalibrationOptions,
    Configuration,
    ControlApi,
    DataApi,
    Episode,
    PolicyInfo,
    Run,
    SubmitRun,
    Turn,
)

from tests.support.servers import TOKENS

ACCEPT_ANY = {"Accept": "*/*"}


class DirectClient:
    """Calls the server by its generated client, without the reference client."""

    def __init__(self, url: str) -> None:
        token = TOKENS["alice"]
        configuration = Configuration(host=url, access_token=token, retries=False)
        self._client = ApiClient(configuration)
        self.control = ControlApi(self._client)
        self.data = DataApi(self._client)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._client.close()

    def submit(self, *tasks: str, **members: Any) -> Run:
        options = CalibrationOptions.from_dict({"tasks": tasks or ["count"]})
        return self.control.submit_run(
            SubmitRun(
                benchmark_id="calibration",
                policy=PolicyInfo(name="other"),
                options=options,
                **members,
            )
        )

    def attach(self, run_id: str, worker_id: str, *, takeover: bool = False) -> Turn:
        request = AttachWorker(attach_key=os.urandom(8).hex(), takeover=takeover)
        return self.data.attach_worker(run_id, worker_id, request)

    def latest(self) -> Run:
        return self.control.list_runs(limit=1).runs[0]

    def episodes(self, run_id: str) -> list[Episode]:
        return self.control.list_episodes(run_id).episodes

    def reasons(self, run_id: str) -> list[str | None]:
        """Why each episode was left last."""
        lefts = [episode.last_left for episode in self.episodes(run_id)]
        return [None if left is None else left.reason for left in lefts]

    def attempts(self, run_id: str) -> list[int]:
        return [episode.attempt for episode in self.episodes(run_id)]
