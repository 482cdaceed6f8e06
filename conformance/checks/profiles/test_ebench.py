"""EBench's wire, where a server offers it: EBE. Runs of calibration, by two doors."""

import time
from urllib.parse import urlsplit

from conformance.client.check_context import Story
from conformance.client.http_client import NoAnswer
from conformance.client.run_client import Run
from conformance.profiles import pickles
from conformance.profiles.ebench import (
    action,
    control,
    count,
    door_of,
    envelope,
    numbers,
    opened,
    plain,
    refusal,
    seen,
)
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed


@requirement("EBE-001")
def test_ebe_001_a_task_is_a_run(story: Story) -> None:
    """A task is made on calibration. Expect a run of that benchmark under its id."""
    asked = {"benchmark_set": "calibration", "model_name": "kit", "is_public": 0}
    task_id = envelope(control(story, "createTask", asked))["task_id"]
    shown = story.call("get_run", run_id=task_id)
    run = Run(story, expect.ok(shown), story.wire)
    story.adopt(run.body)
    expect.equal(run.body["benchmark_id"], "calibration", "the run's benchmark_id")
    other = envelope(control(story, "createTask", asked))["task_id"]
    story.adopt(expect.ok(story.call("get_run", run_id=other)))
    expect.true(other != task_id, "another task_id for another task", other)


@requirement("EBE-002")
def test_ebe_002_control_plane_refuses_in_an_envelope(story: Story) -> None:
    """Tasks and benchmarks that do not exist, a stop too late. Expect envelopes."""
    unknown = {"task_id": "no-such-task"}
    refusal(control(story, "createTask", {"benchmark_set": "no such benchmark"}))
    refusal(control(story, "createTask", unknown))
    refusal(control(story, "ready", unknown))
    door = opened(story, "score")
    door.reset("0")
    door.step({"0": action(score=1, end=1)})
    door.run.until("completed")
    refusal(door.try_stop())


@requirement("EBE-003")
def test_ebe_003_ready_waits_for_the_queue(story: Story) -> None:
    """A run is held in the queue for a while. Expect false, then an endpoint."""
    run = story.submit("score", queue_s=1, wait_ready=False)
    answer = control(story, "ready", {"task_id": run.id})
    is_queued = run.get()["state"] == "queued"
    data = envelope(answer)
    if not is_queued:
        raise SetUpFailed("the run did not wait in the queue; see RUN-008")
    expect.equal(data["ready"], False, "`ready` of a queued run")
    run.until("ready")
    data = envelope(control(story, "ready", {"task_id": run.id}))
    expect.equal(data["ready"], True, "`ready` of a run that is ready")
    path = urlsplit(str(data["endpoint"])).path
    before, middle, name = path.rpartition("/api/predict/")
    expect.true(
        middle and before and name and "/" not in name.rstrip("/"),
        "an endpoint whose path has /api/predict/ before its last part",
        data["endpoint"],
    )


@requirement("EBE-004")
def test_ebe_004_an_old_task_id_resumes(story: Story) -> None:
    """A run is stopped after its first episode. Expect its task_id to go on with it."""
    door = opened(story, "score", "score")
    door.reset("0")
    door.step({"0": action(score=0.5, end=1)})
    door.run.stop()
    data = envelope(control(story, "createTask", {"task_id": door.run.id}))
    expect.equal(data["task_id"], door.run.id, "the task_id")
    expect.true(
        door.run.get()["state"] in ("queued", "ready"),
        "a run that is queued or ready",
        door.run.body["state"],
    )
    scored = [e.get("result", {}).get("score") for e in door.run.episodes()]
    expect.equal(scored, [0.5, None], "the scores of its episodes")


@requirement("EBE-005")
def test_ebe_005_the_endpoint_shows_that_it_lives(story: Story) -> None:
    """The client looks at docs before anything else. Expect 200."""
    expect.equal(opened(story, "score").try_get("docs").status, 200, "the status")


