"""The pages of a host and those of its server have the same links above them."""

from __future__ import annotations

import re
from dataclasses import replace

import httpx
import pytest

from reference_platform.pages.form_calls import COOKIE
from reference_platform.parts import Parts
from reference_record.pages.page_templates import render_page
from reference_server.http.pages.page_links import ServerLinks
from tests.support.platform.approved_accounts import approved

AREAS = ["Runs", "Tracks", "Submissions", "Keys", "Organisations"]


def names_of(page: str) -> list[str]:
    (links,) = re.findall(r'<nav aria-label="Pages">(.*?)</nav>', page, re.DOTALL)
    return re.findall(r"<a [^>]*>([^<]*)</a>", links)


def test_a_page_of_the_server_leads_to_those_of_its_host() -> None:
    links = replace(ServerLinks.of("/pages/runs"), has_tracks=True)
    page = render_page("problem", links, csrf="secret", heading="A problem")
    assert names_of(page) == [*AREAS, "Account"]
    of_a_server = replace(links, has_tracks=False)
    page = render_page("problem", of_a_server, csrf="secret", heading="A problem")
    assert names_of(page) == ["Runs"]


@pytest.mark.parametrize("state", ["approved", "suspended"])
async def test_a_page_of_a_host_leads_to_those_of_its_server(
    parts: Parts, client: httpx.AsyncClient, state: str
) -> None:
    """A suspended account has no pages there; the platform here runs no submissions."""
    await approved(parts, "ada")
    if state == "suspended":
        parts.accounts.decide("ada", "suspend", "a reason", "host")
    client.cookies.set(COOKIE.name, parts.sessions.begin("ada", parts.clock()))
    page = (await client.get("/hosting/submissions")).text
    assert names_of(page) == [*(AREAS if state == "approved" else AREAS[1:]), "ada"]
    assert "This host runs no submissions" in page
