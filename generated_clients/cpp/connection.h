/* Written by hand, beside what is generated from the specification. */

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

#include "models.h"
#include "settings.h"

namespace proctor {

/// No answer came. What was sent may have had its effect.
struct ConnectionError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A success that is not the message expected. What was sent may have had its effect.
struct InvalidAnswer : std::runtime_error {
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
    /// Throws BadSetting for a base URL or a token that cannot be used.
    Connection(std::string url, std::string token, double timeout_s = 60);

    /// The text of a success. Throws Refused and ConnectionError.
    std::string send(Request const& request);

    /// The message that answers. Throws InvalidAnswer too.
    template <typename Message> Message receive(Request const& request) {
        auto const answer = nlohmann::json::parse(send(request), nullptr, false);
        auto const invalid = [&](std::string const& why) {
            return InvalidAnswer(request.method + " " + request.path + " was answered by no " + Message::schema_name + ": " + why);
        };
        if (answer.is_discarded()) throw invalid("it is no JSON");
        try {
            return answer.get<Message>();
        } catch (InvalidMessage const& error) {
            throw invalid(error.what());
        }
    }

private:
    std::string perform(std::string const& url, Request const& request, long& status, std::string& place, double& retry_after_s);

    std::string m_url, m_token;
    std::shared_ptr<void> m_curl;
};

} // namespace proctor
