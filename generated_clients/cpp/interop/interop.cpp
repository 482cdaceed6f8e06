/* What the C++ client sees: interop SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tools/interop.py, which judges; nothing is judged here.
 */
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <set>

#include "../example/calibration.hpp"
#include "../example/worker.hpp"
#include "seen.hpp"

using namespace worker;
using namespace interop;
using Policy = std::function<std::vector<Action>(Turn const&)>;
using Results = std::vector<EpisodeResult>;

/// Base64 as hexadecimal digits.
static std::string unpacked(std::string const& text) {
    static std::string const letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t word = 0;
    int bits = 0;
    for (char letter : text) {
        if (letter == '=') break;
        word = word << 6 | static_cast<std::uint32_t>(letters.find(letter));
        if ((bits += 6) >= 8) bytes += static_cast<char>(word >> (bits -= 8));
    }
    return hex(bytes);
}

static Action with(Action action, std::string const& name, std::vector<double> const& values) {
    action.values[name] = values;
    return action;
}

static Policy by_index(std::vector<double> const& scores) {
    return [scores](Turn const& turn) { return std::vector<Action>(2, act(scores.at(turn.episode->index))); };
}

template <typename Request> json problem_of(Request request) try {
    request();
    return {{"code", "accepted"}};
} catch (Refused const& refused) {
    auto seen = refusal(refused.problem);
    seen["status"] = refused.status;
    seen["retry_after_s"] = refused.retry_after_s;
    return seen;
}

/// One scenario's connection and the requests that all scenarios need.
struct Session {
    std::string url, token;
    ControlApi control{connect(url, token)};

    Run submit(SubmitRun const& body, std::string const& key = unique()) {
        return ask([&] { return control.submitRun(body, key, version); });
    }

    DataApi data(Run const& run) const { return DataApi(connect(run.endpoint, token)); }

    Turn attach(Run const& run) const {
        auto api = data(run);
        AttachWorker const key{unique()};
        return ask([&] { return api.attachWorker(run.run_id, worker_0, key, version); });
    }

    Turn predict(Run const& run, Turn const& turn, std::int64_t seq, std::vector<Action> const& actions) const {
        auto api = data(run);
        Predict const body{turn.session_id, seq, actions, "all"};
        return ask([&] { return api.predict(run.run_id, worker_0, body, version); });
    }

    Results play(Run const& run, Policy const& policy, std::string const& name = worker_0) const {
        Results results;
        worker::play(url, token, run.run_id, name, policy, [&](EpisodeResult const& r) { results.push_back(r); });
        return results;
    }

    std::pair<Results, Results> play_two(Run const& run, Policy const& policy) const {
        auto other = std::async(std::launch::async, [&] { return play(run, policy, worker_1); });
        auto first = play(run, policy);
        return {first, other.get()};
    }

    json the_score(Run const& run, json const& more) {
        return score_of(ask([&] { return control.getScore(run.run_id, version); }), more);
    }
};

static json submit(Session& s) {
    auto const key = unique();
    auto const body = calibration("score", 1, 10);
    auto const first = s.submit(body, key).run_id, second = s.submit(body, key).run_id;
    auto const runs = ask([&] { return s.control.listRuns({}, 1000, version); }).runs;
    auto const service = ask([&] { return s.control.describeService(version); });
    auto const benchmark = ask([&] { return s.control.getBenchmark("calibration", version); });
    json sizes;
    for (auto const& [name, space] : benchmark.action_space) sizes[name] = space.size;
    auto const listed = std::count_if(runs.begin(), runs.end(), [&](auto const& run) { return run.run_id == first; });
    return {{"run_ids", {first, second}}, {"listed", listed}, {"max_workers", service.limits.max_workers}, {"action_sizes", sizes}};
}

static json two_workers(Session& s) {
    auto const run = s.submit(calibration("delay", 8, 4));
    auto const [first, second] = s.play_two(run, [](Turn const& turn) {
        return std::vector<Action>(2, with(act(turn.episode->index % 2), "delay_s", {0.05}));
    });
    return s.the_score(run, {{"played", {{worker_0, indices(first)}, {worker_1, indices(second)}}}});
}

