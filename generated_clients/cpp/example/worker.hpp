/* A worker loop on the generated client: the least that a policy needs to be evaluated.
 * The same loop stands in every language of generated_clients/; see docs/implement/clients.md.
 */
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <random>
#include <sstream>
#include <thread>
#include <vector>

#include "api/ControlApi.h"
#include "api/DataApi.h"

namespace worker {

using namespace proctor;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds retry_timeout{60};
inline const std::string version = "1.0";

inline std::shared_ptr<Connection> connect(std::string const& url, std::string const& token) {
    return std::make_shared<Connection>(url, token);
}

/// Says on stderr why a request is still not answered: after 2 s, and then every 10 s.
class WaitReport {
public:
    void because(std::exception const& error, double wait_s) {
        std::chrono::duration<double> const passed = Clock::now() - m_begin;
        if (passed.count() + wait_s < m_next_s) return;
        std::cerr << std::string("waiting: ") + error.what() + "\n";
        m_next_s = passed.count() + 10;
    }

private:
    Clock::time_point m_begin = Clock::now();
    double m_next_s = 2;
};

/// Send a request until it is answered: a repeat executes nothing twice.
template <typename Request> auto ask(Request request) -> decltype(request()) {
    auto const deadline = Clock::now() + retry_timeout;
    WaitReport waiting;
    for (double pause_s = 0.1;; pause_s = std::min(2 * pause_s, 2.0)) {
        try {
            return request();
        } catch (Failure const& error) {
            double const wait_s = std::max(pause_s, error.retry_after_s);
            std::chrono::duration<double> const left = deadline - Clock::now();
            if (!error.may_repeat || wait_s > left.count()) throw;
            waiting.because(error, wait_s);
            std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
        }
    }
}

/// A name that is not in use.
inline std::string unique() {
    std::random_device entropy;
    std::ostringstream name;
    for (int i = 0; i < 4; ++i) name << std::hex << entropy();
    return name.str();
}

/// The run, as soon as workers may attach.
inline Run until_open(ControlApi& control, std::string const& run_id) {
    while (true) {
        auto run = ask([&] { return control.getRun(run_id, {}, {}, version); });
        if (run.state != "queued") return run;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

/// Play until no episode is left; a lost session is replaced by a new one.
inline void play(std::string const& url, std::string const& token, std::string const& run_id, std::string const& worker_id,
                 std::function<std::vector<Action>(Turn const&)> const& policy, std::function<void(EpisodeResult const&)> const& report) {
    ControlApi control(connect(url, token));
    while (true) try {
        DataApi data(connect(until_open(control, run_id).endpoint, token));
        AttachWorker const key{unique()};
        auto turn = ask([&] { return data.attachWorker(run_id, worker_id, key, version); });
        while (!turn.done) {
            Predict const chunk{turn.session_id, turn.seq + 1, policy(turn)};
            turn = ask([&] { return data.predict(run_id, worker_id, chunk, version); });
            if (turn.episode_result) report(*turn.episode_result);
        }
        return;
    } catch (Refused const& error) {
        auto const code = error.problem.code, end = error.problem.ended_by.value_or("");
        if (code == "illegal_transition" && error.problem.state == "completed") return; // others played the rest
        if (code != "session_ended" || end == "run_stopped" || end == "run_failed") throw;
    }
}

} // namespace worker
