"""A refusal: why a request is not carried out, as an exception.

Every layer raises it. It names one of the codes of `x-problems`; how a code becomes an
HTTP response is decided in `http/problems.py` and in the profiles, not here.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from reference_server.generated.problem_codes import PROBLEMS
from reference_server.rules.runs.lifecycle import Refuse

# At most this much is reported of a request with many faults, or with long names.
ERRORS_MAX = 50
ERROR_CHARS_MAX = 2**14
NAMES_MAX = 20
NAME_CHARS_MAX = 64
# The sentences of these codes in the catalogue fit some of their cases alone: who
# refuses says what fits.
_OF_MANY_CASES = frozenset({"forbidden", "quota_exceeded"})


class Refused(Exception):
    """A request that is answered with a problem.

    code: one of x-problems. detail: what happened, for people. act: what to do about
    it; None is the sentence of the catalogue, where it fits every case of the code.
    errors: (JSON pointer, text) pairs. members: further members of schema Problem.
    retry_after_s: when a repeat may be accepted, if it is known.
    """

    def __init__(
        self,
        code: str,
        detail: str,
        *,
        act: str | None = None,
        errors: Iterable[tuple[str, str]] = (),
        requirement: str | None = None,
        members: Mapping[str, Any] | None = None,
        retry_after_s: float | None = None,
    ) -> None:
        super().__init__(detail)
        self.code = code
        self.detail = detail
        every_case = "" if code in _OF_MANY_CASES else PROBLEMS[code]["act"]
        self.act: str = every_case if act is None else act
        self.errors = first_errors(errors)
        self.requirement = requirement
        self.members = dict(members or {})
        self.retry_after_s = retry_after_s

    @classmethod
    def from_verdict(cls, verdict: Refuse) -> Refused:
        """The refusal that a guard decided."""
        return cls(
            verdict.code,
            verdict.detail,
            act=verdict.act,
            errors=verdict.errors,
            requirement=verdict.requirement,
            members=verdict.members,
        )

    @property
    def sentences(self) -> str:
        """The detail, and the act: the whole text for people."""
        return f"{self.detail} {self.act}".rstrip()


def not_found(kind: str, name: str, there_are: Iterable[str] | None = None) -> Refused:
    """The refusal of a name that nothing of its kind has, such as "track".

    there_are: the names that this caller may know, where they are few.
    """
    detail = f"There is no {kind} {name[:NAME_CHARS_MAX]}."
    act = None if there_are is None else list_names(there_are)
    return Refused("not_found", detail, act=act)


def list_names(there_are: Iterable[str]) -> str:
    """The sentence that names the things that exist."""
    names = sorted(there_are)
    listed = ", ".join(names[:NAMES_MAX]) or "none"
    more = len(names) - NAMES_MAX
    return f"There are: {listed}{f' and {more} more' if more > 0 else ''}."


# Scopes that only tokens of the server have there → how one is made.
_MADE_WITH = {"host": "read+run+host", "operator": "operator"}


def lacks_scope(scope: str, who: str = "token") -> Refused:
    """The refusal of a token, or of another `who`, without a scope (AUTH-005).

    A key of an account may have a scope `host`, too, which is for reviews alone.
    """
    act = f"Use a {who} that has it."
    if who == "token" and scope in _MADE_WITH:
        act = (
            "It is a scope of the server's own tokens: use one of "
            f"`proctor admin token add NAME --scopes {_MADE_WITH[scope]}`. A key of an "
            "account has it for other operations, if at all."
        )
    return Refused("forbidden", f"The {who} has no scope `{scope}`.", act=act)


def no_profile(detail: str) -> Refused:
    """The refusal of what this server does not offer at all."""
    act = "describe_service names the profiles that it has."
    return Refused("not_found", detail, act=act)


def first_errors(errors: Iterable[tuple[str, str]]) -> tuple[tuple[str, str], ...]:
    """The first of many, at least one: an answer is bounded, whatever was sent."""
    first: list[tuple[str, str]] = []
    chars_left = ERROR_CHARS_MAX
    for at, text in errors:
        chars_left -= len(at) + len(text)
        if first and (chars_left < 0 or len(first) == ERRORS_MAX):
            break
        first.append((at, text))
    return tuple(first)
