"""What a submission says of the policy server that its run is played with.

What cannot be meant is refused here; what was left open is filled in, and shown to the
submitter as it is carried out. The API key stands in it sealed, and is in no view.
"""

from __future__ import annotations

import asyncio
from collections.abc import Collection, Iterator, Mapping
from typing import Any

import httpcore

from reference_server.push.egress import (
    AddressNotAllowed,
    EgressPolicy,
    HostNotResolved,
)
from reference_server.push.key_encryption import KeyEncryption
from reference_server.rules.refusal import Refused

_RESOLVE_TIMEOUT_S = 2.0


class PolicyServerValidator:
    """Takes the orders of submissions: refuses what cannot be meant, seals the key.

    protocols: those that a policy can be asked in here.
    """

    def __init__(
        self,
        egress: EgressPolicy | None = None,
        key_encryption: KeyEncryption | None = None,
        protocols: Collection[str] = (),
    ) -> None:
        self._egress = egress or EgressPolicy()
        self._key_encryption = key_encryption or KeyEncryption()
        self._protocols = protocols

    async def validate_and_encrypt(self, submission: dict[str, Any]) -> dict[str, Any]:
        """The submission as it is stored: no key in it can be read (PUSH-016)."""
        requested = submission.get("policy_server")
        errors = list(_errors(submission))
        if requested is not None and requested["protocol"] not in self._protocols:
            supported = " and ".join(self._protocols) or "no protocol"
            errors.append(("/policy_server/protocol", f"{supported} is spoken here"))
        if requested is not None and not errors:
            errors += await self._address_errors(requested["url"])
        if errors:
            raise Refused(
                "invalid_request",
                "The policy server cannot be called like that.",
                errors=errors,
            )
        if requested is None or "api_key" not in requested:
            return submission
        stored = {name: value for name, value in requested.items() if name != "api_key"}
        stored["sealed_key"] = self._key_encryption.encrypt(requested["api_key"])
        return submission | {"policy_server": stored}

    async def _address_errors(self, url: str) -> list[tuple[str, str]]:
        """Told at once where it can be; what counts is looked at with every call."""
        at = "/policy_server/url"
        try:
            target = httpcore.URL(url)
            port = target.port or (443 if target.scheme == b"https" else 80)
            async with asyncio.timeout(_RESOLVE_TIMEOUT_S):
                await self._egress.resolve(target.host.decode(), port)
        except AddressNotAllowed as error:
            return [(at, str(error))]
        except ValueError:
            return [(at, "is no URL")]
        except (HostNotResolved, TimeoutError):
            pass  # its name may be there when the run is played
        return []


def _errors(submission: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """(pointer, text) of what cannot be meant (PUSH-002)."""
    is_push = submission.get("mode") == "push"
    requested = submission.get("policy_server")
    if is_push and requested is None:
        yield "/policy_server", "is missing: with mode push the server calls a policy"
    elif requested is not None and not is_push:
        yield "/policy_server", "is for mode push; without it workers attach"
    elif (
        requested
        and requested["protocol"] != "openai_chat"
        and "generation" in requested
    ):
        yield "/policy_server/generation", "is for the protocol openai_chat"
