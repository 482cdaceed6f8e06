/* Plays the benchmark `calibration` with a scripted policy, or goes on with a run:
 *
 *     PROCTOR_TOKEN=… evaluate URL [RUN_ID]
 *
 * Ctrl-C ends it; the run remains, and its id continues it.
 */
#include <csignal>
#include <cstdlib>
#include <iostream>

#include "proctor/evaluate.h"

using namespace proctor;

static StopSignal* stop = nullptr;

/// Your network goes here. `calibration` scores what the action says.
static std::vector<Action> act(PolicyInput const& input) {
    double const score = input.turn->episode->index % 5 / 4.0;
    Action const action{{{"score", {score}}, {"success", {score > 0.5 ? 1.0 : 0.0}}, {"end", {0}}, {"delay_s", {0}},
                         {"fault", {0}}, {"vector", std::vector<double>(8)}, {"clipped", {0, 0}}}};
    return std::vector<Action>(5, action);
}

int main(int count, char** arguments) try {
    char const* token = std::getenv("PROCTOR_TOKEN");
    if (token == nullptr || *token == 0 || (count != 2 && count != 3)) {
        std::cerr << "usage: " << arguments[0] << " URL [RUN_ID]; the token is PROCTOR_TOKEN\n";
        return 1;
    }
    Server server{arguments[1], token};
    stop = server.stop.get();
    std::signal(SIGINT, [](int) { stop->request(); });

    EvaluateOptions options;
    options.workers = 2;
    options.submission.policy.name = "scripted";
    options.submission.options.emplace().tasks = std::vector<CalibrationTask>(8, "score");
    options.on_run = [](Run const& run) { std::cout << "run " << run.run_id << ": " << run.progress.episodes_total << " episodes\n"; };
    options.on_result = [](EpisodeResult const& r, std::string const&) {
        std::cout << "  episode " << r.index << " (" << r.task << "): " << r.outcome << ", score " << r.score << std::endl;
    };
    auto const score = count == 3 ? resume_evaluation(server, arguments[2], act, options) : evaluate(server, "calibration", act, options);
    std::cout << "score " << score.score.value_or(0) << std::endl;
    return 0;
} catch (std::exception const& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
