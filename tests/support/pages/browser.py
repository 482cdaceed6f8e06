"""A real browser, driven over its DevTools protocol, for tests of the pages.

It is Chromium as the machine has it (Debian: `apt-get install chromium`), headless,
with an empty profile of its own and no connection but to this machine.
"""

import json
import shutil
import subprocess
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Self

import httpx
from websockets.sync.client import connect

from tests.support.paths import ROOT
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_until
from tools.npm_package import provide_file

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-quic"),
    *("--no-first-run", "--disable-background-networking", "--hide-scrollbars"),
    *("--disable-component-update", "--disable-sync", "--remote-debugging-port=0"),
    "--disable-dev-shm-usage",
)


# The rules of accessibility of axe-core, which requirements/pages-npm.txt pins. None of
# them reads the text of styles, which pages that are files may not load again.
AXE = ROOT / ".venv" / "axe.min.js"
VIOLATIONS = """
axe.run({resultTypes: ["violations"], preload: false}).then(
  found => found.violations.map(one => `${one.id} (${one.help}): ${one.nodes[0].html}`))
"""
# Contrast of texts with their ground, as WCAG 2.2 defines it; labels of fields; rows
# of tables that are read at a glance, also where the window is narrow.
FAULTS = """
(() => {
  const parts = text => text.match(/[\\d.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map(v => v / 255)
    .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
    .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = element => {
    for (let one = element; one; one = one.parentElement) {
      const found = parts(getComputedStyle(one).backgroundColor);
      if (found.length < 4 || found[3] === 1) return found;
    }
    return [255, 255, 255];
  };
  const faults = [];
  for (const element of document.querySelectorAll("body *")) {
    const texts = [...element.childNodes].filter(n => n.nodeType === 3);
    const hasText = texts.some(n => n.data.trim());
    if (!hasText || !element.getClientRects().length) continue;
    const [a, b] = [parts(getComputedStyle(element).color), ground(element)].map(light);
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < 4.5) faults.push(`${contrast.toFixed(2)}: ${element.textContent}`);
  }
  for (const field of document.querySelectorAll("input:not([type=hidden]), select"))
    if (!field.labels.length) faults.push(`no label: ${field.name}`);
  for (const picture of document.querySelectorAll("img:not([alt])"))
    faults.push(`no text: ${picture.src}`);
  if (document.querySelectorAll("h1").length !== 1) faults.push("not one heading");
  const {scrollWidth} = document.documentElement;
  if (scrollWidth > innerWidth) faults.push(`${scrollWidth} pixels wide`);
  const laidOn = one => {
    const {left, right, top, bottom} = one.getBoundingClientRect();
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    const range = document.createRange();
    while (texts.nextNode()) {
      if (!texts.currentNode.data.trim() || one.contains(texts.currentNode)) continue;
      // The content of closed details may have a place, and is not shown there.
      if (!texts.currentNode.parentElement.checkVisibility()) continue;
      range.selectNodeContents(texts.currentNode);
      for (const at of range.getClientRects())
        if (at.width && at.left < right && at.right > left
            && at.top < bottom && at.bottom > top) return texts.currentNode.data;
    }
  };
  for (const one of document.querySelectorAll("body *")) {
    if (getComputedStyle(one).position !== "fixed") continue;
    for (let y = 0; y < document.documentElement.scrollHeight; y += 100) {
      scrollTo(0, y);
      const under = laidOn(one);
      if (under) faults.push(`${one.textContent} lies on: ${under}`);
    }
    scrollTo(0, 0);
  }
  for (const one of document.querySelectorAll("tr"))
    if (one.getBoundingClientRect().height >= 200)
      faults.push(`a tall row: ${one.innerText}`);
  return faults;
})()
"""


