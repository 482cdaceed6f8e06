/* What the C++ client sees: interop SCENARIO URL TOKEN prints one JSON line.
 *
 * The scenarios are those of tools/interop.py, which judges; nothing is judged here.
 */
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <iostream>
#include <set>

#include <boost/beast/core/detail/base64.hpp>

#include "../example/calibration.hpp"
#include "../example/worker.hpp"

using namespace worker;
namespace json = boost::json;
using Policy = std::function<std::vector<Action>(Turn const&)>;
using Results = std::vector<EpisodeResult>;

static std::string const worker_0 = "worker-0", worker_1 = "worker-1";
static std::vector<double> const numbers{-0.0, 0.1, 5e-324, std::numeric_limits<double>::max(), 9007199254740991.0, 1.0 / 3, -2.5e-8, 1e22};

static std::string hex(std::string const& bytes) {
    static char const digits[] = "0123456789abcdef";
    std::string text;
    for (unsigned char byte : bytes) (text += digits[byte >> 4]) += digits[byte & 15];
    return text;
}

static std::string unpacked(std::string const& text) {
    namespace base64 = boost::beast::detail::base64;
    std::string bytes(base64::decoded_size(text.size()), '\0');
    bytes.resize(base64::decode(bytes.data(), text.data(), text.size()).first);
    return hex(bytes);
}

static std::string bits(double value) {
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    std::string bytes;
    for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 255);
    return hex(bytes);
}

template <typename Items, typename Function> json::array each(Items const& items, Function function) {
    json::array made;
    for (auto const& item : items) made.push_back(json::value_from(function(item)));
    return made;
}

static Action with(Action action, std::string const& name, std::vector<double> const& values) {
    auto all = action.getValues();
    all[name] = values;
    action.setValues(all);
    return action;
}

static std::shared_ptr<SubmitRun> calibration(std::string const& task, std::size_t count, int max_steps) {
    CalibrationOptions options;
    options.setTasks(std::vector<CalibrationTask>(count, task));
    options.setMaxSteps(max_steps);
    PolicyInfo info;
    info.setName("interop");
    auto body = std::make_shared<SubmitRun>();
    body->setBenchmarkId("calibration");
    body->setPolicy(info);
    body->setOptions(options);
    return body;
}

static std::vector<double> counts(Turn const& turn) {
    std::vector<double> all;
    for (auto const& seen : turn.getObservations()) all.push_back(seen.getState().at("count").at(0));
    return all;
}

static json::array indices(Results const& results) {
    return each(results, [](auto const& result) { return result.getIndex(); });
}

static Policy by_index(std::vector<double> const& scores) {
    return [scores](Turn const& turn) { return std::vector<Action>(2, act(scores.at(turn.getEpisode().getIndex()))); };
}

template <typename Request> json::object problem_of(Request request) try {
    request();
    return {{"code", "accepted"}};
} catch (Refused const& refused) {
    auto const& problem = refused.problem;
    auto const ended_by = problem.getEndedBy();
    return {
        {"status", refused.status}, {"code", problem.getCode()}, {"retryable", problem.isRetryable()},
        {"side_effects", problem.getSideEffects()}, {"retry_after_s", refused.retry_after_s},
        {"pointers", each(problem.getErrors(), [](auto const& item) { return item.getPointer(); })},
        {"expected_seq", problem.getExpectedSeq()},
        {"ended_by", ended_by.empty() ? json::value(nullptr) : json::value(ended_by)},
    };
}

/// One scenario's connection and the requests that all scenarios need.
struct Session {
    std::string url, token;
    ControlApi control{connect(url, token)};

    std::shared_ptr<Run> submit(std::shared_ptr<SubmitRun> const& body, std::string const& key = unique()) {
        return ask([&] { return control.submitRun(body, key, version); });
    }

    std::shared_ptr<DataApi> data(Run const& run) const {
        return std::make_shared<DataApi>(connect(run.getEndpoint(), token));
    }