static json chunks(Session& s) {
    auto const run = s.submit(calibration("count", 1, 10));
    auto turn = s.attach(run);
    std::vector<Turn> turns;
    for (int i = 0; i < 3; ++i) {
        turn = s.predict(run, turn, turn.seq + 1, std::vector<Action>(4, act(0)));
        turns.push_back(turn);
    }
    return chunks_of(turns);
}

static json echo(Session& s) {
    auto body = calibration("echo", 1, 10);
    body.images = ImageChoice{"raw", 64, 48};
    auto const run = s.submit(body);
    auto const look = s.predict(run, s.attach(run), 1, {with(act(0), "vector", numbers)}).observation.value();
    auto const image = look.images.at("pattern");
    json tensors;
    for (auto const& [name, tensor] : look.tensors)
        tensors[name] = {{"dtype", tensor.dtype}, {"shape", tensor.shape}, {"data", unpacked(tensor.data)}};
    return {
        {"codec", image.codec}, {"size", {image.height, image.width, image.channels}},
        {"image", unpacked(image.data)}, {"tensors", tensors}, {"vector", each(look.state.at("vector"), bits)},
    };
}

static json lost_answer(Session& s) {
    auto const run = s.submit(calibration("count", 1, 6));
    auto turn = s.attach(run);
    json all = json::array();
    for (int i = 0; i < 2; ++i) {
        turn = s.predict(run, turn, turn.seq + 1, std::vector<Action>(3, act(0)));
        for (auto const& count : counts(turn)) all.push_back(count);
    }
    return {{"run_id", run.run_id}, {"counts", all}, {"done", turn.done}};
}

static json lost_session(Session& s) {
    auto body = calibration("count", 1, 10);
    body.idle_timeout_s = 2;
    auto const run = s.submit(body);
    int calls = 0;
    std::set<std::string> sessions;
    auto const results = s.play(run, [&](Turn const& turn) {
        sessions.insert(turn.session_id);
        ++calls;
        while (calls == 2 && ask([&] { return s.control.getRun(run.run_id, {}, {}, version); }).live_workers > 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(100)); // thinks for longer than the lease
        return std::vector<Action>(2, act(1));
    });
    return s.the_score(run, {{"sessions", sessions.size()}, {"attempt", results.back().attempt}});
}

static json restart(Session& s) {
    auto const run = s.submit(calibration("score", 4, 6));
    auto const results = s.play(run, by_index({0.25, 0.5, 0.75, 1}));
    return s.the_score(run, {{"attempts", each(results, [](auto const& r) { return r.attempt; })}});
}

static json worker_limit(Session& s) {
    auto body = calibration("score", 3, 10);
    body.max_workers = 1;
    body.idle_timeout_s = 5;
    auto const run = s.submit(body);
    auto const session = s.attach(run).session_id;
    auto data = s.data(run);
    auto const problem = problem_of([&] { data.attachWorker(run.run_id, worker_1, AttachWorker{"k"}, version); });
    ask([&] { data.detachWorker(run.run_id, worker_0, session, version); });
    s.play_two(run, by_index({1, 1, 1}));
    return s.the_score(run, {{"problem", problem}});
}

static json stop_resume(Session& s) {
    auto const run = s.submit(calibration("score", 3, 2));
    auto const policy = by_index({0.5, 0.25, 1});
    auto turn = s.attach(run);
    turn = s.predict(run, turn, 1, policy(turn));
    auto const stopped = ask([&] { return s.control.stopRun(run.run_id, StopRun{"abort"}, version); });
    auto const problem = problem_of([&] { s.predict(run, turn, 2, policy(turn)); });
    ask([&] { return s.control.resumeRun(run.run_id, version); });
    auto const after = indices(s.play(run, policy));
    return s.the_score(run, {{"problem", problem}, {"stopped", stopped.state}, {"after", after}});
}

static json problems(Session& s) {
    auto unknown = calibration("score", 1, 10);
    unknown.benchmark_id = "no_such";
    ControlApi unauthenticated(connect(s.url, "not-a-token"));
    auto const run = s.submit(calibration("count", 1, 10));
    auto const turn = s.attach(run);
    return {{"problems", {
        problem_of([&] { s.control.submitRun(unknown, {}, version); }),
        problem_of([&] { s.control.getRun("no_such", {}, {}, version); }),
        problem_of([&] { unauthenticated.listRuns({}, {}, version); }),
        problem_of([&] { s.predict(run, turn, 1, {with(act(0), "vector", {1})}); }),
        problem_of([&] { s.predict(run, turn, 7, {act(0)}); }),
    }}};
}

