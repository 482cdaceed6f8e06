"""What the Python client sees: interop.py SCENARIO URL TOKEN prints one JSON line.

The scenarios are those of tools/interop.py, which judges; nothing is judged here.
"""

from __future__ import annotations

import base64
import json
import struct
import sys
import time
import uuid
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

sys.path[:0] = [str(Path(__file__).parents[1] / part) for part in (".", "example")]

import proctor_client as pc
from calibration import act
from worker import Refused, Server

VECTOR = [-0.0, 0.1, 5e-324, 1.7976931348623157e308, 9007199254740991.0, 1 / 3, -2.5e-8, 1e22]


def submit(server: Server, tasks: list[str], *, max_steps: int = 10, key: str | None = None,
           **members: Any) -> pc.Run:
    key = key or uuid.uuid4().hex
    options = pc.CalibrationOptions(tasks=tasks, max_steps=max_steps)
    body = pc.SubmitRun(benchmark_id="calibration", policy=pc.PolicyInfo(name="interop"),
                        options=options, **members)
    return server.ask(lambda: server.control.submit_run(body, idempotency_key=key))


def attach(server: Server, run: pc.Run, worker: str) -> pc.Turn:
    body = pc.AttachWorker(attach_key=uuid.uuid4().hex)
    return server.ask(lambda: server.data(run).attach_worker(run.run_id, worker, body))


def predict(server: Server, run: pc.Run, worker: str, turn: pc.Turn, actions: list[pc.Action],
            observe: str | None = None, seq: int | None = None) -> pc.Turn:
    body = pc.Predict(session_id=turn.session_id, seq=seq or turn.seq + 1, actions=actions,
                      observe=observe)
    return server.ask(lambda: server.data(run).predict(run.run_id, worker, body))


def play(server: Server, run: pc.Run, policy: Callable[[pc.Turn], list[pc.Action]],
         workers: int = 1) -> dict[str, list[pc.EpisodeResult]]:
    seen: dict[str, list[pc.EpisodeResult]] = {f"worker-{i}": [] for i in range(workers)}
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(lambda w: server.play(run.run_id, w, policy, seen[w].append), seen))
    return seen


def by_index(scores: list[float]) -> Callable[[pc.Turn], list[pc.Action]]:
    return lambda turn: [act(scores[turn.episode.index])] * 2


def the_score(server: Server, run: pc.Run) -> dict[str, Any]:
    score = server.ask(lambda: server.control.get_score(run.run_id))
    return {"run_id": run.run_id, "score": score.score, "complete": score.complete}


def problem_of(request: Callable[[], Any]) -> dict[str, Any]:
    try:
        request()
    except Refused as error:
        problem = error.problem
        return {
            "status": error.status, "code": problem.code, "retryable": problem.retryable,
            "side_effects": problem.side_effects.value, "retry_after_s": error.retry_after_s,
            "pointers": [item.pointer for item in problem.errors or []],
            "expected_seq": problem.expected_seq,
            "ended_by": problem.ended_by,
        }
    return {"code": "accepted"}


def scenario_submit(server: Server, url: str) -> dict[str, Any]:
    key = uuid.uuid4().hex
    runs = [submit(server, ["score"], key=key) for _ in range(2)]
    listed = server.ask(lambda: server.control.list_runs(limit=1000)).runs
    service = server.ask(server.control.describe_service)
    benchmark = server.ask(lambda: server.control.get_benchmark("calibration"))
    return {
        "run_ids": [run.run_id for run in runs],
        "listed": sum(run.run_id == runs[0].run_id for run in listed),
        "max_workers": service.limits.max_workers,
        "action_sizes": {name: space.size for name, space in benchmark.action_space.items()},
    }


def scenario_two_workers(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["delay"] * 8, max_steps=4)
    seen = play(server, run, lambda turn: [act(turn.episode.index % 2, delay_s=[0.05])] * 2, workers=2)
    return the_score(server, run) | {"played": {w: [r.index for r in rs] for w, rs in seen.items()}}


