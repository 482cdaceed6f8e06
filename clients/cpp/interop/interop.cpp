/* What an evaluation in C++ sees: interop SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tests/interop/scenarios.py, which judges; nothing is judged here.
 */
#include <chrono>
#include <iostream>
#include <set>

#include "interop/seen.hpp"
#include "proctor/evaluate.h"

using namespace interop;
using Results = std::map<std::string, std::vector<EpisodeResult>>;

/// One action of `calibration`, with some values of its own; its success is a score above one half.
static Action act(double score, std::map<std::string, std::vector<double>> values = {}) {
    values.merge(std::map<std::string, std::vector<double>>{
        {"score", {score}}, {"success", {score > 0.5 ? 1.0 : 0.0}}, {"end", {0}}, {"delay_s", {0}}, {"fault", {0}},
        {"vector", std::vector<double>(8)}, {"clipped", {0, 0}}});
    return {values};
}

static Act by_index(std::vector<double> const& scores) {
    return [scores](PolicyInput const& input) { return std::vector<Action>(2, act(scores.at(input.turn->episode->index))); };
}

static json attempts(Results const& results) {
    return each(results.at(worker_0), [](auto const& result) { return result.attempt; });
}

template <typename Request> json problem_of(Request request) try {
    request();
    return {{"code", "accepted"}};
} catch (Error const& error) {
    auto seen = refusal(error.problem.value_or(Problem()));
    seen.update({{"status", error.status}, {"code", error.code}, {"retryable", error.retryable},
                 {"side_effects", error.side_effects}, {"retry_after_s", error.retry_after_s}});
    return seen;
}

/// One request, as an Error where it is refused.
template <typename Request> json problem_of_once(Request request, std::string const& url) {
    return problem_of([&] {
        try {
            request();
        } catch (std::exception const&) {
            throw current_error(url);
        }
    });
}

struct Scenario {
    Server server;
    ControlPlane control{server};

    EvaluateOptions options(SubmitRun const& submission, Results& results, int workers = 1) const {
        EvaluateOptions made;
        made.submission = submission;
        made.workers = workers;
        made.on_result = [&results](EpisodeResult const& result, std::string const& worker) { results[worker].push_back(result); };
        return made;
    }

    std::unique_ptr<Session> attach(Run const& run) const { return Session::attach(server, run, worker_0); }
};

static json submit(Scenario& s) {
    auto const key = unique_key();
    auto const body = calibration("score", 1, 10);
    auto const first = s.control.submit(body, key).run_id, second = s.control.submit(body, key).run_id;
    auto const runs = call(s.server, [&] { return s.control.api().listRuns({}, 1000); }).runs;
    json sizes;
    for (auto const& [name, space] : s.control.benchmark("calibration").action_space) sizes[name] = space.size;
    auto const listed = std::count_if(runs.begin(), runs.end(), [&](auto const& run) { return run.run_id == first; });
    return {{"run_ids", {first, second}}, {"listed", listed}, {"max_workers", s.control.service().limits.max_workers}, {"action_sizes", sizes}};
}

static json two_workers(Scenario& s) {
    Results results;
    Act const policy = [](PolicyInput const& input) {
        return std::vector<Action>(2, act(input.turn->episode->index % 2, {{"delay_s", {0.05}}}));
    };
    auto const score = evaluate(s.server, "calibration", policy, s.options(calibration("delay", 8, 4), results, 2));
    json played;
    for (auto const& [worker, list] : results) played[worker] = indices(list);
    return score_of(score, {{"played", played}});
}

static json chunks(Scenario& s) {
    auto const session = s.attach(s.control.submit(calibration("count", 1, 10)));
    std::vector<Turn> turns;
    for (int i = 0; i < 3; ++i) turns.push_back(session->predict(std::vector<Action>(4, act(0)), "all"));
    return chunks_of(turns);
}

