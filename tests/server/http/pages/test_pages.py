"""The pages of a server, without a browser: what they show, and to whom."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from markupsafe import escape

from tests.support.pages.page_reader import (
    PageReader,
    commands_of,
    elements_of,
    fields_of,
    inline_code_of,
    links_of,
    place_of,
    without_server,
)
from tests.support.pages.played_runs import EVIL, submit_and_play
from tests.support.server.http_runs import predict_body, submit
from tests.support.servers import TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("a server is started")


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    with ReferenceServer(tmp_path_factory.mktemp("pages")) as server:
        yield server


@pytest.fixture(scope="module")
def run_id(server: ReferenceServer) -> str:
    """A run of alice with markup in every text: one success, two failures."""
    return submit_and_play(server, successes={1})


def pages_of(run_id: str, other: str) -> list[str]:
    return [
        "/pages",
        "/pages/runs",
        f"/pages/runs?benchmark={EVIL}&policy={EVIL}&state={EVIL}",
        "/pages/benchmarks/calibration",
        f"/pages/runs/{run_id}",
        f"/pages/runs/{run_id}?outcome={EVIL}&task={EVIL}",
        f"/pages/runs/{run_id}/episodes/e0000",
        f"/pages/compare?baseline={run_id}&run={other}&kind={EVIL}",
        f"/pages/compare/several?run={run_id}&run={other}",
        f"/pages/compare/episode?baseline={run_id}&run={other}&episode=e0000",
    ]


def test_texts_of_others_are_texts(server: ReferenceServer, run_id: str) -> None:
    """Markup in every field. Expect no element, handler or link made of it."""
    reader = PageReader(server.url, "alice")
    other = submit_and_play(server, successes={0})
    for path in pages_of(run_id, other):
        page = reader.text(path)
        assert inline_code_of(page) == [], path
        assert "<script>alert" not in page, path
        assert not [link for link in links_of(page) if "javascript" in link], path
    about = reader.text(f"/pages/runs/{run_id}")
    assert "&lt;script&gt;alert(1)" in about, "the control: the text is on the page"


def test_an_episode_says_why_it_was_left(server: ReferenceServer) -> None:
    """With markup. Expect it on the page of the run until the attempt has a result of
    its own, and then on that of the episode alone."""
    reader, shown = PageReader(server.url, "alice"), str(escape(EVIL))
    with server.client() as client:
        run_id = submit(client, "score")
        worker = f"/v1/runs/{run_id}/workers/w"
        turn = client.put(worker, json={"attach_key": "k"}).json()
        left = {"session_id": turn["session_id"], "reason": EVIL}
        assert client.post(f"{worker}/heartbeat", json=left).is_success
        page = reader.text(f"/pages/runs/{run_id}")
        assert f"Left by its worker: e0000. {shown}" in page
        assert f"left by its worker in attempt 1: {shown}" in page
        assert inline_code_of(page) == []
        end = predict_body(turn, score=1.0, success=1.0, end=1.0)
        assert client.post(f"{worker}/predict", json=end).is_success
    assert shown not in reader.text(f"/pages/runs/{run_id}")
    page = reader.text(f"/pages/runs/{run_id}/episodes/e0000")
    assert f"in attempt 1: {shown}" in page
    assert inline_code_of(page) == []


def test_each_printed_command_names_its_server(
    server: ReferenceServer, run_id: str
) -> None:
    """On the pages of a server at a port that commands do not look at by themselves."""
    reader = PageReader(server.url, "alice")
    board = "/pages/benchmarks/calibration/leaderboard"
    paths = [*pages_of(run_id, submit_and_play(server, successes={0}))]
    for path in [*paths, board, "/pages/history"]:
        assert without_server(reader.text(path)) == [], path
    for path, command in {
        "/pages/benchmarks/calibration": "run --policy POLICY --benchmark calibration",
        "/pages/history": "board verify",
        board: "board verify",
    }.items():
        whole = f"proctor {command} --url {server.url}"
        assert whole in commands_of(reader.text(path)), path
    empty = PageReader(server.url, "bob").text("/pages")
    assert [server.url in command for command in commands_of(empty)] == [True]


def test_links_to_elsewhere_give_nothing_away(server: ReferenceServer) -> None:
    policy = {"name": "p", "homepage": "https://example.org/a"}
    body = {"benchmark_id": "calibration", "policy": policy}
    with server.client() as client:
        run_id = client.post("/v1/runs", json=body).json()["run_id"]
    page = PageReader(server.url, "alice").text(f"/pages/runs/{run_id}")
    (link,) = [
        one for _, one in elements_of(page) if one.get("href", "").startswith("http")
    ]
    assert link["href"] == "https://example.org/a"
    assert {"noopener", "nofollow"} <= set(link["rel"].split())


def test_pages_say_what_the_api_says(server: ReferenceServer, run_id: str) -> None:
    page = PageReader(server.url, "alice").text(f"/pages/runs/{run_id}")
    with server.client() as client:
        score = client.get(f"/v1/runs/{run_id}/score").json()
    rates = [
        f"<b>{100 * one['success_rate']:.1f} %</b> {name}"
        for name, one in score["by_split"].items()
    ]
    assert ", ".join(rates) in page
    mix = f"{100 * score['success_rate']:.1f} % success, 1 of 3 episodes"
    assert f"(mix of 2 splits, which is no result to quote: {mix}" in page
    outcomes = re.findall(r'<tr data-outcome="(\w+)"', page)
    assert outcomes == ["failure", "failure", "success"], "failures stand first"


def test_filters_select_and_pages_end(server: ReferenceServer, run_id: str) -> None:
    reader = PageReader(server.url, "alice")
    page = reader.text(f"/pages/runs/{run_id}?outcome=success")
    assert re.findall(r'<tr data-outcome="(\w+)"', page) == ["success"]
    for wrong in ("page=2", "page=0", "page=x", "page=99999999"):
        assert reader.get(f"/pages/runs/{run_id}?{wrong}").status_code == 404


def test_a_comparison_names_its_benchmark_and_the_part(server: ReferenceServer) -> None:
    """A picture of the page is read alone. Expect both in what is shown."""
    with server.client() as client:
        first, second = (
            submit(client, "score", select={"splits": ["even"]}) for _ in range(2)
        )
    reader = PageReader(server.url, "alice")
    named = r"on (<a [^>]*>)?calibration(</a>)?, version .+, splits even, and nothing"
    for path in (
        f"/pages/runs/{first}",
        f"/pages/compare?baseline={first}&run={second}",
        f"/pages/compare/several?run={first}&run={second}",
        f"/pages/compare/episode?baseline={first}&run={second}&episode=e0000",
    ):
        assert re.search(named, reader.text(path)), path


def test_other_accounts_see_nothing(server: ReferenceServer, run_id: str) -> None:
    """Bob, and a path that nothing has. Expect the same answer."""
    bob = PageReader(server.url, "bob")
    run = f"/pages/runs/{run_id}"
    paths = [run, f"{run}/live", f"{run}/record", f"{run}/episodes/e0000"]
    paths += [f"{run}/episodes/e0000/pictures/0"]
    paths += [f"/pages/compare/several?run={run_id}&run=run_other"]
    paths += [f"/pages/compare?baseline={run_id}&run={run_id}"]
    paths += [f"/pages/compare/episode?baseline={run_id}&run={run_id}&episode=e0000"]
    for path in paths:
        there = bob.get(path)
        absent = bob.get(path.replace(run_id, "run_absent"))
        assert there.status_code == absent.status_code == 404, path
        assert there.text.replace(run_id, "run_absent") == absent.text, path
    assert run_id not in bob.text("/pages") + bob.text("/pages/runs")
    assert PageReader(server.url, "alice").get(run).status_code == 200


def test_without_a_session_there_is_the_sign_in(
    server: ReferenceServer, run_id: str
) -> None:
    reader = PageReader(server.url)
    for path in ("/pages", f"/pages/runs/{run_id}?outcome=failure"):
        answer = reader.get(path)
        assert answer.status_code == 303
        target = httpx.URL(place_of(answer))
        assert target.path == "/pages/login"
        assert target.params["next"] == path
    assert reader.get(f"/pages/runs/{run_id}/live").status_code == 401
    reader.client.cookies.set("proctor_session", "x" * 43, path="/pages")
    assert reader.get("/pages").status_code == 303


def test_the_session_is_a_cookie_that_scripts_cannot_read(
    server: ReferenceServer,
) -> None:
    reader = PageReader(server.url)
    answer = reader.sign_in(TOKENS["alice"], "/pages/runs")
    assert place_of(answer) == "/pages/runs"
    (cookie,) = [
        text
        for text in answer.headers.get_list("set-cookie")
        if text.startswith("proctor_session=") and "Max-Age=0" not in text
    ]
    attributes = {part.strip().lower() for part in cookie.split(";")[1:]}
    assert {"httponly", "samesite=strict"} <= attributes
    assert not any(part.startswith("path=") for part in attributes)
    assert TOKENS["alice"] not in cookie + answer.headers["location"] + answer.text


def test_wrong_tokens_make_no_session(server: ReferenceServer) -> None:
    for token in ("wrong", "", "tóken", "a\r\nb", "x" * 4000):
        reader = PageReader(server.url)
        assert reader.sign_in(token).status_code == 403
        assert reader.get("/pages").status_code == 303


def test_forms_of_other_sites_are_refused(server: ReferenceServer) -> None:
    """Without the secret, or sent by another site. The control signs out."""
    reader = PageReader(server.url, "alice")
    assert reader.sign_out(csrf="x").status_code == 403
    for headers in ({"sec-fetch-site": "cross-site"}, {"origin": "https://evil"}):
        form = {"csrf": reader.csrf()}
        answer = reader.client.post("/pages/logout", data=form, headers=headers)
        assert answer.status_code == 403
    other = PageReader(server.url)
    stolen = {"csrf": "y", "token": TOKENS["alice"], "next": "/pages"}
    assert other.client.post("/pages/login", data=stolen).status_code == 403
    answer = reader.sign_out()
    assert (answer.status_code, place_of(answer)) == (303, "/pages/login")
    assert reader.get("/pages").status_code == 303


def test_planted_cookies_do_not_outlive_a_sign_in(server: ReferenceServer) -> None:
    """Cookies of the right form, set by another site. Expect others after each page."""
    reader = PageReader(server.url)
    planted = dict.fromkeys(("proctor_login", "proctor_session"), "a" * 43)
    for name, value in planted.items():
        reader.client.cookies.set(name, value, "127.0.0.1", "/pages")
    page = reader.client.get("/pages/login")
    assert fields_of(page.text)["csrf"] not in planted.values()
    assert reader.client.cookies["proctor_login"] not in planted.values()
    assert reader.sign_in(TOKENS["alice"]).status_code == 303
    assert reader.client.cookies["proctor_session"] not in planted.values()
    assert "proctor_login" not in reader.client.cookies


def test_only_forms_are_read(server: ReferenceServer) -> None:
    client = PageReader(server.url).client
    assert client.post("/pages/login", json={"token": "x"}).status_code == 415
    big = client.post("/pages/login", data={"token": "x" * 20_000})
    assert big.status_code == 413
    kind = {"content-type": "application/x-www-form-urlencoded"}
    for members in (33, 100):
        many = "&".join(f"a{n}=1" for n in range(members))
        answer = client.post("/pages/login", content=many, headers=kind)
        assert answer.status_code == 400


def test_a_method_that_a_page_lacks_is_refused_as_a_page(
    server: ReferenceServer,
) -> None:
    client = PageReader(server.url).client
    allowed = {"/pages": "GET, HEAD", "/pages/login": "GET, HEAD, POST"}
    allowed |= {"/pages/logout": "POST", "/pages/nothing": "GET, HEAD"}
    for path, methods in allowed.items():
        answer = client.put(path)
        assert (answer.status_code, answer.headers["allow"]) == (405, methods), path
        assert answer.headers["content-type"].startswith("text/html"), path
        assert "default-src 'none'" in answer.headers["content-security-policy"], path
        assert answer.headers["x-frame-options"] == "DENY", path


def test_each_answer_keeps_others_out(server: ReferenceServer, run_id: str) -> None:
    """No frame, no foreign script, no sniffing, no copy in a cache."""
    reader = PageReader(server.url, "alice")
    paths = ["/pages", f"/pages/runs/{run_id}", "/pages/nothing", "/pages/login"]
    for path in [*paths, f"/pages/runs/{run_id}/record"]:
        headers = reader.get(path).headers
        policy = headers["content-security-policy"]
        assert "default-src 'none'" in policy, path
        assert "frame-ancestors 'none'" in policy, path
        assert "unsafe" not in policy, path
        assert headers["x-frame-options"] == "DENY", path
        assert headers["x-content-type-options"] == "nosniff", path
        assert headers["cache-control"] == "no-store", path


def test_what_pages_load_is_here(server: ReferenceServer, run_id: str) -> None:
    """Every script and style of a page is of this server, and kept for good."""
    reader = PageReader(server.url, "alice")
    page = reader.text(f"/pages/runs/{run_id}/episodes/e0000")
    loaded = [
        one.get("src") or one["href"]
        for tag, one in elements_of(page)
        if tag == "link" or (tag == "script" and "src" in one)
    ]
    assert len(loaded) == 5
    for address in loaded:
        answer = reader.get(address)
        assert answer.status_code == 200
        assert "immutable" in answer.headers["cache-control"]
    for wrong in ("../page_templates.py", "%2e%2e/page_templates.py", "none.js"):
        assert reader.get(f"/pages/static/{wrong}").status_code == 404


def test_bad_addresses_are_not_found(server: ReferenceServer, run_id: str) -> None:
    reader = PageReader(server.url, "alice")
    episode = f"/pages/runs/{run_id}/episodes/e0000"
    for path in (
        *("/pages/runs/a%2Fb", "/pages/runs/%00", f"/pages/runs/{'x' * 99}"),
        *("/pages/compare", "/pages/compare?baseline=a&run=%0a", "/pages/x"),
        *("/pages/benchmarks/none", "/pages/runs/x/episodes", "/pages/entries/none"),
        *("/pages/imports", "/pages/imports/x"),
        *("/pages/compare/several", "/pages/compare/several?run=x"),
        f"{episode}/film/{'1' * 5000}", f"{episode}/pictures/{'1' * 5000}",
        f"{episode}/film/{'1' * 64}", f"{episode}/pictures/{'1' * 64}",
    ):  # fmt: skip
        assert reader.get(path).status_code == 404, path


def test_a_browser_at_the_root_is_led_to_the_pages(server: ReferenceServer) -> None:
    """A program is refused there as before."""
    client = PageReader(server.url).client
    answer = client.get("/", headers={"accept": "text/html,*/*"})
    assert (answer.status_code, place_of(answer)) == (303, "/pages")
    assert client.get("/").json()["code"] == "not_found"
    assert client.post("/", headers={"accept": "text/html"}).status_code == 404
    assert place_of(client.get("/pages/")) == "/pages"


def test_the_record_can_be_downloaded(server: ReferenceServer, run_id: str) -> None:
    answer = PageReader(server.url, "alice").get(f"/pages/runs/{run_id}/record")
    with server.client() as client:
        assert answer.content == client.get(f"/v1/runs/{run_id}/record").content
    assert answer.headers["content-disposition"].startswith("attachment")


PUBLISHED = {"model_name": EVIL, "notes": EVIL, "organisation": "=1+1"}


def test_a_run_is_published_and_withdrawn(server: ReferenceServer) -> None:
    """By the forms of its page; a form without the secret changes nothing."""
    run_id = submit_and_play(server, successes={0, 1})
    reader = PageReader(server.url, "alice")
    page, board = f"/pages/runs/{run_id}", "/pages/benchmarks/calibration/leaderboard"
    form = {**PUBLISHED, "is_public": "yes"}
    refused = reader.client.post(f"{page}/publish", data=form | {"csrf": "x"})
    assert refused.status_code == 403
    with server.client() as client:
        sha256 = client.get(f"/v1/runs/{run_id}").json()["manifest_sha256"]
        path = f"/v1/benchmarks/calibration/ranking?manifest_sha256={sha256}"
        assert client.get(path).json()["rows"] == []
        form["csrf"] = reader.csrf()
        answer = reader.client.post(f"{page}/publish", data=form)
        assert place_of(answer) == f"{page}#entry", answer.text
        (row,) = client.get(path).json()["rows"]
        assert row["entry"]["model_name"] == EVIL
        assert f"?manifest={sha256}" in reader.text(board), "its own has no entry"
        shown = reader.text(f"{board}?manifest={sha256}&sort=newest")
        assert "66.7 %" in shown
        assert "By split" in shown
        assert "Rows stand in the order of their score over all episodes" in shown
        assert "By task" not in shown, "there is one task"
        assert inline_code_of(shown) == []
        assert "<script>alert" not in shown
        data = reader.get(f"{board}/csv?manifest={sha256}").text
        assert "'=1+1" in data, "a spreadsheet would compute it"
        assert data.splitlines()[0].endswith("split even,success_rate split odd")
        assert run_id in data, "a record is found by it"
        assert reader.get(f"{board}/json?manifest={sha256}").json()["rows"] == [row]
        entry = f"/pages/entries/{row['entry']['entry_id']}"
        for address in (entry, "/pages/history"):
            about = reader.text(address)
            assert "66.7 %" in about, address
            assert inline_code_of(about) == [], address
            assert "<script>alert" not in about, address
            assert f'{entry}"' in shown, "the control: it is linked"
        sure = {"csrf": form["csrf"], "sure": "yes"}
        reader.client.post(f"{page}/withdraw", data=sure)
        assert client.get(path).json()["rows"] == []
    assert "withdrawn for good" in reader.text(entry)
    assert "withdraw" in reader.text("/pages/history")
    assert "cannot be published again" in reader.text(page)
    assert f"{page}/publish" not in reader.text(page)
    assert reader.client.post(f"{page}/publish", data=form).status_code == 409


def test_pages_can_be_off(tmp_path: Path) -> None:
    with ReferenceServer(tmp_path, PROCTOR_PAGES="off") as server:
        client = PageReader(server.url).client
        for path in ("/", "/pages", "/pages/login"):
            answer = client.get(path, headers={"accept": "text/html"})
            assert answer.status_code == 404
            assert answer.json()["code"] == "not_found"
