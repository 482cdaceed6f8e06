/* A server, how long it is retried, and the operations on its runs.
 *
 * Every request is repeated until it is answered: operations that must not be executed twice
 * carry a seq, an attach_key or an Idempotency-Key, so the answer alone decides.
 */
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "api/ControlApi.h"
#include "proctor/error.h"

namespace proctor {

/// Ends waits; request() may be called by any thread and by a signal handler.
class StopSignal {
public:
    explicit StopSignal(std::shared_ptr<StopSignal const> parent = nullptr) : m_parent(std::move(parent)) {}
    void request() noexcept { m_requested = true; }
    bool requested() const noexcept { return m_requested || (m_parent && m_parent->requested()); }
    /// Throws Interrupted as soon as a stop is requested.
    void sleep(double seconds) const;

private:
    std::shared_ptr<StopSignal const> m_parent;
    std::atomic<bool> m_requested{false};
};

/// Where a server is, and how long it is waited for.
struct Server {
    std::string url, token;
    double retry_timeout_s = 300; ///< How long an unreachable server is retried.
    /// Called with the reason of each wait, by the threads that wait; without it stderr says it after 2 s.
    std::function<void(std::string const& why)> on_waiting{};
    std::shared_ptr<StopSignal> stop = std::make_shared<StopSignal>();
};

/// Limits in seconds for refusals of a code, instead of Server::retry_timeout_s.
using RetryLimits = std::map<std::string, double>;

/// The time and pause of one request that is repeated.
class Retry {
public:
    Retry(Server const& server, RetryLimits const& limits_s);
    /// Wait before the next attempt; throws the error if there is none.
    void wait_after(Error const& error);

private:
    Server const& m_server;
    RetryLimits const& m_limits_s;
    double m_begin, m_next_report_s, m_since = 0, m_pause_s = 0;
    std::string m_code, m_detail;
};

/// What a request to `url` threw, which is being handled, as an Error.
/// control_url: that of the server that named `url` as the endpoint of a run.
Error current_error(std::string const& url, std::string const& control_url = {});

/// The result of `send`, which is called until it succeeds. Throws Error and Interrupted.
/// endpoint: that of a run, if `send` is sent there.
template <typename Send>
auto call(Server const& server, Send send, RetryLimits const& limits_s = {}, std::string const& endpoint = {}) -> decltype(send()) {
    for (Retry retry(server, limits_s);;) {
        try {
            return send();
        } catch (std::exception const&) {
            retry.wait_after(endpoint.empty() ? current_error(server.url) : current_error(endpoint, server.url));
        }
    }
}

/// A text of an error in one line, as others may read it: without the token, and the users,
/// passwords and queries of URLs; at most 500 characters.
std::string without_secrets(std::string text, std::string const& token);

/// A key that is not in use.
std::string unique_key();

/// The operations on runs, each repeated until it is answered. For one thread.
class ControlPlane {
public:
    explicit ControlPlane(Server server);

    Service service();                                   ///< A mistyped URL is an error after seconds.
    Benchmark benchmark(std::string const& benchmark_id); ///< `not_found` names those that exist.
    /// Submits exactly one run: the repeats of the request carry the same key.
    Run submit(SubmitRun const& submission, std::string const& key = unique_key());
    Run run(std::string const& run_id);
    Run stop(std::string const& run_id, StopMode const& mode);
    Run resume(std::string const& run_id);
    Score score(std::string const& run_id);
    /// All episodes, from the pages of the list; page_size 0 is the server's.
    std::vector<Episode> episodes(std::string const& run_id, std::int32_t page_size = 0);

    /// Resume the run if it is stopped or failed; waits while it is stopping.
    Run resume_if_needed(std::string const& run_id);
    /// Wait until episodes can be played (true) or the run is completed (false).
    /// held: episodes held by a session count, because it will be taken over.
    bool wait_for_work(std::string const& run_id, bool held = false);

    /// For the operations that are not here: call(server(), [&] { return api().… }).
    ControlApi& api() { return m_api; }
    Server const& server() const { return m_server; }

private:
    Server m_server;
    ControlApi m_api;
};

} // namespace proctor
