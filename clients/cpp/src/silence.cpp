#include "proctor/silence.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

namespace proctor {
namespace {

std::string const lease_mark = "{lease}";

struct Words {
    std::string cause, cure;
};

std::map<std::string, Words> const words{
    {"standstill",
     {"this program stood still",
      "A machine that swaps, or that suspends this program, stops the thread that extends the lease. Give a new run a longer lease ({lease})."}},
    {"suspended",
     {"this machine was suspended",
      "Keep the machine awake while a run is played (`systemd-inhibit` or `caffeinate` before the command), "
      "or give a new run a longer lease ({lease})."}},
    {"unreached", {"the server was not reached", "A new run with a longer lease ({lease}) outlives such a cut."}},
    {"request",
     {"a request had no answer",
      "The network, a proxy or the server held it back; a new run with a longer lease ({lease}) outlives that."}},
};

template <typename Clock> double seconds() {
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

std::string text(char const* format, double number) {
    char written[32];
    std::snprintf(written, sizeof written, format, number);
    return written;
}

std::string counted(std::size_t count, std::string const& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace

std::string LostSession::describe() const {
    auto const what = step == 0 ? "its session before the first step of " + episode_id
                                : "attempt " + std::to_string(attempt) + " of " + episode_id + " at step " + std::to_string(step);
    auto const lease = text("%g s", lease_s);
    // An answer that was read late hides when the silence began.
    auto const time = silent_s < lease_s ? "longer than its lease of " + lease : text("%.1f s", silent_s) + ", and the lease is " + lease;
    return worker_id + " lost " + what + ": " + words.at(cause).cause + " for " + time;
}

std::string summary(std::vector<LostSession> const& lost, int abandoned) {
    std::set<std::string> workers, causes;
    std::size_t attempts = 0;
    double longest_s = 0;
    for (auto const& session : lost) {
        workers.insert(session.worker_id);
        causes.insert(session.cause);
        attempts += session.step > 0;
        longest_s = std::max({longest_s, session.silent_s, session.lease_s});
    }
    auto said = "Lost by silence: " + counted(lost.size(), "session") + " of " + counted(workers.size(), "worker") + ", and with them " +
                counted(attempts, "attempt") + ".";
    if (abandoned > 0)
        said += " " + counted(abandoned, "episode") + (abandoned == 1 ? " has no attempt left and counts 0." : " have no attempt left and count 0.");
    auto const lease = "EvaluateOptions::submission.idle_timeout_s = " + text("%g", 10 * std::ceil(longest_s / 5));
    for (auto const& cause : causes) {
        auto cure = words.at(cause).cure;
        said += " " + cure.replace(cure.find(lease_mark), lease_mark.size(), lease);
    }
    return said;
}

SilenceMeter::Time SilenceMeter::now() {
    return {seconds<std::chrono::system_clock>(), seconds<std::chrono::steady_clock>()};
}

void SilenceMeter::answered(Time const& sent) {
    std::lock_guard const lock(m_mutex);
    if (sent.awake_s < m_at.awake_s) return;
    m_at = sent;
    m_sent_s = 0;
    m_unreached = false;
}

void SilenceMeter::sent() {
    std::lock_guard const lock(m_mutex);
    m_sent_s = now().awake_s;
}

void SilenceMeter::failed() {
    std::lock_guard const lock(m_mutex);
    m_unreached = true;
}

SilenceMeter::Silence SilenceMeter::silence(double lease_s) const {
    std::lock_guard const lock(m_mutex);
    auto const time = now();
    double const silent_s = time.wall_s - m_at.wall_s, awake_s = time.awake_s - m_at.awake_s;
    if (silent_s - awake_s > lease_s / 2) return {silent_s, "suspended"};
    if (m_unreached) return {silent_s, "unreached"};
    bool const is_waiting = m_sent_s > 0 && time.awake_s - m_sent_s > lease_s / 2;
    return {silent_s, is_waiting ? "request" : "standstill"};
}

} // namespace proctor
