/* A worker loop on the generated client: the least that a policy needs to be evaluated.
 * The same loop stands in every language of generated_clients/; see docs/clients.md.
 */
#pragma once

#include <chrono>
#include <functional>
#include <random>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "api/ControlApi.h"
#include "api/DataApi.h"
#include "api/HttpClientImpl.h"
#include "model/Problem.h"

namespace worker {

using namespace proctor::api;
using namespace proctor::model;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds patience{60};
inline const std::string version = "1.0";
inline thread_local std::string retry_after; // of this thread's last answer

/// The server said no: `problem` says why and what to do.
struct Refused : std::runtime_error {
    Refused(unsigned code, Problem const& why)
        : std::runtime_error(why.getDetail() + " [" + why.getCode() + "]"), status(code), problem(why),
          retry_after_s(retry_after.empty() ? 0 : std::stod(retry_after)) {}
    unsigned status;
    Problem problem;
    double retry_after_s; // 0: not said
};

/// What the generated client leaves to us: the token, absent headers, Retry-After.
class Http : public HttpClientImpl {
public:
    Http(std::string const& host, std::string const& port, bool tls, std::string token)
        : HttpClientImpl(host, port, tls ? Transport::Https : Transport::Http, 11, std::chrono::seconds(60), 1ULL << 30),
          m_token(std::move(token)) {}

    std::pair<boost::beast::http::status, std::string>
    execute(std::string const& verb, std::string const& target, std::string const& body,
            std::map<std::string, std::string> const& given) override {
        std::map<std::string, std::string> headers{{"Authorization", "Bearer " + m_token}};
        for (auto const& [name, value] : given)
            if (!value.empty()) headers.emplace(name, value);
        auto answer = executeWithMetadata(verb, target, body, headers);
        retry_after.clear();
        for (auto const& [name, value] : answer.headers)
            if (name == "Retry-After" || name == "retry-after") retry_after = value;
        return {answer.status, answer.body};
    }

private:
    std::string m_token;
};

/// A connection to http[s]://host[:port]; one request at a time.
inline std::shared_ptr<Http> connect(std::string const& url, std::string const& token) {
    bool const tls = url.rfind("https://", 0) == 0;
    std::string host = url.substr(url.find("//") + 2), port = tls ? "443" : "80";
    host = host.substr(0, host.find('/'));
    if (auto const colon = host.rfind(':'); colon != std::string::npos) {
        port = host.substr(colon + 1);
        host.resize(colon);
    }
    return std::make_shared<Http>(host, port, tls, token);
}

/// Send a request; a refusal becomes Refused.
template <typename Request> auto once(Request request) -> decltype(request()) {
    auto refused = [](auto const& error) {
        auto const status = static_cast<unsigned>(error.getStatus());
        return Refused(status, Problem(boost::json::parse(error.getResponseBody()))); // or a gateway speaks
    };
    try {
        return request();
    } catch (ControlApiException const& error) {
        throw refused(error);
    } catch (DataApiException const& error) {
        throw refused(error);
    }
}

/// Send a request until it is answered: a repeat executes nothing twice.
template <typename Request> auto ask(Request request) -> decltype(request()) {
    auto const deadline = Clock::now() + patience;
    for (double pause_s = 0.1;; pause_s = std::min(2 * pause_s, 2.0)) {
        double wait_s = pause_s;
        try {
            return once(request);
        } catch (Refused const& error) {
            if (!error.problem.isRetryable() || Clock::now() > deadline) throw;
            if (error.retry_after_s > 0) wait_s = error.retry_after_s;
        } catch (std::exception const&) { // no answer, or none that we can read
            if (Clock::now() > deadline) throw;
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    }
}

/// A name that nobody has used.
inline std::string unique() {
    std::random_device entropy;
    std::ostringstream name;
    for (int i = 0; i < 4; ++i) name << std::hex << entropy();
    return name.str();
}

/// The run, as soon as workers may attach.
inline std::shared_ptr<Run> until_open(ControlApi& control, std::string const& run_id) {
    while (true) {
        auto run = ask([&] { return control.getRun(run_id, "", "", version); });
        if (run->getState() != "queued") return run;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

/// Play until no episode is left; a lost session is replaced by a new one.
inline void play(std::string const& url, std::string const& token, std::string const& run_id, std::string const& worker_id,
                 std::function<std::vector<Action>(Turn const&)> const& policy, std::function<void(EpisodeResult const&)> const& report) {
    ControlApi control(connect(url, token));
    while (true) try {
        DataApi data(connect(until_open(control, run_id)->getEndpoint(), token));
        auto key = std::make_shared<AttachWorker>();
        key->setAttachKey(unique());
        auto turn = ask([&] { return data.attachWorker(run_id, worker_id, key, version); });
        while (!turn->isDone()) {
            auto chunk = std::make_shared<Predict>();
            chunk->setSessionId(turn->getSessionId());
            chunk->setSeq(turn->getSeq() + 1);
            chunk->setActions(policy(*turn));
            turn = ask([&] { return data.predict(run_id, worker_id, chunk, version); });
            if (auto result = turn->getEpisodeResult(); !result.getEpisodeId().empty()) report(result);
        }
        return;
    } catch (Refused const& error) {
        auto const code = error.problem.getCode(), end = error.problem.getEndedBy();
        if (code == "illegal_transition" && error.problem.getState() == "completed") return; // others played the rest
        if (code != "session_ended" || end == "run_stopped" || end == "run_failed") throw;
    }
}

} // namespace worker
