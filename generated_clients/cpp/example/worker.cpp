/* Plays the benchmark `calibration` with a scripted policy, or goes on with a run:
 *
 *     PROCTOR_TOKEN=… worker URL [RUN_ID]
 */
#include <cstdlib>
#include <future>
#include <iostream>

#include "calibration.hpp"
#include "worker.hpp"

using namespace worker;

static void evaluate(std::string const& url, std::string const& token, std::string run_id) {
    ControlApi control(connect(url, token));
    SubmitRun submit;
    submit.benchmark_id = "calibration";
    submit.policy.name = "scripted";
    submit.options.emplace().tasks = std::vector<CalibrationTask>(8, "score");
    auto const key = unique();
    auto const run = run_id.empty() ? ask([&] { return control.submitRun(submit, key, version); })
                                    : ask([&] { return control.resumeRun(run_id, version); });
    run_id = run.run_id;
    std::cout << "run " << run_id << ": " << run.progress.episodes_total
              << " episodes; its id, as RUN_ID, goes on with it" << std::endl;
    auto policy = [](Turn const& turn) { return std::vector<Action>(5, act(turn.episode->index % 5 / 4.0)); };
    auto report = [](EpisodeResult const& r) {
        std::ostringstream line;
        line << "  episode " << r.index << " (" << r.task << "): " << r.outcome << ", score " << r.score << "\n";
        std::cout << line.str() << std::flush;
    };
    std::vector<std::future<void>> team;
    for (auto const name : {"worker-0", "worker-1"})
        team.push_back(std::async(std::launch::async, [&, name] { play(url, token, run_id, name, policy, report); }));
    for (auto& member : team) member.get();
    auto const score = ask([&] { return control.getScore(run_id, version); });
    std::cout << "score " << score.score.value_or(-1) << std::endl;
}

int main(int count, char** arguments) try {
    char const* token = std::getenv("PROCTOR_TOKEN");
    if (token == nullptr || *token == 0 || (count != 2 && count != 3)) {
        std::cerr << "usage: " << arguments[0] << " URL [RUN_ID]; the token is PROCTOR_TOKEN\n";
        return 1;
    }
    evaluate(arguments[1], token, count > 2 ? arguments[2] : "");
} catch (std::exception const& error) {
    std::cerr << error.what() << "\n";
    return 1;
}
