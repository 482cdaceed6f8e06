/* Why the server did not hear from a worker for longer than its lease.
 *
 * A session that ends so costs the attempt of its episode, and nothing else shows it: the worker
 * attaches again and plays on. The cause is measured here, not guessed.
 */
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace proctor {

/// A session that has ended because its worker was silent for too long.
struct LostSession {
    std::string worker_id, episode_id;
    std::int32_t step; ///< At which the episode was lost; 0 costs no attempt.
    std::int32_t attempt;
    double lease_s;
    double silent_s;   ///< How long the server heard nothing.
    std::string cause; ///< `standstill`, `suspended`, `unreached` or `request`.

    std::string describe() const;
};

/// All losses of an evaluation in a few sentences, with what to do about them.
std::string summary(std::vector<LostSession> const& lost, int abandoned);

/// Measures since the server's last answer, from any thread.
class SilenceMeter {
public:
    struct Time {
        double wall_s, awake_s; ///< `awake_s` stands still while the machine is suspended.
    };

    SilenceMeter() { answered(); }
    static Time now();

    void answered() { answered(now()); } ///< The server has answered: a lease begins.
    void sent();                         ///< A request other than a heartbeat begins.
    /// A heartbeat that was sent at this time has been answered.
    void answered(Time const& sent);
    void failed(); ///< A heartbeat had no answer.

    struct Silence {
        double silent_s;
        std::string cause;
    };
    /// How long the server has heard nothing, and the most likely cause.
    Silence silence(double lease_s) const;

private:
    mutable std::mutex m_mutex;
    Time m_at{0, 0};
    double m_sent_s = 0; // 0: nothing is sent
    bool m_unreached = false;
};

} // namespace proctor