def scenario_chunks(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["count"])
    turn, turns = attach(server, run, "worker-0"), []
    for _ in range(3):
        turn = predict(server, run, "worker-0", turn, [act(0.0)] * 4, observe="all")
        turns.append(turn)
    return {
        "executed": [t.executed_steps for t in turns],
        "counts": [[o.state["count"][0] for o in t.observations] for t in turns],
        "rewards": [len(t.rewards) for t in turns],
        "stopped_early": [t.stopped_early for t in turns],
        "truncated": [t.truncated for t in turns],
        "done": turn.done,
        "steps": turn.episode_result.steps,
    }


def scenario_echo(server: Server, url: str) -> dict[str, Any]:
    images = pc.ImageChoice(codec="raw", width=64, height=48)
    run = submit(server, ["echo"], images=images)
    turn = attach(server, run, "worker-0")
    seen = predict(server, run, "worker-0", turn, [act(0.0, vector=VECTOR)]).observation
    image = seen.images["pattern"]
    return {
        "codec": image.codec, "size": [image.height, image.width, image.channels],
        "image": base64.b64decode(image.data).hex(),
        "vector": [struct.pack(">d", x).hex() for x in seen.state["vector"]],
        "tensors": {
            name: {"dtype": t.dtype, "shape": t.shape, "data": base64.b64decode(t.data).hex()}
            for name, t in seen.tensors.items()
        },
    }


def scenario_lost_answer(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["count"], max_steps=6)
    turn, counts = attach(server, run, "worker-0"), []
    for _ in range(2):
        turn = predict(server, run, "worker-0", turn, [act(0.0)] * 3, observe="all")
        counts += [o.state["count"][0] for o in turn.observations]
    return {"run_id": run.run_id, "counts": counts, "done": turn.done}


def scenario_lost_session(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["count"], idle_timeout_s=2)
    calls: list[str] = []

    def policy(turn: pc.Turn) -> list[pc.Action]:
        calls.append(turn.session_id)
        if len(calls) == 2:  # thinks for longer than the lease
            while server.ask(lambda: server.control.get_run(run.run_id)).live_workers:
                time.sleep(0.1)
        return [act(1.0)] * 2

    seen = play(server, run, policy)["worker-0"]
    return the_score(server, run) | {"sessions": len(set(calls)), "attempt": seen[-1].attempt}


def scenario_restart(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["score"] * 4, max_steps=6)
    seen = play(server, run, by_index([0.25, 0.5, 0.75, 1.0]))["worker-0"]
    return the_score(server, run) | {"attempts": [result.attempt for result in seen]}


def scenario_worker_limit(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["score"] * 3, max_workers=1, idle_timeout_s=5)
    first = attach(server, run, "worker-0")
    data, body = server.data(run), pc.AttachWorker(attach_key="k")
    problem = problem_of(lambda: server.once(lambda: data.attach_worker(run.run_id, "worker-1", body)))
    server.ask(lambda: data.detach_worker(run.run_id, "worker-0", first.session_id))
    play(server, run, by_index([1.0] * 3), workers=2)
    return the_score(server, run) | {"problem": problem}


def scenario_stop_resume(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["score"] * 3, max_steps=2)
    policy = by_index([0.5, 0.25, 1.0])
    turn = attach(server, run, "worker-0")
    turn = predict(server, run, "worker-0", turn, policy(turn))
    stopped = server.ask(lambda: server.control.stop_run(run.run_id, pc.StopRun(mode="abort")))
    problem = problem_of(lambda: predict(server, run, "worker-0", turn, policy(turn)))
    server.ask(lambda: server.control.resume_run(run.run_id))
    seen = play(server, run, policy)["worker-0"]
    return the_score(server, run) | {
        "problem": problem, "stopped": stopped.state.value, "after": [r.index for r in seen]}