    std::shared_ptr<Turn> attach(Run const& run) const {
        auto key = std::make_shared<AttachWorker>();
        key->setAttachKey(unique());
        return ask([&] { return data(run)->attachWorker(run.getRunId(), worker_0, key, version); });
    }

    std::shared_ptr<Turn> predict(Run const& run, Turn const& turn, std::int64_t seq, std::vector<Action> const& actions) const {
        auto body = std::make_shared<Predict>();
        body->setSessionId(turn.getSessionId());
        body->setSeq(seq);
        body->setActions(actions);
        body->setObserve("all");
        return ask([&] { return data(run)->predict(run.getRunId(), worker_0, body, version); });
    }

    Results play(Run const& run, Policy const& policy, std::string const& name = worker_0) const {
        Results results;
        worker::play(url, token, run.getRunId(), name, policy, [&](EpisodeResult const& r) { results.push_back(r); });
        return results;
    }

    std::pair<Results, Results> play_two(Run const& run, Policy const& policy) const {
        auto other = std::async(std::launch::async, [&] { return play(run, policy, worker_1); });
        auto first = play(run, policy);
        return {first, other.get()};
    }

    json::object the_score(Run const& run, json::object more) {
        auto const score = ask([&] { return control.getScore(run.getRunId(), version); });
        more["run_id"] = run.getRunId();
        more["score"] = json::value_from(score->getScore().value_or(-1));
        more["complete"] = score->isComplete();
        return more;
    }
};

static json::object submit(Session& s) {
    auto const key = unique();
    auto const body = calibration("score", 1, 10);
    auto const first = s.submit(body, key)->getRunId(), second = s.submit(body, key)->getRunId();
    auto const runs = ask([&] { return s.control.listRuns({}, 1000, version); })->getRuns();
    auto const service = ask([&] { return s.control.describeService(version); });
    auto const benchmark = ask([&] { return s.control.getBenchmark("calibration", version); });
    json::object sizes;
    for (auto const& [name, space] : benchmark->getActionSpace()) sizes[name] = space.getSize();
    auto const listed = std::count_if(runs.begin(), runs.end(), [&](auto const& run) { return run.getRunId() == first; });
    return {{"run_ids", {first, second}}, {"listed", listed}, {"max_workers", service->getLimits().getMaxWorkers()}, {"action_sizes", sizes}};
}

static json::object two_workers(Session& s) {
    auto const run = s.submit(calibration("delay", 8, 4));
    auto const [first, second] = s.play_two(*run, [](Turn const& turn) {
        return std::vector<Action>(2, with(act(turn.getEpisode().getIndex() % 2), "delay_s", {0.05}));
    });
    return s.the_score(*run, {{"played", {{worker_0, indices(first)}, {worker_1, indices(second)}}}});
}

static json::object chunks(Session& s) {
    auto const run = s.submit(calibration("count", 1, 10));
    auto turn = s.attach(*run);
    std::vector<Turn> turns;
    for (int i = 0; i < 3; ++i) {
        turn = s.predict(*run, *turn, turn->getSeq() + 1, std::vector<Action>(4, act(0)));
        turns.push_back(*turn);
    }
    return {
        {"executed", each(turns, [](auto const& t) { return t.getExecutedSteps(); })},
        {"counts", each(turns, counts)},
        {"rewards", each(turns, [](auto const& t) { return t.getRewards().size(); })},
        {"stopped_early", each(turns, [](auto const& t) { return t.isStoppedEarly(); })},
        {"truncated", each(turns, [](auto const& t) { return t.isTruncated(); })},
        {"done", turn->isDone()}, {"steps", turn->getEpisodeResult().getSteps()},
    };
}

