"""From a registration to a score, as people do it: pages, mail, commands."""

from __future__ import annotations

import os
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest

from tests.support.pages.browser import Browser
from tests.support.paths import ROOT
from tests.support.platform.hosted_server import HostedServer, MailReceiver
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts a host, a browser and an evaluation")

POLICY = """
class Policy:
    def reset(self, instruction):
        pass

    def act(self, observation):
        return {"score": [1.0], "success": [1.0], "end": [1.0], "delay_s": [0.0],
                "fault": [0.0], "vector": [0.0] * 8, "clipped": [0.0] * 2}
"""
# A page shows a name of a form as text, and executes nothing of it.
HOSTILE_NAME = "<script>document.title='taken'</script> & “Ada”"


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


def fill(browser: Browser, **values: str) -> None:
    for name, value in values.items():
        field = f"document.querySelector('[name={name}]')"
        browser.evaluate(f"{field}.value = {value!r}")


def submit(browser: Browser, button: str) -> None:
    """Press the button with this text."""
    browser.follow(
        "[...document.querySelectorAll('button')]"
        f".find(one => one.innerText === {button!r}).click()"
    )


def sign_in(browser: Browser, host: HostedServer, name: str, password: str) -> None:
    browser.call("Network.clearBrowserCookies")
    browser.open(f"{host.url}/hosting/login")
    fill(browser, account=name, password=password)
    submit(browser, "Sign in")


