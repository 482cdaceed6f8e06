/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */


use reqwest;
use serde::{Deserialize, Serialize, de::Error as _};
use crate::{apis::ResponseContent, models};
use super::{Error, configuration, ContentType};


/// struct for typed errors of method [`attach_worker`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum AttachWorkerError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`detach_worker`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum DetachWorkerError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`heartbeat`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum HeartbeatError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}

/// struct for typed errors of method [`predict`]
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(untagged)]
pub enum PredictError {
    Status4XX(models::Problem),
    Status5XX(models::Problem),
    UnknownValue(serde_json::Value),
}


pub async fn attach_worker(configuration: &configuration::Configuration, run_id: &str, worker_id: &str, attach_worker: models::AttachWorker, proctor_version: Option<&str>) -> Result<models::Turn, Error<AttachWorkerError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_path_worker_id = worker_id;
    let p_body_attach_worker = attach_worker;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/workers/{worker_id}", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id), worker_id=crate::apis::urlencode(p_path_worker_id));
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
    req_builder = req_builder.json(&p_body_attach_worker);

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
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Turn`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Turn`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<AttachWorkerError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn detach_worker(configuration: &configuration::Configuration, run_id: &str, worker_id: &str, session_id: &str, proctor_version: Option<&str>) -> Result<(), Error<DetachWorkerError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_path_worker_id = worker_id;
    let p_query_session_id = session_id;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/workers/{worker_id}", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id), worker_id=crate::apis::urlencode(p_path_worker_id));
    let mut req_builder = configuration.client.request(reqwest::Method::DELETE, &uri_str);

    req_builder = req_builder.query(&[("session_id", &p_query_session_id.to_string())]);
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
        let entity: Option<DetachWorkerError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn heartbeat(configuration: &configuration::Configuration, run_id: &str, worker_id: &str, heartbeat: models::Heartbeat, proctor_version: Option<&str>) -> Result<models::Lease, Error<HeartbeatError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_path_worker_id = worker_id;
    let p_body_heartbeat = heartbeat;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/workers/{worker_id}/heartbeat", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id), worker_id=crate::apis::urlencode(p_path_worker_id));
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
    req_builder = req_builder.json(&p_body_heartbeat);

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
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Lease`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Lease`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<HeartbeatError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}

pub async fn predict(configuration: &configuration::Configuration, run_id: &str, worker_id: &str, predict: models::Predict, proctor_version: Option<&str>) -> Result<models::Turn, Error<PredictError>> {
    // add a prefix to parameters to efficiently prevent name collisions
    let p_path_run_id = run_id;
    let p_path_worker_id = worker_id;
    let p_body_predict = predict;
    let p_header_proctor_version = proctor_version;

    let uri_str = format!("{}/v1/runs/{run_id}/workers/{worker_id}/predict", configuration.base_path, run_id=crate::apis::urlencode(p_path_run_id), worker_id=crate::apis::urlencode(p_path_worker_id));
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
    req_builder = req_builder.json(&p_body_predict);

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
            ContentType::Text => return Err(Error::from(serde_json::Error::custom("Received `text/plain` content type response that cannot be converted to `models::Turn`"))),
            ContentType::Unsupported(unknown_type) => return Err(Error::from(serde_json::Error::custom(format!("Received `{unknown_type}` content type response that cannot be converted to `models::Turn`")))),
        }
    } else {
        let headers = resp.headers().clone();
        let content = resp.text().await?;
        let entity: Option<PredictError> = serde_json::from_str(&content).ok();
        Err(Error::ResponseError(ResponseContent { status, headers, content, entity }))
    }
}
