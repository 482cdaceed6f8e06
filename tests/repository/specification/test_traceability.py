"""Every rule is stated, decided, judged and broken; the table says where.

Expect no gap in either direction: from the specification to the code, and from an id
in the code to the specification.
"""

from tools import traceability
from tools.traceability import Place, citations

SOURCE = '''\
"""A header that cites PRED-001."""

# ATT-001: beside the constant.
LIMIT = 3


class Sessions:
    """ATT-002."""

    # ATT-003, ATT-004
    @property
    def live(self) -> int:
        return 1  # ATT-005

    limit: int = 2  # ATT-006


def digest() -> None:
    """SHA-256 is no rule."""
'''


def test_no_rule_has_a_gap() -> None:
    assert traceability.gaps() == []


def test_the_table_has_a_whole_row_for_every_rule() -> None:
    table = traceability.page()
    assert "**missing**" not in table
    for id_ in traceability.traces():
        assert f"\n| {id_} |" in table


def test_every_excuse_names_a_rule() -> None:
    excused = {*traceability.NO_DECIDING_LINE, *traceability.NO_MUTANT}
    assert excused <= set(traceability.traces())


def test_a_citation_belongs_to_its_definition() -> None:
    found = {id_: [p.name for p in ps] for id_, ps in citations(SOURCE, "f").items()}
    assert found == {
        "PRED-001": [""],
        "ATT-001": ["LIMIT"],
        "ATT-002": ["Sessions"],
        "ATT-003": ["Sessions.live"],
        "ATT-004": ["Sessions.live"],
        "ATT-005": ["Sessions.live"],
        "ATT-006": ["Sessions.limit"],
    }


def test_a_place_is_listed_once() -> None:
    source = "def f():\n    # ATT-001\n    return 1  # ATT-001\n"
    assert citations(source, "f.py") == {"ATT-001": [Place("f.py", "f")]}


def test_a_rule_of_other_programs_has_a_line_or_the_reason_for_none() -> None:
    """SIM-037 is decided by the server, too; SIM-001 by simulators alone."""
    reason = traceability.NO_DECIDING_LINE_BY_PROFILE["simulator"]
    for id_, has_line in (("SIM-037", True), ("SIM-001", False)):
        trace = traceability.traces()[id_]
        text = traceability.describe(trace)
        assert (bool(trace.deciding), reason in text) == (has_line, not has_line)
