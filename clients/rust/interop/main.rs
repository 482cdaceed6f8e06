//! What the Rust client sees: interop SCENARIO URL TOKEN prints one JSON line.
//!
//! The scenarios are those of tools/interop.py, which judges; nothing is judged here.

#[path = "../example/calibration.rs"]
mod calibration;
#[path = "../example/connection.rs"]
mod connection;
#[path = "../example/worker.rs"]
mod worker;

use std::cell::RefCell;
use std::collections::HashSet;
use std::future::Future;
use std::time::Duration;

use base64::{prelude::BASE64_STANDARD, Engine};
use calibration::act;
use proctor_client::apis::configuration::Configuration;
use proctor_client::apis::{control_api, data_api, Error};
use proctor_client::models::*;
use serde_json::{json, Value};
use connection::{at, data, unique};
use worker::{ask, play, Failure};

type Seen = Result<Value, Failure>;

const VECTOR: [f64; 8] = [-0.0, 0.1, 5e-324, f64::MAX, 9007199254740991.0, 1.0 / 3.0, -2.5e-8, 1e22];

struct Choice {
    tasks: (CalibrationTask, usize),
    max_steps: i32,
    max_workers: Option<i32>,
    idle_timeout_s: Option<f64>,
    images: Option<Box<ImageChoice>>,
}

fn choice(task: CalibrationTask, count: usize, max_steps: i32) -> Choice {
    Choice { tasks: (task, count), max_steps, max_workers: None, idle_timeout_s: None, images: None }
}

async fn submit(control: &Configuration, choice: &Choice, key: &str) -> Result<Run, Failure> {
    let options = CalibrationOptions {
        tasks: Some(vec![choice.tasks.0; choice.tasks.1]),
        max_steps: Some(choice.max_steps),
        ..Default::default()
    };
    let mut body = SubmitRun::new("calibration".to_owned(), PolicyInfo::new("interop".to_owned()));
    body.options = Some(Box::new(options));
    body.max_workers = choice.max_workers;
    body.idle_timeout_s = choice.idle_timeout_s;
    body.images = choice.images.clone();
    ask(|| control_api::submit_run(control, body.clone(), Some(key), None)).await
}

async fn attach(control: &Configuration, run: &Run) -> Result<Turn, Failure> {
    let (data, body) = (data(control, run)?, AttachWorker::new(unique()));
    ask(|| data_api::attach_worker(&data, &run.run_id, "worker-0", body.clone(), None)).await
}

async fn predict(control: &Configuration, run: &Run, turn: &Turn, seq: i64, actions: Vec<Action>) -> Result<Turn, Failure> {
    let data = data(control, run)?;
    let mut body = Predict::new(turn.session_id.clone(), seq, actions);
    body.observe = Some(Observe::All);
    ask(|| data_api::predict(&data, &run.run_id, "worker-0", body.clone(), None)).await
}

async fn one_player<F: Future<Output = Vec<Action>>>(
    control: &Configuration, run: &Run, worker: &str, policy: impl FnMut(Turn) -> F,
) -> Result<Vec<EpisodeResult>, Failure> {
    let mut seen = Vec::new();
    play(control, &run.run_id, worker, policy, |result| seen.push(result.clone())).await?;
    Ok(seen)
}

fn index_of(turn: &Turn) -> usize {
    turn.episode.as_ref().map_or(0, |episode| episode.index as usize)
}

/// A policy that commands one score per episode, two actions a chunk.
macro_rules! by_index {
    ($scores:expr) => {
        |turn: Turn| async move { vec![act($scores[index_of(&turn)]); 2] }
    };
}

fn with(mut action: Action, name: &str, values: &[f64]) -> Action {
    action.values.insert(name.to_owned(), values.to_vec());
    action
}