def find_browser() -> str | None:
    """Chromium's path, or None where the machine has none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One tab. A context manager; errors: what its console complained of."""

    def __init__(self) -> None:
        program = find_browser()
        assert program, "Chromium is missing; on Debian: apt-get install chromium"
        self._folder = tempfile.mkdtemp(prefix="browser-")
        command = [program, *FLAGS, f"--user-data-dir={self._folder}", "about:blank"]
        nothing = subprocess.DEVNULL
        self._process = subprocess.Popen(command, stdout=nothing, stderr=nothing)
        port_file = Path(self._folder) / "DevToolsActivePort"
        wait_until(lambda: _has_text(port_file), "the browser listens")
        port = port_file.read_text().split("\n")[0]
        with httpx.Client(trust_env=False, timeout=TIMEOUT_S) as client:
            targets = client.get(f"http://127.0.0.1:{port}/json/list").json()
        (target,) = [one for one in targets if one["type"] == "page"]
        self._open = ExitStack()
        connection = connect(target["webSocketDebuggerUrl"], max_size=None, proxy=None)
        self._socket = self._open.enter_context(connection)
        self._number = 0
        self.errors: list[str] = []
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._open.close()
        self._process.terminate()
        self._process.wait(TIMEOUT_S)
        shutil.rmtree(self._folder, ignore_errors=True)

    def call(self, method: str, **params: Any) -> Any:
        """One command of the protocol; returns its result."""
        self._number += 1
        message = {"id": self._number, "method": method, "params": params}
        self._socket.send(json.dumps(message))
        deadline = time.monotonic() + TIMEOUT_S
        while True:
            answer = json.loads(self._socket.recv(deadline - time.monotonic()))
            if answer.get("id") == self._number:
                assert "error" not in answer, answer
                return answer["result"]
            self._note(answer)

    def _note(self, event: dict[str, Any]) -> None:
        if event["method"] == "Runtime.exceptionThrown":
            self.errors.append(json.dumps(event["params"]["exceptionDetails"]))
        if event["method"] == "Log.entryAdded":
            entry = event["params"]["entry"]
            # A 404 that a test asks for is logged as an error of the network.
            if entry["level"] == "error" and entry["source"] != "network":
                self.errors.append(entry["text"])

    def open(self, url: str) -> None:
        """Go there; returns when the page is loaded."""
        self.call("Page.navigate", url="about:blank")  # another step is another page
        self.wait_for("location.href === 'about:blank'")
        self.evaluate("window.isLeft = true")
        self.call("Page.navigate", url=url)
        self.wait_for("!window.isLeft && document.readyState === 'complete'")

    def evaluate(self, expression: str, *, awaits: bool = False) -> Any:
        """The value of an expression in the page; awaits: that of a promise."""
        how = {"returnByValue": True, "awaitPromise": awaits}
        result = self.call("Runtime.evaluate", expression=expression, **how)
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def wait_for(self, expression: str) -> None:
        """Wait until an expression in the page is true."""

        def is_true() -> bool:
            try:
                return bool(self.evaluate(expression))
            except AssertionError:  # between two pages
                return False

        wait_until(is_true, expression)

    def follow(self, expression: str) -> None:
        """Do what leads to another page, and wait for it."""
        self.evaluate(f"window.isLeft = true; {expression}; 0")
        self.wait_for("!window.isLeft && document.readyState === 'complete'")

    def press(self, key: str) -> None:
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=key)

    def sign_in(self, url: str, token: str) -> None:
        """At a server, by its form."""
        self.open(f"{url}/pages/login")
        self.evaluate(f"document.querySelector('[name=token]').value = '{token}'")
        self.follow("document.querySelector('form.login').requestSubmit()")

    def resize(self, width: int, *, dark: bool = False) -> None:
        self.call(
            "Emulation.setDeviceMetricsOverride",
            width=width, height=900, deviceScaleFactor=1, mobile=False,
        )  # fmt: skip
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        self.call("Emulation.setEmulatedMedia", features=[scheme])

    def find_violations(self) -> list[str]:
        """The complaints of axe-core about the page: rule, and one element of each."""
        provide_file("pages-npm.txt", "axe.min.js", AXE)
        self.evaluate(f"{AXE.read_text()}; 0")
        return list(self.evaluate(VIOLATIONS, awaits=True))

    def find_faults(self) -> list[str]:
        """Faults of the page that a reader would notice, as far as we judge them."""
        return list(self.evaluate(FAULTS))

    @property
    def text(self) -> str:
        return str(self.evaluate("document.body.innerText"))


def _has_text(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0
