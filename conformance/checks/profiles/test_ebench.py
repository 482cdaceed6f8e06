"""The API of EBench: the profile `ebench` (EBE), on runs of calibration."""

import time
from functools import partial
from urllib.parse import urlsplit

from conformance.checks.support.given_states import require_queued
from conformance.client.check_context import CheckContext
from conformance.profiles import pickles
from conformance.profiles.ebench import (
    action,
    begin_ebench_run,
    call_control_plane,
    count,
    create_task,
    expect_attempts,
    expect_count,
    expect_counts,
    expect_plain_pickle,
    expect_refusal,
    expect_success,
    expect_workers,
    name_run,
    numbers,
    open_endpoint,
    require_header_passed_on,
    submit_ebench_run,
)
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable

_QUEUE_S = 1.0


@requirement("EBE-001")
def test_ebe_001_a_task_is_a_run(context: CheckContext) -> None:
    """A task is created on calibration. Expect a run of it under the same id."""
    asked = {"benchmark_set": "calibration", "model_name": "kit", "is_public": 0}
    ids = [create_task(context, **asked)["task_id"] for _ in range(2)]
    for task_id in ids:
        run = context.adopt(expect.ok(context.call("get_run", run_id=task_id)))
        expect.equal(run.body["benchmark_id"], "calibration", "the run's benchmark_id")
    expect.true(ids[0] != ids[1], "another task_id for another task", ids)


@requirement("EBE-002")
def test_ebe_002_control_plane_refuses_in_an_envelope(context: CheckContext) -> None:
    """Unknown tasks and benchmarks, a late stop. Expect envelopes with an error."""
    unknown = {"task_id": "no-such-task"}
    expect_refusal(call_control_plane(context, "createTask", {"benchmark_set": "none"}))
    expect_refusal(call_control_plane(context, "createTask", unknown))
    expect_refusal(call_control_plane(context, "ready", unknown))
    ebench = begin_ebench_run(context, "score")
    ebench.step({"0": action(score=1, end=1)})
    ebench.run.until("completed")
    expect_refusal(ebench.try_stop())


@requirement("EBE-003")
def test_ebe_003_ready_waits_for_the_queue(context: CheckContext) -> None:
    """A run waits in the queue for a while. Expect false, then an endpoint."""
    began_at = time.monotonic()
    queue_s = context.choose_queue_s(_QUEUE_S)
    run = context.submit("score", queue_s=queue_s, wait_ready=False)
    answer = call_control_plane(context, "ready", {"task_id": run.id})
    require_queued(run.get()["state"], began_at, queue_s)
    data = expect_success(answer)
    expect.equal(data["ready"], False, "`ready` of a queued run")
    run.until("ready")
    data = expect_success(call_control_plane(context, "ready", {"task_id": run.id}))
    expect.equal(data["ready"], True, "`ready` of a run that is ready")
    path = urlsplit(str(data["endpoint"])).path
    before, middle, name = path.rpartition("/api/predict/")
    expect.true(
        middle and before and name and "/" not in name.rstrip("/"),
        "an endpoint whose path has /api/predict/ before its last part",
        data["endpoint"],
    )


@requirement("EBE-004")
def test_ebe_004_an_old_task_id_resumes(context: CheckContext) -> None:
    """A run is stopped after its first episode. Expect its task_id to resume it."""
    ebench = begin_ebench_run(context, "score", "score")
    ebench.step({"0": action(score=0.5, end=1)})
    ebench.run.stop()
    data = create_task(context, task_id=ebench.run.id)
    expect.equal(data["task_id"], ebench.run.id, "the task_id")
    expect.true(
        ebench.run.get()["state"] in ("queued", "ready"),
        "a run that is queued or ready",
        ebench.run.body["state"],
    )
    scored = [e.get("result", {}).get("score") for e in ebench.run.episodes()]
    expect.equal(scored, [0.5, None], "the scores of its episodes")


@requirement("EBE-005")
def test_ebe_005_the_endpoint_serves_docs(context: CheckContext) -> None:
    """The client reads `docs` first. Expect 200."""
    expect.equal(
        submit_ebench_run(context, "score").try_get("docs").status, 200, "status"
    )


