#include "proctor/session.h"

#include <algorithm>
#include <chrono>

namespace proctor {
namespace {

constexpr double request_s = 60;
constexpr double margin_s = 3; // added to the lease when waiting for a busy worker
constexpr double reason_s = 3; // the reason is for people: the session ends all the same

/// A request that is silent on a dead connection is repeated in time for the lease.
DataApi data_plane(Server const& server, Run const& run) try {
    // Where requests are repeated for less than a minute, a busy server has that in all.
    double const silence_s = std::max(run.idle_timeout_s / 2, request_s - server.retry_timeout_s);
    return DataApi(std::make_shared<Connection>(run.endpoint, server.token, request_s, std::clamp(silence_s, 10.0, request_s)));
} catch (BadSetting const& error) {
    throw Error("bad_answer", server.url + " named an endpoint of the run that cannot be used: " + error.what() +
                                  ". Ask the operator to set the server's public URL.");
}

bool is_session_end(std::string const& code) {
    return code == "session_ended" || code == "session_superseded";
}

} // namespace

Session::Session(Server server, Run const& run, std::string worker_id)
    : m_server(std::move(server)), m_endpoint(run.endpoint), m_run_id(run.run_id), m_worker_id(std::move(worker_id)),
      m_data(data_plane(m_server, run)) {}

std::unique_ptr<Session> Session::attach(Server const& server, Run const& run, std::string const& worker_id, AttachWorker request) {
    std::unique_ptr<Session> session(new Session(server, run, worker_id));
    request.attach_key = unique_key();
    RetryLimits const limits_s{{"worker_busy", run.idle_timeout_s + margin_s}};
    session->m_turn = call(server, [&] { return session->m_data.attachWorker(run.run_id, worker_id, request); }, limits_s, run.endpoint);
    // Of the first turn, and copied: the thread that plays writes the turn from now on.
    session->m_heartbeats = std::thread([raw = session.get(), id = session->m_turn.session_id, third_s = session->m_turn.lease.idle_timeout_s / 3] {
        raw->send_heartbeats(id, third_s);
    });
    return session;
}

Session::~Session() {
    {
        std::lock_guard const lock(m_mutex);
        m_closed = true;
    }
    m_changed.notify_all();
    if (m_heartbeats.joinable()) m_heartbeats.join();
}

Turn const& Session::predict(std::vector<Action> const& actions, std::optional<Observe> const& observe) {
    Predict const body{m_turn.session_id, m_turn.seq + 1, actions, observe};
    m_unanswered = true;
    m_meter.sent();
    try {
        m_turn = call(m_server, [&] { return m_data.predict(m_run_id, m_worker_id, body); }, {}, m_endpoint);
    } catch (Error const& error) {
        m_ended = is_session_end(error.code);
        m_unanswered = error.side_effects != "none";
        throw;
    }
    m_unanswered = false;
    m_meter.answered();
    return m_turn;
}

std::optional<LostSession> Session::lost(Error const& error) const {
    if (error.code != "session_ended" || !m_turn.episode) return {};
    auto const lease_s = m_turn.lease.idle_timeout_s;
    auto const [silent_s, cause] = m_meter.silence(lease_s);
    auto const ended_by = (error.problem ? error.problem->ended_by : std::nullopt).value_or("unknown");
    if (ended_by != "lease_ended" && (ended_by != "unknown" || silent_s <= lease_s)) return {};
    auto const& episode = *m_turn.episode;
    return LostSession{m_worker_id, episode.episode_id, episode.step, episode.attempt, lease_s, silent_s, cause};
}

void Session::detach() noexcept {
    if (m_ended) return;
    m_ended = true;
    Server server = m_server; // also when the evaluation was interrupted
    server.retry_timeout_s = margin_s;
    server.stop = std::make_shared<StopSignal>();
    server.on_waiting = [](std::string const&) {};
    auto const until = std::chrono::steady_clock::now() + std::chrono::duration<double>(margin_s);
    try {
        call(server, [&] {
            double const left_s = std::chrono::duration<double>(until - std::chrono::steady_clock::now()).count();
            if (left_s < 0.01) throw Error("unreachable", "There was no answer in time.");
            DataApi(std::make_shared<Connection>(m_endpoint, m_server.token, left_s)).detachWorker(m_run_id, m_worker_id, m_turn.session_id);
        });
    } catch (std::exception const&) {
        // Its lease ends it.
    }
}

void Session::leave(std::string const& reason) noexcept {
    if (!reason.empty() && m_turn.episode && !m_ended) try {
        DataApi data(std::make_shared<Connection>(m_endpoint, m_server.token, reason_s));
        data.heartbeat(m_run_id, m_worker_id, Heartbeat{m_turn.session_id, reason});
    } catch (std::exception const&) {
        // Not repeated: what is to follow frees the worker.
    }
    bool const is_free = !m_turn.episode || (m_turn.episode->step == 0 && !m_unanswered);
    if (m_turn.done || is_free) detach();
    m_ended = true;
}

void Session::set_thinking(bool thinking) {
    std::lock_guard const lock(m_mutex);
    m_thinking = thinking;
    m_changed.notify_all();
}

void Session::send_heartbeats(std::string const& session_id, double third_s) {
    DataApi data(std::make_shared<Connection>(m_endpoint, m_server.token, std::max(1.0, third_s)));
    std::unique_lock lock(m_mutex);
    while (!m_closed) {
        m_changed.wait(lock, [&] { return m_closed || m_thinking; });
        auto const is_over = [&] { return m_closed || !m_thinking; };
        while (!m_changed.wait_for(lock, std::chrono::duration<double>(third_s), is_over)) {
            lock.unlock();
            auto const sent = SilenceMeter::now();
            try {
                data.heartbeat(m_run_id, m_worker_id, Heartbeat{session_id});
                m_meter.answered(sent);
            } catch (Refused const& refused) {
                if (!is_session_end(refused.problem.code)) m_meter.failed();
            } catch (std::exception const&) {
                // Not repeated: the next is early enough, and predict says what is wrong.
                m_meter.failed();
            }
            lock.lock();
        }
    }
}

} // namespace proctor
