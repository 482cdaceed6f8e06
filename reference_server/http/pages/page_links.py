"""Addresses of the pages of a server."""

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
    """The links of the pages of a server, as page_templates.Links describes them."""

    is_live: bool = True

    def index(self) -> str:
        return "/pages"

    def runs(self) -> str:
        return "/pages/runs"

    def asset(self, name: str) -> str:
        return f"/pages/static/{name}?v={asset_version(name)}"

    def benchmark(self, benchmark_id: str, manifest_sha256: str = "") -> str:
        return f"/pages/benchmarks/{quote(benchmark_id, safe='')}"

    def leaderboard(self, benchmark_id: str) -> str:
        return f"{self.benchmark(benchmark_id)}/leaderboard"

    def entry(self, entry_id: str) -> str:
        return f"/pages/entries/{quote(entry_id, safe='')}"

    def history(self) -> str:
        return "/pages/history"

    def imports(self) -> str:
        return "/pages/imports"

    def import_page(self, import_id: str) -> str:
        return f"/pages/imports/{quote(import_id, safe='')}"

    def run(self, run_id: str) -> str:
        return f"/pages/runs/{quote(run_id, safe='')}"

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
        return f"/pages/compare?{urlencode({'baseline': baseline, 'run': run_id})}"

    def pair(self, baseline: str, run_id: str, episode: Mapping[str, Any]) -> str:
        chosen = {"baseline": baseline, "run": run_id}
        chosen["episode"] = episode["episode_id"]
        return f"/pages/compare/episode?{urlencode(chosen)}"


def safe_next(path: str) -> str:
    """The path of a browser after the sign-in: only a page of this server."""
    is_page = _NEXT.fullmatch(path) and not path.startswith("/pages/log")
    return path if is_page else "/pages"
