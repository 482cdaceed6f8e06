"""Addresses of the pages of a server, relative to the page that has them.

A proxy may serve the server under a path of its own, which the server need not know.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote, urlencode

from reference_record.pages.page_templates import asset_version

# A path of these pages, with a query at most: never another site.
_NEXT = re.compile(r"/pages(/[A-Za-z0-9_-]+)*(\?[A-Za-z0-9_.=&%+-]*)?")


@dataclass(frozen=True, slots=True)
class ServerLinks:
    """The links of the pages of a server, as page_templates.Links describes them.

    root: the way from the page to the root of the server, such as `../`.
    reads_runs: whether its reader may see runs; an operator of cells may not.
    server_url: where the reader reaches the server, for commands of a terminal.
    has_tracks: whether a program of accounts has pages at the same server.
    """

    root: str = "/"
    is_live: bool = True
    reads_runs: bool = True
    server_url: str = ""
    has_tracks: bool = False

    @classmethod
    def of(cls, path: str) -> ServerLinks:
        """The links of the page at a path, as a browser knows it: still quoted."""
        return cls(root="../" * (path.count("/") - 1))

    def to(self, path: str) -> str:
        """The address of a path of the server."""
        return self.root + path.removeprefix("/")

    def login(self, path: str) -> str:
        """The sign-in, which leads to a path of the server."""
        return self.to(f"/pages/login?{urlencode({'next': safe_next(path)})}")

    def login_with_key(self, path: str) -> str:
        """The same at a host, for who has a key and no password."""
        query = {"with": "key", "next": safe_next(path)}
        return self.to(f"/pages/login?{urlencode(query)}")

    def login_as(self, owner: str, path: str) -> str:
        """The same at a host, as one of the names that the reader acts for."""
        return self.to(f"/pages/login?{urlencode({'owner': owner, 'next': path})}")

    def host_sign_in(self, path: str, *, state: str, owner: str) -> str:
        """Where a program of accounts signs in, and leads back to the sign-in here."""
        query = {"next": safe_next(path), "state": state, "owner": owner}
        return self.to(f"/hosting/pages?{urlencode(query)}")

    def login_from(self, address: str) -> str:
        """The sign-in, which leads to an address of these links."""
        return self.login(f"/{address.removeprefix(self.root)}")

    def index(self) -> str:
        return self.to("/pages") if self.reads_runs else self.cells()

    def runs(self) -> str:
        return self.to("/pages/runs") if self.reads_runs else ""

    def tracks(self) -> str:
        return self.to("/hosting") if self.has_tracks else ""

    def host_pages(self, account: str) -> Mapping[str, str]:
        """What an account has at a host besides tracks. account: what its own says."""
        names = {"Submissions": "submissions", "Keys": "keys"}
        names |= {"Organisations": "organisations", account: "account"}
        return {title: self.to(f"/hosting/{name}") for title, name in names.items()}

    def asset(self, name: str) -> str:
        return self.to(f"/pages/static/{name}?v={asset_version(name)}")

    def benchmark(self, benchmark_id: str, manifest_sha256: str = "") -> str:
        return self.to(f"/pages/benchmarks/{quote(benchmark_id, safe='')}")

    def leaderboard(self, benchmark_id: str) -> str:
        return f"{self.benchmark(benchmark_id)}/leaderboard"

    def entry(self, entry_id: str) -> str:
        return self.to(f"/pages/entries/{quote(entry_id, safe='')}")

    def history(self) -> str:
        return self.to("/pages/history")

    def cells(self) -> str:
        return self.to("/pages/cells")

    def cell(self, cell_id: str) -> str:
        return self.to(f"/pages/cells/{quote(cell_id, safe='')}")

    def second_judgement(self, judgement_id: str) -> str:
        return self.to(f"/pages/second_judgements/{quote(judgement_id, safe='')}")

    def imports(self) -> str:
        return self.to("/pages/imports")

    def import_page(self, import_id: str) -> str:
        return self.to(f"/pages/imports/{quote(import_id, safe='')}")

    def run(self, run_id: str) -> str:
        return self.to(f"/pages/runs/{quote(run_id, safe='')}")

    def record(self, run_id: str) -> str:
        return f"{self.run(run_id)}/record"

    def live(self, run_id: str) -> str:
        return f"{self.run(run_id)}/live"

    def episode(self, run_id: str, episode: Mapping[str, Any]) -> str:
        return f"{self.run(run_id)}/episodes/{quote(episode['episode_id'], safe='')}"

    def picture(self, run_id: str, episode: Mapping[str, Any], number: int) -> str:
        return f"{self.episode(run_id, episode)}/pictures/{number}"

    def film(self, run_id: str, episode: Mapping[str, Any]) -> str:
        return f"{self.episode(run_id, episode)}/film"

    def comparison(self, baseline: str, run_id: str) -> str:
        return self.to(
            f"/pages/compare?{urlencode({'baseline': baseline, 'run': run_id})}"
        )

    def pair(self, baseline: str, run_id: str, episode: Mapping[str, Any]) -> str:
        chosen = {"baseline": baseline, "run": run_id}
        chosen["episode"] = episode["episode_id"]
        return self.to(f"/pages/compare/episode?{urlencode(chosen)}")

    def pair_films(self, baseline: str, run_id: str, episode: Mapping[str, Any]) -> str:
        page, _, query = self.pair(baseline, run_id, episode).partition("?")
        return f"{page}/films?{query}"


def safe_next(path: str) -> str:
    """The path of a browser after the sign-in: only a page of this server."""
    is_page = _NEXT.fullmatch(path) and not path.startswith("/pages/log")
    return path if is_page else "/pages"
