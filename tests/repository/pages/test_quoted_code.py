"""Code that a page quotes from a file stands in that file, word for word."""

import re

import pytest

from tests.support.paths import ROOT

QUOTING_PAGES = ("docs/contribute/add-a-rule.md",)
# A line with nothing but a path and a colon, then the block.
QUOTATION = re.compile(r"^`([^`]+)`:\n\n```\w+\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("page", QUOTING_PAGES)
def test_quoted_code_stands_in_its_file(page: str) -> None:
    """Expect each block in the file that the line above it names."""
    quotations = QUOTATION.findall((ROOT / page).read_text())
    assert len(quotations) == (ROOT / page).read_text().count("```") / 2
    for path, block in quotations:
        assert block in (ROOT / path).read_text(), f"{page} quotes {path} wrongly"
