/* What both interop programs in C++ need to say what they saw: this one, and that of clients/cpp. */
#pragma once

#include <cstring>
#include <limits>
#include <map>

#include "api/ControlApi.h"
#include "api/DataApi.h"

namespace interop {

using nlohmann::json;
using namespace proctor;

inline std::string const worker_0 = "worker-0", worker_1 = "worker-1";
inline std::vector<double> const numbers{-0.0, 0.1, 5e-324, std::numeric_limits<double>::max(), 9007199254740991.0, 1.0 / 3, -2.5e-8, 1e22};

template <typename Bytes> std::string hex(Bytes const& bytes) {
    static char const digits[] = "0123456789abcdef";
    std::string text;
    for (unsigned char byte : bytes) (text += digits[byte >> 4]) += digits[byte & 15];
    return text;
}

inline std::string bits(double value) {
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    std::string bytes;
    for (int shift = 56; shift >= 0; shift -= 8) bytes += static_cast<char>(word >> shift & 255);
    return hex(bytes);
}

template <typename Items, typename Function> json each(Items const& items, Function function) {
    json made = json::array();
    for (auto const& item : items) made.push_back(function(item));
    return made;
}

template <typename T> json or_null(std::optional<T> const& value) {
    return value ? json(*value) : json(nullptr);
}

inline SubmitRun calibration(std::string const& task, std::size_t count, int max_steps) {
    SubmitRun body;
    body.benchmark_id = "calibration";
    body.policy.name = "interop";
    body.options = CalibrationOptions{std::vector<CalibrationTask>(count, task), max_steps};
    return body;
}

inline json indices(std::vector<EpisodeResult> const& results) {
    return each(results, [](auto const& result) { return result.index; });
}

inline json counts(Turn const& turn) {
    return each(turn.observations.value(), [](auto const& seen) { return seen.state.at("count").at(0); });
}

inline json chunks_of(std::vector<Turn> const& turns) {
    auto const& last = turns.back();
    return {
        {"executed", each(turns, [](auto const& t) { return t.executed_steps; })},
        {"counts", each(turns, counts)},
        {"rewards", each(turns, [](auto const& t) { return t.rewards.size(); })},
        {"stopped_early", each(turns, [](auto const& t) { return t.stopped_early; })},
        {"truncated", each(turns, [](auto const& t) { return t.truncated; })},
        {"done", last.done}, {"steps", last.episode_result->steps},
    };
}

inline json score_of(Score const& score, json const& more) {
    json seen = more;
    seen["run_id"] = score.run_id;
    seen["score"] = or_null(score.score);
    seen["complete"] = score.complete;
    return seen;
}

inline json details_of(Score const& score, std::vector<Episode> const& episodes) {
    json splits;
    for (auto const& [name, group] : score.by_split) splits[name] = or_null(group.mean);
    auto const interval = score.success_interval;
    return {
        {"run_id", score.run_id}, {"score", or_null(score.score)}, {"success_rate", or_null(score.success_rate)},
        {"interval", {interval.low, interval.high}}, {"success", score.counts.success}, {"splits", splits},
        {"episodes", each(episodes, [](auto const& e) { return json{e.index, e.result->score, or_null(e.result->seed)}; })},
    };
}

/// The members of a refusal that the judge reads.
inline json refusal(Problem const& problem) {
    return {
        {"code", problem.code}, {"retryable", problem.retryable}, {"side_effects", problem.side_effects},
        {"pointers", each(problem.errors.value_or(std::vector<ProblemItem>()), [](auto const& item) { return item.pointer; })},
        {"expected_seq", or_null(problem.expected_seq)}, {"ended_by", or_null(problem.ended_by)},
    };
}

} // namespace interop
