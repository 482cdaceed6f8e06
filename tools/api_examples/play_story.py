"""Plays the story of the examples of openapi.yaml and policy.yaml, and writes them.

One account submits a run of the benchmark `calibration`, plays it, stops it, resumes it
and publishes it; beside it the server plays the same episodes by calling a policy. All
of it happens: the server is the reference server, the policy server that of `proctor`.
Nothing is written where only ids, times and digests are new. Which operation shows
which example is written by hand in the documents; tests hold every example to its
schema, and all of them to what the server says now.
"""

import json
import tempfile
from pathlib import Path
from typing import Any

from reference_client.api.observation import Observation
from reference_client.policies.policy_http_app import PolicyApp
from tests.support.client.policy_apps import run_app
from tests.support.servers import ReferenceServer
from tests.support.sim.calibration_action import calibration_action
from tools.api_examples.example_text import outdated, write_examples
from tools.api_examples.recorded_story import RecordedApp, Story
from tools.traceability import ROOT

TOKEN = "example-token"  # noqa: S105 - of a server that lives for some seconds
HOST = "https://eval.example.org"
POLICY_HOST = "https://policy.example.org"
SETTINGS = {
    "PROCTOR_TOKENS": f"example-lab:read+run+host:{TOKEN}",
    "PROCTOR_PUBLIC_URL": HOST,
    "PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.0/8",
    "PROCTOR_RECORD_IMPORTS": "on",
    "PROCTOR_PUBLIC_BOARD": "on",
    "PROCTOR_MAX_EVENT_STREAMS": "1",
    "PROCTOR_MAX_SIMULATORS": "1",
}
ASSUMED = {"state": {"count": {"size": 1, "unit": "1", "relative_to": "none"}}}
SUBMISSION = {
    "benchmark_id": "calibration",
    "policy": {"name": "example-policy", "version": "1.2"},
    "max_workers": 2,
    "idle_timeout_s": 60,
    "images": {"codec": "png", "width": 16, "height": 12},
    "options": {"tasks": ["score", "echo"]},
}
ENTRY = {
    "model_name": "Example policy",
    "is_public": True,
    "model_type": "VLA",
    "organisation": "Example Lab",
    "code_url": "https://example.org/code",
}
FLAG = {"flagged": True, "reason": "The code at code_url is of another policy."}

Json = dict[str, Any]


def action(score: float, **values: float) -> Json:
    return {"values": calibration_action(score=score, **values)}


class ExamplePolicy:
    """Ends each episode with its second action, without success; knows no third."""

    def reset(self, instruction: str) -> None:
        """It remembers nothing."""

    def act(self, observation: Observation) -> list[dict[str, Any]]:
        if observation.state["count"][0] > 1:
            raise RuntimeError("The policy has no action for this step.")
        return [calibration_action(score=0.5), calibration_action(score=0.5, end=1)]


def play(story: Story, policy_url: str) -> None:
    look_around(story)
    shown = {
        "submit_run_request": "Two episodes of calibration",
        "submit_run": "Ready for workers",
    }
    key = {"Idempotency-Key": "example-1"}
    submitted = story.call("POST", "/v1/runs", SUBMISSION, shown, headers=key)
    other = SUBMISSION | {"max_workers": 1}
    story.refused("idempotency_conflict", "POST", "/v1/runs", json=other, headers=key)
    run = f"/v1/runs/{submitted['run_id']}"
    session = attach(story, run)
    play_first_episode(story, run, session)
    stop(story, run, session)
    finish(story, run)
    baseline = play_pushed(story, policy_url)
    query = f"baseline={baseline}&runs={submitted['run_id']}"
    shown = {"compare_runs": "A run beside a baseline"}
    story.call("GET", f"/v1/comparisons?{query}", shown=shown)
    shown = {"list_runs": "One run, and the next cursor"}
    story.call("GET", "/v1/runs?limit=1", shown=shown)
    with story.client.stream("GET", f"{run}/events") as events:
        first, _, _ = "".join(events.iter_text()).partition("event: run")
    first = first[: first.index("\n\n", first.index("data:"))]
    story.keep("stream_events", "The beginning of a stream", first)
    hand_in(story, run)
    publish(story, run, submitted["manifest_sha256"])


def look_around(story: Story) -> None:
    for name, summary, path in (
        ("describe_service", "A server and its profiles", "/v1"),
        ("list_benchmarks", "Two benchmarks", "/v1/benchmarks"),
        (
            "get_benchmark",
            "calibration, two tensors of it",
            "/v1/benchmarks/calibration",
        ),
        ("list_keys", "The key in use", "/v1/keys"),
    ):
        story.call("GET", path, shown={name: summary})
    wrong = {"Authorization": "Bearer wrong"}
    story.refused("unauthenticated", "GET", "/v1/runs", headers=wrong)
    story.refused("not_found", "GET", "/v1/runs/run_unknown")
    story.refused("invalid_request", "GET", "/v1/runs?limit=0")