def proctor(host: HostedServer, key: str, folder: Path, *words: str) -> str:
    """The output of `proctor`; it plays on the machine of the participant."""
    done = subprocess.run(
        [sys.executable, "-m", "reference_client.command", *words, "--url", host.url],
        cwd=folder, capture_output=True, text=True, timeout=120, check=False,
        env=os.environ | {"PROCTOR_TOKEN": key, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    return f"{done.stdout}{done.stderr}\nexit {done.returncode}"


def register(browser: Browser, host: HostedServer) -> None:
    browser.open(f"{host.url}/hosting/register")
    fill(
        browser, account="ada", full_name=HOSTILE_NAME, organisation="A Laboratory",
        email="ada@example.org", password="correct horse",
    )  # fmt: skip
    browser.evaluate("document.querySelector('[name=agrees]').checked = true")
    submit(browser, "Register")
    assert "waits for its review" in browser.text
    # Without approval there is no key.
    sign_in(browser, host, "ada", "correct horse")
    browser.open(f"{host.url}/hosting/keys")
    assert "Only an approved account has keys" in browser.text


def approve(browser: Browser, host: HostedServer, mail: MailReceiver) -> None:
    """The administrator gets a mail, and approves on the page."""
    assert "registered as ada" in mail.wait_for("host@example.org", "waits for review")
    sign_in(browser, host, "organiser", host.password)
    browser.open(f"{host.url}/hosting/review")
    assert HOSTILE_NAME in browser.text
    assert browser.evaluate("document.title") == "Review · Proctor"
    assert browser.find_faults() == []
    submit(browser, "Approve")
    mail.wait_for("ada@example.org", "approved")
    assert "organiser  approve  ada" in host.admin("audit")


def make_key(browser: Browser, host: HostedServer) -> str:
    """A key, which the next page does not show any more."""
    browser.open(f"{host.url}/hosting/keys")
    fill(browser, label="laptop")
    submit(browser, "Make a key")
    key = str(browser.evaluate("document.getElementById('secret').innerText"))
    browser.open(f"{host.url}/hosting/keys")
    assert "laptop" in browser.text
    assert key not in browser.text
    assert browser.find_faults() == []
    return key


def keys_shown(browser: Browser, host: HostedServer) -> str:
    browser.open(f"{host.url}/hosting/keys")
    return str(browser.evaluate("document.querySelector('tbody').innerText"))


def test_a_participant_registers_and_is_evaluated(
    host: HostedServer, mail: MailReceiver, browser: Browser, tmp_path: Path
) -> None:
    host.put_track()
    register(browser, host)
    approve(browser, host, mail)
    sign_in(browser, host, "ada", "correct horse")
    key = make_key(browser, host)
    browser.open(f"{host.url}/hosting/tracks/letters")
    submit(browser, "Enter this track")
    # It evaluates from its own machine, and the page shows the score.
    (tmp_path / "mine.py").write_text(POLICY)
    play = ("run", "--policy", "mine.py:Policy", "--benchmark", "calibration")
    assert "exit 0" in proctor(host, key, tmp_path, *play)
    browser.open(f"{host.url}/hosting/tracks/letters")
    assert "completed" in browser.text
    assert "1 of 2" in browser.text
    assert browser.find_faults() == []
    follow_links(browser, host)
    wait_until(lambda: "–" not in keys_shown(browser, host), "the last use is shown")
    assert not browser.errors
    with host.client(key) as client:
        revoke_while_following(browser, client)


def follow_links(browser: Browser, host: HostedServer) -> None:
    """Every link of the page of a track leads to a page that the account may see."""
    track = f"{host.url}/hosting/tracks/letters"
    browser.open(track)
    links = "[...document.querySelectorAll('a')].map(one => one.href)"
    pages = [link for link in browser.evaluate(links) if "/record" not in link]
    assert sum("/pages" in link for link in pages) >= 4
    for page in pages:
        browser.open(track)
        browser.follow(
            f"[...document.links].find(one => one.href === {page!r}).click()"
        )
        heading = browser.evaluate("document.querySelector('h1').innerText")
        assert heading not in ("Sign in", "Refused", "Not found"), page
    # A key is the other way in, and who has signed out stays so.
    browser.open(f"{host.url}/pages")
    submit(browser, "Sign out")
    assert "Key or token" in browser.text
    browser.follow("document.querySelector('main a').click()")
    assert "Runs" in browser.text
    # Without the account's sign-in its page begins with that, and leads back.
    browser.call("Network.clearBrowserCookies")
    browser.open(f"{host.url}/pages/history")
    assert "Sign in with a key" in browser.text
    fill(browser, account="ada", password="correct horse")
    submit(browser, "Sign in")
    assert browser.evaluate("location.pathname") == "/pages/history"


def revoke_while_following(browser: Browser, client: httpx.Client) -> None:
    """The last run of the day is followed; its stream ends when the key is revoked."""
    body = {"benchmark_id": "calibration", "policy": {"name": "x"}}
    run_id = client.post("/v1/runs", json=body).json()["run_id"]
    refused = client.post("/v1/runs", json=body)
    assert (refused.status_code, refused.json()["limit"]) == (429, "per_day")
    ended: list[float] = []

    def follow() -> None:
        with client.stream("GET", f"/v1/runs/{run_id}/events") as events:
            for _ in events.iter_lines():
                pass
        ended.append(time.monotonic())

    following = threading.Thread(target=follow)
    following.start()
    submit(browser, "Revoke")
    revoked_at = time.monotonic()
    following.join(20)
    assert ended
    assert ended[0] - revoked_at < 5
    wait_until(lambda: client.get(f"/v1/runs/{run_id}").status_code == 401, "401")


def test_a_program_signs_in(
    host: HostedServer, browser: Browser, tmp_path: Path
) -> None:
    """`proctor login` shows a code; the page gives it a key, which it keeps."""
    environment = {k: v for k, v in os.environ.items() if k[:8] != "PROCTOR_"}
    environment |= {"XDG_STATE_HOME": str(tmp_path), "PROCTOR_URL": host.url}
    command = [sys.executable, "-m", "reference_client.command"]
    with subprocess.Popen(
        [*command, "login"],
        cwd=ROOT, env=environment, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    ) as program:  # fmt: skip
        assert program.stderr is not None
        page = program.stderr.readline().split()[-1]
        code = program.stderr.readline().split("code ")[1].split(".")[0]
        browser.call("Network.clearBrowserCookies")
        browser.open(page)
        fill(browser, account="organiser", password=host.password)
        submit(browser, "Sign in")
        assert code in browser.text
        assert browser.find_faults() == []
        submit(browser, "Allow")
        assert "has a key now" in browser.text
        assert program.wait(30) == 0
        assert program.stdout is not None
        assert "Signed in as organiser for 90 days." in program.stdout.read()
    done = subprocess.run(
        [*command, "status", "--json"],
        cwd=ROOT, env=environment, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.strip() == "[]"
    (kept,) = (tmp_path / "proctor" / "keys").iterdir()
    assert kept.stat().st_mode & 0o077 == 0
    # Which token was refused, and the one that the host would accept.
    for token, said in (("stale", f"keeps in {kept}, unset PROCTOR_TOKEN"), ("", "")):
        refused = subprocess.run(
            [*command, "status"],
            cwd=ROOT, env=environment | ({"PROCTOR_TOKEN": token} if token else {}),
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert (refused.returncode, said in refused.stderr) == (2 * bool(token), True)
    kept.unlink()
    none = subprocess.run(
        [*command, "status"],
        cwd=ROOT, env=environment, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert f"`proctor login --url {host.url}` makes a key" in none.stderr


@pytest.mark.parametrize("dark", [False, True])
def test_tables_fold_on_a_phone(
    host: HostedServer, browser: Browser, *, dark: bool
) -> None:
    """Expect no table that scrolls to the side, and buttons inside of the window."""
    host.put_track()
    sign_in(browser, host, "organiser", host.password)
    browser.resize(400, dark=dark)
    pages = "review", "operation", "images", "submissions", "keys", "organisations"
    for page in (*pages, "tracks/letters", ""):
        browser.open(f"{host.url}/hosting/{page}")
        assert browser.find_faults() == [], page
        cut = "one => one.scrollWidth > one.clientWidth || "
        cut += "one.getBoundingClientRect().right > innerWidth"
        tables = "[...document.querySelectorAll('.wide, button')]"
        assert browser.evaluate(f"{tables}.filter({cut}).length") == 0, page