@requirement("EBE-006")
def test_ebe_006_reset_begins_an_episode_for_each_worker(story: Story) -> None:
    """Two workers without episodes. Expect the first observation of one for each."""
    door = opened(story, "count", "count")
    shown = seen(door.try_reset("0", "1"))
    expect.equal(sorted(shown), ["0", "1"], "the workers that are shown")
    for worker in shown.values():
        first = [worker["obs"][name] for name in ("reset", "timestep", "state.count")]
        expect.equal(first, [True, 0, [0.0]], "reset, timestep and state.count")
        expect.equal(worker["metric"], None, "metric")
    ids = {worker["obs"]["episode_id"] for worker in shown.values()}
    expect.equal(len(ids), 2, "the number of different episode ids")


@requirement("EBE-007")
def test_ebe_007_reset_gives_no_second_try(story: Story) -> None:
    """A worker is reset after two steps. Expect it to stand where it stood."""
    door = opened(story, "count")
    door.reset("0")
    door.step([{"0": action()}] * 2)
    shown = seen(door.try_reset("0"))["0"]
    expect.equal(count(shown), 2, "state.count")
    expect.equal(shown["obs"]["reset"], False, "reset")
    attempts = [episode["attempt"] for episode in door.run.episodes()]
    expect.equal(attempts, [1], "the attempts of the episodes")


@requirement("EBE-008")
def test_ebe_008_step_executes_in_order(story: Story) -> None:
    """One step of two workers, then a list of three. Expect each executed, in order."""
    door = opened(story, "count", "count")
    door.reset("0", "1")
    shown = seen(door.try_step({"0": action(), "1": action(vector=[7.0] * 8)}))
    expect.equal([count(shown["0"]), count(shown["1"])], [1, 1], "state.count of both")
    expect.equal(shown["1"]["obs"]["state.vector"], [7.0] * 8, "state.vector of one")
    chunk = [{"0": action(vector=[float(n)] * 8), "1": action()} for n in range(3)]
    shown = seen(door.try_step(chunk))
    expect.equal([count(shown["0"]), count(shown["1"])], [4, 4], "state.count of both")
    expect.equal(shown["0"]["obs"]["state.vector"], [2.0] * 8, "state.vector")
    expect.equal(shown["0"]["obs"]["timestep"], 4, "timestep")


@requirement("EBE-009")
def test_ebe_009_the_end_of_an_episode_begins_the_next(story: Story) -> None:
    """The first of two episodes ends. Expect its result beside the next one's start."""
    door = opened(story, "score", "count")
    first = door.reset("0")["0"]["obs"]
    shown = seen(door.try_step({"0": action(score=0.25, end=1)}))["0"]
    expect.equal(shown["obs"]["reset"], True, "reset")
    expect.equal(count(shown), 0, "state.count")
    expect.true(shown["obs"]["episode_id"] != first["episode_id"], "another episode_id")
    expect.equal(shown["metric"], {"score": 0.25}, "metric")
    result = shown["episode_result"] or {}
    told = [result.get(name) for name in ("episode_id", "task_name", "sr")]
    expect.equal(told, [first["episode_id"], "score", 0.25], "the episode_result")
    stored = door.run.episodes()[0]["result"]
    expect.equal(result.get("seed"), stored["seed"], "the seed in the episode_result")


@requirement("EBE-010")
def test_ebe_010_the_end_of_the_run_is_told_and_told_again(story: Story) -> None:
    """Both episodes end. Expect no observation, and metrics, now and later."""
    door = opened(story, "score", "score")
    door.reset("0")
    door.step({"0": action(score=1, end=1)})
    end = {"0": action(score=0.5, end=1)}
    for answer in (door.try_step(end), door.try_step({"0": action()})):
        shown = seen(answer)["0"]
        expect.equal(shown["obs"], None, "obs")
        expect.equal(shown["metric"], {"score": 0.75}, "metric")


@requirement("EBE-011")
def test_ebe_011_numbers_survive_bit_for_bit(story: Story) -> None:
    """Numbers that are easily lost, in lists and arrays. Expect them back as sent."""
    door = opened(story, "echo")
    door.reset("0")
    hard = [0.1, -0.0, 1e300, 5e-324, 1 / 3, -2.5, 2.0**53, 7.0]
    sent = numbers(vector=hard)
    for form in (sent, pickles.Array(sent), pickles.Array(sent, "core")):
        shown = seen(door.try_step({"0": {"action": form}}))["0"]
        back = [number.hex() for number in shown["obs"]["state.vector"]]
        expect.equal(back, [number.hex() for number in hard], "state.vector, in hex")