fn counts(turn: &Turn) -> Vec<f64> {
    turn.observations.iter().flatten().map(|o| o.state["count"][0]).collect()
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn unpacked(base64: &str) -> String {
    hex(&BASE64_STANDARD.decode(base64).expect("base64"))
}

async fn the_score(control: &Configuration, run: &Run, mut more: Value) -> Seen {
    let score = ask(|| control_api::get_score(control, &run.run_id, None)).await?;
    more["run_id"] = json!(run.run_id);
    more["score"] = json!(score.score);
    more["complete"] = json!(score.complete);
    Ok(more)
}

fn problem_of<T>(answer: Result<T, Failure>) -> Value {
    match answer {
        Err(Failure::Refused { status, problem, retry_after_s }) => json!({
            "status": status, "code": problem.code, "retryable": problem.retryable,
            "side_effects": problem.side_effects, "retry_after_s": retry_after_s,
            "pointers": problem.errors.iter().flatten().map(|item| &item.pointer).collect::<Vec<_>>(),
            "expected_seq": problem.expected_seq, "ended_by": problem.ended_by,
        }),
        Err(failure) => json!({ "code": failure.to_string() }),
        Ok(_) => json!({ "code": "accepted" }),
    }
}

fn once<T, E>(answer: Result<T, Error<E>>) -> Result<T, Failure> {
    answer.map_err(Failure::from)
}

fn indices(results: &[EpisodeResult]) -> Vec<i32> {
    results.iter().map(|result| result.index).collect()
}

async fn repeated_submit(control: &Configuration) -> Seen {
    let (key, wanted) = (unique(), choice(CalibrationTask::Score, 1, 10));
    let first = submit(control, &wanted, &key).await?;
    let second = submit(control, &wanted, &key).await?;
    let listed = ask(|| control_api::list_runs(control, None, Some(1000), None)).await?.runs;
    let service = ask(|| control_api::describe_service(control, None)).await?;
    let benchmark = ask(|| control_api::get_benchmark(control, "calibration", None)).await?;
    let sizes = benchmark.action_space.iter().map(|(name, space)| (name.clone(), json!(space.size)));
    Ok(json!({
        "run_ids": [first.run_id, second.run_id],
        "listed": listed.iter().filter(|run| run.run_id == first.run_id).count(),
        "max_workers": service.limits.max_workers,
        "action_sizes": sizes.collect::<serde_json::Map<_, _>>(),
    }))
}

async fn two_workers(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Delay, 8, 4), &unique()).await?;
    let policy = |turn: Turn| async move {
        vec![with(act((index_of(&turn) % 2) as f64), "delay_s", &[0.05]); 2]
    };
    let (first, second) = tokio::try_join!(
        one_player(control, &run, "worker-0", policy),
        one_player(control, &run, "worker-1", policy),
    )?;
    let played = json!({ "worker-0": indices(&first), "worker-1": indices(&second) });
    the_score(control, &run, json!({ "played": played })).await
}

async fn chunks(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Count, 1, 10), &unique()).await?;
    let (mut turn, mut turns) = (attach(control, &run).await?, Vec::new());
    for _ in 0..3 {
        turn = predict(control, &run, &turn, turn.seq + 1, vec![act(0.0); 4]).await?;
        turns.push(turn.clone());
    }
    Ok(json!({
        "executed": turns.iter().map(|t| t.executed_steps).collect::<Vec<_>>(),
        "counts": turns.iter().map(counts).collect::<Vec<_>>(),
        "rewards": turns.iter().map(|t| t.rewards.len()).collect::<Vec<_>>(),
        "stopped_early": turns.iter().map(|t| t.stopped_early).collect::<Vec<_>>(),
        "truncated": turns.iter().map(|t| t.truncated).collect::<Vec<_>>(),
        "done": turn.done,
        "steps": turn.episode_result.map(|result| result.steps),
    }))
}

async fn echo(control: &Configuration) -> Seen {
    let mut wanted = choice(CalibrationTask::Echo, 1, 10);
    wanted.images = Some(Box::new(ImageChoice::new("raw".to_owned(), 64, 48)));
    let run = submit(control, &wanted, &unique()).await?;
    let turn = attach(control, &run).await?;
    let turn = predict(control, &run, &turn, 1, vec![with(act(0.0), "vector", &VECTOR)]).await?;
    let look = turn.observation.expect("an observation");
    let image = &look.images["pattern"];
    let tensors = look.tensors.iter().map(|(name, tensor)| {
        (name.clone(), json!({ "dtype": tensor.dtype, "shape": tensor.shape, "data": unpacked(&tensor.data) }))
    });
    Ok(json!({
        "codec": image.codec, "size": [image.height, image.width, image.channels], "image": unpacked(&image.data),
        "vector": look.state["vector"].iter().map(|x| hex(&x.to_be_bytes())).collect::<Vec<_>>(),
        "tensors": tensors.collect::<serde_json::Map<_, _>>(),
    }))
}

async fn lost_answer(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Count, 1, 6), &unique()).await?;
    let (mut turn, mut all) = (attach(control, &run).await?, Vec::new());
    for _ in 0..2 {
        turn = predict(control, &run, &turn, turn.seq + 1, vec![act(0.0); 3]).await?;
        all.extend(counts(&turn));
    }
    Ok(json!({ "run_id": run.run_id, "counts": all, "done": turn.done }))
}

