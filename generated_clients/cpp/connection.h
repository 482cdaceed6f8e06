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

/// Why a request has no result; the text names who answered, and no secret.
/// may_repeat: the same request can succeed later.
struct Failure : std::runtime_error {
    Failure(std::string const& why, bool may_repeat, double retry_after_s = 0)
        : std::runtime_error(why), may_repeat(may_repeat), retry_after_s(retry_after_s) {}

    bool may_repeat;
    double retry_after_s; // 0: the answer had no Retry-After
};

/// No answer came. What was sent may have had its effect.
struct ConnectionError : Failure {
    explicit ConnectionError(std::string const& why) : Failure(why, true) {}
};

/// A success that is not the message expected. What was sent may have had its effect.
struct InvalidAnswer : Failure {
    using Failure::Failure;
};

/// An answer that is no success. `problem.code` may be one of a later version, or `bad_answer` where another than a
/// server of Proctor has answered.
struct Refused : Failure {
    Refused(long status, Problem why, double retry_after_s)
        : Failure(why.detail + " [" + why.code + "]", why.retryable, retry_after_s), status(status), problem(std::move(why)) {}

    long status;
    Problem problem;
};

struct Answer {
    long status = 0;
    std::string text{}, place{}; // place: where the answer redirects to, or empty
    double retry_after_s = 0;
    bool is_page = false, is_of_proctor = false;
    bool has_whole_head = false, has_length = false; // without a length the end of the connection is that of the text
    bool may_pass = false; // what is in the place of the server may soon be gone
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
    /// silence_s: how long an answer may not go on. Throws BadSetting for a base URL or a token that cannot be used.
    Connection(std::string url, std::string token, double timeout_s = 60, double silence_s = 60);

    /// The text of a success. Throws Refused and ConnectionError.
    std::string send(Request const& request) { return answer_to(request).text; }

    /// The message that answers. Throws InvalidAnswer too.
    template <typename Message> Message receive(Request const& request) {
        auto const answer = answer_to(request);
        auto const message = nlohmann::json::parse(answer.text, nullptr, false);
        auto const invalid = [&](std::string const& why) {
            return InvalidAnswer(who_answered() + " answered " + request.method + " " + request.path + " by no " + Message::schema_name + ": " + why,
                                 answer.may_pass);
        };
        if (message.is_discarded() && !answer.has_length && !answer.is_page) throw ConnectionError("the connection ended before the answer was whole");
        if (message.is_discarded()) throw invalid(answer.is_page ? "it is a page, text/html" : "it is no JSON");
        try {
            return message.get<Message>();
        } catch (InvalidMessage const& error) {
            throw invalid(error.what());
        }
    }

private:
    Answer answer_to(Request const& request);
    Answer perform(std::string const& url, Request const& request);
    std::string who_answered() const; // the server, and the proxy that may have answered in its place

    std::string m_url, m_token;
    std::shared_ptr<void> m_curl;
};

} // namespace proctor