def scenario_problems(server: Server, url: str) -> dict[str, Any]:
    unknown = pc.SubmitRun(benchmark_id="no_such", policy=pc.PolicyInfo(name="interop"))
    unauthenticated = Server(url, "not-a-token").control
    run = submit(server, ["count"])
    turn = attach(server, run, "worker-0")
    return {"problems": [
        problem_of(lambda: server.once(lambda: server.control.submit_run(unknown))),
        problem_of(lambda: server.once(lambda: server.control.get_run("no_such"))),
        problem_of(lambda: server.once(unauthenticated.list_runs)),
        problem_of(lambda: predict(server, run, "worker-0", turn, [act(0.0, vector=[1.0])])),
        problem_of(lambda: predict(server, run, "worker-0", turn, [act(0.0)], seq=7)),
    ]}


def scenario_score(server: Server, url: str) -> dict[str, Any]:
    run = submit(server, ["score"] * 5, max_steps=2)
    play(server, run, by_index([1.0, 0.5, 0.25, 0.0, 0.25]))
    score = server.ask(lambda: server.control.get_score(run.run_id))
    episodes, cursor, pages = [], None, 0
    while cursor or not pages:
        page = server.ask(lambda: server.control.list_episodes(run.run_id, cursor=cursor, limit=2))
        episodes, cursor, pages = episodes + page.episodes, page.next_cursor, pages + 1
    return {
        "run_id": run.run_id, "score": score.score, "success_rate": score.success_rate,
        "interval": [score.success_interval.low, score.success_interval.high],
        "success": score.counts.success,
        "splits": {name: group.mean for name, group in score.by_split.items()},
        "pages": pages, "episodes": [[e.index, e.result.score, e.result.seed] for e in episodes],
    }


def scenario_wrong_answers(server: Server, url: str) -> dict[str, Any]:
    """Every run that is listed is answered by what is no run."""
    errors = {}
    for run in server.ask(lambda: server.control.list_runs()).runs:
        try:
            server.control.get_run(run.run_id)
            errors[run.run_id] = "accepted"
        except pc.ApiException as error:
            errors[run.run_id] = "refused" if error.status else "bad_answer"
    return {"errors": errors}


def scenario_later_version(server: Server, url: str) -> dict[str, Any]:
    service = server.ask(server.control.describe_service)
    benchmark = server.ask(lambda: server.control.get_benchmark("calibration"))
    vector = benchmark.action_space["vector"]
    assert vector.parts is not None
    run = submit(server, ["echo"])
    seen = attach(server, run, "worker-0").observation
    return {
        "profiles": service.profiles, "image_codecs": service.image_codecs,
        "success_rule": benchmark.success_rule, "rotation": vector.parts["all"].rotation,
        "out_of_range": vector.out_of_range, "mode": run.mode, "policy": run.policy.name,
        "codec": seen.images["pattern"].codec, "dtype": seen.tensors["float64"].dtype,
        "problem": problem_of(lambda: server.once(lambda: server.control.get_run("no_such"))),
    }


def vectors(directory: str) -> dict[str, Any]:
    """Each golden vector decoded by the client's models and encoded again."""
    seen: dict[str, Any] = {}
    for file in sorted(Path(directory).glob("*.json")):
        for vector in json.loads(file.read_text())["vectors"]:
            if vector.get("refused"):  # for servers
                continue
            try:
                model = getattr(pc, vector["schema"]).from_json(vector["json"])
                seen[vector["id"]] = model.to_json()
            except ValueError:
                seen[vector["id"]] = "refused"
    return seen


def main(scenario: str, url: str, token: str) -> None:
    if scenario == "vectors":
        print(json.dumps(vectors(url)))
        return
    server = Server(url, token)
    print(json.dumps(globals()[f"scenario_{scenario}"](server, url)))


if __name__ == "__main__":
    main(*sys.argv[1:])