@requirement("EBE-012")
def test_ebe_012_one_bad_action_moves_nobody(story: Story) -> None:
    """Of two workers one has an action that does not fit. Expect neither to move."""
    door = opened(story, "count", "count")
    door.reset("0", "1")
    bad = ([0.0] * 3, [float("nan")] * 15, numbers(success=7))
    for number, wrong in enumerate(bad):
        good = action(vector=[float(number)] * 8)  # each time a step of its own
        answer = door.try_step({"0": good, "1": {"action": wrong}})
        expect.refused(answer, "invalid_request")
    shown = seen(door.try_step({"0": action(), "1": action()}))
    expect.equal([count(shown["0"]), count(shown["1"])], [1, 1], "state.count of both")


@requirement("EBE-013")
def test_ebe_013_a_step_whose_answer_was_lost_is_not_executed_twice(
    story: Story,
) -> None:
    """The client leaves while a step is executed, and sends it again.

    Expect the answer to the first.
    """
    door = opened(story, "delay")
    door.reset("0")
    slow = {"0": action(delay_s=1)}
    for _ in range(2):
        try:
            door.try_step(slow, timeout_s=0.4)
        except NoAnswer:
            continue
        raise SetUpFailed("a step of a second was answered in less; see CAL-004")
    expect.equal(count(seen(door.try_step(slow))["0"]), 1, "state.count")


@requirement("EBE-014")
def test_ebe_014_the_same_action_again_is_a_step(story: Story) -> None:
    """A policy chooses the same action three times. Expect three steps."""
    door = opened(story, "count")
    door.reset("0")
    same = {"0": action(vector=[1.0] * 8)}
    for expected in (1, 2, 3):
        shown = seen(door.try_step(same))["0"]
        expect.equal(count(shown), expected, "state.count")


@requirement("EBE-015")
def test_ebe_015_a_pickle_that_calls_is_refused(story: Story) -> None:
    """Pickles that would call something harmless. Expect refusals, and no call."""
    door = opened(story, "count")
    door.reset("0")
    wait_s = 2.0
    calls = [
        pickles.Call("time", "sleep", [wait_s]),
        pickles.Call("builtins", "eval", ["[0.0] * 15"]),
        pickles.Call("builtins", "list", [[0.0] * 15]),
        pickles.Call("numpy", "zeros", [15]),
    ]
    for call in calls:
        answer = door.try_step({"0": {"action": call}})
        expect.refused(answer, "malformed_body")
        expect.true(
            answer.elapsed_s < wait_s, "an answer at once", f"{answer.elapsed_s:.1f} s"
        )
    expect.refused(door.try_send("step", b"\x80\x03]"), "malformed_body")
    expect.equal(count(seen(door.try_step({"0": action()}))["0"]), 1, "state.count")


@requirement("EBE-016")
def test_ebe_016_kill_ends_a_worker(story: Story) -> None:
    """One of two workers is killed, then once more. Expect the other one to live."""
    door = opened(story, "count", "count")
    door.reset("0", "1")
    door.step({"0": action(), "1": action()})
    for _ in range(2):
        expect.equal(door.try_workers("kill", "0").status, 200, "the status")
        expect.equal(door.run.get()["live_workers"], 1, "live_workers of the run")
    shown = seen(door.try_step({"1": action(vector=[1.0] * 8)}))
    expect.equal(count(shown["1"]), 2, "state.count of the other worker")
    attempts = [episode["attempt"] for episode in door.run.episodes()]
    expect.equal(attempts, [2, 1], "the attempts of the episodes")


