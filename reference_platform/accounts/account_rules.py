"""An account, and the decisions that are possible on it. Pure: no clock, no disk."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import Final, Literal

import msgspec

from reference_server.rules.refusal import Refused

AccountState = Literal["pending", "approved", "rejected", "suspended"]
Decision = Literal["approve", "reject", "suspend", "reinstate"]
Evaluation = Literal["own_machine", "hosted", "both"]
Role = Literal["participant", "administrator"]

# state → decision → next state. Everything else is refused (HST-004).
DECISIONS: Final[Mapping[AccountState, Mapping[Decision, AccountState]]] = {
    "pending": {"approve": "approved", "reject": "rejected"},
    "rejected": {"approve": "approved"},
    "approved": {"suspend": "suspended"},
    "suspended": {"reinstate": "approved"},
}
NEEDS_REASON: Final[frozenset[Decision]] = frozenset(("reject", "suspend"))
EMAIL_CHANGE_S: Final = 30 * 86_400.0
PASSWORD_CHARS: Final = (10, 200)
# Names that belong to the host, or that a reader would take for it.
RESERVED: Final = frozenset(
    ("admin", "administrator", "host", "local", "platform", "proctor", "root", "system")
)
_NAME: Final = re.compile(r"[a-z][a-z0-9]{2,31}")
# One @, and nothing that a mail program would read as a second address.
_EMAIL: Final = re.compile(r"[A-Za-z0-9._%+-]{1,64}@[A-Za-z0-9-]+(\.[A-Za-z0-9-]+)+")
_TEXT_CHARS: Final = 200


class Account(msgspec.Struct, frozen=True):
    """evaluation: how its policies are evaluated. is_own_model: it made the policy.

    reason: of the last decision. agreed_at: to keep the rules of each track.
    """

    account: str
    full_name: str
    organisation: str
    email: str
    email_changed_at: float | None
    evaluation: Evaluation
    is_own_model: bool
    agreed_at: float
    password_hash: str
    role: Role
    state: AccountState
    reason: str
    created_at: float
    decided_at: float | None

    @property
    def is_administrator(self) -> bool:
        return self.role == "administrator" and self.state == "approved"


class SignUp(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The form with which a person registers."""

    account: str
    full_name: str
    organisation: str
    email: str
    password: str
    evaluation: Evaluation = "own_machine"
    is_own_model: bool = False
    agrees: bool = False


def check_sign_up(filled: SignUp) -> None:
    """HST-001. Raises Refused, which names each member that is wrong."""
    errors = [
        *([] if _NAME.fullmatch(filled.account) else [("/account", _NAME_TEXT)]),
        *_text_errors("full_name", filled.full_name),
        *_text_errors("organisation", filled.organisation),
        *([] if is_email(filled.email) else [("/email", "must be an e-mail address")]),
        *password_errors(filled.password, filled.account),
        *([] if filled.agrees else [("/agrees", "must be true")]),
    ]
    if filled.account in RESERVED:
        errors.append(("/account", "is a name of the host"))
    if errors:
        raise Refused(
            "invalid_request",
            "; ".join(f"{pointer[1:]} {text}" for pointer, text in errors) + ".",
            errors=errors,
        )


_NAME_TEXT: Final = "must be 3 to 32 lowercase letters and digits, a letter first"


def is_email(text: str) -> bool:
    return len(text) <= 254 and _EMAIL.fullmatch(text) is not None


def password_errors(password: str, account: str) -> list[tuple[str, str]]:
    least, most = PASSWORD_CHARS
    if not least <= len(password) <= most:
        return [("/password", f"must have {least} to {most} characters")]
    if account and account in password.lower():
        return [("/password", "must not contain the name of the account")]
    return []


def _text_errors(name: str, text: str) -> list[tuple[str, str]]:
    is_right = text.strip() and len(text) <= _TEXT_CHARS and text.isprintable()
    wrong = f"must be one line of 1 to {_TEXT_CHARS} characters"
    return [] if is_right else [(f"/{name}", wrong)]


def decide(account: Account, decision: Decision, reason: str) -> AccountState:
    """The state after a decision of an administrator. Raises Refused (HST-004)."""
    state = DECISIONS[account.state].get(decision)
    if state is None:
        text = f"`{decision}` is not possible: the account is {account.state}."
        possible = ", ".join(f"`{name}`" for name in DECISIONS[account.state])
        raise Refused("illegal_transition", f"{text} Possible: {possible}.")
    if decision in NEEDS_REASON and not reason.strip():
        text = f"`{decision}` needs a reason, which the account gets."
        raise Refused("invalid_request", text, errors=[("/reason", "is required")])
    return state


def parse_decision(text: str) -> Decision:
    """Raises Refused."""
    try:
        return msgspec.convert(text, Decision)  # type: ignore[no-any-return]
    except msgspec.ValidationError as error:
        raise Refused("invalid_request", "Choose a decision.") from error


def check_key_scopes(account: Account, scopes: Collection[str]) -> None:
    """HST-003, HST-014. Raises Refused."""
    if account.state != "approved":
        raise Refused("forbidden", "Only an approved account has keys.")
    if "host" in scopes and not account.is_administrator:
        raise Refused("forbidden", "The account is no administrator.")


def check_email_change(account: Account, email: str, now: float) -> None:
    """HST-006: once in thirty days. Raises Refused."""
    if not is_email(email):
        wrong = "must be an e-mail address"
        raise Refused("invalid_request", f"email {wrong}.", errors=[("/email", wrong)])
    changed_at = account.email_changed_at
    if changed_at is not None and now < changed_at + EMAIL_CHANGE_S:
        days = int((changed_at + EMAIL_CHANGE_S - now) // 86_400) + 1
        text = f"The address was changed less than 30 days ago; wait {days} days."
        raise Refused("quota_exceeded", text)
