"""A browser without scripts: fetches pages, keeps cookies, sends their forms."""

import re
from collections.abc import Mapping
from html import unescape
from html.parser import HTMLParser

import httpx

from tests.support.servers import TIMEOUT_S, TOKENS


class PageReader:
    """Who reads the pages of a server; signed in if an account is named."""

    def __init__(self, url: str, account: str = "") -> None:
        self.client = httpx.Client(base_url=url, timeout=TIMEOUT_S, trust_env=False)
        if account:
            answer = self.sign_in(TOKENS[account])
            assert answer.status_code == 303, answer.text

    def get(self, path: str) -> httpx.Response:
        return self.client.get(path)

    def text(self, path: str) -> str:
        """The HTML of a page that is there."""
        answer = self.get(path)
        assert answer.status_code == 200, (path, answer.status_code, answer.text)
        return answer.text

    def sign_in(self, token: str, next_path: str = "") -> httpx.Response:
        page = self.client.get("/pages/login", params={"next": next_path})
        form = fields_of(page.text) | {"token": token}
        return self.client.post("/pages/login", data=form)

    def sign_out(self, **changed: str) -> httpx.Response:
        form = fields_of(self.text("/pages")) | changed
        return self.client.post("/pages/logout", data=form)

    def csrf(self) -> str:
        return fields_of(self.text("/pages"))["csrf"]


def place_of(answer: httpx.Response) -> str:
    """The path to which an answer leads a browser, at the server that gave it."""
    here = answer.request.url
    place = here.join(answer.headers["location"])
    assert place.netloc == here.netloc
    return str(place).removeprefix(f"{here.scheme}://{here.netloc.decode()}")


def fields_of(page: str) -> dict[str, str]:
    """Name and value of the hidden fields of a page, each as a browser reads it."""
    return {
        element["name"]: element.get("value", "")
        for tag, element in elements_of(page)
        if tag == "input" and element.get("type") == "hidden"
    }


def elements_of(page: str) -> list[tuple[str, Mapping[str, str]]]:
    """Tag and attributes of every element, in their order."""
    found: list[tuple[str, Mapping[str, str]]] = []

    class Reader(HTMLParser):
        def handle_starttag(
            self, tag: str, attrs: list[tuple[str, str | None]]
        ) -> None:
            found.append((tag, {name: value or "" for name, value in attrs}))

    Reader().feed(page)
    return found


def commands_of(page: str) -> list[str]:
    """The commands of `proctor` that a page prints, without the marks in them."""
    code = re.findall(r"<(pre|code)\b[^>]*>(.*?)</\1>", page, re.DOTALL)
    texts = [unescape(re.sub(r"<[^>]*>", "", text)) for _, text in code]
    parts = [part.strip() for text in texts for part in text.split("&&")]
    return [part for part in parts if re.match(r"proctor\s", part)]


def without_server(page: str) -> list[str]:
    """The printed commands that look for a server which they do not name."""
    is_local = re.compile(r"proctor (admin|verify)\b")
    return [
        command
        for command in commands_of(page)
        if "--url http" not in command and not is_local.match(command)
    ]


def links_of(page: str) -> list[str]:
    return [one["href"] for tag, one in elements_of(page) if "href" in one]


def inline_code_of(page: str) -> list[str]:
    """Scripts, handlers and styles that stand in the page itself."""
    found = []
    for tag, element in elements_of(page):
        is_data = element.get("type") == "application/json"
        if tag == "style" or (tag == "script" and "src" not in element and not is_data):
            found.append(tag)
        found += [name for name in element if re.match(r"on|style$", name)]
    return found