@requirement("EBE-006")
def test_ebe_006_reset_begins_an_episode_for_each_worker(context: CheckContext) -> None:
    """Two workers without an episode. Expect a first observation for each."""
    ebench = submit_ebench_run(context, "count", "count")
    shown = expect_workers(ebench.try_reset("0", "1"))
    expect.equal(sorted(shown), ["0", "1"], "the workers that are shown")
    for worker in shown.values():
        first = [worker["obs"][name] for name in ("reset", "timestep", "state.count")]
        expect.equal(first, [True, 0, [0.0]], "reset, timestep and state.count")
        expect.equal(worker["metric"], None, "metric")
    ids = {worker["obs"]["episode_id"] for worker in shown.values()}
    expect.equal(len(ids), 2, "the number of different episode ids")


@requirement("EBE-007")
def test_ebe_007_reset_does_not_restart_an_episode(context: CheckContext) -> None:
    """A worker is reset after two steps. Expect its episode unchanged."""
    ebench = begin_ebench_run(context, "count")
    ebench.step([{"0": action()}] * 2)
    expect.equal(expect_count(ebench.try_reset("0"), 2)["obs"]["reset"], False, "reset")
    expect_attempts(ebench, 1)


@requirement("EBE-008")
def test_ebe_008_step_executes_in_order(context: CheckContext) -> None:
    """One step of two workers, then a list of three. Expect each executed, in order."""
    ebench = begin_ebench_run(context, "count", "count", workers=2)
    shown = expect_counts(
        ebench.try_step({"0": action(), "1": action(vector=[7.0] * 8)}), 1, 1
    )
    expect.equal(shown["1"]["obs"]["state.vector"], [7.0] * 8, "state.vector of one")
    chunk = [{"0": action(vector=[float(n)] * 8), "1": action()} for n in range(3)]
    shown = expect_counts(ebench.try_step(chunk), 4, 4)
    expect.members(shown["0"]["obs"], {"state.vector": [2.0] * 8, "timestep": 4})


@requirement("EBE-009")
def test_ebe_009_the_end_of_an_episode_begins_the_next(context: CheckContext) -> None:
    """The first of two episodes ends. Expect its result and the next observation."""
    ebench = submit_ebench_run(context, "score", "count")
    first = ebench.reset("0")["0"]["obs"]
    shown = expect_workers(ebench.try_step({"0": action(score=0.25, end=1)}))["0"]
    expect.equal(shown["obs"]["reset"], True, "reset")
    expect.equal(count(shown), 0, "state.count")
    expect.true(shown["obs"]["episode_id"] != first["episode_id"], "another episode_id")
    expect.equal(shown["metric"], {"score": 0.25}, "metric")
    result = shown["episode_result"] or {}
    reported = [result.get(name) for name in ("episode_id", "task_name", "sr")]
    expect.equal(reported, [first["episode_id"], "score", 0.25], "the episode_result")
    stored = ebench.run.episodes()[0]["result"]
    expect.equal(result.get("seed"), stored["seed"], "the seed in the episode_result")


@requirement("EBE-010")
def test_ebe_010_end_of_run_is_repeated(context: CheckContext) -> None:
    """Both episodes end; then the worker steps and is reset. Expect metrics without an
    observation each time."""
    ebench = begin_ebench_run(context, "score", "score")
    ebench.step({"0": action(score=1, end=1)})
    end = {"0": action(score=0.5, end=1)}
    requests = (
        partial(ebench.try_step, end),
        partial(ebench.try_step, {"0": action()}),
        partial(ebench.try_reset, "0"),
    )
    for answer in (send() for send in requests):
        shown = expect_workers(answer)["0"]
        expect.members(shown, {"obs": None, "metric": {"score": 0.75}})


@requirement("EBE-011")
def test_ebe_011_numbers_survive_bit_for_bit(context: CheckContext) -> None:
    """Numbers that lose bits easily, in lists and arrays. Expect the same bits."""
    ebench = begin_ebench_run(context, "echo")
    hard = [0.1, -0.0, 1e300, 5e-324, 1 / 3, -2.5, 2.0**53, 7.0]
    sent = numbers(vector=hard)
    for form in (sent, pickles.PickledArray(sent), pickles.PickledArray(sent, "core")):
        shown = expect_workers(ebench.try_step({"0": {"action": form}}))["0"]
        back = [number.hex() for number in shown["obs"]["state.vector"]]
        expect.equal(back, [number.hex() for number in hard], "state.vector, in hex")