/// Every run that is listed is answered by what is no run.
static json wrong_answers(Session& s) {
    json errors;
    for (auto const& run : ask([&] { return s.control.listRuns({}, {}, version); }).runs) {
        try {
            s.control.getRun(run.run_id, {}, {}, version);
            errors[run.run_id] = "accepted";
        } catch (InvalidAnswer const&) {
            errors[run.run_id] = "bad_answer";
        }
    }
    return {{"errors", errors}};
}

static json later_version(Session& s) {
    auto const service = ask([&] { return s.control.describeService(version); });
    auto const benchmark = ask([&] { return s.control.getBenchmark("calibration", version); });
    auto const run = s.submit(calibration("echo", 1, 10));
    auto const look = s.attach(run).observation.value();
    auto const& vector = benchmark.action_space.at("vector");
    return {
        {"profiles", service.profiles}, {"image_codecs", service.image_codecs}, {"success_rule", benchmark.success_rule},
        {"rotation", vector.parts->at("all").rotation}, {"out_of_range", vector.out_of_range}, {"mode", or_null(run.mode)},
        {"policy", run.policy.name}, {"codec", look.images.at("pattern").codec}, {"dtype", look.tensors.at("float64").dtype},
        {"problem", problem_of([&] { s.control.getRun("no_such", {}, {}, version); })},
    };
}

static json score(Session& s) {
    auto const run = s.submit(calibration("score", 5, 2));
    auto const id = run.run_id;
    s.play(run, by_index({1, 0.5, 0.25, 0, 0.25}));
    auto const score = ask([&] { return s.control.getScore(id, version); });
    std::vector<Episode> episodes;
    std::optional<std::string> cursor;
    int pages = 0;
    while (pages == 0 || cursor) {
        auto const page = ask([&] { return s.control.listEpisodes(id, cursor, 2, version); });
        episodes.insert(episodes.end(), page.episodes.begin(), page.episodes.end());
        cursor = page.next_cursor;
        ++pages;
    }
    auto seen = details_of(score, episodes);
    seen["pages"] = pages;
    return seen;
}

template <typename Message> std::string again(std::string const& body) {
    return json(json::parse(body).get<Message>()).dump();
}

/// Each golden vector decoded by the client's models and encoded again.
static json vectors(std::string const& directory) {
    std::map<std::string, std::string (*)(std::string const&)> const models{
        {"Action", again<Action>}, {"Image", again<Image>}, {"Predict", again<Predict>},
        {"Problem", again<Problem>}, {"Tensor", again<Tensor>}, {"Turn", again<Turn>}};
    json seen;
    for (auto const& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".json") continue;
        std::ifstream file(entry.path());
        auto const document = json::parse(file);
        for (auto const& vector : document.at("vectors")) {
            if (vector.contains("refused")) continue; // for servers
            seen[vector.at("id").get<std::string>()] = models.at(vector.at("schema"))(vector.at("json"));
        }
    }
    return seen;
}

int main(int, char** arguments) try {
    std::string const scenario = arguments[1], url = arguments[2], token = arguments[3];
    std::map<std::string, json (*)(Session&)> const scenarios{
        {"submit", submit}, {"two_workers", two_workers}, {"chunks", chunks}, {"echo", echo},
        {"lost_answer", lost_answer}, {"lost_session", lost_session}, {"restart", restart},
        {"worker_limit", worker_limit}, {"stop_resume", stop_resume}, {"problems", problems}, {"score", score},
        {"wrong_answers", wrong_answers}, {"later_version", later_version}};
    if (scenario == "vectors") {
        std::cout << vectors(url).dump() << std::endl;
        return 0;
    }
    Session session{url, token};
    std::cout << scenarios.at(scenario)(session).dump() << std::endl;
    return 0;
} catch (std::exception const& error) {
    std::cerr << error.what() << std::endl;
    return 1;
}
