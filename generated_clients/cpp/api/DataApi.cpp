/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#include "DataApi.h"

namespace proctor {

Turn DataApi::attachWorker(std::string const& runId, std::string const& workerId, AttachWorker const& attachWorker, std::optional<std::string> const& proctorVersion) {
    Request request{"PUT", "/v1/runs/{run_id}/workers/{worker_id}"};
    request.path_parameter("run_id", runId);
    request.path_parameter("worker_id", workerId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(attachWorker).dump();
    return m_connection->receive<Turn>(request);
}

void DataApi::detachWorker(std::string const& runId, std::string const& workerId, std::string const& sessionId, std::optional<std::string> const& proctorVersion) {
    Request request{"DELETE", "/v1/runs/{run_id}/workers/{worker_id}"};
    request.path_parameter("run_id", runId);
    request.path_parameter("worker_id", workerId);
    request.query_parameter("session_id", sessionId);
    request.header("Proctor-Version", proctorVersion);
    m_connection->send(request);
}

Lease DataApi::heartbeat(std::string const& runId, std::string const& workerId, Heartbeat const& heartbeat, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/runs/{run_id}/workers/{worker_id}/heartbeat"};
    request.path_parameter("run_id", runId);
    request.path_parameter("worker_id", workerId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(heartbeat).dump();
    return m_connection->receive<Lease>(request);
}

Turn DataApi::predict(std::string const& runId, std::string const& workerId, Predict const& predict, std::optional<std::string> const& proctorVersion) {
    Request request{"POST", "/v1/runs/{run_id}/workers/{worker_id}/predict"};
    request.path_parameter("run_id", runId);
    request.path_parameter("worker_id", workerId);
    request.header("Proctor-Version", proctorVersion);
    request.body = nlohmann::json(predict).dump();
    return m_connection->receive<Turn>(request);
}

} // namespace proctor