static json echo(Scenario& s) {
    auto body = calibration("echo", 1, 10);
    body.images = ImageChoice{"raw", 64, 48};
    auto const session = s.attach(s.control.submit(body));
    auto const input = decode(session->predict({act(0, {{"vector", numbers}})}).observation.value());
    auto const& image = input.images.at("pattern");
    json tensors;
    for (auto const& [name, tensor] : input.tensors)
        tensors[name] = {{"dtype", tensor.dtype}, {"shape", tensor.shape}, {"data", hex(tensor.bytes)}};
    return {
        {"codec", image.codec}, {"size", {image.height, image.width, image.channels}}, {"image", hex(image.data)},
        {"tensors", tensors}, {"vector", each(input.state.at("vector"), bits)},
    };
}

static json lost_answer(Scenario& s) {
    auto const run = s.control.submit(calibration("count", 1, 6));
    auto const session = s.attach(run);
    json all = json::array();
    for (int i = 0; i < 2; ++i)
        for (auto const& count : counts(session->predict(std::vector<Action>(3, act(0)), "all"))) all.push_back(count);
    return {{"run_id", run.run_id}, {"counts", all}, {"done", session->turn().done}};
}

static json with_a_pause(Scenario& s, double lease_s, std::function<void(std::string const& run_id)> const& pause) {
    auto body = calibration("count", 1, 10);
    body.idle_timeout_s = lease_s;
    Results results;
    auto options = s.options(body, results);
    std::string run_id;
    options.on_run = [&](Run const& run) { run_id = run.run_id; };
    std::set<std::string> sessions;
    int calls = 0;
    Act const policy = [&](PolicyInput const& input) {
        sessions.insert(input.turn->session_id);
        if (++calls == 2) pause(run_id);
        return std::vector<Action>(2, act(1));
    };
    auto const score = evaluate(s.server, "calibration", policy, options);
    return score_of(score, {{"sessions", sessions.size()}, {"attempt", results[worker_0].back().attempt}});
}

/// Thinks until the lease is over; the gateway loses its heartbeats.
static json lost_session(Scenario& s) {
    return with_a_pause(s, 2, [&](std::string const& run_id) {
        while (s.control.run(run_id).live_workers > 0) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    });
}

/// Thinks for longer than the lease.
static json heartbeat(Scenario& s) {
    return with_a_pause(s, 3.1, [](std::string const&) { std::this_thread::sleep_for(std::chrono::seconds(4)); });
}

static json restart(Scenario& s) {
    Results results;
    auto const score = evaluate(s.server, "calibration", by_index({0.25, 0.5, 0.75, 1}), s.options(calibration("score", 4, 6), results));
    return score_of(score, {{"attempts", attempts(results)}});
}

/// The policy throws after the first turn, with a text that has a password and the token.
static json left(Scenario& s) {
    Results results;
    auto options = s.options(calibration("count", 1, 10), results);
    std::string run_id;
    options.on_run = [&](Run const& run) { run_id = run.run_id; };
    Act const policy = [&](PolicyInput const& input) -> std::vector<Action> {
        if (input.step > 0) throw std::runtime_error("no answer of\nhttp://me:password@host/?key=k with " + s.server.token);
        return {act(0)};
    };
    try {
        evaluate(s.server, "calibration", policy, options);
    } catch (std::runtime_error const&) {
        return {{"run_id", run_id}};
    }
    return {};
}

static json worker_limit(Scenario& s) {
    auto body = calibration("score", 3, 10);
    body.max_workers = 1;
    body.idle_timeout_s = 5;
    auto const run = s.control.submit(body);
    auto const session = s.attach(run);
    DataApi data(std::make_shared<Connection>(run.endpoint, s.server.token));
    auto const problem = problem_of_once([&] { data.attachWorker(run.run_id, "worker-1", AttachWorker{"k"}); }, s.server.url);
    session->detach();
    Results results;
    auto const score = resume_evaluation(s.server, run.run_id, by_index({1, 1, 1}), s.options({}, results, 2));
    return score_of(score, {{"problem", problem}});
}

