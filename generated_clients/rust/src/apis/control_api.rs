/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


use reqwest;
use serde::{Deserialize, Serialize, de::Error as _};
use crate::{apis::ResponseContent, models};
use super::{Error, configuration, ContentType};


/// struct for typed errors of method [`compare_runs`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum CompareRunsError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`delete_import`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DeleteImportError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`delete_run`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DeleteRunError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`describe_service`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DescribeServiceError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`flag_entry`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum FlagEntryError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_benchmark`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetBenchmarkError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_checkpoint`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetCheckpointError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_entry`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetEntryError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_import`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetImportError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_ranking`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetRankingError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_run`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetRunError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`get_score`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum GetScoreError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`import_record`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ImportRecordError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_benchmarks`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListBenchmarksError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_entries`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListEntriesError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_episodes`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListEpisodesError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_history`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListHistoryError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_imports`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListImportsError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_keys`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListKeysError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`list_runs`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ListRunsError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`prove_consistency`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ProveConsistencyError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`prove_inclusion`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ProveInclusionError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`publish_entry`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum PublishEntryError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`resume_run`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ResumeRunError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`stop_run`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum StopRunError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`submit_run`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum SubmitRunError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`withdraw_entry`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum WithdrawEntryError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}


/// Pairs the episodes of runs of one manifest. Offered with the profile `compare`; scoring.md has the arithmetic.
pub async fn compare_runs(configuration: &configuration::Configuration, baseline: &str, runs: &str, tolerance: Option<f64>, proctor_version: Option<&str>) -> Result<models::Comparison, Error<CompareRunsError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_baseline = baseline;
    let p_query_runs = runs;
    let p_query_tolerance = tolerance;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/comparisons", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    req_builder = req_builder.query(&[("baseline", &p_query_baseline.to_string())]);
    req_builder = req_builder.query(&[("runs", &p_query_runs.to_string())]);
    if let Some(ref param_value) = p_query_tolerance {
        req_builder = req_builder.query(&[("tolerance", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Comparison`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Comparison`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<CompareRunsError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// What was read of it and its replay are forgotten. Offered with the profile `record_import`.
pub async fn delete_import(configuration: &configuration::Configuration, import_id: &str, proctor_version: Option<&str>) -> Result<(), Error<DeleteImportError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_import_id = import_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/records/{import_id}", configuration.base_path, import_id=crate::apis::urlencode(p_path_import_id));
    let mut req_builder = configuration.client.request(reqwest::Method::DELETE, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();

    if !status.is_client_error() && !status.is_server_error() {
        Ok(())
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<DeleteImportError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn delete_run(configuration: &configuration::Configuration, run_id: &str, proctor_version: Option<&str>) -> Result<(), Error<DeleteRunError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::DELETE, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();

    if !status.is_client_error() && !status.is_server_error() {
        Ok(())
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<DeleteRunError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn describe_service(configuration: &configuration::Configuration, proctor_version: Option<&str>) -> Result<models::Service, Error<DescribeServiceError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Service`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Service`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<DescribeServiceError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// For the host: the token needs the scope `host`, besides `run`. A flagged entry is shown with the reason, and has no rank.
pub async fn flag_entry(configuration: &configuration::Configuration, entry_id: &str, flag_entry: models::FlagEntry, proctor_version: Option<&str>) -> Result<models::BoardEntry, Error<FlagEntryError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_entry_id = entry_id;
    let p_body_flag_entry = flag_entry;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/entries/{entry_id}/flag", configuration.base_path, entry_id=crate::apis::urlencode(p_path_entry_id));
    let mut req_builder = configuration.client.request(reqwest::Method::PUT, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };
    req_builder = req_builder.json(&p_body_flag_entry);

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BoardEntry`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BoardEntry`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<FlagEntryError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn get_benchmark(configuration: &configuration::Configuration, benchmark_id: &str, proctor_version: Option<&str>) -> Result<models::Benchmark, Error<GetBenchmarkError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_benchmark_id = benchmark_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/benchmarks/{benchmark_id}", configuration.base_path, benchmark_id=crate::apis::urlencode(p_path_benchmark_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Benchmark`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Benchmark`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetBenchmarkError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// A signed note, as board.md has it, by the key of `list_keys` that is in use.
pub async fn get_checkpoint(configuration: &configuration::Configuration, proctor_version: Option<&str>) -> Result<models::Checkpoint, Error<GetCheckpointError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/history/checkpoint", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Checkpoint`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Checkpoint`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetCheckpointError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// Of another account only if it is public, or was when it was withdrawn.
pub async fn get_entry(configuration: &configuration::Configuration, entry_id: &str, proctor_version: Option<&str>) -> Result<models::BoardEntry, Error<GetEntryError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_entry_id = entry_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/entries/{entry_id}", configuration.base_path, entry_id=crate::apis::urlencode(p_path_entry_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BoardEntry`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BoardEntry`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetEntryError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// Offered with the profile `record_import`.
pub async fn get_import(configuration: &configuration::Configuration, import_id: &str, proctor_version: Option<&str>) -> Result<models::RecordImport, Error<GetImportError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_import_id = import_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/records/{import_id}", configuration.base_path, import_id=crate::apis::urlencode(p_path_import_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::RecordImport`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::RecordImport`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetImportError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// One ranking for every caller; private entries do not enter. board.md has the arithmetic.
pub async fn get_ranking(configuration: &configuration::Configuration, benchmark_id: &str, manifest_sha256: Option<&str>, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::Ranking, Error<GetRankingError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_benchmark_id = benchmark_id;
    let p_query_manifest_sha256 = manifest_sha256;
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/benchmarks/{benchmark_id}/ranking", configuration.base_path, benchmark_id=crate::apis::urlencode(p_path_benchmark_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_manifest_sha256 {
        req_builder = req_builder.query(&[("manifest_sha256", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Ranking`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Ranking`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetRankingError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn get_run(configuration: &configuration::Configuration, run_id: &str, if_none_match: Option<&str>, prefer: Option<&str>, proctor_version: Option<&str>) -> Result<models::Run, Error<GetRunError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_header_if_none_match = if_none_match;
    let p_header_prefer = prefer;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_if_none_match {
        req_builder = req_builder.header("If-None-Match", param_value.to_string());
    }
    if let Some(param_value) = p_header_prefer {
        req_builder = req_builder.header("Prefer", param_value.to_string());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Run`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Run`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetRunError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn get_score(configuration: &configuration::Configuration, run_id: &str, proctor_version: Option<&str>) -> Result<models::Score, Error<GetScoreError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/score", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Score`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Score`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<GetScoreError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// The body is the archive that record.md describes; it is verified before the answer, so what is broken is refused with the file and the rule (REC-113). Then it is replayed on this server, when its simulators are free: `get_import` shows how far that is, and the level of trust that the record has here. Offered with the profile `record_import`. The same bytes, sent again by the account, are the same import.
pub async fn import_record(configuration: &configuration::Configuration, body: &str, proctor_version: Option<&str>) -> Result<models::RecordImport, Error<ImportRecordError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_body_body = body;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/records", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::POST, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };
    req_builder = req_builder.json(&p_body_body);

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::RecordImport`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::RecordImport`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ImportRecordError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn list_benchmarks(configuration: &configuration::Configuration, proctor_version: Option<&str>) -> Result<models::BenchmarkList, Error<ListBenchmarksError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/benchmarks", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BenchmarkList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BenchmarkList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListBenchmarksError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// Public entries, and private ones of the account that asks; none that is withdrawn.
pub async fn list_entries(configuration: &configuration::Configuration, benchmark_id: Option<&str>, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::BoardEntryList, Error<ListEntriesError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_benchmark_id = benchmark_id;
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/entries", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_benchmark_id {
        req_builder = req_builder.query(&[("benchmark_id", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BoardEntryList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BoardEntryList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListEntriesError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn list_episodes(configuration: &configuration::Configuration, run_id: &str, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::EpisodeList, Error<ListEpisodesError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/episodes", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::EpisodeList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::EpisodeList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListEpisodesError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// The leaves of the tree of board.md. No leaf is ever changed or taken out.
pub async fn list_history(configuration: &configuration::Configuration, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::HistoryPage, Error<ListHistoryError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/history", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::HistoryPage`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::HistoryPage`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListHistoryError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// Offered with the profile `record_import`.
pub async fn list_imports(configuration: &configuration::Configuration, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::RecordImportList, Error<ListImportsError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/records", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::RecordImportList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::RecordImportList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListImportsError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// Offered with the profile `record`. Needs no token, as checking a record needs none.
pub async fn list_keys(configuration: &configuration::Configuration, proctor_version: Option<&str>) -> Result<models::KeyList, Error<ListKeysError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/keys", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::KeyList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::KeyList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListKeysError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn list_runs(configuration: &configuration::Configuration, cursor: Option<&str>, limit: Option<i32>, proctor_version: Option<&str>) -> Result<models::RunList, Error<ListRunsError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_cursor = cursor;
    let p_query_limit = limit;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    if let Some(ref param_value) = p_query_cursor {
        req_builder = req_builder.query(&[("cursor", &param_value.to_string())]);
    }
    if let Some(ref param_value) = p_query_limit {
        req_builder = req_builder.query(&[("limit", &param_value.to_string())]);
    }
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::RunList`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::RunList`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ListRunsError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// For sizes up to that of the checkpoint, the old one at least 1 and at most the new one.
pub async fn prove_consistency(configuration: &configuration::Configuration, old_size: &str, new_size: &str, proctor_version: Option<&str>) -> Result<models::ConsistencyProof, Error<ProveConsistencyError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_old_size = old_size;
    let p_query_new_size = new_size;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/history/consistency", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    req_builder = req_builder.query(&[("old_size", &p_query_old_size.to_string())]);
    req_builder = req_builder.query(&[("new_size", &p_query_new_size.to_string())]);
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::ConsistencyProof`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::ConsistencyProof`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ProveConsistencyError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// For a size up to that of the checkpoint and a leaf below it.
pub async fn prove_inclusion(configuration: &configuration::Configuration, leaf_index: &str, tree_size: &str, proctor_version: Option<&str>) -> Result<models::InclusionProof, Error<ProveInclusionError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_query_leaf_index = leaf_index;
    let p_query_tree_size = tree_size;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/history/inclusion", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::GET, &uri_str);

    req_builder = req_builder.query(&[("leaf_index", &p_query_leaf_index.to_string())]);
    req_builder = req_builder.query(&[("tree_size", &p_query_tree_size.to_string())]);
    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::InclusionProof`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::InclusionProof`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ProveInclusionError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// A run has one entry. A repeat with the same body changes nothing; with another body it replaces the description, which has the defaults for what is left out. The score follows from the run and never changes. How often is bounded (BRD-001). Offered with the profile `board`, as are the operations on entries, rankings and history.
pub async fn publish_entry(configuration: &configuration::Configuration, run_id: &str, publish_entry: models::PublishEntry, proctor_version: Option<&str>) -> Result<models::BoardEntry, Error<PublishEntryError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_body_publish_entry = publish_entry;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/entry", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::PUT, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };
    req_builder = req_builder.json(&p_body_publish_entry);

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BoardEntry`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BoardEntry`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<PublishEntryError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn resume_run(configuration: &configuration::Configuration, run_id: &str, proctor_version: Option<&str>) -> Result<models::Run, Error<ResumeRunError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/resume", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::POST, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Run`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Run`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<ResumeRunError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn stop_run(configuration: &configuration::Configuration, run_id: &str, stop_run: models::StopRun, proctor_version: Option<&str>) -> Result<models::Run, Error<StopRunError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_body_stop_run = stop_run;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/stop", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::POST, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };
    req_builder = req_builder.json(&p_body_stop_run);

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Run`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Run`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<StopRunError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn submit_run(configuration: &configuration::Configuration, submit_run: models::SubmitRun, idempotency_key: Option<&str>, proctor_version: Option<&str>) -> Result<models::Run, Error<SubmitRunError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_body_submit_run = submit_run;
    let p_header_idempotency_key = idempotency_key;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs", configuration.base_path);
    let mut req_builder = configuration.client.request(reqwest::Method::POST, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_idempotency_key {
        req_builder = req_builder.header("Idempotency-Key", param_value.to_string());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };
    req_builder = req_builder.json(&p_body_submit_run);

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Run`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Run`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<SubmitRunError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

/// A withdrawn entry has no rank and is in no list; `get_entry` and the history go on to show it. A repeat changes nothing.
pub async fn withdraw_entry(configuration: &configuration::Configuration, run_id: &str, proctor_version: Option<&str>) -> Result<models::BoardEntry, Error<WithdrawEntryError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/entry", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id));
    let mut req_builder = configuration.client.request(reqwest::Method::DELETE, &uri_str);

    if let Some(ref user_agent) = configuration.user_agent {
        req_builder = req_builder.header(reqwest::header::USER_AGENT, user_agent.clone());
    }
    if let Some(param_value) = p_header_proctor_version {
        req_builder = req_builder.header("Proctor-Version", param_value.to_string());
    }
    if let Some(ref token) = configuration.bearer_access_token {
        req_builder = req_builder.bearer_auth(token.to_owned());
    };

    let req = req_builder.build()?;
    let resp = configuration.client.execute(req).await?;

    let status = resp.status();
    let content_type = resp
        .headers()
        .get("content-type")
        .and_then(|v| v.to_str().ok())
        .unwrap_or("application/octet-stream");
    let content_type = super::ContentType::from(content_type);

    if !status.is_client_error() && !status.is_server_error() {
        let content = resp.text().await?;
        match content_type {
            ContentType::Json => serde_json::from_str(&content).map_err(Error::from),
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::BoardEntry`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::BoardEntry`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<WithdrawEntryError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}
