"""Which benchmark a `mode` of FlagEval's scripts stands for: the host's table.

FlagEval binds data sets to a domain and a mode, such as NLP and Qnext. Which benchmark
of this server takes their place is decided by the host, in the setting
`flageval_modes`. Pure; it must not know which benchmarks exist.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NoReturn

from reference_server.rules.refusal import Refused

DEFAULT_MODE = "FlagRelease"  # of FlagEval's server
QUESTIONS = "question_answering"
ANY_MODE = "*"
_ENTRY = re.compile(r"(NLP|MM):([^\s,:=]{1,100})=([a-z][a-z0-9_]{0,63})")


@dataclass(frozen=True, slots=True)
class ModeTable:
    """benchmarks: (domain, mode) → benchmark_id; mode `*` stands for any other."""

    benchmarks: Mapping[tuple[str, str], str] = field(default_factory=dict)

    @classmethod
    def parse(cls, text: str) -> ModeTable:
        """`NLP:Qnext=quiz,MM:*=question_answering`. Raises ValueError."""
        benchmarks: dict[tuple[str, str], str] = {}
        for entry in filter(None, map(str.strip, text.split(","))):
            match = _ENTRY.fullmatch(entry)
            if match is None:
                raise ValueError(f"{entry!r} is not DOMAIN:MODE=BENCHMARK_ID")
            if (match[1], match[2]) in benchmarks:
                raise ValueError(f"{match[1]}:{match[2]} is mapped twice")
            benchmarks[match[1], match[2]] = match[3]
        return cls(benchmarks)

    def find(self, domain: str, mode: str) -> str | None:
        """FLE-023: the benchmark of exactly this mode; an empty one is the default."""
        return self.benchmarks.get((domain, mode or DEFAULT_MODE))

    def find_any(self, domain: str, mode: str) -> str:
        """The benchmark of a mode that is neither mapped nor one. Raises Refused."""
        if (domain, ANY_MODE) in self.benchmarks:
            return self.benchmarks[domain, ANY_MODE]
        if mode or domain == "NLP":
            self._refuse(domain, mode)
        return QUESTIONS

    def _refuse(self, domain: str, mode: str) -> NoReturn:
        modes = [name for of, name in self.benchmarks if of == domain]
        mapped = f"mapped for {domain}: {', '.join(sorted(modes)) or 'none'}"
        if mode:
            at, text = (
                "/mode",
                f"is not a known benchmark, and no mode of the host ({mapped})",
            )
        else:
            at, text = (
                "/domain",
                f"NLP needs `mode`: a benchmark, or a mode of the host ({mapped})",
            )
        name = mode or DEFAULT_MODE
        raise Refused(
            "invalid_request",
            f"This host maps the mode {name[:100]} of the domain {domain} to nothing.",
            errors=[(at, text)],
        )
