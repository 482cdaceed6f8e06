/* An evaluation from submission to score.
 *
 * A round ends when no worker finds an episode to play. Then either the run is completed, or
 * episodes have been requeued by a session that ended, and another round begins.
 */
#include "proctor/evaluate.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace proctor {
namespace {

/// Sessions in a row that end before their first turn: attaching again does not help then.
constexpr int empty_sessions_max = 8;

using ActionSpace = std::map<std::string, VectorSpace>;

struct ActPolicy : Policy {
    explicit ActPolicy(Act const& act) : m_act(act) {}
    std::vector<Action> act(PolicyInput const& input) override { return m_act(input); }

private:
    Act m_act;
};

MakePolicy from(Act const& act) {
    return [act] { return std::make_unique<ActPolicy>(act); };
}

Error invalid(std::string const& pointer, std::string const& what, Benchmark const& benchmark) {
    std::string shape;
    for (auto const& [name, space] : benchmark.action_space) shape += (shape.empty() ? "" : ", ") + name + " " + std::to_string(space.size);
    return Error("invalid_request", "The policy returned actions that cannot be sent: " + pointer + " " + what +
                                        ". Correct what it returns. An action of " + benchmark.benchmark_id + " is: " + shape + ".");
}

/// Refuses what the server would refuse, with the shape of an action. It checks ranges.
void check(std::vector<Action> const& actions, Benchmark const& benchmark) {
    if (actions.empty()) throw invalid("/actions", "is empty; a chunk holds at least one action", benchmark);
    for (std::size_t i = 0; i < actions.size(); ++i) {
        auto const at = "/actions/" + std::to_string(i) + "/values";
        for (auto const& [name, numbers] : actions[i].values) {
            auto const space = benchmark.action_space.find(name);
            if (space == benchmark.action_space.end()) throw invalid(at, "has " + name + ", which is no name", benchmark);
            if (static_cast<std::int32_t>(numbers.size()) != space->second.size)
                throw invalid(at + "/" + name, "has " + std::to_string(numbers.size()) + " numbers", benchmark);
            if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); }))
                throw invalid(at + "/" + name, "holds a number that is not finite", benchmark);
        }
        for (auto const& [name, space] : benchmark.action_space)
            if (!space.tasks && actions[i].values.count(name) == 0) throw invalid(at, "lacks " + name, benchmark);
    }
}

PolicyInput input_of(Turn const& turn) {
    if (!turn.episode || !turn.observation)
        throw Error("bad_answer", "A turn has no observation, and is not done. Report it to the server's operator.", false, "possible");
    PolicyInput input = decode(*turn.observation);
    input.instruction = turn.episode->instruction;
    input.task = turn.episode->task;
    input.episode_id = turn.episode->episode_id;
    input.step = turn.episode->step;
    input.turn = &turn;
    return input;
}

/// What the workers of an evaluation share.
struct Evaluation {
    Server server; // with the stop signal of the workers
    Run run;
    Benchmark benchmark;
    EvaluateOptions options;
    bool reads_reasons; // why a worker leaves an episode
    std::mutex reporting{};
    std::vector<LostSession> lost{};

    void report(LostSession const& session) {
        std::lock_guard const lock(reporting);
        lost.push_back(session);
        std::cerr << "warning: " + session.describe() + ".\n";
    }
};

/// Plays episodes of a run with its own policy, in its own thread.
class Worker {
public:
    Worker(Evaluation& shared, std::string id, std::unique_ptr<Policy> policy)
        : m_shared(shared), m_id(std::move(id)), m_policy(std::move(policy)), m_takeover(shared.options.takeover) {}

    /// Returns when no episode is left, or the state of the run forbids attaching. A session that
    /// ends early (its lease ran out, the server restarted) is replaced by another.
    void play() {
        for (int empty = 0;; m_shared.server.stop->sleep(0.05 * ((1 << empty) - 1))) {
            std::unique_ptr<Session> session;
            try {
                session = attach();
            } catch (Error const& error) {
                if (error.code == "illegal_transition") return;
                throw;
            }
            try {
                play(*session);
                session->leave();
                return;
            } catch (Error const& error) {
                session->leave(why_left());
                if (auto const lost = session->lost(error)) m_shared.report(*lost);
                empty = session->turn().seq > 0 ? 0 : empty + 1;
                if (error.code != "session_ended" || empty == empty_sessions_max) throw;
            } catch (...) {
                session->leave(why_left());
                throw;
            }
        }
    }

