//! Plays the benchmark `calibration` with a scripted policy, or goes on with a run:
//!
//!     PROCTOR_TOKEN=… cargo run --example worker -- URL [RUN_ID]

mod calibration;
mod connection;
mod worker;

use proctor_client::apis::control_api;
use proctor_client::models::{CalibrationOptions, CalibrationTask, EpisodeResult, PolicyInfo, SubmitRun, Turn};
use calibration::act;
use connection::{at, unique};
use worker::{ask, play, Failure};

async fn evaluate(url: &str, token: &str, run_id: Option<&String>) -> Result<(), Failure> {
    let control = at(url, token)?;
    let options = CalibrationOptions { tasks: Some(vec![CalibrationTask::Score; 8]), ..Default::default() };
    let policy_info = PolicyInfo::new("scripted".to_owned());
    let mut submit = SubmitRun::new("calibration".to_owned(), policy_info);
    submit.options = Some(Box::new(options));
    let key = unique();
    let run = match run_id {
        Some(id) => ask(|| control_api::resume_run(&control, id, None)).await?,
        None => ask(|| control_api::submit_run(&control, submit.clone(), Some(&key), None)).await?,
    };
    println!("run {}: {} episodes; its id, as RUN_ID, goes on with it", run.run_id, run.progress.episodes_total);
    let policy = |turn: Turn| async move {
        let index = turn.episode.map_or(0, |episode| episode.index);
        vec![act(f64::from(index % 5) / 4.0); 5]
    };
    let report = |r: &EpisodeResult| println!("  episode {} ({}): {}, score {}", r.index, r.task, r.outcome, r.score);
    tokio::try_join!(
        play(&control, &run.run_id, "worker-0", policy, report),
        play(&control, &run.run_id, "worker-1", policy, report),
    )?;
    let score = ask(|| control_api::get_score(&control, &run.run_id, None)).await?;
    println!("score {}", score.score.unwrap_or(f64::NAN));
    Ok(())
}

#[tokio::main]
async fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let token = std::env::var("PROCTOR_TOKEN").unwrap_or_default();
    if token.is_empty() || (arguments.len() != 2 && arguments.len() != 3) {
        eprintln!("usage: {} URL [RUN_ID]; the token is PROCTOR_TOKEN", arguments[0]);
        std::process::exit(1);
    }
    if let Err(failure) = evaluate(&arguments[1], &token, arguments.get(2)).await {
        let is_unknown = matches!(&failure, Failure::Refused { problem, .. } if problem.code == "not_found");
        if is_unknown && arguments[1].trim_end_matches('/').ends_with("/v1") {
            eprintln!("The base URL ends with /v1, which every request adds: give the part before it.");
        }
        eprintln!("{failure}");
        std::process::exit(1);
    }
}