@requirement("EBE-012")
def test_ebe_012_one_bad_action_refuses_the_step(context: CheckContext) -> None:
    """One of two workers has an invalid action. Expect no action executed."""
    ebench = begin_ebench_run(context, "count", "count", workers=2)
    bad = ([0.0] * 3, [float("nan")] * 15, numbers(success=7))
    for number, wrong in enumerate(bad):
        good = action(vector=[float(number)] * 8)  # each time a step of its own
        answer = ebench.try_step({"0": good, "1": {"action": wrong}})
        expect.refused(answer, "invalid_request")
    expect_counts(ebench.try_step({"0": action(), "1": action()}), 1, 1)


@requirement("EBE-013")
def test_ebe_013_a_repeated_step_is_not_executed_twice(context: CheckContext) -> None:
    """The client disconnects while a step is executed, and repeats it. Expect the
    response to the first."""
    ebench = begin_ebench_run(context, "delay")
    slow = {"0": action(delay_s=1)}
    for _ in range(2):
        ebench.disconnect_during_step(slow)
    expect_count(ebench.try_step(slow), 1)


@requirement("EBE-014")
def test_ebe_014_the_same_action_again_is_a_step(context: CheckContext) -> None:
    """A policy sends the same action three times. Expect three steps."""
    ebench = submit_ebench_run(context, "count")
    if ebench.status().get("equal_steps", "execute") != "execute":
        raise NotApplicable("the operator has chosen to answer equal steps")
    ebench.reset("0")
    same = {"0": action(vector=[1.0] * 8)}
    for expected in (1, 2, 3):
        expect_count(ebench.try_step(same), expected)


@requirement("EBE-015")
def test_ebe_015_a_pickle_that_calls_is_refused(context: CheckContext) -> None:
    """Pickles with a call of a harmless function. Expect refusals, and no call."""
    ebench = begin_ebench_run(context, "count")
    wait_s = 2.0
    calls = [
        pickles.PickledCall("time", "sleep", [wait_s]),
        pickles.PickledCall("builtins", "eval", ["[0.0] * 15"]),
        pickles.PickledCall("builtins", "list", [[0.0] * 15]),
        pickles.PickledCall("numpy", "zeros", [15]),
    ]
    for call in calls:
        answer = ebench.try_step({"0": {"action": call}})
        expect.refused(answer, "malformed_body")
        what = "an answer at once"
        expect.in_time(answer.elapsed_s, 0.9 * wait_s, what, may_be_noise=False)
    expect.refused(ebench.try_send("step", b"\x80\x03]"), "malformed_body")
    expect_count(ebench.try_step({"0": action()}), 1)


@requirement("EBE-016")
def test_ebe_016_kill_ends_a_worker(context: CheckContext) -> None:
    """One of two workers is killed, with one that has no session, and again alone.
    Expect its session ended, and the other worker unaffected."""
    ebench = begin_ebench_run(context, "count", "count", workers=2)
    ebench.step({"0": action(), "1": action()})
    for named in (("no-session", "0"), ("0",)):
        answer = expect.ok(ebench.try_workers("kill", *named))
        expect.equal(answer["data"]["success"], True, "data.success")
        expect.equal(ebench.run.get()["live_workers"], 1, "live_workers of the run")
    shown = expect_workers(ebench.try_step({"1": action(vector=[1.0] * 8)}))
    expect.equal(count(shown["1"]), 2, "state.count of the other worker")
    expect_attempts(ebench, 2, 1)


@background
@requirement("EBE-017")
def test_ebe_017_a_step_after_the_lease_executes_nothing(context: CheckContext) -> None:
    """A worker is idle for longer than its lease, then steps. Expect the action not
    executed, and the first observation of the episode."""
    ebench = begin_ebench_run(context, "count", idle_timeout_s=1)
    ebench.step({"0": action()})
    time.sleep(1 + context.tolerance_s)
    ebench.run.until("ready")
    shown = expect_count(ebench.try_step({"0": action()}), 0)
    expect.equal(shown["obs"]["reset"], True, "reset")
    expect.equal(shown["metric"], None, "metric")
    expect_count(ebench.try_step({"0": action()}), 1)


