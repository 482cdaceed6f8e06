"""Texts that a spreadsheet would compute get a quote; all others stay as they are."""

import pytest

from reference_record.pages.spreadsheet_cells import as_cell

SIGNS = "=+-@\uff1d\uff0b\uff0d\uff20\ufe66\ufe62\ufe63\ufe6b\u2212"
BEFORE = ("", " ", "   ", "\u00a0", "\u200b", "\ufeff", "\x00", " \u2060 ", "\u3000")


@pytest.mark.parametrize("sign", SIGNS)
def test_a_formula_behind_anything_that_is_not_seen(sign: str) -> None:
    for before in BEFORE:
        assert as_cell(f"{before}{sign}1+1") == f"'{before}{sign}1+1", repr(before)


@pytest.mark.parametrize(
    ("text", "cell"),
    [
        ("\t=1", "'\t'=1"),
        ("\rname", "'\rname"),
        ("\nname", "'\nname"),
        ("name;=1+1;x", "name;'=1+1;x"),
        ("name; @SUM(1)", "name;' @SUM(1)"),
        ("first\n=1", "first\n'=1"),
        ("a\t+1", "a\t'+1"),
    ],
)
def test_a_formula_in_a_cell_that_begins_inside(text: str, cell: str) -> None:
    assert as_cell(text) == cell


@pytest.mark.parametrize(
    "value",
    ["", "name", "a = b", "x-1", "a@b.example", "a; b", "'=1", -1.5, None, True],
)
def test_nothing_else_changes(value: object) -> None:
    assert as_cell(value) is value