static json::object echo(Session& s) {
    ImageChoice choice;
    choice.setCodec("raw");
    choice.setWidth(64);
    choice.setHeight(48);
    auto const body = calibration("echo", 1, 10);
    body->setImages(choice);
    auto const run = s.submit(body);
    auto const look = s.predict(*run, *s.attach(*run), 1, {with(act(0), "vector", numbers)})->getObservation();
    auto const image = look.getImages().at("pattern");
    json::object tensors;
    for (auto const& [name, tensor] : look.getTensors())
        tensors[name] = {{"dtype", tensor.getDtype()}, {"shape", json::value_from(tensor.getShape())}, {"data", unpacked(tensor.getData())}};
    return {
        {"codec", image.getCodec()}, {"size", {image.getHeight(), image.getWidth(), image.getChannels()}},
        {"image", unpacked(image.getData())}, {"tensors", tensors}, {"vector", each(look.getState().at("vector"), bits)},
    };
}

static json::object lost_answer(Session& s) {
    auto const run = s.submit(calibration("count", 1, 6));
    auto turn = s.attach(*run);
    std::vector<double> all;
    for (int i = 0; i < 2; ++i) {
        turn = s.predict(*run, *turn, turn->getSeq() + 1, std::vector<Action>(3, act(0)));
        for (double count : counts(*turn)) all.push_back(count);
    }
    return {{"run_id", run->getRunId()}, {"counts", json::value_from(all)}, {"done", turn->isDone()}};
}

static json::object lost_session(Session& s) {
    auto const body = calibration("count", 1, 10);
    body->setIdleTimeoutS(2);
    auto const run = s.submit(body);
    int calls = 0;
    std::set<std::string> sessions;
    auto const results = s.play(*run, [&](Turn const& turn) {
        sessions.insert(turn.getSessionId());
        ++calls;
        while (calls == 2 && ask([&] { return s.control.getRun(run->getRunId(), "", "", version); })->getLiveWorkers() > 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(100)); // thinks for longer than the lease
        return std::vector<Action>(2, act(1));
    });
    return s.the_score(*run, {{"sessions", sessions.size()}, {"attempt", results.back().getAttempt()}});
}

static json::object restart(Session& s) {
    auto const run = s.submit(calibration("score", 4, 6));
    auto const results = s.play(*run, by_index({0.25, 0.5, 0.75, 1}));
    return s.the_score(*run, {{"attempts", each(results, [](auto const& r) { return r.getAttempt(); })}});
}

static json::object worker_limit(Session& s) {
    auto const body = calibration("score", 3, 10);
    body->setMaxWorkers(1);
    body->setIdleTimeoutS(5);
    auto const run = s.submit(body);
    auto const id = run->getRunId(), session = s.attach(*run)->getSessionId();
    auto const data = s.data(*run);
    auto key = std::make_shared<AttachWorker>();
    key->setAttachKey("k");
    auto const problem = problem_of([&] { once([&] { return data->attachWorker(id, worker_1, key, version); }); });
    ask([&] { data->detachWorker(id, worker_0, session, version); });
    s.play_two(*run, by_index({1, 1, 1}));
    return s.the_score(*run, {{"problem", problem}});
}

static json::object stop_resume(Session& s) {
    auto const run = s.submit(calibration("score", 3, 2));
    auto const policy = by_index({0.5, 0.25, 1});
    auto turn = s.attach(*run);
    turn = s.predict(*run, *turn, 1, policy(*turn));
    auto abort = std::make_shared<StopRun>();
    abort->setMode("abort");
    auto const stopped = ask([&] { return s.control.stopRun(run->getRunId(), abort, version); });
    auto const problem = problem_of([&] { s.predict(*run, *turn, 2, policy(*turn)); });
    ask([&] { return s.control.resumeRun(run->getRunId(), version); });
    auto const after = indices(s.play(*run, policy));
    return s.the_score(*run, {{"problem", problem}, {"stopped", stopped->getState()}, {"after", after}});
}

