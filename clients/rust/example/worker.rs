//! A worker loop on the generated client: the least that a policy needs to be evaluated.
//! The same loop stands in the example of every language; see docs/implement/clients.md.

use std::fmt;
use std::future::Future;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use crate::connection::{data, failure_of, reasons, unique, HAS_ANSWERED};
use proctor_client::apis::configuration::Configuration;
use proctor_client::apis::{control_api, data_api, Error};
use proctor_client::models::{
    Action, AttachWorker, EpisodeResult, Predict, Problem, Run, RunState, Turn,
};

const RETRY_TIMEOUT: Duration = Duration::from_secs(60);

/// Why a request brought nothing.
#[derive(Debug)]
pub enum Failure {
    /// The server said no: the problem says why and what to do.
    Refused { status: u16, problem: Box<Problem>, retry_after_s: Option<f64> },
    /// No answer, or one of a gateway or a network that may soon be gone.
    Lost(String),
    /// A setting is wrong, such as the URL, or an answer; to repeat the request does not help.
    Wrong(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Failure::Refused { problem, .. } => write!(out, "{} [{}]", problem.detail, problem.code),
            Failure::Lost(why) | Failure::Wrong(why) => write!(out, "{why}"),
        }
    }
}

impl<T> From<Error<T>> for Failure {
    fn from(error: Error<T>) -> Self {
        let answer = match error {
            Error::ResponseError(answer) => answer,
            Error::Reqwest(cause) => return Failure::Lost(reasons(&cause)),
            // What has a length and lacks a part of it is an error of the connection: here the end of the body is its end.
            Error::Serde(cause) if cause.is_eof() && cause.column() > 0 => {
                return Failure::Lost(format!("the connection ended before the answer was whole: {cause}"))
            }
            cause => return Failure::Wrong(format!("no message of Proctor was answered: {cause}")),
        };
        let Ok(problem) = serde_json::from_str(&answer.content) else {
            return failure_of(&answer);
        };
        let wait = answer.headers.get("retry-after").and_then(|text| text.to_str().ok()?.parse::<u32>().ok());
        let retry_after_s = wait.map(f64::from);
        Failure::Refused { status: answer.status.as_u16(), problem, retry_after_s }
    }
}

/// Send a request until it is answered: a repeat executes nothing twice.
pub async fn ask<T, E, F>(mut send: impl FnMut() -> F) -> Result<T, Failure>
where
    F: Future<Output = Result<T, Error<E>>>,
{
    let (deadline, mut pause_s) = (Instant::now() + RETRY_TIMEOUT, 0.1_f64);
    let mut next_report = Instant::now() + Duration::from_secs(2); // then every 10 s
    loop {
        let failure = match send().await {
            Ok(value) => {
                HAS_ANSWERED.store(true, Ordering::Relaxed);
                return Ok(value);
            }
            Err(error) => Failure::from(error),
        };
        let wait_s = match &failure {
            Failure::Refused { problem, .. } if !problem.retryable => return Err(failure),
            Failure::Wrong(_) => return Err(failure),
            Failure::Refused { retry_after_s, .. } => *retry_after_s,
            Failure::Lost(_) => None,
        };
        let pause = Duration::from_secs_f64(wait_s.unwrap_or(pause_s));
        if Instant::now() + pause > deadline {
            return Err(failure);
        }
        if Instant::now() + pause >= next_report {
            eprintln!("waiting: {failure}");
            next_report = Instant::now() + Duration::from_secs(10);
        }
        tokio::time::sleep(pause).await;
        pause_s = (2.0 * pause_s).min(2.0);
    }
}

/// Play until no episode is left; a lost session is replaced by a new one.
pub async fn play<F: Future<Output = Vec<Action>>>(
    control: &Configuration,
    run_id: &str,
    worker_id: &str,
    mut policy: impl FnMut(Turn) -> F,
    mut report: impl FnMut(&EpisodeResult),
) -> Result<(), Failure> {
    loop {
        let failure = match session(control, run_id, worker_id, &mut policy, &mut report).await {
            Err(Failure::Refused { status, problem, retry_after_s }) => {
                let completed = problem.state == Some(RunState::Completed);
                if problem.code == "illegal_transition" && completed {
                    return Ok(()); // the other workers have played the rest
                }
                let over = matches!(problem.ended_by.as_deref(), Some("run_stopped" | "run_failed"));
                if problem.code == "session_ended" && !over {
                    eprintln!("warning: {worker_id} lost its session, and the attempt of an episode that had begun: {}", problem.detail);
                    continue;
                }
                Failure::Refused { status, problem, retry_after_s }
            }
            other => return other,
        };
        return Err(failure);
    }
}

async fn session<F: Future<Output = Vec<Action>>>(
    control: &Configuration,
    run_id: &str,
    worker_id: &str,
    policy: &mut impl FnMut(Turn) -> F,
    report: &mut impl FnMut(&EpisodeResult),
) -> Result<(), Failure> {
    let data = data(control, &until_open(control, run_id).await?)?;
    let key = AttachWorker::new(unique());
    let mut turn = ask(|| data_api::attach_worker(&data, run_id, worker_id, key.clone(), None)).await?;
    while !turn.done {
        let chunk = Predict::new(turn.session_id.clone(), turn.seq + 1, policy(turn).await);
        turn = ask(|| data_api::predict(&data, run_id, worker_id, chunk.clone(), None)).await?;
        if let Some(result) = &turn.episode_result {
            report(result);
        }
    }
    Ok(())
}

/// The run, as soon as workers may attach.
pub async fn until_open(control: &Configuration, run_id: &str) -> Result<Run, Failure> {
    loop {
        let run = ask(|| control_api::get_run(control, run_id, None, None, None)).await?;
        if run.state != RunState::Queued {
            return Ok(run);
        }
        tokio::time::sleep(Duration::from_millis(100)).await;
    }
}