@requirement("EBE-018")
def test_ebe_018_stop_is_served_at_both_urls(context: CheckContext) -> None:
    """Two runs are stopped, one at each URL. Expect both stopped."""
    for at_root in (False, True):
        ebench = submit_ebench_run(context, "count")
        root = ebench.endpoint.partition("/api/predict/")[0]
        expect_success(ebench.try_stop(root if at_root else None))
        expect.equal(ebench.run.get()["state"], "stopped", "the state of the run")


@requirement("EBE-019")
def test_ebe_019_status_has_the_progress(context: CheckContext) -> None:
    """One of three episodes is scored, one is in progress. Expect these counts."""
    ebench = begin_ebench_run(context, "score", "count", "count")
    ebench.step({"0": action(score=0.25, end=1)})
    status = expect.ok(ebench.try_get("status"))["data"]
    expected = {
        "run_id": ebench.run.id,
        "benchmark_id": "calibration",
        "total_episodes": 3,
        "completed_episodes": 1,
        "in_progress_episodes": 1,
        "active_workers": ["0"],
        "results": {"score": 0.25},
        "status": "running",
    }
    expect.equal({name: status[name] for name in expected}, expected, "the status")


@requirement("EBE-020")
def test_ebe_020_responses_are_plain_data(context: CheckContext) -> None:
    """Responses with images, tensors and results. Expect pickles of plain data."""
    ebench = submit_ebench_run(context, "echo", "score")
    answers = [ebench.try_reset("0"), ebench.try_step({"0": action()})]
    answers.append(ebench.try_step({"0": action(success=1, end=1)}))
    for answer in answers:
        try:
            expect_plain_pickle(answer)
        except pickles.GlobalInPickle as error:
            expect.true(False, "a pickle that names nothing", f"it names {error}")


@requirement("EBE-021")
def test_ebe_021_another_account_finds_no_run(context: CheckContext) -> None:
    """Another account uses task_id and endpoint. Expect the response of no run."""
    ebench = begin_ebench_run(context, "count")
    other_account = context.second_account
    step = ebench.try_step({"0": action()}, http_client=other_account)
    expect.refused(step, "not_found")
    for name in ("ready", "createTask"):
        codes = [
            expect.ok(
                call_control_plane(context, name, {"task_id": task_id}, other_account)
            )["code"]
            for task_id in (ebench.run.id, "no-such-task")
        ]
        expect.equal(codes[0], codes[1], f"`code` of `{name}`")
    expect_count(ebench.try_step({"0": action()}), 1)


@requirement("EBE-023")
def test_ebe_023_step_accepts_a_chunk(context: CheckContext) -> None:
    """Chunks of three steps; the second ends early. Expect both counts."""
    ebench = begin_ebench_run(context, "count", "count")
    for last, executed, stopped_early, seen_after in (
        (0, 3, False, 3),
        (1, 2, True, 0),
    ):
        chunk = [{"0": action(end=last if n == 1 else 0)} for n in range(3)]
        reported = expect_workers(ebench.try_send("step_chunk", pickles.write(chunk)))
        expect.equal(count(reported["obs"]["0"]), seen_after, "state.count")
        pair = [reported["executed_steps"], reported["stopped_early"]]
        expect.equal(pair, [executed, stopped_early], "steps and stopped_early")


@requirement("EBE-022")
def test_ebe_022_the_score_is_the_run_s(context: CheckContext) -> None:
    """Four episodes by two workers. Expect their scores in the run's score."""
    scores = [1.0, 0.5, 0.25, 0.0]
    run = context.submit(*["score"] * 4)
    ebench = open_endpoint(context, run)
    ebench.reset("0", "1")
    for first in (0, 2):
        ends = {
            worker: action(score=score, end=1)
            for worker, score in zip("01", scores[first : first + 2], strict=True)
        }
        ebench.step(ends)
    results = [episode.get("result", {}) for episode in run.episodes()]
    reported = sorted(result.get("score", -1) for result in results)
    expect.equal(reported, sorted(scores), "the scores of the episodes")
    score = run.score()
    expect.equal(score["score"], 0.4375, "the score")
    expect.equal(run.get()["state"], "completed", "the state of the run")


