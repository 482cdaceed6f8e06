"""Attacks on filters, comparisons, forms and leaderboards. Each has its control."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from urllib.parse import parse_qs, quote, urlencode, urlsplit

import pytest

from tests.support.pages.page_reader import (
    PageReader,
    inline_code_of,
    links_of,
    place_of,
)
from tests.support.pages.played_runs import EVIL, submit_and_play
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server is started")

BOARD = "/pages/benchmarks/calibration/leaderboard"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("attacks")
    with ReferenceServer(folder, PROCTOR_PUBLIC_BOARD="on") as server:
        yield server


@pytest.fixture(scope="module")
def run_id(server: ReferenceServer) -> str:
    """A run of alice."""
    return submit_and_play(server, successes={1})


@pytest.fixture(scope="module")
def own_id(server: ReferenceServer) -> str:
    """A run of bob, who attacks; with the same episodes."""
    return submit_and_play(server, successes={0}, account="bob")


def test_the_run_beside_ones_own_must_be_readable(
    server: ReferenceServer, run_id: str, own_id: str
) -> None:
    """Bob names his own run and alice's, in either order. Expect neither's results."""
    bob = PageReader(server.url, "bob")

    def paths_of(one: str, other: str) -> list[str]:
        query = urlencode({"baseline": one, "run": other})
        return [
            f"/pages/compare?{query}",
            f"/pages/compare/episode?{query}&episode=e0000",
        ]

    for ids in ((own_id, run_id), (run_id, own_id)):
        for path in paths_of(*ids):
            there, absent = bob.get(path), bob.get(path.replace(run_id, "run_absent"))
            assert there.status_code == absent.status_code == 404, path
            assert there.text.replace(run_id, "run_absent") == absent.text, path
    for path in paths_of(own_id, own_id):
        assert bob.get(path).status_code == 200, path


def test_episodes_of_different_benchmarks_are_not_put_side_by_side(
    server: ReferenceServer, run_id: str
) -> None:
    """Both have an episode e0000. Expect no claim of where the two diverge."""
    other = submit_and_play(server, {0}, tasks=("score", "count"))
    alice = PageReader(server.url, "alice")
    path = f"/pages/compare/episode?baseline={run_id}&run={other}&episode=e0000"
    answer = alice.get(path)
    assert answer.status_code == 409
    assert "within one manifest. Here " in answer.text
    assert alice.get(path.replace(other, run_id)).status_code == 200


def test_markup_in_every_parameter_is_a_text(
    server: ReferenceServer, run_id: str
) -> None:
    """Known and unknown parameters, as values and as names. Expect no element of it."""
    alice = PageReader(server.url, "alice")
    names = [
        *("text", "sort", "manifest", "outcome", "task", "split", "kind", "page"),
        *("benchmark", "policy", "state", "cursor", "baseline", "run", "episode"),
    ]
    pages = [
        *("/pages", "/pages/runs", f"/pages/runs/{run_id}", BOARD, "/pages/compare"),
        *(f"{BOARD}/csv", "/pages/compare/episode", "/pages/login"),
    ]
    shown = 0
    for page in pages:
        for name in (*names, "next", EVIL):
            answer = alice.get(f"{page}?{urlencode({name: EVIL})}")
            assert answer.status_code in (200, 400, 404, 422), (page, name)
            if not answer.headers["content-type"].startswith("text/html"):
                continue
            assert inline_code_of(answer.text) == [], (page, name)
            assert "<script>alert" not in answer.text, (page, name)
            assert not [a for a in links_of(answer.text) if EVIL in a], (page, name)
            shown += "&lt;script&gt;alert(1)" in answer.text
    assert shown, "the control: some pages repeat it as text"


def test_a_published_entry_is_text_for_visitors_too(
    server: ReferenceServer, run_id: str
) -> None:
    """Markup in each field, and links that a browser would execute."""
    alice = PageReader(server.url, "alice")
    page = f"/pages/runs/{run_id}/publish"
    texts = dict.fromkeys(("model_name", "model_type", "organisation", "notes"), EVIL)
    form = {**texts, "csrf": alice.csrf(), "is_public": "yes"}
    for address in ("javascript:alert(1)", "data:text/html,x", "//evil.example"):
        for name in ("homepage", "code_url"):
            answer = alice.client.post(page, data=form | {name: address})
            assert answer.status_code in (400, 422), (name, address)
    address = "https://example.org/\"onmouseover='x'<b>"
    form |= {"homepage": address, "code_url": address}
    assert alice.client.post(page, data=form).status_code == 303
    with server.client() as client:
        sha256 = client.get(f"/v1/runs/{run_id}").json()["manifest_sha256"]
    for reader in (alice, PageReader(server.url, "bob"), PageReader(server.url)):
        shown = reader.text(f"{BOARD}?manifest={sha256}")
        assert "&lt;script&gt;alert(1)" in shown
        assert inline_code_of(shown) == []
        assert "<script>alert" not in shown
        assert [link for link in links_of(shown) if link == address]


def test_forms_that_other_sites_send_change_nothing(server: ReferenceServer) -> None:
    """With the reader's own secret, as if it had leaked. Expect no entry."""
    own_id = submit_and_play(server, {0}, account="bob")
    bob = PageReader(server.url, "bob")
    form = {"csrf": bob.csrf(), "model_name": "m", "sure": "yes"}
    sites: list[Mapping[str, str]] = [
        *({"sec-fetch-site": site} for site in ("cross-site", "same-site")),
        *({"origin": one} for one in ("null", "https://evil.example", "http://x:1")),
    ]
    page = f"/pages/runs/{own_id}"
    for change in ("publish", "withdraw"):
        for headers in sites:
            answer = bob.client.post(f"{page}/{change}", data=form, headers=headers)
            assert answer.status_code == 403, (change, headers)
        assert bob.get(f"{page}/{change}?{urlencode(form)}").status_code == 404
    assert "Published as" not in bob.text(page)
    own = {"sec-fetch-site": "same-origin", "origin": server.url}
    answer = bob.client.post(f"{page}/publish", data=form, headers=own)
    assert answer.status_code == 303
    assert "Published as" in bob.text(page)


