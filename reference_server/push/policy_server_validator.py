"""Checks the member `policy_server` of a submission, and encrypts its API key.

PUSH-002 and the other combinations that no schema expresses are decided here. Defaults
are filled in by `rules/policy_server.py`. It must not call the policy server: the only
network access is to resolve its host name, so that a forbidden address is refused at
submit; what counts is the check at every connection, in `egress`.
"""

from __future__ import annotations

import asyncio
from collections.abc import Collection, Iterator

import httpcore

from reference_server.push.egress import (
    AddressNotAllowed,
    EgressPolicy,
    HostNotResolved,
)
from reference_server.push.key_encryption import KeyEncryption
from reference_server.rules.manifest import Submission
from reference_server.rules.refusal import Refused

_RESOLVE_TIMEOUT_S = 2.0
_MODELS = ("openai_chat", "openai_completions")  # protocols of language models


class PolicyServerValidator:
    """Refuses invalid combinations, and replaces the API key by its encrypted form.

    protocols: the policy protocols that this server can use.
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

    def digest_key(self, submission: Submission) -> Submission:
        """The submission to compare others with: a digest in place of its API key.

        PUSH-016: what is stored of it must not let a key be guessed.
        """
        requested = submission.get("policy_server")
        if requested is None or "api_key" not in requested:
            return submission
        digest = self._key_encryption.digest(requested["api_key"])
        return submission | {"policy_server": requested | {"api_key": digest}}

    async def validate_and_encrypt(
        self, submission: Submission, account: str
    ) -> Submission:
        """The submission as it is stored, with its key encrypted (PUSH-016, FLE-017).

        account: whose share of name look-ups is used. Raises Refused.
        """
        requested = submission.get("policy_server")
        errors = list(_errors(submission))
        if requested is not None and requested["protocol"] not in self._protocols:
            supported = ", ".join(self._protocols) or "none"
            text = f"is not supported; supported protocols: {supported}"
            errors.append(("/policy_server/protocol", text))
        if requested is not None and not errors:
            errors += await self._address_errors(requested["url"], account)
        if errors:
            raise Refused(
                "invalid_request",
                "The policy_server configuration is invalid.",
                errors=errors,
            )
        if requested is None or "api_key" not in requested:
            return submission
        stored = requested.copy()
        stored["sealed_key"] = self._key_encryption.encrypt(stored.pop("api_key"))
        return submission | {"policy_server": stored}

    async def _address_errors(self, url: str, account: str) -> list[tuple[str, str]]:
        """PUSH-015: a forbidden address is refused at submit, where it is known then.

        Every connection is checked again, see `egress.CheckedBackend`.
        """
        at = "/policy_server/url"
        try:
            target = httpcore.URL(url)
            if self._egress.socket_of(target.host.decode()):
                return []
            port = target.port or (443 if target.scheme == b"https" else 80)
            async with asyncio.timeout(_RESOLVE_TIMEOUT_S):
                await self._egress.resolve(target.host.decode(), port, account)
        except AddressNotAllowed as error:
            return [(at, str(error))]
        except ValueError:
            return [(at, "is not a URL")]
        except (HostNotResolved, TimeoutError):
            pass  # the name may be resolvable when the run is played
        return []


def _errors(submission: Submission) -> Iterator[tuple[str, str]]:
    """(JSON pointer, text) of each invalid combination (PUSH-002)."""
    is_push = submission.get("mode") == "push"
    requested = submission.get("policy_server")
    if is_push and requested is None:
        yield "/policy_server", "is required with mode push: the server calls a policy"
    elif requested is not None and not is_push:
        yield "/policy_server", "is allowed only with mode push"
    elif (
        requested and requested["protocol"] not in _MODELS and "generation" in requested
    ):
        text = f"is allowed only with protocol {' or '.join(_MODELS)}"
        yield "/policy_server/generation", text