async fn lost_session(control: &Configuration) -> Seen {
    let mut wanted = choice(CalibrationTask::Count, 1, 10);
    wanted.idle_timeout_s = Some(2.0);
    let run = submit(control, &wanted, &unique()).await?;
    let calls = RefCell::new(Vec::new());
    let policy = |turn: Turn| {
        calls.borrow_mut().push(turn.session_id);
        let thinks = calls.borrow().len() == 2; // for longer than the lease
        let run_id = &run.run_id;
        async move {
            while thinks {
                let seen = ask(|| control_api::get_run(control, run_id, None, None, None)).await.expect("the run");
                if seen.live_workers == 0 {
                    break;
                }
                tokio::time::sleep(Duration::from_millis(100)).await;
            }
            vec![act(1.0); 2]
        }
    };
    let results = one_player(control, &run, "worker-0", policy).await?;
    let sessions = calls.borrow().iter().collect::<HashSet<_>>().len();
    let attempt = results.last().map(|result| result.attempt);
    the_score(control, &run, json!({ "sessions": sessions, "attempt": attempt })).await
}

async fn restart(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Score, 4, 6), &unique()).await?;
    let results = one_player(control, &run, "worker-0", by_index!([0.25, 0.5, 0.75, 1.0])).await?;
    let attempts: Vec<_> = results.iter().map(|result| result.attempt).collect();
    the_score(control, &run, json!({ "attempts": attempts })).await
}

async fn worker_limit(control: &Configuration) -> Seen {
    let mut wanted = choice(CalibrationTask::Score, 3, 10);
    (wanted.max_workers, wanted.idle_timeout_s) = (Some(1), Some(5.0));
    let run = submit(control, &wanted, &unique()).await?;
    let (turn, data) = (attach(control, &run).await?, data(control, &run)?);
    let key = AttachWorker::new("k".to_owned());
    let problem = problem_of(once(data_api::attach_worker(&data, &run.run_id, "worker-1", key, None).await));
    ask(|| data_api::detach_worker(&data, &run.run_id, "worker-0", &turn.session_id, None)).await?;
    tokio::try_join!(
        one_player(control, &run, "worker-0", by_index!([1.0; 3])),
        one_player(control, &run, "worker-1", by_index!([1.0; 3])),
    )?;
    the_score(control, &run, json!({ "problem": problem })).await
}

async fn stop_resume(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Score, 3, 2), &unique()).await?;
    let turn = attach(control, &run).await?;
    let turn = predict(control, &run, &turn, 1, vec![act(0.5); 2]).await?;
    let abort = StopRun { mode: Some(StopMode::Abort), reason: None };
    let stopped = ask(|| control_api::stop_run(control, &run.run_id, abort.clone(), None)).await?;
    let problem = problem_of(predict(control, &run, &turn, 2, vec![act(0.5); 2]).await);
    ask(|| control_api::resume_run(control, &run.run_id, None)).await?;
    let results = one_player(control, &run, "worker-0", by_index!([0.5, 0.25, 1.0])).await?;
    let more = json!({ "problem": problem, "stopped": stopped.state, "after": indices(&results) });
    the_score(control, &run, more).await
}

async fn problems(control: &Configuration) -> Seen {
    let unknown = SubmitRun::new("no_such".to_owned(), PolicyInfo::new("interop".to_owned()));
    let unauthenticated = at(&control.base_path, "not-a-token")?;
    let run = submit(control, &choice(CalibrationTask::Count, 1, 10), &unique()).await?;
    let turn = attach(control, &run).await?;
    let short = vec![with(act(0.0), "vector", &[1.0])];
    Ok(json!({ "problems": [
        problem_of(once(control_api::submit_run(control, unknown, None, None).await)),
        problem_of(once(control_api::get_run(control, "no_such", None, None, None).await)),
        problem_of(once(control_api::list_runs(&unauthenticated, None, None, None).await)),
        problem_of(predict(control, &run, &turn, 1, short).await),
        problem_of(predict(control, &run, &turn, 7, vec![act(0.0)]).await),
    ]}))
}

/// Every run that is listed is answered by what is no run.
async fn wrong_answers(control: &Configuration) -> Seen {
    let mut errors = serde_json::Map::new();
    for run in ask(|| control_api::list_runs(control, None, None, None)).await?.runs {
        let error = match control_api::get_run(control, &run.run_id, None, None, None).await {
            Ok(_) => "accepted",
            Err(Error::Serde(_)) => "bad_answer",
            Err(Error::ResponseError(answer)) if answer.status.is_success() => "bad_answer",
            Err(other) => return Err(Failure::from(other)),
        };
        errors.insert(run.run_id, json!(error));
    }
    Ok(json!({ "errors": errors }))
}

