#include "proctor/server.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <random>
#include <regex>
#include <sstream>
#include <thread>

namespace proctor {
namespace {

constexpr double first_pause_s = 0.1, longest_pause_s = 5, poll_s = 0.2, stop_check_s = 0.05;
constexpr double first_contact_s = 3; // short for a mistyped URL, long enough for a starting server
constexpr double first_answer_s = 5;  // the same, where something accepts connections and is silent
constexpr double first_report_s = 2, next_report_s = 10;
constexpr double defect_s = 10;       // a defect of the server seldom disappears by itself
constexpr std::size_t reason_max = 500, cleaned_max = 4000;
constexpr double page_s = 60;         // for a page in the place of a server that has answered, such as a network's sign-in

double now_s() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double chance(double low, double high) {
    thread_local std::mt19937 generator{std::random_device{}()};
    return std::uniform_real_distribution<double>(low, high)(generator);
}

double limit_s(Error const& error, RetryLimits const& limits_s, double total_s) {
    if (auto const found = limits_s.find(error.code); found != limits_s.end()) return found->second;
    // A healthy server at its capacity is waited for without a limit of time.
    if (error.code == "worker_limit" || error.code == "no_capacity") return std::numeric_limits<double>::infinity();
    bool const is_of_gateway = error.status == 429 || error.status >= 500;
    if (error.code == "bad_answer" && !is_of_gateway) return std::min(page_s, total_s);
    return error.code == "internal_error" ? std::min(defect_s, total_s) : total_s;
}

Server checked(Server server) try {
    server.url = clean_base_url(server.url);
    server.token = clean_token(server.token);
    return server;
} catch (BadSetting const& error) {
    throw Error("invalid_request", error.what() + std::string("."));
}

/// What is waited for, on stderr; workers that wait for the same thing say it once.
void report_wait(std::string const& why) {
    static std::mutex mutex;
    static std::pair<std::string, double> said;
    std::lock_guard const lock(mutex);
    if (said.first == why && now_s() - said.second < next_report_s / 2) return;
    said = {why, now_s()};
    std::cerr << "waiting: " + why + "\n";
}

} // namespace

void StopSignal::sleep(double seconds) const {
    for (double const until = now_s() + seconds; !requested();) {
        double const left_s = until - now_s();
        if (left_s <= 0) return;
        std::this_thread::sleep_for(std::chrono::duration<double>(std::min(left_s, stop_check_s)));
    }
    throw Interrupted();
}

Retry::Retry(Server const& server, RetryLimits const& limits_s)
    : m_server(server), m_limits_s(limits_s), m_begin(now_s()), m_next_report_s(first_report_s) {}

void Retry::wait_after(Error const& error) {
    if (m_code != error.code) {
        m_since = now_s();
        m_pause_s = first_pause_s;
    }
    // With chance, so that workers that failed together do not repeat together.
    double const wait_s = error.retry_after_s > 0 ? error.retry_after_s + chance(0, first_pause_s) : m_pause_s * chance(0.5, 1);
    double const left_s = m_since + limit_s(error, m_limits_s, m_server.retry_timeout_s) - now_s();
    if (!error.retryable || wait_s > left_s) throw error;
    if (m_server.on_waiting) {
        if (m_detail != error.detail) m_server.on_waiting(error.detail);
    } else if (now_s() - m_begin + wait_s >= m_next_report_s) {
        report_wait(error.detail);
        m_next_report_s = now_s() - m_begin + next_report_s;
    }
    m_code = error.code;
    m_detail = error.detail;
    m_pause_s = std::min(2 * m_pause_s, longest_pause_s);
    m_server.stop->sleep(wait_s);
}

namespace {

/// What was thrown by a request to `url`, which is being handled, as an Error.
Error error_at(std::string const& url) {
    try {
        throw;
    } catch (Error const& error) {
        return error;
    } catch (Refused const& refused) {
        return Error(refused.problem, refused.status, refused.retry_after_s);
    } catch (ConnectionError const& error) {
        auto const detail = url + " is unreachable (" + error.what() + "). Check the URL, and that the server runs.";
        return Error("unreachable", detail, true, "possible");
    } catch (InvalidAnswer const& error) {
        auto const detail = url + " sent an invalid response (" + error.what() + "). Check that the URL is that of a Proctor server; " +
                            "if it is, report this to its operator. The request may have been carried out; to repeat it as it was is safe.";
        return Error("bad_answer", detail, error.may_repeat, "possible");
    } catch (nlohmann::json::exception const& error) { // only a text that is no UTF-8 cannot be written
        auto const detail = std::string("The request cannot be written as JSON (") + error.what() + "). Correct its texts: they are UTF-8.";
        return Error("invalid_request", detail);
    }
}

} // namespace

Error current_error(std::string const& url, std::string const& control_url) {
    auto const error = error_at(url);
    bool const is_misled = error.code == "unreachable" || error.code == "bad_answer" || error.code == "not_found";
    if (!is_misled || control_url.empty() || control_url == url) return error;
    return error.explained(" " + url + " is the endpoint of the run, which " + control_url +
                           " has named. If clients reach the server elsewhere, its operator sets --public-url.");
}

std::string without_secrets(std::string text, std::string const& token) {
    std::string const instead = "(token)";
    for (auto at = text.find(token); !token.empty() && at != std::string::npos; at = text.find(token, at + instead.size()))
        text.replace(at, token.size(), instead);
    static std::regex const user("://[^/?#\\s]*@"), query("(://[^\\s?#]*)[?#][^\\s'\"<>]*");
    // An expression goes deeper with each character of a text.
    text = std::regex_replace(std::regex_replace(text.substr(0, cleaned_max), user, "://"), query, "$1?…");
    std::string line;
    std::size_t characters = 0;
    for (char const c : text) {
        bool const is_blank = (c >= 0 && c <= ' ') || c == 0x7f, continues = (c & 0xc0) == 0x80;
        if (is_blank && (line.empty() || line.back() == ' ')) continue;
        if (!continues && ++characters == reason_max) return line + "…";
        line += is_blank ? ' ' : c;
    }
    return line;
}

std::string unique_key() {
    std::random_device entropy;
    std::ostringstream key;
    for (int i = 0; i < 4; ++i) key << std::hex << entropy();
    return key.str();
}

ControlPlane::ControlPlane(Server server)
    : m_server(checked(std::move(server))), m_api(std::make_shared<Connection>(m_server.url, m_server.token)) {}

Service ControlPlane::service() {
    Server first = m_server;
    first.retry_timeout_s = std::min(first_contact_s, m_server.retry_timeout_s);
    ControlApi api(std::make_shared<Connection>(first.url, first.token, first_answer_s));
    return call(first, [&] { return api.describeService(); });
}

Benchmark ControlPlane::benchmark(std::string const& benchmark_id) try {
    return call(m_server, [&] { return m_api.getBenchmark(benchmark_id); });
} catch (Error const& error) {
    if (error.code != "not_found") throw;
    std::string names;
    for (auto const& one : call(m_server, [&] { return m_api.listBenchmarks(); }).benchmarks)
        names += (names.empty() ? "" : ", ") + one.benchmark_id;
    throw Error("not_found", m_server.url + " has no benchmark " + benchmark_id + "; it has " + names);
}

Run ControlPlane::submit(SubmitRun const& submission, std::string const& key) {
    return call(m_server, [&] { return m_api.submitRun(submission, key); });
}

Run ControlPlane::run(std::string const& run_id) {
    return call(m_server, [&] { return m_api.getRun(run_id); });
}

Run ControlPlane::stop(std::string const& run_id, StopMode const& mode) {
    return call(m_server, [&] { return m_api.stopRun(run_id, StopRun{mode}); });
}

Run ControlPlane::resume(std::string const& run_id) {
    return call(m_server, [&] { return m_api.resumeRun(run_id); });
}

Score ControlPlane::score(std::string const& run_id) {
    return call(m_server, [&] { return m_api.getScore(run_id); });
}

std::vector<Episode> ControlPlane::episodes(std::string const& run_id, std::int32_t page_size) {
    std::vector<Episode> all;
    auto const limit = page_size > 0 ? std::optional(page_size) : std::nullopt;
    for (std::optional<std::string> cursor;;) {
        auto const page = call(m_server, [&] { return m_api.listEpisodes(run_id, cursor, limit); });
        all.insert(all.end(), page.episodes.begin(), page.episodes.end());
        cursor = page.next_cursor;
        if (!cursor) return all;
    }
}

Run ControlPlane::resume_if_needed(std::string const& run_id) {
    for (;; m_server.stop->sleep(poll_s)) {
        auto const now = run(run_id);
        if (now.state == "stopping") continue;
        if (now.state == "failed" && !now.retryable.value_or(false)) throw RunFailed(now);
        return now.state == "stopped" || now.state == "failed" ? resume(run_id) : now;
    }
}

bool ControlPlane::wait_for_work(std::string const& run_id, bool held) {
    for (;; m_server.stop->sleep(poll_s)) {
        auto const now = run(run_id);
        if (now.state == "completed") return false;
        if (now.state == "failed") throw RunFailed(now);
        if (now.state == "stopped") throw RunStopped(now);
        if (now.state == "queued" || now.state == "stopping") continue;
        // If a session of others ends early, its episode is played here.
        if (held || now.progress.episodes_pending > 0) return true;
    }
}

} // namespace proctor