@background
@requirement("EBE-017")
def test_ebe_017_a_step_after_the_lease_executes_nothing(story: Story) -> None:
    """A worker is idle for longer than its lease, then steps.

    Expect the action not to be executed, and the episode's beginning to be shown.
    """
    door = opened(story, "count", idle_timeout_s=1)
    door.reset("0")
    door.step({"0": action()})
    time.sleep(1 + story.tolerance_s)
    door.run.until("ready")
    shown = seen(door.try_step({"0": action()}))["0"]
    expect.equal(count(shown), 0, "state.count")
    expect.equal(shown["obs"]["reset"], True, "reset")
    expect.equal(shown["metric"], None, "metric")
    expect.equal(count(seen(door.try_step({"0": action()}))["0"]), 1, "state.count")


@requirement("EBE-018")
def test_ebe_018_stop_is_found_in_both_places(story: Story) -> None:
    """Two runs are stopped, one at each URL. Expect both to be stopped."""
    for at_root in (False, True):
        door = opened(story, "count")
        root = door.endpoint.partition("/api/predict/")[0]
        envelope(door.try_stop(root if at_root else None))
        expect.equal(door.run.get()["state"], "stopped", "the state of the run")


@requirement("EBE-019")
def test_ebe_019_status_tells_how_far_the_run_is(story: Story) -> None:
    """One of three episodes is scored, one is played. Expect the status to say so."""
    door = opened(story, "score", "count", "count")
    door.reset("0")
    door.step({"0": action(score=0.25, end=1)})
    status = expect.ok(door.try_get("status"))["data"]
    expected = {
        "run_id": door.run.id,
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
def test_ebe_020_answers_name_nothing(story: Story) -> None:
    """Answers with images, tensors and results. Expect plain data alone."""
    door = opened(story, "echo", "score")
    answers = [door.try_reset("0"), door.try_step({"0": action()})]
    answers.append(door.try_step({"0": action(success=1, end=1)}))
    for answer in answers:
        try:
            plain(answer)
        except pickles.NamesSomething as error:
            expect.true(False, "a pickle that names nothing", f"it names {error}")


@requirement("EBE-021")
def test_ebe_021_another_account_finds_no_run(story: Story) -> None:
    """Another account knows task_id and endpoint. Expect as much as for no run."""
    door = opened(story, "count")
    door.reset("0")
    stranger = story.wire_2
    step = door.try_step({"0": action()}, wire=stranger)
    expect.refused(step, "not_found")
    for name in ("ready", "createTask"):
        codes = [
            expect.ok(control(story, name, {"task_id": task_id}, stranger))["code"]
            for task_id in (door.run.id, "no-such-task")
        ]
        expect.equal(codes[0], codes[1], f"`code` of `{name}`")
    shown = seen(door.try_step({"0": action()}))["0"]
    expect.equal(count(shown), 1, "state.count")


@requirement("EBE-023")
def test_ebe_023_a_chunk_is_taken_where_ebench_takes_it(story: Story) -> None:
    """Three steps, then three of which the second ends. Expect both to be told."""
    door = opened(story, "count", "count")
    door.reset("0")
    for last, executed, is_cut, seen_after in ((0, 3, False, 3), (1, 2, True, 0)):
        chunk = [{"0": action(end=last if n == 1 else 0)} for n in range(3)]
        told = seen(door.try_send("step_chunk", pickles.write(chunk)))
        expect.equal(count(told["obs"]["0"]), seen_after, "state.count")
        pair = [told["executed_steps"], told["stopped_early"]]
        expect.equal(pair, [executed, is_cut], "executed_steps and stopped_early")


@requirement("EBE-022")
def test_ebe_022_the_score_is_the_run_s(story: Story) -> None:
    """Four episodes by two workers. Expect their scores in the run's score."""
    scores = [1.0, 0.5, 0.25, 0.0]
    run = story.submit(*["score"] * 4)
    door = door_of(story, run)
    door.reset("0", "1")
    for first in (0, 2):
        ends = {
            worker: action(score=score, end=1)
            for worker, score in zip("01", scores[first : first + 2], strict=True)
        }
        door.step(ends)
    results = [episode.get("result", {}) for episode in run.episodes()]
    told = sorted(result.get("score", -1) for result in results)
    expect.equal(told, sorted(scores), "the scores of the episodes")
    score = run.score()
    expect.equal(score["score"], 0.4375, "the score")
    expect.equal(run.get()["state"], "completed", "the state of the run")
