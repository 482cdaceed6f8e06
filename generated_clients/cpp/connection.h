/* Generated from spec/openapi.yaml by `make generate`; never edited by hand. */

/* One connection to a server, over libcurl: what stands under the operations of api/. */
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "model/Problem.h"

namespace proctor {

/// No answer came, or none that is JSON. What was sent may have had its effect.
struct ConnectionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An answer that is no success. `problem.code` may be one of a later version.
struct Refused : std::runtime_error {
    Refused(long status, Problem why, double retry_after_s)
        : std::runtime_error(why.detail + " [" + why.code + "]"), status(status), problem(std::move(why)), retry_after_s(retry_after_s) {}

    long status;
    Problem problem;
    double retry_after_s; // 0: the answer had no Retry-After
};

struct Request {
    std::string method;
    std::string path; // a template until its parameters are put in
    std::string query{};
    std::vector<std::pair<std::string, std::string>> headers{};
    std::optional<std::string> body{};

    void path_parameter(std::string const& name, std::string const& value);
    void query_parameter(std::string const& name, std::string const& value);
    void query_parameter(std::string const& name, std::optional<std::string> const& value);
    void query_parameter(std::string const& name, std::optional<std::int32_t> const& value);
    void query_parameter(std::string const& name, std::optional<double> const& value);
    void header(std::string const& name, std::optional<std::string> const& value);
};

/// Kept open between requests; one request at a time, so each thread has its own.
class Connection {
public:
    Connection(std::string url, std::string token, double timeout_s = 60);

    /// The answer; null when it has no body. Throws Refused and ConnectionError.
    nlohmann::json send(Request const& request);

private:
    std::string m_url, m_token;
    std::shared_ptr<void> m_curl;
};

} // namespace proctor