@requirement("EBE-024")
def test_ebe_024_the_run_is_named_in_header_and_query(context: CheckContext) -> None:
    """Every operation with `run_id` in both places, and with another run's. Expect
    success, and `not_found`."""
    ebench = submit_ebench_run(context, "count")
    second_id = context.submit("count").id
    step = pickles.write({"0": action()})
    calls = [
        partial(ebench.try_get, "docs"),
        partial(ebench.try_get, "status"),
        partial(ebench.try_workers, "create_workers", "0"),
        partial(ebench.try_reset, "0"),
        partial(ebench.try_send, "step", step),
        partial(ebench.try_chunk, [{"0": action()}]),
        partial(ebench.try_workers, "kill", "0"),
    ]
    for call in calls:
        expect.refused(call(params={"run_id": second_id}), "not_found")
        named_in_header = call(headers={"run_id": second_id}, params={})
        require_header_passed_on(named_in_header)
        expect.refused(named_in_header, "not_found")
        answer = call(**name_run(ebench))
        expect.equal(answer.status, 200, "the status with `run_id` in both places")


@requirement("EBE-025")
def test_ebe_025_metrics_have_labels_for_the_client(context: CheckContext) -> None:
    """Three episodes of two tasks, by a step with a query and by `step_chunk`. Expect
    labels with the progress, and `sr` 1 for a full score alone."""
    ebench = begin_ebench_run(context, "score", "score", "count")
    ends = [action(score=1, end=1), action(score=0.5, end=1), action(end=1)]
    first = ebench.try_step({"0": ends[0]}, params={"run_id": ebench.run.id})
    second = ebench.try_chunk([{"0": ends[1]}])
    last = ebench.try_chunk([{"0": ends[2]}])
    metrics = [
        expect_workers(first)["0"]["metric"],
        expect_workers(second)["obs"]["0"]["metric"],
        expect_workers(last)["obs"]["0"]["metric"],
    ]
    nothing = {"score": 0.0, "sr": 0.0}
    expected = [
        {"*(1/2)score": {"score": 1.0, "sr": 1.0}},
        {"(2/2)score": {"score": 0.5, "sr": 0.0}},
        {"(2/2)score": {"score": 0.75, "sr": 0.5}, "(1/1)count": nothing},
    ]
    expect.equal(metrics, expected, "the metrics")


@requirement("EBE-026")
def test_ebe_026_episode_results_are_complete(context: CheckContext) -> None:
    """A full and a half score, by `step_chunk`, and a half one by the older client.
    Expect all that a result file needs, with ids that differ."""
    ebench = begin_ebench_run(context, "count", "score", "score")
    reported = []
    for end in (action(success=1, end=1), action(score=0.5, end=1)):
        answer = ebench.try_chunk([{"0": end}])
        reported.append(expect_workers(answer)["obs"]["0"]["episode_result"] or {})
    answer = ebench.try_step({"0": action(score=0.5, end=1)})
    reported.append(expect_workers(answer)["0"]["episode_result"] or {})
    shown = [
        tuple(result.get(name) for name in ("task_name", "seed", "score", "sr"))
        for result in reported
    ]
    expected = [
        ("count", 1000, 1, 1),
        ("score", 1001, 0.5, 0),
        ("score", 1002, 0.5, 0.5),
    ]
    expect.equal(shown, expected, "task_name, seed, score and sr")
    ids = {str(result.get("episode_id")) for result in reported}
    expect.equal(len(ids - {"None"}), 3, "the number of ids")


@requirement("EBE-027")
def test_ebe_027_a_completed_task_is_executed_again(context: CheckContext) -> None:
    """A completed run's task_id; the run is one of a part, where the server has those.
    Expect another run of its manifest that names it."""
    tasks, part = ["score", "score"], None
    if context.offers("subsets"):
        tasks, part = [*tasks, "count"], {"tasks": ["score"]}
    ebench = begin_ebench_run(context, *tasks, select=part, max_steps=3)
    for _ in range(2):
        ebench.step({"0": action(score=1, end=1)})
    old = ebench.run.until("completed")
    asked = {"task_id": ebench.run.id}
    made = create_task(context, **asked)
    new = expect.ok(context.call("get_run", run_id=made["task_id"]))
    context.adopt(new)
    expect.true(new["run_id"] != old["run_id"], "another run_id", new["run_id"])
    hashes = [new["manifest_sha256"], old["manifest_sha256"]]
    expect.equal(hashes[0], hashes[1], "manifest_sha256")
    version = new["policy"].get("version", "")
    expect.true(old["run_id"] in version, "a policy.version with the old id", version)
    expect.equal(ebench.run.get()["state"], "completed", "the state of the old run")


