"""Accounts and keys of a platform in this process, and its clock."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from argon2 import PasswordHasher

from reference_platform.accounts.account_rules import Role, SignUp
from reference_platform.parts import Parts


class Clock:
    """Stands still until a test moves it."""

    def __init__(self) -> None:
        self.now = 1_800_000_000.0

    def __call__(self) -> float:
        return self.now


def quick_parts(database: Path, **how: Any) -> Parts:
    """The platform with passwords that are quick to hash."""
    hasher = PasswordHasher(time_cost=1, memory_cost=8, parallelism=1)
    return Parts.of(database, hasher=hasher, **how)


async def approved(parts: Parts, name: str, role: Role = "participant") -> str:
    filled = SignUp(
        account=name, full_name="A. Person", organisation="A Laboratory",
        email=f"{name}@example.org", password="correct horse", agrees=True,
    )  # fmt: skip
    await parts.accounts.register(filled, role)
    parts.accounts.decide(name, "approve", "", "a test")
    return name


def key_of(parts: Parts, account: str, *scopes: str, lifetime_s: float = 3600) -> str:
    names = scopes or ("read", "run", "account")
    return parts.keys.make(account, "", names, lifetime_s, parts.clock())[1]
