"""A server that nginx serves under a path of its own, as its documentation begins."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from urllib.parse import urldefrag, urljoin, urlsplit

import pytest

from reference_client import ProctorError, evaluate
from tests.support.client.policies import GradedPolicy
from tests.support.kit.reverse_proxies import BASE_PATHS, run_proxy
from tests.support.kit.run_kit import KitRun, run_kit
from tests.support.pages.browser import Browser
from tests.support.pages.page_reader import PageReader, elements_of
from tests.support.pages.played_runs import submit_and_play
from tests.support.ports import free_port
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server, a proxy and a kit")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("base_path")
    with ReferenceServer(folder, PROCTOR_PROFILES="ebench") as server:
        yield server


@pytest.fixture(scope="module")
def proxy_url(
    server: ReferenceServer, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[str]:
    """The URL of nginx, which drops headers with an underscore, too."""
    folder, port = tmp_path_factory.mktemp("proxy"), free_port()
    with run_proxy("nginx", folder / "nginx", port, server.url, BASE_PATHS):
        yield f"http://127.0.0.1:{port}"


@pytest.fixture(scope="module")
def run_id(server: ReferenceServer) -> str:
    submit_and_play(server, {0})
    return submit_and_play(server, {1})


def evaluate_at(url: str) -> int:
    played = evaluate(
        GradedPolicy,
        url=url,
        token=TOKENS["alice"],
        benchmark="calibration",
        episodes=1,
        retry_timeout_s=1,
    )
    return played.counts.success


def judge(url: str, folder: Path, only: str) -> KitRun:
    return run_kit(
        folder, *("--url", url), *("--only", only), PROCTOR_TOKEN=TOKENS["alice"]
    )


def test_a_prefix_that_the_proxy_sends_is_in_the_endpoint(
    proxy_url: str, tmp_path: Path
) -> None:
    assert evaluate_at(f"{proxy_url}/proctor") == 1
    kit = judge(f"{proxy_url}/proctor", tmp_path, "RUN-001,RUN-016,EBE-005,EBE-024")
    assert kit.outcomes == {
        "RUN-001": "passed",
        "RUN-016": "passed",
        "EBE-005": "passed",
        "EBE-024": "not_verified",
    }
    assert "nginx, in front" in kit.rows["EBE-024"]["reason"]
    assert "underscores_in_headers on" in kit.rows["EBE-024"]["reason"]
    assert kit.code == 0


def test_without_it_client_and_kit_name_the_endpoint(
    proxy_url: str, tmp_path: Path
) -> None:
    with pytest.raises(ProctorError) as caught:
        evaluate_at(f"{proxy_url}/without")
    assert f"{proxy_url} answered 405" in caught.value.detail
    assert f"which {proxy_url}/without has named" in caught.value.detail
    assert "--public-url" in caught.value.detail
    kit = judge(f"{proxy_url}/without", tmp_path, "RUN-016")
    assert kit.code == 2
    assert f"runs have the endpoint {proxy_url}, which does not lead" in kit.output
    assert "--public-url" in kit.output


def addresses_of(page: str) -> set[str]:
    """All that a browser may fetch from a page: links, files, forms, streams."""
    names = ("href", "src", "sse-connect")
    found = {one[n] for _, one in elements_of(page) for n in names if n in one}
    forms = [one for tag, one in elements_of(page) if tag == "form"]
    fetching = [one for one in forms if one.get("method", "get") == "get"]
    return found | {one.get("action", "") for one in fetching}


@pytest.mark.parametrize("base", ["proctor", "without"])
def test_every_address_of_the_pages_is_below_the_base_path(
    base: str, proxy_url: str, run_id: str
) -> None:
    """The proxy need not even name the path: all addresses are relative."""
    reader = PageReader(f"{proxy_url}/{base}", "alice")
    root = f"{proxy_url}/{base}/pages"
    waiting, seen = [root, f"{root}/runs/{run_id}"], set[str]()
    while waiting:
        seen.add(address := waiting.pop())
        with reader.client.stream("GET", address) as answer:
            # Forms without their fields are refused, by a page.
            assert answer.status_code in (200, 404), address
            kind = answer.headers["content-type"]
            if not kind.startswith("text/html"):
                continue
            page = answer.read().decode()
        if answer.status_code == 404:
            assert "/compare" in address, address
        for name in addresses_of(page):
            place, _ = urldefrag(urljoin(address, name))
            if urlsplit(place).netloc == urlsplit(root).netloc:
                assert place.startswith(root), (address, name)
                waiting += [] if place in seen else [place]
    assert {root, f"{root}/runs", f"{root}/runs/{run_id}/episodes/e0001"} <= seen
    assert len(seen) > 20
    assert reader.sign_out().headers["location"] == "../pages/login"
    assert reader.get(root).status_code == 303


def test_the_pages_work_in_a_browser(
    server: ReferenceServer, proxy_url: str, run_id: str
) -> None:
    """Expect a run to be watched, an episode to be played, and forms to lead on."""
    root = f"{proxy_url}/proctor"
    with Browser() as browser, server.client() as client:
        browser.sign_in(root, TOKENS["alice"])
        assert browser.evaluate("location.href") == f"{root}/pages"
        body = {"benchmark_id": "calibration", "policy": {"name": "watched"}}
        options = {"tasks": ["score", "score"]}
        watched = client.post("/v1/runs", json=body | {"options": options}).json()
        browser.open(f"{root}/pages/runs/{watched['run_id']}")
        stop = {"mode": "abort"}
        client.post(f"/v1/runs/{watched['run_id']}/stop", json=stop)
        browser.wait_for("document.body.innerText.includes('stopped')")
        browser.open(f"{root}/pages/runs/{run_id}")
        chosen = "document.querySelector('form[action$=\"/pages/compare\"]')"
        browser.follow(f"{chosen}.requestSubmit()")
        assert browser.evaluate("location.pathname") == "/proctor/pages/compare"
        browser.open(f"{root}/pages/runs/{run_id}/episodes/e0001#step=0")
        browser.press("End")
        browser.wait_for("location.hash === '#step=1'")
        fetched = browser.evaluate(
            "performance.getEntriesByType('resource').map(one => one.name)"
        )
        assert fetched
        assert all(name.startswith(f"{root}/pages/") for name in fetched)
        browser.follow("document.querySelector('header form').requestSubmit()")
        assert browser.evaluate("location.pathname") == "/proctor/pages/login"
        assert browser.errors == []