@requirement("EBE-028")
def test_ebe_028_a_long_list_of_steps_is_one_step(context: CheckContext) -> None:
    """One step more than `max_chunk` of the benchmark; the same with a last action that
    does not fit; one step more than announced. Expect the first executed, and the
    others refused as a whole."""
    manifest = expect.ok(context.call("get_benchmark", benchmark_id="calibration"))
    ebench = submit_ebench_run(context, "count", max_steps=10_000)
    most = ebench.status().get("max_chunk", 0)
    length = manifest["max_chunk"] + 1
    if most < length:
        raise NotApplicable("`status` announces no longer lists of steps")
    ebench.reset("0")
    shown = expect_workers(ebench.try_chunk([{"0": action()}] * length))
    expect.equal(count(shown["obs"]["0"]), length, "state.count")
    expect.equal(shown["executed_steps"], length, "executed_steps")
    good = [{"0": action()}] * (length - 1)
    bad = [[*good, {"0": last}] for last in ({"action": [0.0]}, action(success=7))]
    for wrong in (*bad, [{"0": action()}] * (most + 1)):
        expect.refused(ebench.try_chunk(wrong), "invalid_request")
    shown = expect_count(ebench.try_step({"0": action()}), length + 1)


@requirement("EBE-030")
def test_ebe_030_a_killed_worker_costs_no_episode(context: CheckContext) -> None:
    """An episode with one attempt is killed twice. Expect it unscored, and counted."""
    ebench = submit_ebench_run(context, "score", max_attempts=1)
    limit = ebench.status().get("max_attempts", 0)
    if limit is not None and limit < 3:
        raise NotApplicable("`status` announces fewer than three attempts")
    for _ in range(2):
        ebench.reset("0")
        ebench.step({"0": action(score=0.5)})
        ebench.try_workers("kill", "0")
    [episode] = ebench.run.episodes()
    expect.members(episode, {"attempt": 3, "status": "pending"})
    ebench.reset("0")
    ebench.step({"0": action(score=1, end=1)})
    [episode] = ebench.run.episodes()
    attempt_and_score = [episode["result"]["attempt"], episode["result"]["score"]]
    expect.equal(attempt_and_score, [3, 1.0], "attempt and score of the result")


@requirement("EBE-031")
def test_ebe_031_a_lost_result_is_given_later(context: CheckContext) -> None:
    """The client disconnects from the step that ends an episode, and from the next one.
    Expect its `episode_result` in the answer to the next step or the one after it."""
    ebench = submit_ebench_run(context, "delay", "delay")
    lost = ebench.reset("0")["0"]["obs"]["episode_id"]
    for end in (1, 0):
        ebench.disconnect_during_step({"0": action(delay_s=1, end=end)})
        ebench.reset("0")  # waits for the end of the step
    given = []
    for number in range(2):
        step = {"0": action(vector=[float(number)] * 8)}
        shown = expect_workers(ebench.try_step(step))["0"]
        given.append((shown["episode_result"] or {}).get("episode_id"))
    expect.true(lost in given, f"the result of {lost}", given)


@requirement("EBE-032")
def test_ebe_032_workers_are_created(context: CheckContext) -> None:
    """Two workers are created, one of them while it plays an episode. Expect two
    sessions, and the episode of the first to go on."""
    ebench = begin_ebench_run(context, "count", "count")
    ebench.step({"0": action()})
    for _ in range(2):
        answer = expect.ok(ebench.try_workers("create_workers", "0", "1"))
        expect.equal(answer["data"]["success"], True, "data.success")
        expect.equal(ebench.run.get()["live_workers"], 2, "live_workers of the run")
    shown = expect_workers(ebench.try_step({"0": action(vector=[1.0] * 8)}))
    expect.equal(count(shown["0"]), 2, "state.count of the first worker")