async fn later_version(control: &Configuration) -> Seen {
    let service = ask(|| control_api::describe_service(control, None)).await?;
    let benchmark = ask(|| control_api::get_benchmark(control, "calibration", None)).await?;
    let vector = &benchmark.action_space["vector"];
    let run = submit(control, &choice(CalibrationTask::Echo, 1, 10), &unique()).await?;
    let seen = attach(control, &run).await?.observation.expect("an observation");
    Ok(json!({
        "profiles": service.profiles, "image_codecs": service.image_codecs, "success_rule": benchmark.success_rule,
        "rotation": vector.parts.as_ref().expect("parts")["all"].rotation, "out_of_range": vector.out_of_range, "mode": run.mode, "policy": run.policy.name,
        "codec": seen.images["pattern"].codec, "dtype": seen.tensors["float64"].dtype,
        "problem": problem_of(once(control_api::get_run(control, "no_such", None, None, None).await)),
    }))
}

async fn score(control: &Configuration) -> Seen {
    let run = submit(control, &choice(CalibrationTask::Score, 5, 2), &unique()).await?;
    one_player(control, &run, "worker-0", by_index!([1.0, 0.5, 0.25, 0.0, 0.25])).await?;
    let score = ask(|| control_api::get_score(control, &run.run_id, None)).await?;
    let (mut episodes, mut pages, mut cursor) = (Vec::new(), 0, None::<String>);
    while pages == 0 || cursor.is_some() {
        let page = ask(|| control_api::list_episodes(control, &run.run_id, cursor.as_deref(), Some(2), None)).await?;
        episodes.extend(page.episodes.iter().map(|e| json!([
            e.index, e.result.as_ref().map(|r| r.score), e.result.as_ref().map(|r| r.seed)
        ])));
        (cursor, pages) = (page.next_cursor, pages + 1);
    }
    let splits = score.by_split.iter().map(|(name, group)| (name.clone(), json!(group.mean)));
    Ok(json!({
        "run_id": run.run_id, "score": score.score, "success_rate": score.success_rate,
        "interval": [score.success_interval.low, score.success_interval.high], "success": score.counts.success,
        "splits": splits.collect::<serde_json::Map<_, _>>(), "pages": pages, "episodes": episodes,
    }))
}

/// The text decoded by the client's model and encoded again.
fn again<T: serde::de::DeserializeOwned + serde::Serialize>(text: &str) -> String {
    let model: Result<T, _> = serde_json::from_str(text);
    model.map_or("refused".to_owned(), |model| serde_json::to_string(&model).expect("encodes"))
}

/// Each golden vector decoded by the client's models and encoded again.
fn vectors(directory: &str) -> Value {
    let mut seen = serde_json::Map::new();
    for file in std::fs::read_dir(directory).expect("a directory").flatten() {
        if file.path().extension().is_none_or(|ending| ending != "json") {
            continue;
        }
        let text = std::fs::read_to_string(file.path()).expect("a file");
        let document: Value = serde_json::from_str(&text).expect("JSON");
        for vector in document["vectors"].as_array().expect("vectors") {
            if vector["refused"] == true {
                continue; // for servers
            }
            let text = vector["json"].as_str().expect("text");
            let said = match vector["schema"].as_str() {
                Some("Action") => again::<Action>(text),
                Some("Image") => again::<Image>(text),
                Some("Predict") => again::<Predict>(text),
                Some("Problem") => again::<Problem>(text),
                Some("Tensor") => again::<Tensor>(text),
                Some("Turn") => again::<Turn>(text),
                other => panic!("no model {other:?}"),
            };
            seen.insert(vector["id"].as_str().expect("an id").to_owned(), json!(said));
        }
    }
    Value::Object(seen)
}

#[tokio::main]
async fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let (scenario, url, token) = (&arguments[1], &arguments[2], &arguments[3]);
    if scenario == "vectors" {
        return println!("{}", vectors(url)); // needs no server
    }
    let control = &at(url, token).expect("a URL and a token");
    let seen = match scenario.as_str() {
        "submit" => repeated_submit(control).await,
        "two_workers" => two_workers(control).await,
        "chunks" => chunks(control).await,
        "echo" => echo(control).await,
        "lost_answer" => lost_answer(control).await,
        "lost_session" => lost_session(control).await,
        "restart" => restart(control).await,
        "worker_limit" => worker_limit(control).await,
        "stop_resume" => stop_resume(control).await,
        "problems" => problems(control).await,
        "wrong_answers" => wrong_answers(control).await,
        "later_version" => later_version(control).await,
        "score" => score(control).await,
        other => panic!("no scenario {other}"),
    };
    match seen {
        Ok(seen) => println!("{seen}"),
        Err(failure) => {
            eprintln!("{failure}");
            std::process::exit(1);
        }
    }
}