    std::exception_ptr failure{};
    bool is_superseded = false;

private:
    /// Of what was thrown, which is being handled, as those who look at the run read it.
    std::string why_left() const {
        std::string why = "Its evaluation was interrupted, or another worker of it has failed.";
        try {
            throw;
        } catch (Interrupted const&) {
        } catch (Error const& error) {
            why = error.what();
        } catch (std::exception const& error) {
            why = std::string("The policy threw: ") + error.what();
        } catch (...) {
            why = "The policy threw what is no std::exception.";
        }
        return m_shared.reads_reasons ? without_secrets(why, m_shared.server.token) : "";
    }

    std::unique_ptr<Session> attach() {
        AttachWorker request;
        if (m_takeover) request.takeover = true; // unknown to a server without `sessions`
        request.assumes = m_shared.options.assumes;
        // Once only: two programs that both take over would supersede each other forever.
        m_takeover = false;
        return Session::attach(m_shared.server, m_shared.run, m_id, request);
    }

    void play(Session& session) {
        bool is_new = true; // after a takeover the episode goes on with a new policy
        while (!session.turn().done) {
            auto const actions = think(session, is_new);
            if (m_shared.server.stop->requested()) throw Interrupted();
            is_new = false;
            auto const& result = session.predict(actions).episode_result;
            if (!result || !m_shared.options.on_result) continue;
            std::lock_guard const lock(m_shared.reporting);
            m_shared.options.on_result(*result, m_id);
        }
    }

    std::vector<Action> think(Session& session, bool is_new) {
        Session::KeepAlive const keep_alive(session);
        auto const input = input_of(session.turn());
        if (is_new || input.step == 0) m_policy->reset(input.instruction);
        auto actions = m_policy->act(input);
        check(actions, m_shared.benchmark);
        return actions;
    }

    Evaluation& m_shared;
    std::string m_id;
    std::unique_ptr<Policy> m_policy;
    bool m_takeover;
};

/// Play in this thread; a failure ends the other workers too, unless another program took over.
void run_worker(Worker& worker, StopSignal& stop) {
    try {
        worker.play();
    } catch (Error const& error) {
        worker.failure = std::current_exception();
        worker.is_superseded = error.code == "session_superseded";
        if (!worker.is_superseded) stop.request();
    } catch (...) {
        worker.failure = std::current_exception();
        stop.request();
    }
}

bool is_interruption(std::exception_ptr const& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (Interrupted const&) {
        return true;
    } catch (...) {
        return false;
    }
}

/// Every worker plays until no episode is left; `team` keeps those that may play on.
void play_round(std::vector<std::unique_ptr<Worker>>& team, StopSignal& stop) {
    std::vector<std::thread> threads;
    for (auto& worker : team) threads.emplace_back([&stop, raw = worker.get()] { run_worker(*raw, stop); });
    for (auto& thread : threads) thread.join();
    std::exception_ptr failure;
    for (auto const& worker : team) // the first cause, not the workers that it has interrupted
        if (worker->failure && !worker->is_superseded && (!failure || is_interruption(failure))) failure = worker->failure;
    if (failure) std::rethrow_exception(failure);
    auto const superseded = team.front()->failure;
    team.erase(std::remove_if(team.begin(), team.end(), [](auto const& worker) { return worker->is_superseded; }), team.end());
    if (team.empty()) std::rethrow_exception(superseded);
}

