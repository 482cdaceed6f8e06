"""The result of one run of the kit: a verdict for every rule, and the exit code."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from conformance.exchanges.curl import script
from conformance.run_settings import Settings
from conformance.specification.document import load_spec, spec_sha256
from conformance.specification.ledger import (
    CORE,
    LEVELS,
    Requirement,
    load_ledger,
)
from conformance.specification.stages import advice_when_done, advice_when_not_done
from conformance.verdicts.coverage import Coverage
from conformance.verdicts.expect import ANY_CORE_SEQUENCE, ANY_SEQUENCE, TIME_WAS_UP
from conformance.verdicts.levels import LevelVerdict, judge_level
from conformance.verdicts.universal_rules import (
    ORACLE_RULES,
    UNIVERSAL_RULES,
    Breach,
    Tally,
)
from conformance.verdicts.verdict import Outcome, Verdict, exit_code

NOT_ANNOUNCED = "not announced"
_NOTES = 5
_VALUE = re.compile(r"'[^']*'|[0-9]+")
_WAITING = (Outcome.FAILED, Outcome.INCONCLUSIVE, Outcome.NOT_VERIFIED)
WORST_FIRST = (
    Outcome.FAILED,
    Outcome.KIT_ERROR,
    Outcome.INCONCLUSIVE,
    Outcome.NOT_VERIFIED,
    Outcome.NOT_APPLICABLE,
    Outcome.PASSED,
)


@dataclass
class Result:
    """The content of the reports. `problem` is the reason why nothing was decided."""

    settings: Settings
    started_at: str = ""
    elapsed_s: float = 0.0
    problem: str | None = None
    notes: list[str] = field(default_factory=list)
    round_trip_p50_s: float = 0.0
    rows: dict[str, Verdict] = field(default_factory=dict)
    stale: list[str] = field(default_factory=list)
    coverage: Coverage = field(default_factory=Coverage)
    # Operations that the server does not serve, each with what it answers instead.
    unserved: dict[str, str] = field(default_factory=dict)

    @property
    def exit_code(self) -> int:
        """0 no MUST is violated but known failures, 1 violated, 2 not decided."""
        if self.problem is not None:
            return 2
        levels = {row.id: row.level for row in load_ledger().values()}
        code = exit_code(self.rows.values(), levels)
        if code == 0 and any(
            row.reason.startswith(TIME_WAS_UP) for row in self.rows.values()
        ):
            return 2
        is_short = self.settings.level is not None and bool(self.missing_profiles())
        return 1 if (self.stale or is_short) and code == 0 else code

    @property
    def verdict_code(self) -> int:
        """The exit code, but 1 where a known failure of a MUST was excused."""
        return self.exit_code or int(bool(self.violated()))

    def violated(self) -> list[str]:
        """Name each MUST that is violated, known failures among them."""
        ledger = load_ledger()
        return [
            row.requirement_id
            for row in self.rows.values()
            if row.outcome == Outcome.FAILED
            and ledger[row.requirement_id].level == "MUST"
        ]

    def missing_profiles(self) -> list[str]:
        """Name the profiles of the level --level that the server does not announce."""
        of_level = LEVELS[self.settings.level or CORE]
        return [name for name in of_level if not self.settings.is_offered(name)]

    @property
    def is_partial(self) -> bool:
        """Whether only a selection of the rules was checked."""
        return self.settings.is_partial

    def counts(self, level: str) -> Counter[Outcome]:
        """Count the outcomes of the rows of a level."""
        ledger = load_ledger()
        return Counter(
            verdict.outcome
            for verdict in self.rows.values()
            if ledger[verdict.requirement_id].level == level
        )

    def headline(self) -> str:
        """Give the numbers in one line."""
        count = self.counts("MUST")
        parts = [
            f"{count.total()} MUST: {count[Outcome.PASSED]} verified",
            f"{count[Outcome.FAILED]} violated",
            f"{count[Outcome.NOT_VERIFIED]} not verified",
            f"{count[Outcome.NOT_APPLICABLE]} not applicable",
        ]
        parts += [
            f"{count[outcome]} {label(outcome)}"
            for outcome in (Outcome.INCONCLUSIVE, Outcome.KIT_ERROR)
            if count[outcome]
        ]
        warned = self.counts("SHOULD")[Outcome.FAILED]
        if warned:
            parts.append(f"{warned} SHOULD violated")
        return ", ".join(parts)

    def applicable(self) -> list[Verdict]:
        """Give the rows that a reader sees: those of profiles that are announced."""
        ledger = load_ledger()
        return [
            row
            for row in self.rows.values()
            if row.outcome != Outcome.NOT_APPLICABLE
            or is_offered(ledger[row.requirement_id], self.settings)
        ]

    def profiles(self) -> dict[str, str]:
        """Give each profile with its MUST rules verified, of all that apply."""
        ledger = load_ledger()
        counts: dict[str, Counter[Outcome]] = {}
        for verdict in self.rows.values():
            rule = ledger[verdict.requirement_id]
            if rule.level == "MUST":
                counts.setdefault(rule.profile, Counter())[verdict.outcome] += 1
        return {profile: _of_all(count) for profile, count in counts.items()}

    def profile_texts(self) -> list[str]:
        """Give each announced profile with its numbers, and count the other ones."""
        profiles = self.profiles().items()
        texts = [f"{name} {text}" for name, text in profiles if text != NOT_ANNOUNCED]
        if left_out := len(profiles) - len(texts):
            texts.append(f"{left_out} profiles {NOT_ANNOUNCED}")
        return texts

    def levels(self) -> list[LevelVerdict]:
        """Judge each level; none where no server was judged."""
        if not (self.settings.service and self.settings.is_of_server):
            return []
        is_decided = self.problem is None
        return [
            judge_level(name, self.rows, self.settings, is_decided=is_decided)
            for name in LEVELS
        ]

    def level_lines(self) -> list[str]:
        """Give the verdict on each level as a sentence."""
        return [f"{level.title}: {level.text}." for level in self.levels()]

    def open_rules(self) -> dict[str, list[str]]:
        """Give the rules that were not verified, by verdict and reason, worst first."""
        by_reason: dict[tuple[Outcome, str], list[str]] = {}
        for verdict in self.applicable():
            if verdict.outcome != Outcome.PASSED:
                is_failed = verdict.outcome == Outcome.FAILED
                reason = "" if is_failed else verdict.reason.split("\n")[0]
                by_reason.setdefault((verdict.outcome, reason), []).append(
                    verdict.requirement_id
                )
        words = {Outcome.FAILED: "violated"}
        return {
            ", ".join(filter(None, (words.get(kind) or label(kind), reason))): ids
            for (kind, reason), ids in sorted(
                by_reason.items(),
                key=lambda item: (WORST_FIRST.index(item[0][0]), -len(item[1])),
            )
        }

    def causes(self, *outcomes: Outcome) -> list[list[Verdict]]:
        """Give the rows with these outcomes, worst first, those of one cause together.

        The cause is taken for one where the same was expected and the same observed,
        or the same is given as the reason.
        """
        by_cause: dict[tuple[str, ...], list[Verdict]] = {}
        for verdict in sorted(
            (row for row in self.rows.values() if row.outcome in outcomes),
            key=lambda row: WORST_FIRST.index(row.outcome),
        ):
            said = (verdict.expected, verdict.observed, verdict.reason)
            is_known = bool(verdict.observed or verdict.reason)
            excused = str(verdict.is_known_failure)
            alone = "" if is_known else verdict.requirement_id
            key = (verdict.outcome.value, excused, alone, *said)
            by_cause.setdefault(key, []).append(verdict)
        return list(by_cause.values())

    def conclusion(self) -> str:
        """Give the last line."""
        if self.problem is not None:
            return f"not decided: {self.problem}"
        scope = " (selected rules)" if self.is_partial else ""
        if self.exit_code == 2:
            return f"not decided: {self._undecided()}"
        violated, missing = self.violated(), self.missing_profiles()
        claims = [f"NOT conformant{scope}"] if violated or missing else []
        if missing:
            claims.append(f"{', '.join(missing)} missing")
        if self.exit_code == 0 and violated:
            known = ", ".join(violated)
            claims.append(f"every MUST that is violated is a known failure ({known})")
        if self.stale:
            verb = "passes" if len(self.stale) == 1 else "pass"
            claims.append(
                f"{', '.join(self.stale)} {verb} now: take the line out of the file "
                "of --known-failures"
            )
        return ": ".join(claims) or f"conformant{scope}"

    def advice(self) -> str | None:
        """Say what to do next, where the kit was run with --stage."""
        stage = self.settings.stage
        if stage is None:
            return None
        if self.exit_code == 0:
            skips = self.settings.quick
            return advice_when_done(stage, self.settings.level, skips=skips)
        return advice_when_not_done(stage, self._first_step())

    def _first_step(self) -> str:
        """Say where to begin: at the cause of most rows, or the first that failed."""
        if self.problem is not None:
            return "see the reason above"
        waiting = Counter(
            row.waits_for
            for row in self.rows.values()
            if row.waits_for in self.unserved
        )
        if waiting:
            [(name, count)] = waiting.most_common(1)
            rules = "1 rule waits" if count == 1 else f"{count} rules wait"
            return f"serve `{name}`, for which {rules}: {self.unserved[name]}"
        levels = {row.id: row.level for row in load_ledger().values()}
        wrong = [
            verdict
            for verdict in self.rows.values()
            if verdict.outcome not in (Outcome.PASSED, Outcome.NOT_APPLICABLE)
            and not verdict.allowed
            and levels[verdict.requirement_id] == "MUST"
        ]
        worst = min(wrong, key=lambda row: WORST_FIRST.index(row.outcome), default=None)
        if worst is None:
            return "see the reason above"
        return f"begin with {worst.requirement_id}: --only {worst.requirement_id}"

    def _undecided(self) -> str:
        """Name the rules that were not decided, with the reason of the first."""
        open_rows = [
            row
            for row in self.rows.values()
            if row.outcome not in (Outcome.PASSED, Outcome.NOT_APPLICABLE)
        ]
        broken = [row for row in open_rows if not row.allowed] or open_rows
        if not broken:
            return "the server offers none of the selected profiles"
        ids = ", ".join(row.requirement_id for row in broken[:8])
        more = f" and {len(broken) - 8} more" if len(broken) > 8 else ""
        reason = (broken[0].reason.strip() or "?").splitlines()[0]
        return f"{ids}{more} ({reason})"


def label(outcome: Outcome) -> str:
    """Give an outcome in words."""
    return outcome.value.replace("_", " ")


def _of_all(count: Counter[Outcome]) -> str:
    applying = count.total() - count[Outcome.NOT_APPLICABLE]
    return f"{count[Outcome.PASSED]}/{applying}" if applying else NOT_ANNOUNCED


def is_offered(row: Requirement, settings: Settings) -> bool:
    """Say whether the server announces the profile of a rule."""
    return settings.is_offered(row.profile)


def conclude(
    result: Result,
    verdicts: Mapping[str, Verdict],
    tally: Tally,
    known_failures: set[str],
) -> None:
    """Fill in the rows of a result from the verdicts of the checks."""
    for row in result.settings.selected_rules:
        verdict = _verdict_on(row, result, verdicts)
        if row.id in (*UNIVERSAL_RULES, *ORACLE_RULES):
            _apply_tally(verdict, tally)
        result.rows[row.id] = verdict
    if not is_offered(load_ledger()[ANY_SEQUENCE], result.settings):
        _name_rule_of_core(result.rows)
    _fail_rules_broken_in_set_ups(result.rows)
    for verdict in result.rows.values():
        if verdict.breaks and not _is_judged(verdict.breaks, result):
            verdict.reason = verdict.reason.removesuffix(f"; see {verdict.breaks}")
            verdict.breaks = ""
    _apply_differences(result, tally, known_failures)
    _doubt_rules_with_differences(result, tally, known_failures)
    _note_breaches_of_later_stages(result, tally)
    _name_unserved_operations(result, tally)
    result.notes += filter(None, [tally.served.lost_on_the_way()])
    for row in result.settings.selected_rules:
        verdict = result.rows[row.id]
        if row.id in known_failures:
            verdict.is_known_failure = verdict.outcome == Outcome.FAILED
            if verdict.outcome == Outcome.PASSED:
                result.stale.append(row.id)


def _verdict_on(
    row: Requirement, result: Result, verdicts: Mapping[str, Verdict]
) -> Verdict:
    def unjudged(reason: str | None, *, allowed: bool = True) -> Verdict:
        return Verdict(row.id, Outcome.NOT_VERIFIED, reason or "", allowed)

    if not is_offered(row, result.settings):
        reason = f"profile {row.profile} is not announced by the server"
        return Verdict(row.id, Outcome.NOT_APPLICABLE, reason)
    if not row.is_observable:
        return unjudged(row.why)
    if row.id in verdicts:
        return verdicts[row.id]
    if result.problem is not None:
        return unjudged(result.problem, allowed=False)
    if result.settings.quick:
        return unjudged("skipped by --quick")
    return Verdict(row.id, Outcome.KIT_ERROR, "the kit has no check for this rule")


def _doubt_rules_with_differences(
    result: Result, tally: Tally, known_failures: set[str]
) -> None:
    """Verify no rule by answers that contradict another rule.

    The oracle judges each answer by those before it; on a server that invents its
    answers, some fit by chance.
    """
    for rule in ORACLE_RULES:
        verdict, broken = result.rows.get(rule), tally.broken_in_check.get(rule)
        if broken and verdict is not None and verdict.outcome == Outcome.PASSED:
            verdict.outcome = Outcome.NOT_VERIFIED
            verdict.allowed = broken <= known_failures
            verdict.reason = (
                f"answers to its requests broke {', '.join(sorted(broken))}"
            )


def _apply_tally(verdict: Verdict, tally: Tally) -> None:
    """Fail a rule that some response of the run broke."""
    row = verdict.requirement_id
    breaches = [
        item for item in tally.breaches if item.requirement_id == row and not item.rules
    ]
    if verdict.outcome == Outcome.PASSED and not tally.exercised[row]:
        verdict.outcome = Outcome.NOT_VERIFIED
        verdict.reason = "no response in this run exercised the rule"
    if not breaches or verdict.outcome == Outcome.FAILED:
        return
    first = breaches[0]
    verdict.outcome = Outcome.FAILED
    verdict.reason = f"{tally.broken[row]} of {tally.exercised[row]} answers"
    verdict.expected, verdict.observed = first.expected, first.observed
    verdict.exchanges = [
        replace(breach.exchange, is_judged=True) for breach in breaches[:3]
    ]
    verdict.left_out = 0


def _apply_differences(result: Result, tally: Tally, known_failures: set[str]) -> None:
    """Fail the rules that answers broke in the exchanges of any check.

    A rule fails by the exchanges of its own check first. Where a rule has failed, an
    answer that this rule explains fails no other one. Any other answer may follow from
    the same mistake: it counts for all rules together, and for the rule itself once
    nothing else has failed. So do the answers that follow the first one of a check.
    """
    breaches = [breach for breach in tally.breaches if breach.rules]
    for breach in breaches:
        if breach.is_own and _is_judged(breach.requirement_id, result):
            _fail_by(breach, breach.requirement_id, result)
    failed = {
        row_id
        for row_id, row in result.rows.items()
        if row.outcome == Outcome.FAILED and row_id not in known_failures
    }
    all_rules = ANY_SEQUENCE if _is_judged(ANY_SEQUENCE, result) else ANY_CORE_SEQUENCE
    judged_checks, new, unjudged = set[str](), set[str](), list[Breach]()
    for breach in breaches:
        if (failed | new) & set(breach.rules):
            continue
        is_first = not failed and breach.check not in judged_checks
        judged_checks.add(breach.check)
        row = breach.requirement_id if is_first else all_rules
        new.add(row)
        if _is_judged(row, result):
            _fail_by(breach, row, result)
        else:
            unjudged.append(breach)
    _note_unjudged_differences(unjudged, result)


def _is_judged(row_id: str, result: Result) -> bool:
    row = result.rows.get(row_id)
    return row is not None and row.outcome != Outcome.NOT_APPLICABLE


def _fail_by(breach: Breach, row_id: str, result: Result) -> None:
    row = result.rows[row_id]
    if row.outcome != Outcome.FAILED:
        row.outcome = Outcome.FAILED
        row.reason = f"{breach.requirement_id}, by the request "
        row.reason += breach.exchange.correlation_id
        row.expected, row.observed = breach.expected, breach.observed
        row.waits_for = breach.waits_for
        row.exchanges = [*breach.before, breach.exchange]


def _note_unjudged_differences(breaches: list[Breach], result: Result) -> None:
    """Show the first answer by which each rule was broken that this run leaves out."""
    counts = Counter(breach.requirement_id for breach in breaches)
    firsts = {breach.requirement_id: breach for breach in reversed(breaches)}
    for rule, count in list(counts.items())[:_NOTES]:
        first = firsts[rule]
        doubt = " may be violated, too, or this follows from what failed"
        note = rule + doubt * (rule in result.rows)
        note += f": expected {first.expected}, observed {first.observed}"
        others = "1 more answer" if count == 2 else f"{count - 1} more answers"
        more = f" (and {others})" if count > 1 else ""
        result.notes.append(note + more)


def _name_unserved_operations(result: Result, tally: Tally) -> None:
    """Give the rows that wait for an operation which is not served their one cause.

    A row that failed stays so: an operation that no request reaches breaks its rules.
    """
    for verdict in result.rows.values():
        cause = tally.served.cause(verdict.waits_for)
        if cause is None or verdict.outcome not in _WAITING:
            verdict.waits_for = ""
            continue
        result.unserved[verdict.waits_for] = cause
        verdict.reason = f"`{verdict.waits_for}` is not served: {cause}"
        if verdict.outcome == Outcome.FAILED:
            continue
        verdict.outcome = Outcome.NOT_VERIFIED
        if verdict.breaks:
            verdict.reason += f"; see {verdict.breaks}"


def _note_breaches_of_later_stages(result: Result, tally: Tally) -> None:
    """Show answers that break their schema where --stage leaves that rule out."""
    if result.settings.stage is None:
        return
    left_out = [
        breach
        for breach in tally.breaches
        if breach.requirement_id not in result.rows and not breach.rules
    ]
    said = Counter[str]()
    firsts: dict[str, str] = {}
    for breach in left_out:
        text = f"{breach.requirement_id}: {breach.observed}"
        same = _VALUE.sub("", text)  # notes that differ by a value are one
        firsts.setdefault(same, text)
        said[same] += 1
    for same, text in list(firsts.items())[:_NOTES]:
        others = said[same] - 1
        more = f" (and in {others} more)" if others else ""
        result.notes.append(text + more)


def _name_rule_of_core(rows: dict[str, Verdict]) -> None:
    """Name MODEL-003 in the place of MODEL-001, which is of a profile not announced."""
    for verdict in rows.values():
        if verdict.breaks == ANY_SEQUENCE:
            verdict.breaks = ANY_CORE_SEQUENCE
            verdict.reason = verdict.reason.replace(ANY_SEQUENCE, ANY_CORE_SEQUENCE)


def _fail_rules_broken_in_set_ups(rows: dict[str, Verdict]) -> None:
    """Fail a rule whose check passed, but that the set-up of another check saw broken.

    MODEL-001, or MODEL-003 in Core, is the rule on all answers together: it fails
    where nothing else explains a refusal.
    """
    witnesses = [
        v for v in rows.values() if v.outcome == Outcome.NOT_VERIFIED and v.breaks
    ]
    of_all = (ANY_SEQUENCE, ANY_CORE_SEQUENCE)
    for verdict in sorted(witnesses, key=lambda v: v.breaks in of_all):
        broken = rows.get(verdict.breaks)
        if broken is None or broken.outcome != Outcome.PASSED:
            continue
        if verdict.breaks in of_all and any(
            row.outcome == Outcome.FAILED for row in rows.values()
        ):
            continue
        broken.outcome = Outcome.FAILED
        broken.reason = f"broken in the set-up of {verdict.requirement_id}"
        broken.expected = load_ledger()[verdict.breaks].text
        broken.observed = f"{verdict.reason} (in the set-up of {verdict.check})"
        broken.exchanges = verdict.exchanges


def as_plain(result: Result) -> dict[str, Any]:
    """Give the report as JSON-ready data; see report.schema.json."""
    ledger = load_ledger()
    settings = result.settings
    rows = []
    for row_id, verdict in result.rows.items():
        row = ledger[row_id]
        rule = {"level": row.level, "profile": row.profile, "text": row.text}
        commands = "\n".join(script(verdict.exchanges, settings.url))
        rows.append(
            rule | {"source": row.source, "script": commands} | verdict.as_plain()
        )
    return {
        "schema_version": 1,
        "spec": {"version": load_spec().version, "sha256": spec_sha256()},
        "url": settings.url,
        "server": {
            key: settings.service.get(key)
            for key in ("name", "version", "protocol", "profiles")
        },
        "started_at": result.started_at,
        "elapsed_s": round(result.elapsed_s, 3),
        "seed": settings.seed,
        "minutes": settings.minutes,
        "coverage": result.coverage.as_plain(),
        "only": settings.only,
        "level": settings.level,
        "profiles": settings.profiles,
        "quick": settings.quick,
        "stage": settings.stage,
        "max_time_s": settings.max_time_s,
        "round_trip_p50_s": result.round_trip_p50_s,
        "round_trip_p95_s": settings.round_trip_s,
        "tolerance_s": settings.tolerance_s,
        "notes": result.notes,
        "problem": result.problem,
        "stale_known_failures": result.stale,
        "headline": result.headline(),
        "levels": {level.name: level.text for level in result.levels()},
        "conclusion": result.conclusion(),
        "exit_code": result.exit_code,
        "counts": {
            level: {key.value: n for key, n in result.counts(level).items()}
            for level in ("MUST", "SHOULD")
        },
        "rows": rows,
    }
