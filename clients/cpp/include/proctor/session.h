/* A session of a worker: from attach to its end.
 *
 * A lost answer is harmless: the request is repeated unchanged, with its attach_key or seq, and
 * the server repeats the answer without executing the request again. A session that ends in the
 * middle of an episode costs an attempt once an action was executed; so an interrupted
 * evaluation leaves such a session to its lease.
 */
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "api/DataApi.h"
#include "proctor/server.h"
#include "proctor/silence.h"

namespace proctor {

/// A live session. Its requests are for one thread; heartbeats have their own.
class Session {
public:
    /// Waits while the run is at its worker limit, or an earlier session of the worker lives.
    static std::unique_ptr<Session> attach(Server const& server, Run const& run, std::string const& worker_id,
                                           AttachWorker request = {});
    ~Session();
    Session(Session const&) = delete;
    Session& operator=(Session const&) = delete;

    Turn const& turn() const { return m_turn; } ///< The latest turn.
    /// Execute a chunk exactly once; returns the turn. observe: `all` or `last`.
    Turn const& predict(std::vector<Action> const& actions, std::optional<Observe> const& observe = {});

    /// How this worker has lost the session by its silence, if it has. error: the refusal `session_ended`.
    /// A server that no longer knows the reason is believed to have ended the lease if that has passed.
    std::optional<LostSession> lost(Error const& error) const;

    /// Extends the lease by heartbeats while it exists: the policy computes.
    class KeepAlive {
    public:
        explicit KeepAlive(Session& session) : m_session(session) { m_session.set_thinking(true); }
        ~KeepAlive() { m_session.set_thinking(false); }
        KeepAlive(KeepAlive const&) = delete;
        KeepAlive& operator=(KeepAlive const&) = delete;

    private:
        Session& m_session;
    };

    /// End the session; never throws, and takes 3 s where no answer comes.
    void detach() noexcept;
    /// Give the session up without the loss of an attempt; never throws. Detaches where that
    /// costs nothing, else leaves it to its lease: `takeover` then continues the episode.
    /// reason: why, for those who look at the run; only for a server with the profile `reasons`.
    void leave(std::string const& reason = {}) noexcept;

private:
    Session(Server server, Run const& run, std::string worker_id);
    void set_thinking(bool thinking);
    void send_heartbeats(std::string const& session_id, double third_s);

    Server m_server;
    std::string m_endpoint, m_run_id, m_worker_id;
    DataApi m_data;
    Turn m_turn{};
    bool m_ended = false;
    bool m_unanswered = false; // a predict was sent and its answer has not come
    SilenceMeter m_meter{};

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_thinking = false, m_closed = false;
    std::thread m_heartbeats;
};

} // namespace proctor
