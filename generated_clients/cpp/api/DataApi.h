/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

#pragma once

#include <memory>

#include "../connection.h"

namespace proctor {

/// Each call throws Refused when the server refuses it, ConnectionError when no answer came, InvalidAnswer
/// when what came is not the message expected.
class DataApi {
public:
    explicit DataApi(std::shared_ptr<Connection> connection) : m_connection(std::move(connection)) {}

    /// Attach a worker
    Turn attachWorker(std::string const& runId, std::string const& workerId, AttachWorker const& attachWorker, std::optional<std::string> const& proctorVersion = {});

    /// Detach a worker
    void detachWorker(std::string const& runId, std::string const& workerId, std::string const& sessionId, std::optional<std::string> const& proctorVersion = {});

    /// Keep a session alive
    Lease heartbeat(std::string const& runId, std::string const& workerId, Heartbeat const& heartbeat, std::optional<std::string> const& proctorVersion = {});

    /// Play a turn
    Turn predict(std::string const& runId, std::string const& workerId, Predict const& predict, std::optional<std::string> const& proctorVersion = {});

private:
    std::shared_ptr<Connection> m_connection;
};

} // namespace proctor
