"""Submissions under test: the raw response, and a clean-up of the run."""

import uuid
from functools import partial
from itertools import islice
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.exchanges.pages import read_pages
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

_PAGES_MAX = 10
_PAGE_LIMIT = 100
_NEWEST_PAGES = 3
# Members that objects and maps have in some languages; as ids and keys they are
# ordinary names.
NAMES_OF_LANGUAGES = ("constructor", "toString", "__proto__", "hasOwnProperty", "null")


def submit(context: CheckContext, body: dict[str, Any], **how: Any) -> Answer:
    """Send a body of submit_run unchanged; the run is stopped after the check."""
    return adopt_answer(context, context.call("submit_run", json=body, **how), **how)


def adopt_answer(context: CheckContext, answer: Answer, **how: Any) -> Answer:
    """Stop the run that an answer shows, if it shows one, after the check."""
    if answer.status == 201 and isinstance(answer.json, dict):
        context.adopt(answer.json, how.get("http_client"))
    return answer


def expect_accepted(context: CheckContext, answer: Answer) -> Any:
    """Give the run of a valid body, if the account may make it."""
    return expect.ok(context.require_admitted(answer), 201)


def uniquely_named_body(context: CheckContext) -> dict[str, Any]:
    """Give a body whose policy has a name that no other run has."""
    return context.submit_body(policy={"name": f"conformance kit {uuid.uuid4()}"})


def runs_of(context: CheckContext, body: dict[str, Any]) -> list[str]:
    """Find the runs of a body, by the name of its policy, among the newest.

    Other checks submit runs meanwhile, which may fill a page.
    """
    name = body["policy"]["name"]

    def read(params: dict[str, Any]) -> Any:
        call = partial(context.call, "list_runs", params=params)
        return context.require(call, 200, "list_runs")

    for page in islice(read_pages(read, limit=_PAGE_LIMIT), _NEWEST_PAGES):
        ids = [r["run_id"] for r in page["runs"] if r["policy"]["name"] == name]
        if ids:
            return ids
    return []


def whole_submission(context: CheckContext) -> dict[str, Any]:
    """Give a body of submit_run with every member that a pull run may have."""
    benchmark = context.benchmark
    policy = {"name": f"conformance kit {uuid.uuid4()}", "version": "1"}
    policy |= {"submitter": "kit", "homepage": "https://a.example"}
    options: dict[str, Any] = {"tasks": ["score", "count"], "max_steps": 5}
    options["success_rule"] = "last_step"
    members: dict[str, Any] = {}
    if context.offers("sessions"):
        options["max_attempts"] = 2
        members["idle_timeout_s"] = context.limits["idle_timeout_s_max"]
    if context.offers("faults"):
        options["max_faults"] = 2
    if context.offers("control"):
        options["queue_s"] = 1
    if context.offers("observations"):
        codec = benchmark["image_codecs"][0]
        members["images"] = {"codec": codec, **benchmark["image_sizes"][0]}
    return context.submit_body(
        **members,
        policy=policy,
        max_workers=1,
        options=options,
        mode="pull" if context.offers("push") else None,
    )


def find_listed(context: CheckContext, ids: set[str]) -> dict[str, dict[str, Any]]:
    """Find runs in the pages of `list_runs`, newest first."""
    listed: dict[str, dict[str, Any]] = {}

    def read(params: dict[str, Any]) -> Any:
        return expect.ok(context.call("list_runs", params=params))

    for page in islice(read_pages(read, limit=_PAGE_LIMIT), _PAGES_MAX):
        listed |= {r["run_id"]: r for r in page["runs"] if r["run_id"] in ids}
        if ids <= set(listed):
            break
    missing = ids - set(listed)
    if missing:
        raise SetUpFailed(f"`list_runs` does not show {missing}", breaks="RUN-009")
    return listed


def submit_and_show(
    context: CheckContext, **members: Any
) -> tuple[RunClient, dict[str, dict[str, Any]]]:
    """Submit a run with members; give it as each operation shows it, by operation."""
    answer = context.call("submit_run", json=context.submit_body(**members))
    submitted = expect_accepted(context, answer)
    run = context.adopt(submitted)
    return run, {
        "submit_run": submitted,
        "get_run": expect.ok(run.call("get_run")),
        "list_runs": find_listed(context, {run.id})[run.id],
        "stop_run": expect.ok(run.call("stop_run", json={})),
        "resume_run": expect.ok(run.call("resume_run")),
    }