static json::object problems(Session& s) {
    auto unknown = calibration("score", 1, 10);
    unknown->setBenchmarkId("no_such");
    ControlApi stranger(connect(s.url, "not-a-token"));
    auto const run = s.submit(calibration("count", 1, 10));
    auto const turn = s.attach(*run);
    return {{"problems", {
        problem_of([&] { once([&] { return s.control.submitRun(unknown, "", version); }); }),
        problem_of([&] { once([&] { return s.control.getRun("no_such", "", "", version); }); }),
        problem_of([&] { once([&] { return stranger.listRuns({}, {}, version); }); }),
        problem_of([&] { s.predict(*run, *turn, 1, {with(act(0), "vector", {1})}); }),
        problem_of([&] { s.predict(*run, *turn, 7, {act(0)}); }),
    }}};
}

static json::object score(Session& s) {
    auto const run = s.submit(calibration("score", 5, 2));
    auto const id = run->getRunId();
    s.play(*run, by_index({1, 0.5, 0.25, 0, 0.25}));
    auto const score = ask([&] { return s.control.getScore(id, version); });
    json::array episodes;
    boost::optional<std::string> cursor;
    int pages = 0;
    while (pages == 0 || cursor) {
        auto const page = ask([&] { return s.control.listEpisodes(id, cursor, 2, version); });
        for (auto const& e : page->getEpisodes())
            episodes.push_back({e.getIndex(), e.getResult().getScore(), e.getResult().getSeed()});
        auto const next = page->getNextCursor();
        cursor = next ? boost::optional<std::string>(*next) : boost::none;
        ++pages;
    }
    json::object splits;
    for (auto const& [name, group] : score->getBySplit()) splits[name] = group.getMean().value_or(-1);
    auto const interval = score->getSuccessInterval();
    return {
        {"run_id", id}, {"score", score->getScore().value_or(-1)}, {"success_rate", score->getSuccessRate().value_or(-1)},
        {"interval", {interval.getLow(), interval.getHigh()}}, {"success", score->getCounts().getSuccess()},
        {"splits", splits}, {"pages", pages}, {"episodes", episodes},
    };
}

template <typename Model> std::string again(json::value const& value) {
    return Model(value).toJsonString();
}

/// Each golden vector decoded by the client's models and encoded again.
static json::object vectors(std::string const& directory) {
    std::map<std::string, std::string (*)(json::value const&)> const models{
        {"Action", again<Action>}, {"Image", again<Image>}, {"Predict", again<Predict>},
        {"Problem", again<Problem>}, {"Tensor", again<Tensor>}, {"Turn", again<Turn>}};
    json::object seen;
    for (auto const& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".json") continue;
        std::ifstream file(entry.path());
        std::ostringstream text;
        text << file.rdbuf();
        auto const document = json::parse(text.str());
        for (auto const& vector : document.at("vectors").as_array()) {
            if (vector.as_object().contains("refused")) continue; // for servers
            auto const name = json::value_to<std::string>(vector.at("schema"));
            auto const body = json::value_to<std::string>(vector.at("json"));
            seen[vector.at("id").as_string()] = models.at(name)(json::parse(body));
        }
    }
    return seen;
}

int main(int, char** arguments) try {
    std::string const scenario = arguments[1], url = arguments[2], token = arguments[3];
    std::map<std::string, json::object (*)(Session&)> const scenarios{
        {"submit", submit}, {"two_workers", two_workers}, {"chunks", chunks}, {"echo", echo},
        {"lost_answer", lost_answer}, {"lost_session", lost_session}, {"restart", restart},
        {"worker_limit", worker_limit}, {"stop_resume", stop_resume}, {"problems", problems}, {"score", score}};
    if (scenario == "vectors") {
        std::cout << json::serialize(vectors(url)) << std::endl;
        return 0;
    }
    Session session{url, token};
    std::cout << json::serialize(scenarios.at(scenario)(session)) << std::endl;
    return 0;
} catch (std::exception const& error) {
    std::cerr << error.what() << std::endl;
    return 1;
}
