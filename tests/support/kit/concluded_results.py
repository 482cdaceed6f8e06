"""Results of a run of the kit that a test makes up: verdicts, without a server."""

from collections.abc import Iterable

from conformance.run_settings import Settings
from conformance.specification.document import load_spec
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result, conclude
from conformance.verdicts.universal_rules import Tally
from conformance.verdicts.verdict import Outcome, Verdict


def concluded(
    settings: Settings,
    *verdicts: Verdict,
    known: Iterable[str] = (),
    tally: Tally | None = None,
) -> Result:
    """Conclude these verdicts of the selected rules, of which all others passed.

    known: rules that are known to fail. tally: what was seen of the rules that every
    answer keeps; by default an answer to each of them, also judged by the oracle.
    """
    if tally is None:
        tally = Tally(load_spec())
        tally.exercised.update(load_ledger())
    result = Result(settings)
    found = {row.id: Verdict(row.id, Outcome.PASSED) for row in settings.selected_rules}
    found |= {verdict.requirement_id: verdict for verdict in verdicts}
    conclude(result, found, tally, set(known))
    return result
