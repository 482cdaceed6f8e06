"""The policy server of a push run, as its submission names it, with defaults.

Pure: how a policy server is called, and whether its address is allowed, is decided in
`push/`. The API key is encrypted here, and in no view.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from reference_record.generated import answers
from reference_server.generated import models
from reference_server.rules.runs.run import RunHead

CALL_TIMEOUT_S = 30.0
MAX_RETRIES = 3


@dataclass(frozen=True, slots=True)
class PolicyServerConfig:
    """Schema PolicyServer, complete; `sealed_key` instead of its `api_key`."""

    url: str
    protocol: models.PolicyProtocol
    sealed_key: str | None
    model: str | None
    call_timeout_s: float
    max_concurrent: int
    max_retries: int
    generation: Mapping[str, float]

    @classmethod
    def from_run(cls, run: RunHead) -> PolicyServerConfig:
        """The policy server of a run with mode `push`."""
        requested = run.submission["policy_server"]
        return cls(
            url=requested["url"].rstrip("/"),
            protocol=requested["protocol"],
            sealed_key=requested.get("sealed_key"),
            model=requested.get("model"),
            call_timeout_s=requested.get("call_timeout_s", CALL_TIMEOUT_S),
            max_concurrent=min(
                requested.get("max_concurrent", run.max_workers), run.max_workers
            ),
            max_retries=requested.get("max_retries", MAX_RETRIES),
            generation=requested.get("generation", {}),
        )

    def view(self) -> answers.PolicyServerView:
        """The policy server as the submitter is shown it, without the key."""
        view: answers.PolicyServerView = {
            "url": self.url,
            "protocol": self.protocol,
            "has_api_key": self.sealed_key is not None,
            "call_timeout_s": self.call_timeout_s,
            "max_concurrent": self.max_concurrent,
            "max_retries": self.max_retries,
        }
        if self.model is not None:
            view["model"] = self.model
        if self.generation:
            view["generation"] = self.generation
        return view