def test_a_private_entry_is_its_accounts_alone(
    server: ReferenceServer, own_id: str
) -> None:
    """On no leaderboard, in no download, for no other reader."""
    bob = PageReader(server.url, "bob")
    form = {"csrf": bob.csrf(), "model_name": "secret model"}
    answer = bob.client.post(f"/pages/runs/{own_id}/publish", data=form)
    assert answer.status_code == 303
    with server.client("bob") as client:
        sha256 = client.get(f"/v1/runs/{own_id}").json()["manifest_sha256"]
        entries = client.get("/v1/entries").json()["entries"]
    (entry_id,) = (one["entry_id"] for one in entries if one["run_id"] == own_id)
    page = f"/pages/entries/{entry_id}"
    assert "secret model" in bob.text(page), "the control"
    for reader in (PageReader(server.url, "alice"), PageReader(server.url)):
        for form_of in ("", "/csv", "/json"):
            shown = reader.text(f"{BOARD}{form_of}?manifest={sha256}")
            assert "secret model" not in shown
            assert own_id not in shown
        assert reader.get(page).status_code == 404
        assert "secret model" not in reader.text("/pages/history")
    assert "secret model" in bob.text(f"/pages/runs/{own_id}")


def test_the_sign_in_after_a_form_leads_back_to_its_page(
    server: ReferenceServer, run_id: str
) -> None:
    """The session ended while the form was open: a form cannot be opened as a page."""
    for change in ("publish", "withdraw"):
        reader = PageReader(server.url)
        page = f"/pages/runs/{run_id}"
        answer = reader.client.post(f"{page}/{change}", data={"csrf": "x"})
        assert answer.status_code == 303
        (target,) = parse_qs(urlsplit(answer.headers["location"]).query)["next"]
        assert target == page
        answer = reader.sign_in(TOKENS["alice"], target)
        assert reader.get(answer.headers["location"]).status_code == 200


@pytest.mark.parametrize(
    "target",
    [
        *("/pages/\\evil.example", "/pages?//evil.example", "/pages/runs/../../v1"),
        *("/pages/%2e%2e/v1", "/pages/%0d%0aSet-Cookie:a", "/pages;//evil.example"),
        *("/pages#//evil.example", "/Pages", "/pages\t", "\\\\evil.example/pages"),
        *("http:/pages", "/pages/logout", "/pagesx", "/pages?a=b\r\nX: y"),
        *("//evil.example", "https://evil.example", "/\\evil.example", "javascript:a"),
        *("/pages//evil.example", "/pages/../v1", "/pages\n/x", "/pages@evil", ""),
        "/pages/login",
    ],
)
def test_no_address_leads_elsewhere(server: ReferenceServer, target: str) -> None:
    """By the sign-in, and by the header Host of a request that needs one."""
    reader = PageReader(server.url)
    landed = place_of(reader.sign_in(TOKENS["alice"], target))
    assert landed == "/pages"
    evil = {"host": "evil.example"}
    answer = PageReader(server.url).client.get("/pages/runs", headers=evil)
    assert place_of(answer) == f"/pages/login?next={quote('/pages/runs', '')}"