static json stop_resume(Scenario& s) {
    auto const run = s.control.submit(calibration("score", 3, 2));
    auto const session = s.attach(run);
    session->predict(std::vector<Action>(2, act(0.5)));
    auto const stopped = s.control.stop(run.run_id, "abort");
    auto const problem = problem_of([&] { session->predict(std::vector<Action>(2, act(0.25))); });
    Results results;
    auto const score = resume_evaluation(s.server, run.run_id, by_index({0.5, 0.25, 1}), s.options({}, results));
    return score_of(score, {{"problem", problem}, {"stopped", stopped.state}, {"after", indices(results[worker_0])}});
}

static json problems(Scenario& s) {
    auto unknown = calibration("score", 1, 10);
    unknown.benchmark_id = "no_such";
    ControlPlane unauthenticated({s.server.url, "not-a-token"});
    auto const run = s.control.submit(calibration("count", 1, 10));
    auto const session = s.attach(run);
    DataApi data(std::make_shared<Connection>(run.endpoint, s.server.token));
    Predict const skipped{session->turn().session_id, 7, {act(0)}};
    return {{"problems", {
        problem_of([&] { s.control.submit(unknown); }),
        problem_of([&] { s.control.run("no_such"); }),
        problem_of([&] { unauthenticated.run("no_such"); }),
        problem_of([&] { session->predict({act(0, {{"vector", {1}}})}); }),
        problem_of([&] { call(s.server, [&] { return data.predict(run.run_id, worker_0, skipped); }); }),
    }}};
}

/// Every run that is listed is answered by what is no run.
static json wrong_answers(Scenario& s) {
    json errors;
    for (auto const& run : call(s.server, [&] { return s.control.api().listRuns(); }).runs)
        errors[run.run_id] = problem_of([&] { s.control.run(run.run_id); })["code"];
    return {{"errors", errors}};
}

static json later_version(Scenario& s) {
    auto const service = s.control.service();
    auto const benchmark = s.control.benchmark("calibration");
    auto const run = s.control.submit(calibration("echo", 1, 10));
    auto const session = s.attach(run);
    auto const& observation = session->turn().observation.value();
    auto const input = decode(observation); // drops what it cannot know
    auto const& vector = benchmark.action_space.at("vector");
    return {
        {"profiles", service.profiles}, {"image_codecs", service.image_codecs}, {"success_rule", benchmark.success_rule},
        {"rotation", vector.parts->at("all").rotation}, {"out_of_range", vector.out_of_range}, {"mode", or_null(run.mode)},
        {"policy", run.policy.name}, {"codec", input.images.at("pattern").codec}, {"dtype", observation.tensors.at("float64").dtype},
        {"problem", problem_of([&] { s.control.run("no_such"); })},
    };
}

static json score(Scenario& s) {
    Results results;
    auto const score = evaluate(s.server, "calibration", by_index({1, 0.5, 0.25, 0, 0.25}), s.options(calibration("score", 5, 2), results));
    return details_of(score, s.control.episodes(score.run_id, 2));
}

int main(int, char** arguments) try {
    std::map<std::string, json (*)(Scenario&)> const scenarios{
        {"submit", submit}, {"two_workers", two_workers}, {"chunks", chunks}, {"echo", echo}, {"lost_answer", lost_answer},
        {"lost_session", lost_session}, {"heartbeat", heartbeat}, {"restart", restart}, {"left", left}, {"worker_limit", worker_limit},
        {"stop_resume", stop_resume}, {"problems", problems}, {"score", score}, {"wrong_answers", wrong_answers}, {"later_version", later_version}};
    Scenario scenario{{arguments[2], arguments[3]}};
    std::cout << scenarios.at(arguments[1])(scenario).dump() << std::endl;
    return 0;
} catch (std::exception const& error) {
    std::cerr << error.what() << std::endl;
    return 1;
}
