"""Runs of a manifest of their own, completed and published; withdrawn after the check.

A board of a check has no entry of another check: `max_steps`, `max_faults` and
`max_attempts` of its runs are drawn anew each time, and entries do not stay.
"""

import uuid
from collections.abc import Sequence
from functools import partial
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.exchanges.pages import read_pages
from conformance.oracle.expected_ranking import RankedRun, expected_ranking
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

BENCHMARK = "calibration"


class Board:
    """The entries of one manifest, as a check makes them."""

    def __init__(self, context: CheckContext) -> None:
        self.context = context
        drawn = uuid.uuid4().int
        self._options: dict[str, Any] = {
            "max_steps": 2 + drawn % 9000,
            "max_faults": 1 + drawn // 9000 % 10,
            "max_attempts": 1 + drawn // 90_000 % 10,
        }
        self.published: list[RankedRun] = []
        self.manifest_sha256 = ""

    def play(
        self,
        successes: str,
        scores: Sequence[float] | None = None,
        http_client: HttpClient | None = None,
        episodes: int | None = None,
        policy: str | None = None,
    ) -> RunClient:
        """Play a run: `1` is a success with score 1, unless scores are given.

        episodes: how many are played, all by default. policy: its name, one of its own
        by default: an account has one entry of one result of a policy (BRD-022).
        """
        tasks = ["score"] * len(successes)
        run = self.context.submit(
            *tasks,
            http_client=http_client,
            policy={"name": policy or f"conformance kit {uuid.uuid4()}"},
            **self._options,
        )
        self.manifest_sha256 = run.body["manifest_sha256"]
        worker = run.worker()
        worker.attach()
        played = list(zip(successes, scores or map(int, successes), strict=True))
        for success, score in played[:episodes]:
            worker.play(score=score, success=int(success))
        if episodes is None:
            run.until("completed")
        return run

    def add(
        self,
        successes: str,
        scores: Sequence[float] | None = None,
        http_client: HttpClient | None = None,
        **description: Any,
    ) -> dict[str, Any]:
        """Play a run and publish it; gives its entry."""
        run = self.play(successes, scores, http_client)
        entry = require_entry(run, **description)
        if entry["is_public"]:
            mean = sum(scores or map(int, successes)) / len(successes)
            self.note(entry["entry_id"], mean, successes)
        return entry

    def note(self, entry_id: str, score: float, successes: str) -> None:
        """Note an entry that was published, for the expected ranking."""
        self.published.append(RankedRun(entry_id, score, successes))

    def ranking(self) -> dict[str, Any]:
        """Read the ranking, with the rows of all its pages, which may be short."""
        endless = SetUpFailed("`get_ranking` does not end", breaks="BRD-008")
        pages = [*read_pages(lambda params: self.ranking_page(**params), endless)]
        return pages[0] | {"rows": [row for page in pages for row in page["rows"]]}

    def ranking_page(self, **params: Any) -> Any:
        """Read a page of the ranking, whose members are what is under test."""
        answer = self.context.call(
            "get_ranking",
            benchmark_id=BENCHMARK,
            params={"manifest_sha256": self.manifest_sha256} | params,
        )
        return expect.ok(answer)

    def ranked_ids(self) -> list[str]:
        """Read the ids of the entries in the ranking, in their order."""
        return [row["entry"]["entry_id"] for row in self.ranking()["rows"]]

    def expected(self) -> dict[str, Any]:
        """Compute the ranking of what was published."""
        episodes = [len(entry.successes or "") for entry in self.published[:1]]
        return expected_ranking(self.published, sum(episodes))


def description_of(**members: Any) -> dict[str, Any]:
    """Give a body of publish_entry, public unless it is said."""
    return {"model_name": "conformance kit", "is_public": True} | members


def try_publish(run: RunClient, **members: Any) -> Answer:
    """Send `publish_entry`; an entry that it makes is withdrawn after the check."""
    return run.call("publish_entry", json=description_of(**members))


def require_entry(run: RunClient, **members: Any) -> dict[str, Any]:
    """Publish a run as a set-up step; gives its entry."""
    entry: dict[str, Any] = run.context.require(
        lambda: try_publish(run, **members), 201, "publish_entry"
    )
    return entry


def change_entry(run: RunClient, **members: Any) -> None:
    """Change the description of an entry, or repeat it, as a set-up step."""
    step = partial(try_publish, run, **members)
    run.context.require(step, 200, "publish_entry")


def flag_entry(context: CheckContext, entry_id: str, *, flagged: bool) -> None:
    """Flag an entry, or take its flag back, as a set-up step of the second account."""
    body = {"flagged": flagged, "reason": "A check of the conformance kit."}
    answer = context.call(
        "flag_entry",
        entry_id=entry_id,
        json=body,
        http_client=context.second_account,
    )
    if answer.status == 403:
        text = "the token of the second account (PROCTOR_TOKEN_2) lacks the scope host"
        raise SetUpFailed(text, allowed=True)
    expect.require(answer, 200, "`flag_entry`")


def listed_entries(
    context: CheckContext,
    wanted: set[str],
    http_client: HttpClient | None = None,
    **params: Any,
) -> list[str]:
    """Read pages of `list_entries` until all that are wanted were there, or the end.

    Gives the wanted ids as often and in the order that they came; entries of other
    checks come and go meanwhile.
    """

    def read(params: dict[str, Any]) -> Any:
        answer = context.call("list_entries", params=params, http_client=http_client)
        return expect.ok(answer)

    listed: list[str] = []
    endless = SetUpFailed("`list_entries` does not end", breaks="BRD-007")
    for page in read_pages(read, endless, **params):
        listed += [
            entry["entry_id"]
            for entry in page["entries"]
            if entry["entry_id"] in wanted
        ]
        if wanted <= set(listed):
            break
    return listed


def read_leaves(context: CheckContext, limit: int = 1000) -> list[bytes]:
    """Read all leaves, page by page."""
    leaves: list[bytes] = []

    def read(params: dict[str, Any]) -> Any:
        return expect.ok(context.call("list_history", params=params))

    endless = SetUpFailed("`list_history` does not end", breaks="BRD-013")
    for page in read_pages(read, endless, limit=limit):
        for leaf in page["leaves"]:
            expect.equal(leaf["index"], len(leaves), "index of a leaf")
            leaves.append(leaf["leaf"].encode())
    return leaves