Score play_to_score(ControlPlane& control, Evaluation& shared, std::vector<std::unique_ptr<Policy>> policies) {
    if (shared.options.on_run) shared.options.on_run(shared.run);
    std::vector<std::unique_ptr<Worker>> team;
    for (auto& policy : policies) {
        auto id = shared.options.worker_prefix + "-" + std::to_string(team.size());
        team.push_back(std::make_unique<Worker>(shared, std::move(id), std::move(policy)));
    }
    for (bool held = shared.options.takeover; control.wait_for_work(shared.run.run_id, held); held = false)
        play_round(team, *shared.server.stop);
    return control.score(shared.run.run_id);
}

/// Says at the end of an evaluation which sessions were lost.
struct Summary {
    std::vector<LostSession> const& lost;
    int abandoned = 0;

    ~Summary() {
        if (!lost.empty()) std::cerr << summary(lost, abandoned) + "\n";
    }
};

/// The score. What ends the evaluation without one is said here, with how the run goes on: a program that
/// does not catch it ends without a word of the run.
Score evaluated(ControlPlane& control, Evaluation& shared, std::vector<std::unique_ptr<Policy>> policies) {
    try {
        Summary said{shared.lost};
        auto const score = play_to_score(control, shared, std::move(policies));
        said.abandoned = score.counts.abandoned;
        return score;
    } catch (RunFailed const&) {
        throw;
    } catch (RunStopped const&) {
        throw;
    } catch (...) {
        std::cerr << "Run " + shared.run.run_id + " remains on the server; " + how_to_resume(shared.run.run_id) + ".\n";
        throw;
    }
}

/// The first request: a mistyped URL is an error after seconds. Returns whether the server has the profile `reasons`.
bool check_workers(ControlPlane& control, int workers) {
    auto const service = control.service();
    auto const allowed = service.limits.max_workers;
    if (workers < 1 || workers > allowed)
        throw Error("invalid_request", std::to_string(workers) + " workers requested; " + control.server().url + " allows 1 to " +
                                           std::to_string(allowed) + " per run.");
    return std::count(service.profiles.begin(), service.profiles.end(), "reasons") > 0;
}

/// Policies load before the run exists, so that one that fails leaves no run behind.
std::vector<std::unique_ptr<Policy>> load(MakePolicy const& make_policy, int workers) {
    std::vector<std::unique_ptr<Policy>> policies;
    for (int i = 0; i < workers; ++i) policies.push_back(make_policy());
    return policies;
}

/// The server with a stop signal of its own, below the caller's.
Server below(Server const& server) {
    Server mine = server;
    mine.stop = std::make_shared<StopSignal>(server.stop);
    return mine;
}

} // namespace

Score evaluate(Server const& server, std::string const& benchmark_id, MakePolicy const& make_policy, EvaluateOptions options) {
    ControlPlane control(server);
    bool const reads_reasons = check_workers(control, options.workers);
    auto benchmark = control.benchmark(benchmark_id);
    if (benchmark.unavailable_reason) throw Error("benchmark_unavailable", *benchmark.unavailable_reason);
    auto policies = load(make_policy, options.workers);
    options.submission.benchmark_id = benchmark_id;
    if (options.submission.policy.name.empty()) options.submission.policy.name = "policy";
    auto run = control.submit(options.submission);
    Evaluation shared{below(control.server()), std::move(run), std::move(benchmark), std::move(options), reads_reasons};
    return evaluated(control, shared, std::move(policies));
}

Score resume_evaluation(Server const& server, std::string const& run_id, MakePolicy const& make_policy, EvaluateOptions options) {
    ControlPlane control(server);
    bool const reads_reasons = check_workers(control, options.workers);
    auto benchmark = control.benchmark(control.run(run_id).benchmark_id);
    auto policies = load(make_policy, options.workers);
    auto run = control.resume_if_needed(run_id);
    Evaluation shared{below(control.server()), std::move(run), std::move(benchmark), std::move(options), reads_reasons};
    return evaluated(control, shared, std::move(policies));
}

Score evaluate(Server const& server, std::string const& benchmark_id, Act const& act, EvaluateOptions options) {
    return evaluate(server, benchmark_id, from(act), std::move(options));
}

Score resume_evaluation(Server const& server, std::string const& run_id, Act const& act, EvaluateOptions options) {
    return resume_evaluation(server, run_id, from(act), std::move(options));
}

} // namespace proctor
