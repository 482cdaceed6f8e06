"""The page of an operator: what it shows in each phase, and what its forms send."""

from __future__ import annotations

from typing import Any

import pytest

from reference_record.pages.page_templates import render_page
from reference_server.http.pages.cell_pages import judgement_of
from reference_server.http.pages.page_links import ServerLinks

ASKED = "Put the block on the left mark."


def shown_in(phase: str) -> str:
    cell: dict[str, Any] = {
        "cell_id": "arm",
        "phase": phase,
        "trial": 3,
        "operator": "olga",
        "is_yours": True,
        "setup": {
            "name": "left",
            "instruction": f"Put the block in the middle.\n\n{ASKED}",
            "has_picture": True,
        },
        "stopped_by": "stopped by olga",
        "rubric": {"success": "The block is on its mark.", "criteria": []},
    }
    return render_page("cells/panel", ServerLinks(""), csrf="", cell=cell, seen="")


@pytest.mark.parametrize("phase", ["preparing", "playing", "judging"])
def test_who_judges_sees_the_setup_and_what_was_asked(phase: str) -> None:
    shown = shown_in(phase)
    assert ASKED in shown
    assert "pages/cells/arm/picture?trial=3" in shown


@pytest.mark.parametrize(
    ("form", "success"),
    [({}, None), ({"success": "yes"}, True), ({"success": "no"}, False)],
)
def test_a_form_without_a_choice_sends_none(
    form: dict[str, str], success: bool | None
) -> None:
    assert judgement_of(form).get("success") == success
