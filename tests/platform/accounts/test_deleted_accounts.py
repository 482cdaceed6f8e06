"""Accounts that were never approved can be deleted; nothing else is theirs."""

from __future__ import annotations

import pytest

from reference_platform.accounts.account_rules import SignUp
from reference_platform.command_line.challenge_command import main
from reference_platform.parts import Parts
from reference_server.rules.refusal import Refused
from tests.support.platform.approved_accounts import approved


async def register(parts: Parts, name: str, email: str) -> None:
    filled = SignUp(
        account=name, full_name="A. Person", organisation="A Laboratory",
        email=email, password="correct horse", agrees=True,
    )  # fmt: skip
    await parts.accounts.register(filled)


@pytest.mark.parametrize(("is_rejected", "mails"), [(False, 0), (True, 2)])
async def test_an_account_without_approval_is_deleted_with_its_mail(
    parts: Parts, *, is_rejected: bool, mails: int
) -> None:
    """Another account has the address of one of the two. Expect its mail to stay."""
    for name in ("eve", "kim", "max"):
        await register(parts, name, f"{'one' if name == 'eve' else 'two'}@x.org")
        if is_rejected:
            parts.accounts.decide(name, "reject", "a reason", "host")
    for name in ("eve", "kim"):
        parts.accounts.delete(name, "host")
        with pytest.raises(Refused, match="no such account"):
            parts.accounts.get(name)
    assert parts.outbox.waiting()[0] == mails
    await register(parts, "eve", "one@x.org")


async def test_accounts_are_deleted_together_or_not_at_all(
    parts: Parts, capsys: pytest.CaptureFixture[str]
) -> None:
    """One of three was approved. Expect all to stay; then the other two to go."""
    for name in ("eve", "kim"):
        await register(parts, name, f"{name}@x.org")
    await approved(parts, "ada")
    waiting = parts.outbox.waiting()
    words = ["account", "delete", "eve", "kim"]
    where = ["--database", str(parts.database.path)]
    assert main([*words, "ada", *where]) == 2
    assert "not possible: the account is approved" in capsys.readouterr().err
    states = {name: parts.accounts.get(name).state for name in ("eve", "kim", "ada")}
    assert states == {"eve": "pending", "kim": "pending", "ada": "approved"}
    assert parts.outbox.waiting() == waiting
    assert main([*words, *where]) == 0
    for name in ("eve", "kim"):
        with pytest.raises(Refused, match="no such account"):
            parts.accounts.get(name)


@pytest.mark.parametrize("state", ["approved", "suspended"])
async def test_an_account_that_was_approved_stays(parts: Parts, state: str) -> None:
    await approved(parts, "ada")
    if state == "suspended":
        parts.accounts.decide("ada", "suspend", "a reason", "host")
    with pytest.raises(Refused, match=f"not possible: the account is {state}"):
        parts.accounts.delete("ada", "host")
    assert parts.accounts.get("ada").state == state