def attach(story: Story, run: str) -> str:
    """Attach a worker; the id of its session."""
    worker = f"{run}/workers/w0"
    body = {"attach_key": "Jq3kR8mZ", "assumes": ASSUMED}
    wrong = body | {"assumes": {"state": {"count": {"unit": "rad"}}}}
    story.refused("convention_mismatch", "PUT", worker, json=wrong)
    shown = {
        "attach_worker_request": "A worker and what it assumes",
        "attach_worker": "Turn 0, the first observation",
    }
    session_id: str = story.call("PUT", worker, body, shown)["session_id"]
    another = {"attach_key": "another"}
    story.refused("worker_busy", "PUT", worker, json=another)
    story.refused("no_capacity", "PUT", f"{run}/workers/w1", json=another)
    return session_id


def play_first_episode(story: Story, run: str, session_id: str) -> None:
    predict = f"{run}/workers/w0/predict"
    session = {"session_id": session_id}
    body = session | {"seq": 1, "actions": [action(0.25), action(0.5)]}
    shown = {
        "predict_request": "A chunk of two actions",
        "predict": "The next observation",
    }
    story.call("POST", predict, body, shown)
    story.refused("seq_out_of_order", "POST", predict, json=body | {"seq": 3})
    changed = body | {"actions": [action(1)]}
    story.refused("seq_conflict", "POST", predict, json=changed)
    shown = {"heartbeat_request": "The session", "heartbeat": "When the lease ends"}
    story.call("POST", f"{run}/workers/w0/heartbeat", session, shown)
    end = session | {"seq": 2, "actions": [action(1, success=1, end=1)]}
    shown = {
        "predict_end_request": "An action that ends the episode",
        "predict_end": "A result, and the next episode",
    }
    story.call("POST", predict, end, shown)
    story.call("GET", run, shown={"get_run": "A run in play"})
    with story.client.stream("GET", f"{run}/events"):
        story.refused("unavailable", "GET", f"{run}/events")


def stop(story: Story, run: str, session_id: str) -> None:
    shown = {"get_score_bounds": "Bounds, with an episode missing"}
    story.call("GET", f"{run}/score", shown=shown)
    reason = "The policy raised ValueError: no joint 7 (my_policy.py:31)"
    left = {"session_id": session_id, "reason": reason}
    shown = {"heartbeat_reason_request": "Why the worker leaves the episode"}
    story.call("POST", f"{run}/workers/w0/heartbeat", left, shown)
    shown = {"stop_run_request": "Stop now", "stop_run": "The stopped run"}
    story.call("POST", f"{run}/stop", {"mode": "abort"}, shown)
    late = {"session_id": session_id, "seq": 3, "actions": [action(1)]}
    story.refused("session_ended", "POST", f"{run}/workers/w0/predict", json=late)
    shown = {"list_episodes": "A scored and a pending one"}
    story.call("GET", f"{run}/episodes", shown=shown)


def finish(story: Story, run: str) -> None:
    shown = {"resume_run": "Ready for workers again"}
    story.call("POST", f"{run}/resume", shown=shown)
    worker = f"{run}/workers/w0"
    session_id = story.call("PUT", worker, {"attach_key": "next"})["session_id"]
    last = {"session_id": session_id, "seq": 1}
    last |= {"actions": [action(1, success=1, end=1)]}
    shown = {"predict_done": "The last turn: no episode is left"}
    story.call("POST", f"{worker}/predict", last, shown)
    story.refused("no_episode", "POST", f"{worker}/predict", json=last | {"seq": 2})
    story.call("DELETE", f"{worker}?session_id={session_id}")
    shown = {"get_score": "The score of a completed run"}
    story.call("GET", f"{run}/score", shown=shown)
    story.refused("illegal_transition", "POST", f"{run}/resume")


def play_pushed(story: Story, policy_url: str) -> str:
    """Let the server call a policy; the id of the run."""
    shown = {
        "submit_push_run_request": "The server calls the policy",
        "submit_push_run": "A run that calls a policy server",
    }
    server = {"url": policy_url, "protocol": "proctor", "api_key": "example-key"}
    pushed = {"mode": "push", "policy_server": server}
    body = SUBMISSION | {"policy": {"name": "baseline"}} | pushed
    run_id: str = story.call("POST", "/v1/runs", body, shown)["run_id"]
    story.wait(f"/v1/runs/{run_id}", "completed")
    return run_id


