"""A request for a page: who reads, and what the address says, checked."""

from __future__ import annotations

import re
from dataclasses import dataclass

from starlette.requests import Request

from reference_server.generated.parameters import PATH_PATTERNS
from reference_server.http.pages.api_documents import ApiDocuments, Problem
from reference_server.http.pages.page_links import ServerLinks
from reference_server.http.pages.page_sessions import PageSession

_ID = re.compile(PATH_PATTERNS["run_id"])
_PAGE = re.compile(r"[1-9][0-9]{0,5}")


@dataclass(frozen=True, slots=True)
class PageCall:
    """A request of a reader who is signed in. links: of the page that answers it."""

    request: Request
    session: PageSession
    api: ApiDocuments
    links: ServerLinks

    @property
    def csrf(self) -> str:
        return self.session.csrf

    def path(self, name: str) -> str:
        return _checked_id(self.request.path_params[name])

    def query_id(self, name: str) -> str:
        return _checked_id(self.request.query_params.get(name, ""))

    def query_ids(self, name: str) -> list[str]:
        return [_checked_id(text) for text in self.request.query_params.getlist(name)]

    def query(self, name: str) -> str:
        return self.request.query_params.get(name, "")[:200]

    @property
    def page(self) -> int:
        text = self.query("page") or "1"
        if not _PAGE.fullmatch(text):
            raise Problem(404, "not_found", "There is no such page.")
        return int(text)


def links_of(request: Request) -> ServerLinks:
    """The links of the page that a request is for."""
    raw = request.scope.get("raw_path") or request.url.path.encode()
    path = raw.partition(b"?")[0].decode("latin-1")
    return ServerLinks.of(path)


def _checked_id(text: str) -> str:
    if not _ID.fullmatch(text):
        raise Problem(404, "not_found", "There is no such page.")
    return text
