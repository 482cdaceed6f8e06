"""Refuses a policy whose assumptions a benchmark contradicts, before there is a run."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from reference_client.errors import ProctorError
from reference_record.contents.contradicted_assumptions import contradictions


def check_assumptions(
    assumes: Mapping[str, Any] | None, benchmark: Mapping[str, Any]
) -> None:
    """assumes: schema Assumptions. benchmark: schema Benchmark.

    Raises ProctorError, with a pointer at each contradiction, if there is any.
    """
    errors = list(contradictions(assumes or {}, benchmark))
    if errors:
        raise ProctorError(
            "convention_mismatch",
            f"The policy assumes other conventions than {benchmark['benchmark_id']} "
            "declares; no run was submitted. Convert as the errors say, or correct "
            "what the policy assumes.",
            errors=errors,
        )