def hand_in(story: Story, run: str) -> None:
    """Import the record of the run itself."""
    record = story.client.get(f"{run}/record").content
    sent: Json = {"headers": {"Content-Type": "application/zip"}}
    broken = record.replace(b'"success"', b'"failure"', 1)
    story.refused("record_broken", "POST", "/v1/records", content=broken, **sent)
    shown = {"import_record": "A record that waits for its replay"}
    made = story.call("POST", "/v1/records", shown=shown, content=record, **sent)
    path = f"/v1/records/{made['import_id']}"
    story.wait(path, "finished")
    story.call("GET", path, shown={"get_import": "The record, replayed here"})
    story.call("GET", "/v1/records", shown={"list_imports": "One import"})


def publish(story: Story, run: str, manifest_sha256: str) -> None:
    shown = {"publish_entry_request": "A public entry", "publish_entry": "The entry"}
    entry_id = story.call("PUT", f"{run}/entry", ENTRY, shown)["entry_id"]
    story.refused("not_deletable", "DELETE", run)
    flag = f"/v1/entries/{entry_id}/flag"
    shown = {"flag_entry_request": "A reason", "flag_entry": "The flagged entry"}
    story.call("PUT", flag, FLAG, shown)
    story.call("PUT", flag, {"flagged": False, "reason": "The URL was corrected."})
    ranking = f"/v1/benchmarks/calibration/ranking?manifest_sha256={manifest_sha256}"
    cursor = story.call("GET", "/v1/history?limit=1")["next_cursor"]
    second = f"/v1/history?limit=1&cursor={cursor}"
    inclusion = "/v1/history/inclusion?leaf_index=1&tree_size=3"
    consistency = "/v1/history/consistency?old_size=1&new_size=3"
    for name, summary, path in (
        ("list_entries", "One entry", "/v1/entries"),
        ("get_ranking", "One entry with its rank", ranking),
        ("list_history", "One leaf, and the next cursor", second),
        ("get_checkpoint", "Three leaves, signed", "/v1/history/checkpoint"),
        ("prove_inclusion", "The second of three leaves", inclusion),
        ("prove_consistency", "From one leaf to three", consistency),
    ):
        story.call("GET", path, shown={name: summary})
    shown = {"withdraw_entry": "The withdrawn entry"}
    story.call("DELETE", f"{run}/entry", shown=shown)
    story.refused("entry_withdrawn", "PUT", f"{run}/entry", json=ENTRY)


def examples_of_policy(policy: RecordedApp, policy_url: str) -> dict[str, Json]:
    """The first call of each operation of policy.yaml, and three that are refused."""
    _, described = policy.bodies["/v1/policy"]
    asked, ready = policy.bodies["/v1/policy/reset"]
    turn, actions = policy.bodies["/v1/policy/predict"]
    story = Story(policy_url, "example-key")
    for name, summary, value in (
        ("describe_policy", "A policy and what it assumes", described),
        ("reset_request", "An episode of calibration", asked),
        ("reset", "The policy is ready", ready),
        ("predict_request", "Turn 0, the first observation", turn),
        ("predict", "A chunk of two actions", actions),
    ):
        story.keep(name, summary, value)
    unknown = turn | {"session_id": "unknown"}
    story.refused("session_ended", "POST", "/v1/policy/predict", json=unknown)
    wrong = {"Authorization": "Bearer wrong"}
    story.refused("unauthenticated", "GET", "/v1/policy", headers=wrong)
    late = turn["observation"]["state"] | {"count": [2.0]}
    body = turn | {"observation": turn["observation"] | {"state": late}}
    story.refused("policy_failed", "POST", "/v1/policy/predict", json=body)
    return story.examples


def played_examples() -> dict[str, dict[str, Json]]:
    """The examples of each document, from a story that is played now."""
    policy = RecordedApp(
        PolicyApp(
            ExamplePolicy, "example-policy", key="example-key", assumes=ASSUMED
        ).app
    )
    with (
        tempfile.TemporaryDirectory() as directory,
        run_app(policy) as policy_url,
        ReferenceServer(Path(directory), **SETTINGS) as server,
    ):
        story = Story(server.url, TOKEN)
        play(story, policy_url)
        examples = {
            "openapi.yaml": story.examples,
            "policy.yaml": examples_of_policy(policy, policy_url),
        }
    text = json.dumps(examples).replace(policy_url, POLICY_HOST)
    written: dict[str, dict[str, Json]] = json.loads(text)
    return written


def main() -> int:
    """Write the examples, if one says something else than before."""
    examples = played_examples()
    files = {ROOT / "spec" / name: shown for name, shown in examples.items()}
    changed = [name for file, shown in files.items() for name in outdated(file, shown)]
    for file, shown in files.items() if changed else ():
        write_examples(file, shown)
    print(f"examples: {', '.join(changed) or 'up to date'}")
    return 0
