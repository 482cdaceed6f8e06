"""What a submission says of the policy server that its run is played with.

What cannot be meant is refused here; what was left open is filled in, and shown to the
submitter as it is carried out. The API key stands in it sealed, and is in no view.
"""

from __future__ import annotations

import asyncio
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import httpcore

from reference_server.generated import models
from reference_server.http.problems import Refused
from reference_server.push.egress import Gate, NotAllowed, Unresolved
from reference_server.push.key_encryption import Sealer
from reference_server.rules.run import RunHead

CALL_TIMEOUT_S = 30.0
MAX_RETRIES = 3
_LOOK_S = 2.0


@dataclass(frozen=True, slots=True)
class Order:
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
    def of(cls, run: RunHead) -> Order:
        """That of a run with mode `push`."""
        asked = run.submission["policy_server"]
        return cls(
            url=asked["url"].rstrip("/"),
            protocol=asked["protocol"],
            sealed_key=asked.get("sealed_key"),
            model=asked.get("model"),
            call_timeout_s=asked.get("call_timeout_s", CALL_TIMEOUT_S),
            max_concurrent=min(
                asked.get("max_concurrent", run.max_workers), run.max_workers
            ),
            max_retries=asked.get("max_retries", MAX_RETRIES),
            generation=asked.get("generation", {}),
        )

    def view(self) -> models.PolicyServerView:
        """What the submitter is shown."""
        shown = models.PolicyServerView(
            url=self.url,
            protocol=self.protocol,
            has_api_key=self.sealed_key is not None,
            call_timeout_s=self.call_timeout_s,
            max_concurrent=self.max_concurrent,
            max_retries=self.max_retries,
        )
        if self.model is not None:
            shown.model = self.model
        if self.generation:
            shown.generation = dict(self.generation)
        return shown


class OrderDesk:
    """Takes the orders of submissions: refuses what cannot be meant, seals the key.

    protocols: those that a policy can be asked in here.
    """

    def __init__(
        self,
        gate: Gate | None = None,
        sealer: Sealer | None = None,
        protocols: Collection[str] = (),
    ) -> None:
        self._gate = gate or Gate()
        self._sealer = sealer or Sealer()
        self._protocols = protocols

    async def kept(self, submission: dict[str, Any]) -> dict[str, Any]:
        """The submission as it is stored: no key in it can be read (PUSH-016)."""
        asked = submission.get("policy_server")
        errors = list(_faults(submission))
        if asked is not None and asked["protocol"] not in self._protocols:
            spoken = " and ".join(self._protocols) or "no protocol"
            errors.append(("/policy_server/protocol", f"{spoken} is spoken here"))
        if asked is not None and not errors:
            errors += await self._address_faults(asked["url"])
        if errors:
            raise Refused(
                "invalid_request",
                "The policy server cannot be called like that.",
                errors=errors,
            )
        if asked is None or "api_key" not in asked:
            return submission
        kept = {name: value for name, value in asked.items() if name != "api_key"}
        kept["sealed_key"] = self._sealer.seal(asked["api_key"])
        return submission | {"policy_server": kept}

    async def _address_faults(self, url: str) -> list[tuple[str, str]]:
        """Told at once where it can be; what counts is looked at with every call."""
        at = "/policy_server/url"
        try:
            target = httpcore.URL(url)
            port = target.port or (443 if target.scheme == b"https" else 80)
            async with asyncio.timeout(_LOOK_S):
                await self._gate.addresses(target.host.decode(), port)
        except NotAllowed as error:
            return [(at, str(error))]
        except ValueError:
            return [(at, "is no URL")]
        except (Unresolved, TimeoutError):
            pass  # its name may be there when the run is played
        return []


def _faults(submission: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """(pointer, text) of what cannot be meant (PUSH-002)."""
    is_push = submission.get("mode") == "push"
    asked = submission.get("policy_server")
    if is_push and asked is None:
        yield "/policy_server", "is missing: with mode push the server calls a policy"
    elif asked is not None and not is_push:
        yield "/policy_server", "is for mode push; without it workers attach"
    elif asked and asked["protocol"] != "openai_chat" and "generation" in asked:
        yield "/policy_server/generation", "is for the protocol openai_chat"
